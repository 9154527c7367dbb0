//! Scalar floating-point numbers.

use super::Scalar;
use super::row::Pair;

/// A [`Scalar`] that is a floating-point number: `f64` and `f32`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no number type of mechanisms",
    note = "parameters, times and results are `f64`, or `f32` for `Name::<f32>`: write `20.0` for a whole number `20`"
)]
pub trait Float: Scalar {
    /// Two numbers in one register.
    #[doc(hidden)]
    type Pair: Pair<Self>;

    /// Whether this is one of Rust's own numbers, for which the crate compiles what other types compile where they are used.
    #[doc(hidden)]
    const IS_PRIMITIVE: bool = false;

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
    const IS_PRIMITIVE: bool = true;

    #[inline]
    fn binade(self) -> Self {
        if self.is_normal() { f64::from_bits(self.to_bits() & 0x7FF0_0000_0000_0000) } else { 1.0 }
    }
}

impl Float for f32 {
    type Pair = [f32; 2];
    const IS_PRIMITIVE: bool = true;

    #[inline]
    fn binade(self) -> Self {
        if self.is_normal() { f32::from_bits(self.to_bits() & 0x7F80_0000) } else { 1.0 }
    }
}
