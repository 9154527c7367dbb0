//! Numbers whose comparisons have one answer per lane: a scalar, which is one lane, or several numbers side by side.

use core::fmt::Debug;

use super::{DetSign, Real, sin_cos, single};

/// The answer to a comparison, by lane.
pub trait Mask: Copy + Debug {
    /// The same answer in every lane.
    fn of(answer: bool) -> Self;

    /// Yes in every lane.
    fn all(self) -> bool;

    /// Yes in both.
    #[must_use]
    fn and(self, other: Self) -> Self;

    /// The other answer.
    #[must_use]
    fn not(self) -> Self;

    /// Yes in one at least.
    #[must_use]
    fn or(self, other: Self) -> Self;
}

/// A [`Real`] with which a mechanism can be followed in time: `f64` and `f32`, which are one lane each, and numbers of several lanes.
pub trait SimdReal: Real {
    /// What a comparison says.
    type Mask: Mask;

    /// The signs of determinants.
    type Signs: Copy + Debug;

    /// The difference between 1 and the next greater number.
    const EPSILON: Self;

    /// √ε, the length of a correction after which the next one is about a rounding.
    const ROOT_EPSILON: Self;

    /// Whether `self` ≤ `bound`; no where one of them is NaN.
    fn at_most(self, bound: Self) -> Self::Mask;

    /// `then` where the answer is yes, `otherwise` where it is no.
    #[must_use]
    fn pick(mask: Self::Mask, then: Self, otherwise: Self) -> Self;

    /// The sign of each lane; zero counts as positive.
    fn signs(self) -> Self::Signs;

    /// Where signs are the same.
    fn same_signs(a: Self::Signs, b: Self::Signs) -> Self::Mask;

    /// (sine, cosine) with a relative error of 2 ε at most, for the loops of the solver, where speed counts and bits need not be the
    /// same as those of [`sin_cos`](Real::sin_cos).
    #[must_use]
    fn fast_sin_cos(self) -> (Self, Self);

    /// (sine, cosine) of several angles, which may be computed side by side.
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
