//! Numbers that the Newton loop can compare.

use crate::Real;

/// A [`Real`] with an order, a rounding unit and a way into messages: `f64` and `f32`.
pub trait Float: Real + PartialOrd {
    /// The difference between 1 and the next greater number.
    const EPSILON: Self;

    /// √ε, the length of a correction after which the next one is about a rounding.
    const ROOT_EPSILON: Self;

    /// The nearest `f64`, for messages.
    fn to_f64(self) -> f64;

    /// Neither infinite nor NaN.
    fn is_finite(self) -> bool;

    /// The greatest power of two that is not above |`self`|; 1 for zero, subnormal, infinite and NaN.
    ///
    /// Multiplying by it and dividing by it are exact, which makes it the right number to scale with.
    #[must_use]
    fn binade(self) -> Self;

    /// (sine, cosine) to within a unit of the last place, for the loops of the solver, where speed counts and bits need not be the
    /// same as those of [`sin_cos`](Real::sin_cos).
    #[inline(always)]
    #[must_use]
    fn turn(self) -> (Self, Self) {
        self.sin_cos()
    }
}

impl Float for f64 {
    const EPSILON: Self = f64::EPSILON;
    const ROOT_EPSILON: Self = 1.0 / 67_108_864.0;

    #[inline]
    fn to_f64(self) -> f64 {
        self
    }
    #[inline]
    fn is_finite(self) -> bool {
        f64::is_finite(self)
    }
    #[inline]
    fn turn(self) -> (Self, Self) {
        crate::turn::sin_cos(self)
    }
    #[inline]
    fn binade(self) -> Self {
        if self.is_normal() { f64::from_bits(self.to_bits() & 0x7FF0_0000_0000_0000) } else { 1.0 }
    }
}

impl Float for f32 {
    const EPSILON: Self = f32::EPSILON;
    const ROOT_EPSILON: Self = 3.452_669_8e-4;

    #[inline]
    fn to_f64(self) -> f64 {
        f64::from(self)
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
