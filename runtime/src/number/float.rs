//! Scalar floating-point numbers.

use super::row::Pair;
use super::{DetSign, SimdReal};

/// A scalar [`SimdReal`] with an order and a conversion to `f64`: `f64` and `f32`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no number type of mechanisms",
    note = "parameters, times and results are `f64`, or `f32` for `Name::<f32>`: write `20.0` for a whole number `20`"
)]
pub trait Float: SimdReal<Mask = bool, Signs = DetSign> + PartialOrd {
    /// Two numbers in one register.
    #[doc(hidden)]
    type Pair: Pair<Self>;

    /// 0
    const ZERO: Self;

    /// The nearest `f64`, for messages.
    fn to_f64(self) -> f64;

    /// Its bit pattern.
    fn bits(self) -> u64;

    /// Neither infinite nor NaN.
    fn is_finite(self) -> bool;

    /// The greatest power of two that is not above |`self`|; 1 for zero, subnormal, infinite and NaN.
    ///
    /// Multiplying by it and dividing by it are exact, which makes it the right number to scale with.
    #[must_use]
    fn binade(self) -> Self;
}

impl Float for f64 {
    #[cfg(feature = "pairs")]
    type Pair = wide::f64x2;
    #[cfg(not(feature = "pairs"))]
    type Pair = [f64; 2];

    const ZERO: Self = 0.0;

    #[inline]
    fn to_f64(self) -> f64 {
        self
    }
    #[inline]
    fn bits(self) -> u64 {
        self.to_bits()
    }
    #[inline]
    fn is_finite(self) -> bool {
        f64::is_finite(self)
    }
    #[inline]
    fn binade(self) -> Self {
        if self.is_normal() { f64::from_bits(self.to_bits() & 0x7FF0_0000_0000_0000) } else { 1.0 }
    }
}

impl Float for f32 {
    type Pair = [f32; 2];

    const ZERO: Self = 0.0;

    #[inline]
    fn to_f64(self) -> f64 {
        f64::from(self)
    }
    #[inline]
    fn bits(self) -> u64 {
        u64::from(self.to_bits())
    }
    #[inline]
    fn is_finite(self) -> bool {
        f32::is_finite(self)
    }
    #[inline]
    fn binade(self) -> Self {
        if self.is_normal() { f32::from_bits(self.to_bits() & 0x7F80_0000) } else { 1.0 }
    }
}
