//! Double-double arithmetic, for the centres of balls. Error bounds are the business of [`Ball`](super::Ball).
//!
//! With u = 2⁻⁵³ the relative errors are at most 3u² + 13u³ for a sum, 7u² for a product and 15u² + 56u³ for a quotient, without
//! overflow or subnormal numbers (Joldes, Muller, Popescu: Tight and rigorous error bounds for basic building blocks of
//! double-word arithmetic, ACM TOMS 44, 2017: algorithms 6, 10 and 17). No fused operations: the bits are the same everywhere.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// `high` + `low`, with `high` the double nearest to the sum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Twofold {
    pub(super) high: f64,
    pub(super) low: f64,
}

/// a + b as a double and the remainder (Knuth: The Art of Computer Programming, 4.2.2).
fn sum(a: f64, b: f64) -> Twofold {
    let high = a + b;
    let part = high - a;
    Twofold { high, low: (a - (high - part)) + (b - part) }
}

/// The same for |a| ≥ |b| or a = 0.
fn ordered_sum(a: f64, b: f64) -> Twofold {
    let high = a + b;
    Twofold { high, low: b - (high - a) }
}

/// The first 26 bits of a number and the others.
fn halves(a: f64) -> (f64, f64) {
    let shifted = 134_217_729.0 * a; // 2²⁷ + 1
    let high = shifted - (shifted - a);
    (high, a - high)
}

/// a b as a double and the remainder (Dekker: A floating-point technique for extending the available precision, 1971).
fn product(a: f64, b: f64) -> Twofold {
    let high = a * b;
    let ((a1, a0), (b1, b0)) = (halves(a), halves(b));
    Twofold { high, low: ((a1 * b1 - high) + a1 * b0 + a0 * b1) + a0 * b0 }
}

impl Twofold {
    /// A double.
    pub(super) const fn of(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }

    /// Times a power of two.
    pub(super) fn scaled(self, power: f64) -> Self {
        Self { high: self.high * power, low: self.low * power }
    }

    /// √x for x > 0 by one step of Newton's method from the root of the double.
    pub(super) fn sqrt(self) -> Self {
        let root = libm::sqrt(self.high);
        let rest = self - product(root, root);
        ordered_sum(root, rest.high / (2.0 * root))
    }
}

impl Add for Twofold {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (high, low) = (sum(self.high, other.high), sum(self.low, other.low));
        let first = ordered_sum(high.high, high.low + low.high);
        ordered_sum(first.high, first.low + low.low)
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
        ordered_sum(most.high, most.low + (self.high * other.low + self.low * other.high))
    }
}

impl Div for Twofold {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self - other * Self::of(first);
        ordered_sum(first, rest.high / other.high)
    }
}

#[cfg(test)]
mod tests {
    use super::Twofold;

    const U2: f64 = f64::EPSILON * f64::EPSILON / 4.0;

    /// Numbers with digits everywhere.
    fn numbers() -> impl Iterator<Item = Twofold> {
        (1..200).map(|n| {
            let n = f64::from(n);
            Twofold::of(libm::sin(n) * libm::exp2(libm::fmod(n * 7.0, 40.0) - 20.0)) + Twofold::of(libm::cos(n) * 1e-20)
        })
    }

    #[test]
    fn sums_and_products_are_undone() {
        for (a, b) in numbers().zip(numbers().skip(7)) {
            let size = a.high.abs() + b.high.abs();
            assert!((((a + b) - b) - a).high.abs() <= 8.0 * U2 * size);
            assert!((((a * b) / b) - a).high.abs() <= 32.0 * U2 * a.high.abs());
        }
    }

    #[test]
    fn roots_squared_are_the_numbers() {
        for a in numbers().map(|a| if a.high < 0.0 { -a } else { a }) {
            let root = a.sqrt();
            assert!((root * root - a).high.abs() <= 16.0 * U2 * a.high);
        }
    }

    #[test]
    fn products_of_integers_are_exact() {
        let square = Twofold::of(9_007_199_254_740_991.0) * Twofold::of(9_007_199_254_740_989.0);
        // (2⁵³ − 1)(2⁵³ − 3) = 2¹⁰⁶ − 2⁵⁵ + 3
        let whole = Twofold::of(libm::exp2(106.0)) - Twofold::of(libm::exp2(55.0));
        assert_eq!((square - whole).high, 3.0);
    }
}
