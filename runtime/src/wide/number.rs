//! SIMD registers as numbers of the equations and of the solver.

use nalgebra::SMatrix;
use wide::{f32x8, f64x4};

use super::{Dense, Wide};
use crate::careful::Care;
use crate::linear::Linear;
use crate::pass::{Solved, Stop};
use crate::problem::{Block, Evaluate};
use crate::{Lanes, Mask, Orientation, Real, Table, turn};

/// The answers of a comparison of registers: all bits of a lane are set where it is yes.
#[derive(Clone, Copy, Debug)]
pub struct Answers<R>(R);

/// A register as a number. Functions are those of `libm`, lane by lane, but for what one instruction computes.
macro_rules! register {
    ($register:ident, $lane:ident, $lanes:literal, bits: $bits:ident, turn: $turn:expr) => {
        impl Mask for Answers<$register> {
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

        impl Real for $register {
            #[inline(always)]
            fn of(value: f64) -> Self {
                Self::splat(value as $lane)
            }
            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                let pairs = self.to_array().map(Real::sin_cos);
                (Self::new(pairs.map(|(sine, _)| sine)), Self::new(pairs.map(|(_, cosine)| cosine)))
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                $register::sqrt(self)
            }
            #[inline]
            fn tan(self) -> Self {
                Self::new(self.to_array().map(Real::tan))
            }
            #[inline]
            fn asin(self) -> Self {
                Self::new(self.to_array().map(Real::asin))
            }
            #[inline]
            fn acos(self) -> Self {
                Self::new(self.to_array().map(Real::acos))
            }
            #[inline]
            fn atan(self) -> Self {
                Self::new(self.to_array().map(Real::atan))
            }
            #[inline]
            fn atan2(self, x: Self) -> Self {
                let (y, x) = (self.to_array(), x.to_array());
                Self::new(core::array::from_fn(|lane| Real::atan2(y[lane], x[lane])))
            }
            #[inline]
            fn exp(self) -> Self {
                Self::new(self.to_array().map(Real::exp))
            }
            #[inline]
            fn ln(self) -> Self {
                Self::new(self.to_array().map(Real::ln))
            }
            #[inline(always)]
            fn abs(self) -> Self {
                $register::abs(self)
            }
            #[inline]
            fn sign(self) -> Self {
                Self::new(self.to_array().map(Real::sign))
            }
            #[inline(always)]
            fn select_less(lhs: Self, rhs: Self, then: Self, otherwise: Self) -> Self {
                lhs.simd_lt(rhs).bitselect(then, otherwise)
            }
            #[inline]
            fn table(self, table: &Table) -> (Self, Self, Self) {
                triple(self.to_array().map(|lane| lane.table(table)), Self::new)
            }
            #[inline]
            fn map(self, function: fn(f64) -> (f64, f64, f64)) -> (Self, Self, Self) {
                triple(self.to_array().map(|lane| lane.map(function)), Self::new)
            }
        }

        impl Lanes for $register {
            type Mask = Answers<Self>;
            type Dense<const K: usize> = Dense<Self, K, $lanes>;
            type Sides = Answers<Self>;

            const EPSILON: Self = Self::splat($lane::EPSILON);
            const ROOT_EPSILON: Self = Self::splat(<$lane as Lanes>::ROOT_EPSILON);

            #[inline(always)]
            fn at_most(self, bound: Self) -> Answers<Self> {
                Answers(self.simd_le(bound))
            }
            #[inline(always)]
            fn pick(mask: Answers<Self>, then: Self, otherwise: Self) -> Self {
                mask.0.bitselect(then, otherwise)
            }
            #[inline(always)]
            fn sides(self) -> Answers<Self> {
                Answers(self.simd_lt(Self::splat(0.0)))
            }
            #[inline(always)]
            fn same(a: Answers<Self>, b: Answers<Self>) -> Answers<Self> {
                Answers(a.0 ^ b.0).not()
            }
            #[inline(always)]
            fn turn(self) -> (Self, Self) {
                $turn(self)
            }
            fn carefully<L: Linear<Self, K>, const K: usize, const N: usize>(
                _: &Care<'_, Self, N>,
                _: &Block<K>,
                _: [Self; K],
                _: &Evaluate<'_, Self, L, K>,
            ) -> Result<Solved<Self, L, K>, Stop<Self>> {
                Err(Stop::Far)
            }
        }

        impl Wide<$lanes> for $register {
            type Lane = $lane;

            #[inline(always)]
            fn from_lanes(lanes: [$lane; $lanes]) -> Self {
                Self::new(lanes)
            }
            #[inline(always)]
            fn to_lanes(self) -> [$lane; $lanes] {
                self.to_array()
            }
            #[inline]
            fn from_sides(lanes: [Orientation; $lanes]) -> Answers<Self> {
                Self::mask(lanes.map(|side| side == Orientation::Negative))
            }
            #[inline]
            fn to_sides(sides: Answers<Self>) -> [Orientation; $lanes] {
                Self::answers(sides).map(|negative| if negative { Orientation::Negative } else { Orientation::Positive })
            }
            #[inline(always)]
            fn answers(mask: Answers<Self>) -> [bool; $lanes] {
                mask.0.to_array().map(|lane| lane.to_bits() != 0)
            }
            #[inline(always)]
            fn mask(answers: [bool; $lanes]) -> Answers<Self> {
                Answers(Self::new(answers.map(|answer| $lane::from_bits(if answer { $bits::MAX } else { 0 }))))
            }
        }
    };
}

register!(f64x4, f64, 4, bits: u64, turn: turn_of_four);
register!(f32x8, f32, 8, bits: u32, turn: turn_of_eight);

/// (sine, cosine), all lanes at once unless one is far from zero.
#[inline(always)]
fn turn_of_four(x: f64x4) -> (f64x4, f64x4) {
    if x.abs().simd_lt(f64x4::splat(turn::LARGEST)).all() { turn::within_range(x) } else { turn_by_lane(x) }
}

/// (sine, cosine), four lanes at a time in double precision and rounded.
#[inline(always)]
fn turn_of_eight(x: f32x8) -> (f32x8, f32x8) {
    // Written out, since rustc does not compile closures over eight lanes into their caller.
    let [a, b, c, d, e, f, g, h] = x.to_array().map(f64::from);
    let (low, high) = (turn_of_four(f64x4::new([a, b, c, d])), turn_of_four(f64x4::new([e, f, g, h])));
    let both = |low: f64x4, high: f64x4| {
        let ([a, b, c, d], [e, f, g, h]) = (low.to_array(), high.to_array());
        f32x8::new([a as f32, b as f32, c as f32, d as f32, e as f32, f as f32, g as f32, h as f32])
    };
    (both(low.0, high.0), both(low.1, high.1))
}

#[cold]
#[inline(never)]
fn turn_by_lane(x: f64x4) -> (f64x4, f64x4) {
    let pairs = x.to_array().map(Lanes::turn);
    (f64x4::new(pairs.map(|(sine, _)| sine)), f64x4::new(pairs.map(|(_, cosine)| cosine)))
}

/// Values, first and second derivatives from those of each lane.
fn triple<S: Copy, R, const L: usize>(lanes: [(S, S, S); L], register: fn([S; L]) -> R) -> (R, R, R) {
    (register(lanes.map(|lane| lane.0)), register(lanes.map(|lane| lane.1)), register(lanes.map(|lane| lane.2)))
}

/// A block's matrix of lanes as the matrix of one of them.
pub(super) fn matrix_of_lane<W: Wide<L>, const K: usize, const L: usize>(matrix: &SMatrix<W, K, K>, lane: usize) -> SMatrix<W::Lane, K, K> {
    matrix.map(|entry| entry.to_lanes()[lane])
}
