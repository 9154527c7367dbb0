//! Numbers of one lane, with an order.

use super::{DetSign, SimdReal};

/// A [`SimdReal`] of one lane, with an order and a conversion to `f64`: `f64` and `f32`, and numbers that carry derivatives,
/// [`Gradient`](crate::Gradient)s, of which the values are compared.
///
/// Forces are evaluated and motions are integrated over it, so that loads, energies and motions have derivatives by parameters.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no number type of mechanisms",
    note = "parameters, times and results are `f64`, or `f32` for `Name::<f32>`: write `20.0` for a whole number `20`"
)]
pub trait Scalar: SimdReal<Mask = bool, Signs = DetSign> + PartialOrd {
    /// 0
    const ZERO: Self;

    /// True for numbers that carry derivatives by parameters.
    const HAS_DERIVATIVES: bool;

    /// The nearest `f64`, for messages.
    fn to_f64(self) -> f64;

    /// Its bit pattern, or a hash of more bits than 64.
    fn bits(self) -> u64;

    /// Neither infinite nor NaN.
    fn is_finite(self) -> bool;

    /// The same value, which depends on no parameter. Sizes of steps are such numbers.
    #[must_use]
    fn without_derivatives(self) -> Self;

    /// Its derivative by the parameter of this number, as a number that depends on none; `None` if there is no such parameter.
    #[must_use]
    fn derivative(self, parameter: usize) -> Option<Self>;

    /// The same value with the value of `by` as its derivative by the parameter of this number, if there is one.
    #[must_use]
    fn with_derivative(self, parameter: usize, by: Self) -> Self;
}

/// A floating-point number depends on nothing.
macro_rules! scalar {
    ($scalar:ident) => {
        impl Scalar for $scalar {
            const ZERO: Self = 0.0;
            const HAS_DERIVATIVES: bool = false;

            #[inline]
            fn to_f64(self) -> f64 {
                self.into()
            }
            #[inline]
            fn bits(self) -> u64 {
                self.to_bits().into()
            }
            #[inline]
            fn is_finite(self) -> bool {
                $scalar::is_finite(self)
            }
            #[inline(always)]
            fn without_derivatives(self) -> Self {
                self
            }
            #[inline(always)]
            fn derivative(self, _: usize) -> Option<Self> {
                None
            }
            #[inline(always)]
            fn with_derivative(self, _: usize, _: Self) -> Self {
                self
            }
        }
    };
}

scalar!(f64);
scalar!(f32);
