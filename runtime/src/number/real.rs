//! The number type of emitted code: arithmetic and the functions of the language. Comparisons, which only the solver needs, are in
//! [`SimdReal`](crate::SimdReal) and [`Float`](crate::Float).

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::{Table, single};

/// A number over which emitted code is generic: `f64` and `f32`, and any other type with this arithmetic (SIMD registers, dual
/// numbers, intervals).
///
/// There are no comparison operators, because lanes and intervals have no single answer to a comparison.
/// For `f64` every function is that of `libm`, for `f32` too but for sine, cosine, tangent and arc sine, which `libm` computes with
/// doubles: so the bits are the same on every platform, and `f32` needs no double but for [`map`](Self::map).
///
/// Angles are never wrapped; the sine of an angle is that of the stored number. After many turns stored numbers are coarse: at
/// 10 000 turns neighbouring numbers are 7e-12 rad apart in `f64` and 4e-3 rad, a quarter of a degree, in `f32`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no number type of mechanisms",
    note = "parameters, times and results are `f64`, or `f32` for `Name::<f32>`: write `20.0` for a whole number `20`"
)]
pub trait Real:
    Copy + Debug + PartialEq + 'static + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// The number nearest to `value`.
    fn of(value: f64) -> Self;

    /// Sine and cosine, in this order, of an angle in radians.
    fn sin_cos(self) -> (Self, Self);

    /// Square root; not a number below zero.
    fn sqrt(self) -> Self;

    /// Tangent of an angle in radians.
    fn tan(self) -> Self;

    /// Arc sine in radians, from −π/2 to π/2; not a number outside [−1, 1].
    fn asin(self) -> Self;

    /// Arc cosine in radians, from 0 to π; not a number outside [−1, 1].
    fn acos(self) -> Self;

    /// Arc tangent in radians, from −π/2 to π/2.
    fn atan(self) -> Self;

    /// Angle in radians, from −π to π, of the vector (`x`, `self`): `self` is y.
    fn atan2(self, x: Self) -> Self;

    /// e to the power `self`.
    fn exp(self) -> Self;

    /// Natural logarithm; not a number below zero.
    fn ln(self) -> Self;

    /// Absolute value.
    fn abs(self) -> Self;

    /// −1 below zero, 1 above; zero and NaN are returned as they are.
    fn sign(self) -> Self;

    /// `then` where `lhs < rhs`, `otherwise` elsewhere, also where one of the two is NaN.
    fn select_less(lhs: Self, rhs: Self, then: Self, otherwise: Self) -> Self;

    /// Whether `lhs < rhs`; `None` where lanes differ, and for numbers that cannot tell.
    #[inline(always)]
    #[must_use]
    fn is_less(_lhs: Self, _rhs: Self) -> Option<bool> {
        None
    }

    /// The values of `then` where `lhs < rhs`, those of `otherwise` elsewhere, as [`select_less`](Self::select_less) would choose them. Only one
    /// of the two is computed if [`is_less`](Self::is_less) has an answer.
    #[inline(always)]
    #[must_use]
    fn choose_less<const K: usize>(
        lhs: Self,
        rhs: Self,
        then: impl FnOnce() -> [Self; K],
        otherwise: impl FnOnce() -> [Self; K],
    ) -> [Self; K] {
        let is_less = Self::is_less(lhs, rhs);
        // Each is called at one place, so that nested choices do not double the code.
        let unused = [Self::of(0.0); K];
        let then = if is_less == Some(false) { unused } else { then() };
        let otherwise = if is_less == Some(true) { unused } else { otherwise() };
        match is_less {
            Some(true) => then,
            Some(false) => otherwise,
            None => core::array::from_fn(|k| Self::select_less(lhs, rhs, then[k], otherwise[k])),
        }
    }

    /// The greater of the two; `self` where they cannot be compared.
    #[must_use]
    fn max(self, other: Self) -> Self {
        Self::select_less(self, other, other, self)
    }

    /// Value, first and second derivative at `self` of a cubic spline, as [`Table::evaluate`] defines them, and for `f32`
    /// [`Table::evaluate_single`].
    fn table(self, table: &Table) -> (Self, Self, Self);

    /// Value, first and second derivative at `self` of a function that exists for `f64` only, such as a measured law.
    fn map(self, function: fn(f64) -> (f64, f64, f64)) -> (Self, Self, Self);
}

/// Functions of one number by functions of its type.
macro_rules! functions {
    ($($name:ident = $function:path;)*) => {
        $(
            #[inline]
            fn $name(self) -> Self {
                $function(self)
            }
        )*
    };
}

/// Operations that are the same in every precision.
macro_rules! comparisons {
    ($float:ident) => {
        #[inline]
        fn abs(self) -> Self {
            $float::abs(self)
        }
        #[inline]
        fn sign(self) -> Self {
            match self {
                x if x > 0.0 => 1.0,
                x if x < 0.0 => -1.0,
                zero_or_nan => zero_or_nan,
            }
        }
        #[inline]
        fn select_less(lhs: Self, rhs: Self, then: Self, otherwise: Self) -> Self {
            if lhs < rhs { then } else { otherwise }
        }
        #[inline(always)]
        fn is_less(lhs: Self, rhs: Self) -> Option<bool> {
            Some(lhs < rhs)
        }
    };
}

impl Real for f64 {
    #[inline]
    fn of(value: f64) -> Self {
        value
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        libm::sincos(self)
    }
    functions! {
        sqrt = libm::sqrt;
        tan = libm::tan;
        asin = libm::asin;
        acos = libm::acos;
        atan = libm::atan;
        exp = libm::exp;
        ln = libm::log;
    }
    #[inline]
    fn atan2(self, x: Self) -> Self {
        libm::atan2(self, x)
    }
    comparisons!(f64);
    #[inline]
    fn table(self, table: &Table) -> (Self, Self, Self) {
        table.evaluate(self)
    }
    #[inline]
    fn map(self, function: fn(f64) -> (f64, f64, f64)) -> (Self, Self, Self) {
        function(self)
    }
}

impl Real for f32 {
    #[inline]
    fn of(value: f64) -> Self {
        value as f32
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        single::sin_cos(self)
    }
    functions! {
        sqrt = libm::sqrtf;
        tan = single::tan;
        asin = single::asin;
        acos = libm::acosf;
        atan = libm::atanf;
        exp = libm::expf;
        ln = libm::logf;
    }
    #[inline]
    fn atan2(self, x: Self) -> Self {
        libm::atan2f(self, x)
    }
    comparisons!(f32);
    #[inline]
    fn table(self, table: &Table) -> (Self, Self, Self) {
        table.evaluate_single(self)
    }
    #[inline]
    fn map(self, function: fn(f64) -> (f64, f64, f64)) -> (Self, Self, Self) {
        narrow(function(f64::from(self)))
    }
}

/// A value and its two derivatives, each rounded once.
fn narrow((value, first, second): (f64, f64, f64)) -> (f32, f32, f32) {
    (value as f32, first as f32, second as f32)
}
