//! Numbers of about 106 bits as an unevaluated sum of two `f64`, to round powers of π once.
//!
//! The algorithms are Dekker's and Knuth's, as in T. J. Dekker, *A floating-point technique for
//! extending the available precision*, Numer. Math. 18 (1971).

/// The sum of `high` and `low`, where `high` is the sum rounded to nearest.
#[derive(Clone, Copy)]
pub(super) struct Twofold {
    high: f64,
    low: f64,
}

impl Twofold {
    /// π
    pub(super) const PI: Twofold = Twofold { high: std::f64::consts::PI, low: 1.224_646_799_147_353_2e-16 };

    /// A whole number below 2¹²⁰.
    pub(super) fn from_integer(value: u128) -> Twofold {
        let high = value as f64;
        let rest = value as i128 - high as i128;
        Twofold::sum(high, rest as f64)
    }

    /// x · y
    pub(super) fn mul(self, other: Twofold) -> Twofold {
        let product = Twofold::product(self.high, other.high);
        let cross = self.high.mul_add(other.low, self.low * other.high);
        Twofold::sum(product.high, product.low + cross)
    }

    /// x / y
    pub(super) fn div(self, other: Twofold) -> Twofold {
        let first = self.high / other.high;
        let rest = self.minus(other.times(first));
        let second = rest.high / other.high;
        let third = rest.minus(other.times(second)).high / other.high;
        let leading = Twofold::sum(first, second);
        Twofold::sum(leading.high, leading.low + third)
    }

    /// xⁿ
    pub(super) fn power(self, exponent: u8) -> Twofold {
        let one = Twofold { high: 1.0, low: 0.0 };
        (0..exponent).fold(one, |product, _| product.mul(self))
    }

    /// The nearest `f64`.
    pub(super) fn round(self) -> f64 {
        self.high + self.low
    }

    fn times(self, factor: f64) -> Twofold {
        self.mul(Twofold { high: factor, low: 0.0 })
    }

    fn minus(self, other: Twofold) -> Twofold {
        let difference = Twofold::sum(self.high, -other.high);
        Twofold::sum(difference.high, difference.low + (self.low - other.low))
    }

    /// a + b without error.
    fn sum(a: f64, b: f64) -> Twofold {
        let high = a + b;
        let from_b = high - a;
        Twofold { high, low: (a - (high - from_b)) + (b - from_b) }
    }

    /// a · b without error.
    fn product(a: f64, b: f64) -> Twofold {
        let high = a * b;
        Twofold { high, low: a.mul_add(b, -high) }
    }
}
