//! Intervals by centre and radius, rounded outward: arithmetic over all numbers that may be meant.
//!
//! ```text
//! ⟨a, r⟩ = { x : |x − a| ≤ r }
//! ⟨a, r⟩ ± ⟨b, s⟩ ⊂ ⟨a ± b, r + s⟩
//! ⟨a, r⟩ · ⟨b, s⟩ ⊂ ⟨a b, |a| s + r |b| + r s⟩
//! ⟨a, r⟩ / ⟨b, s⟩ ⊂ ⟨a / b, (r + |a/b| s) / (|b| − s)⟩
//! ```
//!
//! Centres have twice the digits of a double, so that what a ball has grown by in a few thousand operations is still far below a rounding
//! of a double. Each operation adds the error of its centre, 16u² = 2⁻¹⁰² of it where the literature proves less
//! ([`twofold`](super::twofold)), and rounds the radius up by a factor, so that no rounding mode is needed.
//! Rump: Fast and parallel interval arithmetic, BIT 39, 1999.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::twofold::Twofold;

/// A number known to within a radius.
///
/// Whatever is said of a ball is true of every number in it. What is not defined everywhere in the ball has an infinite radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ball {
    pub(super) center: Twofold,
    /// Not below zero, or NaN.
    pub(super) radius: f64,
    /// Nothing in it comes from a function that is known by its values at doubles only, or from beside a jump.
    pub(super) is_proven: bool,
}

/// Relative errors of centres are at most 15u² + 56u³ < 16u².
pub(super) const ROUNDING: f64 = 1.0 / 5.070_602_400_912_918e30; // 2⁻¹⁰²

/// Underflow in the rests of a product or a quotient costs less: factors below are in the range that makes it so.
const UNDERFLOW: f64 = 1e-180;

/// Divisors and dividends beyond this or below its inverse are not computed with.
const LARGEST: f64 = 1e120;

/// Not below a result of up to sixteen sums, products and quotients of numbers that are not negative, each of which was rounded.
pub(super) fn up(value: f64) -> f64 {
    value * (1.0 + 16.0 * f64::EPSILON) + f64::MIN_POSITIVE
}

/// Not above such a result, where it is not negative either.
pub(super) fn down(value: f64) -> f64 {
    value * (1.0 - 16.0 * f64::EPSILON) - f64::MIN_POSITIVE
}

/// The greater of the two, and NaN where one is.
pub(super) fn greater(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

impl Ball {
    /// A double, exactly.
    pub(super) const fn exact(value: f64) -> Self {
        Self::around(Twofold::of(value), 0.0)
    }

    /// All numbers this near to a centre.
    pub(super) const fn around(center: Twofold, radius: f64) -> Self {
        Self { center, radius, is_proven: true }
    }

    /// Any number.
    pub(super) const fn anything() -> Self {
        Self::around(Twofold::of(0.0), f64::INFINITY)
    }

    /// Of which nothing is proven.
    pub(super) fn doubted(self) -> Self {
        Self { is_proven: false, ..self }
    }

    /// With the doubts about another.
    pub(super) fn with_doubts_of(self, other: Self) -> Self {
        Self { is_proven: self.is_proven && other.is_proven, ..self }
    }

    /// It is one double.
    pub(super) fn is_double(self) -> bool {
        self.radius == 0.0 && self.center.low == 0.0
    }

    /// It is zero and nothing else.
    pub(super) fn is_zero(self) -> bool {
        self.is_double() && self.center.high == 0.0
    }

    /// The greatest magnitude in it.
    pub(super) fn magnitude(self) -> f64 {
        up(self.center.high.abs() + self.radius)
    }

    /// The least magnitude in it, or less; below zero where it contains zero.
    pub(super) fn least(self) -> f64 {
        let size = self.center.high.abs();
        if self.is_double() { size } else { (size - self.radius) - up(16.0 * f64::EPSILON * (size + self.radius)) }
    }

    /// Not below any number in it.
    pub(super) fn highest(self) -> f64 {
        let (high, radius) = (self.center.high, self.radius);
        if self.is_double() { high } else { (high + radius) + up(16.0 * f64::EPSILON * (high.abs() + radius)) }
    }

    /// Not above any number in it.
    pub(super) fn lowest(self) -> f64 {
        -(-self).highest()
    }

    /// It may be zero.
    pub(super) fn may_vanish(self) -> bool {
        let is_off_zero = self.least() > 0.0;
        !is_off_zero
    }

    /// A ball around the same centre in which the other lies as well.
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

    /// Whether each number in it is less than each in the other, or none is; None where it depends on which are meant.
    pub(super) fn is_less(self, other: Self) -> Option<bool> {
        let (is_less, is_not) = (self.highest() < other.lowest(), self.lowest() >= other.highest());
        (is_less || is_not).then_some(is_less)
    }

    /// A function that is known by its values and derivatives at doubles. There it is taken for exact; between them it is only
    /// estimated, from the derivatives.
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
