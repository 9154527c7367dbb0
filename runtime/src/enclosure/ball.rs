//! Interval arithmetic by centre and radius, rounded outward.
//!
//! ```text
//! ⟨a, r⟩ = { x : |x − a| ≤ r }
//! ⟨a, r⟩ ± ⟨b, s⟩ ⊂ ⟨a ± b, r + s⟩
//! ⟨a, r⟩ · ⟨b, s⟩ ⊂ ⟨a b, |a| s + r |b| + r s⟩
//! ⟨a, r⟩ / ⟨b, s⟩ ⊂ ⟨a / b, (r + |a/b| s) / (|b| − s)⟩
//! ```
//!
//! Centres have twice the digits of a double, so that the radius after a few thousand operations is still far below a rounding of a
//! double. Each operation adds the error of its centre, 16u² = 2⁻¹⁰² of it where the literature proves less
//! ([`twofold`](super::twofold)), and rounds the radius up by a factor, so that no rounding mode is needed.
//! Rump: Fast and parallel interval arithmetic, BIT 39, 1999.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::twofold::Twofold;

/// A number known to within a radius.
///
/// A function of a ball contains the function of every number in it. Where a function is not defined on the whole ball, the radius
/// of the result is infinite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ball {
    pub(super) center: Twofold,
    /// Not below zero, or NaN.
    pub(super) radius: f64,
    /// Whether it is proven: it depends neither on a function that is known only by its values at doubles, nor on an undecided
    /// condition.
    pub(super) is_proven: bool,
}

/// Relative errors of centres are at most 15u² + 56u³ < 16u².
pub(super) const ROUNDING: f64 = 1.0 / 5.070_602_400_912_918e30; // 2⁻¹⁰²

/// Bounds the error by underflow in the low parts of a product or quotient, for factors in the range below.
const UNDERFLOW: f64 = 1e-180;

/// Largest magnitude of divisors and dividends; the smallest is its inverse. Beyond, the result is unbounded.
const LARGEST: f64 = 1e120;

/// An upper bound of a result of up to sixteen rounded sums, products and quotients of non-negative numbers.
pub(super) fn up(value: f64) -> f64 {
    value * (1.0 + 16.0 * f64::EPSILON) + f64::MIN_POSITIVE
}

/// A lower bound of such a result, if that is non-negative.
pub(super) fn down(value: f64) -> f64 {
    value * (1.0 - 16.0 * f64::EPSILON) - f64::MIN_POSITIVE
}

/// The greater of the two; NaN if one is.
pub(super) fn greater(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

impl Ball {
    /// A double, exactly.
    pub(super) const fn exact(value: f64) -> Self {
        Self::around(Twofold::of(value), 0.0)
    }

    /// All numbers within a radius of a centre.
    pub(super) const fn around(center: Twofold, radius: f64) -> Self {
        Self { center, radius, is_proven: true }
    }

    /// Any number.
    pub(super) const fn anything() -> Self {
        Self::around(Twofold::of(0.0), f64::INFINITY)
    }

    /// The same ball, marked as not proven.
    pub(super) fn doubted(self) -> Self {
        Self { is_proven: false, ..self }
    }

    /// The same ball, marked as not proven if the other is not.
    pub(super) fn with_doubts_of(self, other: Self) -> Self {
        Self { is_proven: self.is_proven && other.is_proven, ..self }
    }

    /// Whether it is a single double.
    pub(super) fn is_double(self) -> bool {
        self.radius == 0.0 && self.center.low == 0.0
    }

    /// Whether it is exactly zero.
    pub(super) fn is_zero(self) -> bool {
        self.is_double() && self.center.high == 0.0
    }

    /// An upper bound of the magnitudes in it.
    pub(super) fn magnitude(self) -> f64 {
        up(self.center.high.abs() + self.radius)
    }

    /// A lower bound of the magnitudes in it; negative if it contains zero.
    pub(super) fn least(self) -> f64 {
        let size = self.center.high.abs();
        if self.is_double() { size } else { (size - self.radius) - up(16.0 * f64::EPSILON * (size + self.radius)) }
    }

    /// An upper bound of the numbers in it.
    pub(super) fn highest(self) -> f64 {
        let (high, radius) = (self.center.high, self.radius);
        if self.is_double() { high } else { (high + radius) + up(16.0 * f64::EPSILON * (high.abs() + radius)) }
    }

    /// A lower bound of the numbers in it.
    pub(super) fn lowest(self) -> f64 {
        -(-self).highest()
    }

    /// Whether it contains zero.
    pub(super) fn may_vanish(self) -> bool {
        let is_off_zero = self.least() > 0.0;
        !is_off_zero
    }

    /// A ball around the same centre that contains the other as well.
    pub(super) fn hull(self, other: Self) -> Self {
        let apart = (self - other).magnitude();
        Self { radius: greater(self.radius, up(apart + other.radius)), ..self.with_doubts_of(other) }
    }
}

impl Add for Ball {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return if self.is_zero() { other.with_doubts_of(self) } else { self.with_doubts_of(other) };
        }
        let center = self.center + other.center;
        let radius = up(self.radius + other.radius + ROUNDING * center.high.abs());
        Self { center, radius, is_proven: self.is_proven && other.is_proven }
    }
}

impl Neg for Ball {
    type Output = Self;
    fn neg(self) -> Self {
        Self { center: -self.center, ..self }
    }
}

impl Sub for Ball {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Ball {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let is_proven = self.is_proven && other.is_proven;
        if self.is_zero() && other.radius.is_finite() || other.is_zero() && self.radius.is_finite() {
            return Self { is_proven, ..Self::exact(0.0) };
        }
        let center = self.center * other.center;
        let (a, b) = (self.center.high.abs(), other.center.high.abs());
        let spread = up(up(a) * other.radius) + up(up(b) * self.radius) + up(self.radius * other.radius);
        Self { center, radius: up(spread + ROUNDING * center.high.abs() + UNDERFLOW), is_proven }
    }
}

impl Div for Ball {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let (a, b) = (self.center.high.abs(), other.center.high.abs());
        let least = other.least();
        if !(least > 0.0 && a <= LARGEST && (1.0 / LARGEST..=LARGEST).contains(&b)) {
            return Self::anything().with_doubts_of(self).with_doubts_of(other);
        }
        let center = self.center / other.center;
        let quotient = up(center.high.abs());
        let radius = up((self.radius + up(quotient * other.radius)) / least + ROUNDING * quotient + UNDERFLOW);
        Self { center, radius, is_proven: self.is_proven && other.is_proven }
    }
}

impl Ball {
    /// | |x| − |a| | ≤ |x − a|
    pub(super) fn abs(self) -> Self {
        Self { center: if self.center.high < 0.0 { -self.center } else { self.center }, ..self }
    }

    /// Whether every number in it is less than every number in the other; false if none is, None if undecided.
    pub(super) fn is_less(self, other: Self) -> Option<bool> {
        let (is_less, is_not) = (self.highest() < other.lowest(), self.lowest() >= other.highest());
        (is_less || is_not).then_some(is_less)
    }

    /// A function that is known by its values and derivatives at doubles. They are taken as exact there; between doubles they are
    /// estimated from the derivatives, and not proven.
    pub(super) fn map(self, function: fn(f64) -> (f64, f64, f64)) -> [Self; 3] {
        let (value, first, second) = function(self.center.high);
        let [v, d, dd] = [value, first, second].map(|value| Self::exact(value).with_doubts_of(self));
        if self.is_double() {
            return [v, d, dd];
        }
        let by = Self { center: Twofold::of(self.center.low), ..self };
        [v + d * by, d + dd * by, dd].map(|estimate| {
            let radius = up(estimate.radius + f64::EPSILON * estimate.center.high.abs());
            Self { radius, is_proven: false, ..estimate }
        })
    }
}
