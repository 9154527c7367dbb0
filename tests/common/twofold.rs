//! Numbers of double the precision: the sum of two doubles, 32 digits.
//!
//! Dekker: A floating-point technique for extending the available precision, 1971; Knuth: The Art of Computer Programming, 4.2.2.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use reuleaux::{Real, Table};

/// `high` + `low`, with `low` below a rounding of `high`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Twofold {
    /// The nearest double.
    pub high: f64,
    /// The rest.
    pub low: f64,
}

/// π/2
const QUARTER: Twofold = Twofold { high: std::f64::consts::FRAC_PI_2, low: 6.123233995736766e-17 };

/// a + b as a double and its rounding error.
fn sum(a: f64, b: f64) -> Twofold {
    let high = a + b;
    let part = high - a;
    Twofold { high, low: (a - (high - part)) + (b - part) }
}

/// a b as a double and its rounding error.
fn product(a: f64, b: f64) -> Twofold {
    let high = a * b;
    Twofold { high, low: a.mul_add(b, -high) }
}

impl Twofold {
    const ZERO: Self = Self { high: 0.0, low: 0.0 };

    /// Two Newton steps from a double; each doubles the number of digits.
    fn refined(guess: f64, step: impl Fn(Self) -> Self) -> Self {
        let first = step(Self::of(guess));
        step(first)
    }

    /// Σ terms, each computed from the previous one and its index, until they no longer contribute.
    fn series(first: Self, next: impl Fn(Self, f64) -> Self) -> Self {
        let (mut total, mut term) = (first, first);
        for number in 1..40 {
            term = next(term, f64::from(number));
            total = total + term;
        }
        total
    }
}

impl From<f64> for Twofold {
    fn from(value: f64) -> Self {
        Self::of(value)
    }
}

impl Add for Twofold {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (high, low) = (sum(self.high, other.high), sum(self.low, other.low));
        let first = sum(high.high, high.low + low.high);
        sum(first.high, first.low + low.low)
    }
}

impl Neg for Twofold {
    type Output = Self;
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for Twofold {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Twofold {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let most = product(self.high, other.high);
        sum(most.high, most.low + (self.high * other.low + self.low * other.high))
    }
}

impl Div for Twofold {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self - other * Self::of(first);
        let second = rest.high / other.high;
        let rest = rest - other * Self::of(second);
        sum(first, second) + Self::of(rest.high / other.high)
    }
}

impl PartialOrd for Twofold {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        (*self - *other).high.partial_cmp(&0.0)
    }
}

impl Real for Twofold {
    fn of(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }

    /// Reduces the angle modulo quarter turns, sums the series, then applies the quarter turns.
    fn sin_cos(self) -> (Self, Self) {
        let (mut rest, mut quarters) = (self, 0.0_f64);
        // Several passes for a large angle, since the number of quarter turns is rounded.
        for _ in 0..3 {
            let more = (rest / QUARTER).high.round();
            rest = rest - QUARTER * Self::of(more);
            quarters = quarters.rem_euclid(4.0) + more.rem_euclid(4.0);
        }
        let square = -(rest * rest);
        let sine = Self::series(rest, |term, n| term * square / Self::of(2.0 * n * (2.0 * n + 1.0)));
        let cosine = Self::series(Self::of(1.0), |term, n| term * square / Self::of(2.0 * n * (2.0 * n - 1.0)));
        match quarters.rem_euclid(4.0) as u8 {
            0 => (sine, cosine),
            1 => (cosine, -sine),
            2 => (-sine, -cosine),
            _ => (-cosine, sine),
        }
    }

    fn sqrt(self) -> Self {
        if self.high <= 0.0 {
            return Self::of(self.high.sqrt());
        }
        Self::refined(self.high.sqrt(), |root| (root + self / root) * Self::of(0.5))
    }

    fn tan(self) -> Self {
        let (sine, cosine) = self.sin_cos();
        sine / cosine
    }

    fn asin(self) -> Self {
        self.atan2((Self::of(1.0) - self * self).sqrt())
    }

    fn acos(self) -> Self {
        (Self::of(1.0) - self * self).sqrt().atan2(self)
    }

    fn atan(self) -> Self {
        self.atan2(Self::of(1.0))
    }

    fn atan2(self, x: Self) -> Self {
        let size = x * x + self * self;
        if size == Self::ZERO {
            return Self::of(self.high.atan2(x.high));
        }
        let length = size.sqrt();
        Self::refined(self.high.atan2(x.high), |angle| {
            let (sine, cosine) = angle.sin_cos();
            angle + (self * cosine - x * sine) / length
        })
    }

    fn exp(self) -> Self {
        let twos = (self.high / std::f64::consts::LN_2).round();
        let rest = (self - Self::of(2.0).ln() * Self::of(twos)) * Self::of(1.0 / 256.0);
        let mut power = Self::series(Self::of(1.0), |term, n| term * rest / Self::of(n));
        for _ in 0..8 {
            power = power * power;
        }
        power * Self::of(twos.exp2())
    }

    /// 2 artanh((m − 1) / (m + 1)) by its series, m between √½ and √2.
    fn ln(self) -> Self {
        if !(self.high > 0.0 && self.high.is_finite()) {
            return Self::of(self.high.ln());
        }
        let twos = if self.high == 2.0 && self.low == 0.0 { 0.0 } else { self.high.log2().round() };
        let mantissa = self * Self::of((-twos).exp2());
        let ratio = (mantissa - Self::of(1.0)) / (mantissa + Self::of(1.0));
        let square = ratio * ratio;
        let (mut total, mut power) = (ratio, ratio);
        for number in 1..80 {
            power = power * square;
            total = total + power / Self::of(f64::from(2 * number + 1));
        }
        let logarithm = total + total;
        if twos == 0.0 { logarithm } else { logarithm + Self::of(2.0).ln() * Self::of(twos) }
    }

    fn abs(self) -> Self {
        if self.high < 0.0 { -self } else { self }
    }

    fn sign(self) -> Self {
        Self::of(Real::sign(self.high))
    }

    fn select_less(lhs: Self, rhs: Self, then: Self, otherwise: Self) -> Self {
        if lhs < rhs { then } else { otherwise }
    }

    /// Accurate to double precision, then linear along the tangent.
    fn table(self, table: &Table) -> (Self, Self, Self) {
        let (value, first, second) = table.evaluate(self.high);
        (Self::of(value) + Self::of(first) * Self::of(self.low), Self::of(first), Self::of(second))
    }

    /// Accurate to double precision, then linear along the tangent.
    fn map(self, function: fn(f64) -> (f64, f64, f64)) -> (Self, Self, Self) {
        let (value, first, second) = function(self.high);
        (Self::of(value) + Self::of(first) * Self::of(self.low), Self::of(first), Self::of(second))
    }
}
