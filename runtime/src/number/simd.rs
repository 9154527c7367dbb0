//! Numbers whose comparisons have one answer per lane: a scalar, which is one lane, or several numbers side by side.

use core::fmt::Debug;

use super::{DetSign, Real, sin_cos, single};

/// The result of a comparison, by lane.
pub trait Mask: Copy + Debug {
    /// The same value in every lane.
    fn of(answer: bool) -> Self;

    /// Whether it is true in every lane.
    fn all(self) -> bool;

    /// Logical and, by lane.
    #[must_use]
    fn and(self, other: Self) -> Self;

    /// Logical not, by lane.
    #[must_use]
    fn not(self) -> Self;

    /// Logical or, by lane.
    #[must_use]
    fn or(self, other: Self) -> Self;
}

/// A [`Real`] with comparisons by lane: `f64` and `f32`, which have one lane each, and numbers of several lanes.
pub trait SimdReal: Real {
    /// The result of a comparison.
    type Mask: Mask;

    /// The signs of determinants.
    type Signs: Copy + Debug;

    /// The difference between 1 and the next greater number.
    const EPSILON: Self;

    /// √ε: after a Newton correction of this length the next one is about a rounding error.
    const ROOT_EPSILON: Self;

    /// `self` ≤ `bound`, by lane; false if one of them is NaN.
    fn at_most(self, bound: Self) -> Self::Mask;

    /// `then` in the lanes where `mask` is true, `otherwise` in the others.
    #[must_use]
    fn pick(mask: Self::Mask, then: Self, otherwise: Self) -> Self;

    /// The sign of each lane; zero counts as positive.
    fn signs(self) -> Self::Signs;

    /// The lanes in which the signs are equal.
    fn same_signs(a: Self::Signs, b: Self::Signs) -> Self::Mask;

    /// (sine, cosine) with a relative error of at most 2 ε, for the solver's loops: faster than [`sin_cos`](Real::sin_cos), and not
    /// bit-identical to it.
    #[must_use]
    fn fast_sin_cos(self) -> (Self, Self);

    /// (sine, cosine) of several angles, possibly vectorised.
    #[inline(always)]
    #[must_use]
    fn fast_sin_cos_of_each<const K: usize>(angles: [Self; K]) -> [(Self, Self); K] {
        angles.map(Self::fast_sin_cos)
    }
}

impl Mask for bool {
    #[inline(always)]
    fn of(answer: bool) -> Self {
        answer
    }
    #[inline(always)]
    fn all(self) -> bool {
        self
    }
    #[inline(always)]
    fn and(self, other: Self) -> Self {
        self & other
    }
    #[inline(always)]
    fn or(self, other: Self) -> Self {
        self | other
    }
    #[inline(always)]
    fn not(self) -> Self {
        !self
    }
}

/// A scalar is one lane.
macro_rules! scalar {
    ($scalar:ident, root: $root:expr, one: $one:expr, each: $each:expr) => {
        impl SimdReal for $scalar {
            type Mask = bool;
            type Signs = DetSign;

            const EPSILON: Self = $scalar::EPSILON;
            const ROOT_EPSILON: Self = $root;

            #[inline(always)]
            fn at_most(self, bound: Self) -> bool {
                self <= bound
            }
            #[inline(always)]
            fn pick(mask: bool, then: Self, otherwise: Self) -> Self {
                if mask { then } else { otherwise }
            }
            #[inline(always)]
            fn signs(self) -> DetSign {
                if self < 0.0 { DetSign::Negative } else { DetSign::Positive }
            }
            #[inline(always)]
            fn same_signs(a: DetSign, b: DetSign) -> bool {
                a == b
            }
            #[inline(always)]
            fn fast_sin_cos(self) -> (Self, Self) {
                $one(self)
            }
            #[inline(always)]
            fn fast_sin_cos_of_each<const K: usize>(angles: [Self; K]) -> [(Self, Self); K] {
                $each(angles)
            }
        }
    };
}

scalar!(f64, root: 1.0 / 67_108_864.0, one: sin_cos::sin_cos, each: sin_cos::sin_cos_of_each);
scalar!(f32, root: 3.452_669_8e-4, one: single::sin_cos, each: single::sin_cos_of_each);
