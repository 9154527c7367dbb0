//! Numbers of twice the precision of a double: an unevaluated sum of two. Knuth's and Dekker's error-free sum and product; see
//! Hida, Li, Bailey: Algorithms for quad-double precision floating point arithmetic, 2001.

use std::ops::{Add, Mul, Neg, Sub};

/// The number `high` + `low`, |`low`| at most half a unit in the last place of `high`.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Twofold {
    pub(crate) high: f64,
    pub(crate) low: f64,
}

/// 2π.
pub(crate) const TAU: Twofold = Twofold { high: std::f64::consts::TAU, low: 2.449_293_598_294_706_4e-16 };

impl Twofold {
    /// high + low, of which the first is not the smaller one.
    fn normal(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self { high: sum, low: low - (sum - high) }
    }

    /// This times a power of two.
    fn scaled(self, power: f64) -> Self {
        Self { high: self.high * power, low: self.low * power }
    }

    /// Sine and cosine: Taylor's series at an angle 2⁻⁸ as large, which is then doubled eight times.
    pub(crate) fn sincos(self) -> (Self, Self) {
        let angle = self.scaled(1.0 / 256.0);
        let square = angle * angle;
        // Sine and 1 − cosine, which keeps its digits when it is doubled.
        let (mut sine, mut rest) = (Self::default(), Self::default());
        for k in (1..=12).rev() {
            let k = f64::from(k);
            sine = Self::from(1.0) - square * sine.over(2.0 * k * (2.0 * k + 1.0));
            rest = Self::from(1.0) - square * rest.over((2.0 * k + 1.0) * (2.0 * k + 2.0));
        }
        (sine, rest) = (angle * sine, (square * rest).scaled(0.5));
        for _ in 0..8 {
            (sine, rest) = ((sine - sine * rest).scaled(2.0), (sine * sine).scaled(2.0));
        }
        (sine, Self::from(1.0) - rest)
    }

    /// This divided by a double.
    fn over(self, divisor: f64) -> Self {
        let high = self.high / divisor;
        let rest = self - Self::from(high) * Self::from(divisor);
        Self::normal(high, rest.high / divisor)
    }
}

impl From<f64> for Twofold {
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

impl Add for Twofold {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let sum = self.high + other.high;
        let part = sum - self.high;
        let error = (self.high - (sum - part)) + (other.high - part);
        Self::normal(sum, error + (self.low + other.low))
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
        let product = self.high * other.high;
        let error = self.high.mul_add(other.high, -product);
        Self::normal(product, error + (self.high * other.low + self.low * other.high))
    }
}
