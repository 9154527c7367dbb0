//! SIMD registers as numbers of the equations and of the solver.

use core::ops::{Add, Div, Mul, Neg, Sub};

use nalgebra::SMatrix;
use reuleaux::for_lanes::{NoColdStart, SIN_COS_RANGE, sin_cos_in_range};
use reuleaux::{DetSign, Elimination, FactorReal, Mask, Real, SimdReal, Small, SolverReal, Sparse, Table};
use wide::{f32x8, f64x4};

use super::{LaneFactors, Wide};

/// The result of a comparison: all bits of a lane are set where it is true.
#[derive(Clone, Copy, Debug)]
pub struct LaneMask<R>(R);

/// Implements the number traits for a register. Functions are those of `libm`, lane by lane, except where one instruction computes
/// them.
macro_rules! register {
    ($(#[$doc:meta])* $name:ident($register:ident), $lane:ident, $lanes:literal, bits: $bits:ident, sin_cos: $sin_cos:expr) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name(pub $register);

        impl $name {
            /// The same number in every lane.
            #[inline(always)]
            #[must_use]
            pub const fn splat(value: $lane) -> Self {
                Self($register::splat(value))
            }

            /// The numbers by lane.
            #[inline(always)]
            #[must_use]
            pub fn to_array(self) -> [$lane; $lanes] {
                self.0.to_array()
            }

            /// A function of each lane.
            #[inline(always)]
            fn map(self, function: impl Fn($lane) -> $lane) -> Self {
                Self::from(self.to_array().map(function))
            }
        }

        impl From<[$lane; $lanes]> for $name {
            #[inline(always)]
            fn from(lanes: [$lane; $lanes]) -> Self {
                Self($register::new(lanes))
            }
        }

        impl Add for $name {
            type Output = Self;
            #[inline(always)]
            fn add(self, other: Self) -> Self {
                Self(self.0 + other.0)
            }
        }

        impl Sub for $name {
            type Output = Self;
            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                Self(self.0 - other.0)
            }
        }

        impl Mul for $name {
            type Output = Self;
            #[inline(always)]
            fn mul(self, other: Self) -> Self {
                Self(self.0 * other.0)
            }
        }

        impl Div for $name {
            type Output = Self;
            #[inline(always)]
            fn div(self, other: Self) -> Self {
                Self(self.0 / other.0)
            }
        }

        impl Neg for $name {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }

        impl Mask for LaneMask<$register> {
            #[inline(always)]
            fn of(answer: bool) -> Self {
                Self($register::splat($lane::from_bits(if answer { $bits::MAX } else { 0 })))
            }
            #[inline(always)]
            fn all(self) -> bool {
                self.0.all()
            }
            #[inline(always)]
            fn and(self, other: Self) -> Self {
                Self(self.0 & other.0)
            }
            #[inline(always)]
            fn or(self, other: Self) -> Self {
                Self(self.0 | other.0)
            }
            #[inline(always)]
            fn not(self) -> Self {
                Self(self.0 ^ Self::of(true).0)
            }
        }

        impl Real for $name {
            #[inline(always)]
            fn of(value: f64) -> Self {
                Self::splat(value as $lane)
            }
            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                pair(self.to_array().map(Real::sin_cos))
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                Self(self.0.sqrt())
            }
            #[inline]
            fn tan(self) -> Self {
                self.map(Real::tan)
            }
            #[inline]
            fn asin(self) -> Self {
                self.map(Real::asin)
            }
            #[inline]
            fn acos(self) -> Self {
                self.map(Real::acos)
            }
            #[inline]
            fn atan(self) -> Self {
                self.map(Real::atan)
            }
            #[inline]
            fn atan2(self, x: Self) -> Self {
                let (y, x) = (self.to_array(), x.to_array());
                Self::from(core::array::from_fn(|lane| Real::atan2(y[lane], x[lane])))
            }
            #[inline]
            fn exp(self) -> Self {
                self.map(Real::exp)
            }
            #[inline]
            fn ln(self) -> Self {
                self.map(Real::ln)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                Self(self.0.abs())
            }
            #[inline]
            fn sign(self) -> Self {
                self.map(Real::sign)
            }
            #[inline(always)]
            fn select_less(lhs: Self, rhs: Self, then: Self, otherwise: Self) -> Self {
                Self(lhs.0.simd_lt(rhs.0).bitselect(then.0, otherwise.0))
            }
            #[inline(always)]
            fn is_less(lhs: Self, rhs: Self) -> Option<bool> {
                let is_less = lhs.0.simd_lt(rhs.0);
                if is_less.all() {
                    return Some(true);
                }
                (!is_less.any()).then_some(false)
            }
            #[inline]
            fn table(self, table: &Table) -> (Self, Self, Self) {
                triple(self.to_array().map(|lane| lane.table(table)))
            }
            #[inline]
            fn map(self, function: fn(f64) -> (f64, f64, f64)) -> (Self, Self, Self) {
                triple(self.to_array().map(|lane| Real::map(lane, function)))
            }
        }

        impl SimdReal for $name {
            type Mask = LaneMask<$register>;
            type Signs = LaneMask<$register>;

            const EPSILON: Self = Self::splat($lane::EPSILON);
            const ROOT_EPSILON: Self = Self::splat(<$lane as SimdReal>::ROOT_EPSILON);

            #[inline(always)]
            fn at_most(self, bound: Self) -> Self::Mask {
                LaneMask(self.0.simd_le(bound.0))
            }
            #[inline(always)]
            fn pick(mask: Self::Mask, then: Self, otherwise: Self) -> Self {
                Self(mask.0.bitselect(then.0, otherwise.0))
            }
            #[inline(always)]
            fn signs(self) -> Self::Signs {
                LaneMask(self.0.simd_lt($register::splat(0.0)))
            }
            #[inline(always)]
            fn same_signs(a: Self::Signs, b: Self::Signs) -> Self::Mask {
                LaneMask(a.0 ^ b.0).not()
            }
            #[inline(always)]
            fn fast_sin_cos(self) -> (Self, Self) {
                let (sine, cosine) = $sin_cos(self.0);
                (Self(sine), Self(cosine))
            }
        }

        impl FactorReal for $name {
            type Small<const K: usize> = Small<Self, K>;
            type Sparse<E, const K: usize, const ENTRIES: usize, const FACTORS: usize>
                = Sparse<Self, E, K, ENTRIES, FACTORS>
            where
                E: Elimination<Self, K, ENTRIES, FACTORS>;
            type Dense<const K: usize> = LaneFactors<Self, K, $lanes>;
        }

        /// A lane that a warm step does not solve is solved by itself ([`Lockstep`](super::Lockstep)).
        impl SolverReal for $name {
            type Cold<'a, const N: usize> = NoColdStart;
        }

        impl Wide<$lanes> for $name {
            type Lane = $lane;

            #[inline(always)]
            fn from_lanes(lanes: [$lane; $lanes]) -> Self {
                Self::from(lanes)
            }
            #[inline(always)]
            fn to_lanes(self) -> [$lane; $lanes] {
                self.to_array()
            }
            #[inline]
            fn from_signs(lanes: [DetSign; $lanes]) -> Self::Signs {
                Self::mask_from_lanes(lanes.map(|side| side == DetSign::Negative))
            }
            #[inline]
            fn to_signs(signs: Self::Signs) -> [DetSign; $lanes] {
                Self::mask_to_lanes(signs).map(|negative| if negative { DetSign::Negative } else { DetSign::Positive })
            }
            #[inline(always)]
            fn mask_to_lanes(mask: Self::Mask) -> [bool; $lanes] {
                mask.0.to_array().map(|lane| lane.to_bits() != 0)
            }
            #[inline(always)]
            fn mask_from_lanes(answers: [bool; $lanes]) -> Self::Mask {
                LaneMask($register::new(answers.map(|answer| $lane::from_bits(if answer { $bits::MAX } else { 0 }))))
            }
        }
    };
}

register!(
    /// Four `f64` in one register.
    F64x4(f64x4), f64, 4, bits: u64, sin_cos: sin_cos_of_four
);
register!(
    /// Eight `f32` in one register.
    F32x8(f32x8), f32, 8, bits: u32, sin_cos: sin_cos_of_eight
);

/// (sine, cosine), all lanes at once unless an angle is very large.
#[inline(always)]
fn sin_cos_of_four(x: f64x4) -> (f64x4, f64x4) {
    if x.abs().simd_lt(f64x4::splat(SIN_COS_RANGE)).all() {
        let (sine, cosine) = sin_cos_in_range(F64x4(x));
        (sine.0, cosine.0)
    } else {
        sin_cos_by_lane(x)
    }
}

/// (sine, cosine), four lanes at a time in double precision and rounded.
#[inline(always)]
fn sin_cos_of_eight(x: f32x8) -> (f32x8, f32x8) {
    // Written out, since rustc does not compile closures over eight lanes into their caller.
    let [a, b, c, d, e, f, g, h] = x.to_array().map(f64::from);
    let (low, high) = (sin_cos_of_four(f64x4::new([a, b, c, d])), sin_cos_of_four(f64x4::new([e, f, g, h])));
    let both = |low: f64x4, high: f64x4| {
        let ([a, b, c, d], [e, f, g, h]) = (low.to_array(), high.to_array());
        f32x8::new([a as f32, b as f32, c as f32, d as f32, e as f32, f as f32, g as f32, h as f32])
    };
    (both(low.0, high.0), both(low.1, high.1))
}

#[cold]
#[inline(never)]
fn sin_cos_by_lane(x: f64x4) -> (f64x4, f64x4) {
    let pairs = x.to_array().map(SimdReal::fast_sin_cos);
    (f64x4::new(pairs.map(|(sine, _)| sine)), f64x4::new(pairs.map(|(_, cosine)| cosine)))
}

/// Sines and cosines from those of each lane.
fn pair<S: Copy, R: From<[S; L]>, const L: usize>(lanes: [(S, S); L]) -> (R, R) {
    (R::from(lanes.map(|lane| lane.0)), R::from(lanes.map(|lane| lane.1)))
}

/// Values, first and second derivatives from those of each lane.
fn triple<S: Copy, R: From<[S; L]>, const L: usize>(lanes: [(S, S, S); L]) -> (R, R, R) {
    (R::from(lanes.map(|lane| lane.0)), R::from(lanes.map(|lane| lane.1)), R::from(lanes.map(|lane| lane.2)))
}

/// A block's matrix of lanes as the matrix of one of them.
pub(super) fn matrix_of_lane<W: Wide<L>, const K: usize, const L: usize>(matrix: &SMatrix<W, K, K>, lane: usize) -> SMatrix<W::Lane, K, K> {
    matrix.map(|entry| entry.to_lanes()[lane])
}
