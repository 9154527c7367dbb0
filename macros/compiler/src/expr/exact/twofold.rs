//! Numbers of about 106 bits as an unevaluated sum of two `f64`, for powers of π and functions of constants.
//!
//! The algorithms are Dekker's and Knuth's, as in T. J. Dekker, *A floating-point technique for
//! extending the available precision*, Numer. Math. 18 (1971).

/// The sum of `high` and `low`, where `high` is the sum rounded to nearest.
#[derive(Clone, Copy, Debug)]
pub(in crate::expr) struct Twofold {
    high: f64,
    low: f64,
}

impl Twofold {
    /// π
    pub(in crate::expr) const PI: Twofold = Twofold { high: std::f64::consts::PI, low: 1.224_646_799_147_353_2e-16 };

    /// A whole number below 2¹²⁰.
    pub(in crate::expr) fn from_integer(value: u128) -> Twofold {
        let high = value as f64;
        let rest = value as i128 - high as i128;
        Twofold::sum(high, rest as f64)
    }

    /// A small whole number.
    pub(in crate::expr) fn whole(value: i64) -> Twofold {
        Twofold { high: value as f64, low: 0.0 }
    }

    /// x · y
    pub(in crate::expr) fn mul(self, other: Twofold) -> Twofold {
        let product = Twofold::product(self.high, other.high);
        let cross = self.high.mul_add(other.low, self.low * other.high);
        Twofold::sum(product.high, product.low + cross)
    }

    /// x / y
    pub(in crate::expr) fn div(self, other: Twofold) -> Twofold {
        let first = self.high / other.high;
        let rest = self.minus(other.times(first));
        let second = rest.high / other.high;
        let third = rest.minus(other.times(second)).high / other.high;
        let leading = Twofold::sum(first, second);
        Twofold::sum(leading.high, leading.low + third)
    }

    /// xⁿ
    pub(in crate::expr) fn power(self, exponent: u8) -> Twofold {
        let one = Twofold::whole(1);
        (0..exponent).fold(one, |product, _| product.mul(self))
    }

    /// x + y
    pub(in crate::expr) fn plus(self, other: Twofold) -> Twofold {
        let sum = Twofold::sum(self.high, other.high);
        Twofold::sum(sum.high, sum.low + (self.low + other.low))
    }

    /// x − y
    pub(in crate::expr) fn minus(self, other: Twofold) -> Twofold {
        self.plus(other.neg())
    }

    /// −x
    pub(in crate::expr) fn neg(self) -> Twofold {
        Twofold { high: -self.high, low: -self.low }
    }

    /// √x; `None` unless x > 0.
    pub(in crate::expr) fn sqrt(self) -> Option<Twofold> {
        let root = libm::sqrt(self.high);
        let rest = self.minus(Twofold::product(root, root));
        (root > 0.0).then(|| Twofold::sum(root, rest.high / (2.0 * root)))
    }

    /// sin x and cos x, by their series about the nearest multiple of π/2; `None` for |x| above 1000, where the multiple is not exact
    /// enough.
    pub(in crate::expr) fn sine_and_cosine(self) -> Option<[Twofold; 2]> {
        let quarter = Twofold::PI.times(0.5);
        let turns = libm::round(self.high / quarter.high);
        let rest = self.minus(quarter.times(turns));
        let mut sums = [Twofold::whole(0); 2];
        let mut term = Twofold::whole(1);
        // (π/4)³¹/31! is below 2⁻¹²⁰.
        for order in 0..31_u8 {
            let sum = &mut sums[usize::from(order % 2)];
            *sum = if order % 4 < 2 { sum.plus(term) } else { sum.minus(term) };
            term = term.mul(rest).div(Twofold::whole(i64::from(order) + 1));
        }
        let [cosine, sine] = sums;
        let found = match libm::fmod(turns, 4.0) as i8 {
            0 => [sine, cosine],
            1 | -3 => [cosine, sine.neg()],
            2 | -2 => [sine.neg(), cosine.neg()],
            _ => [cosine.neg(), sine],
        };
        (self.high.abs() < 1000.0).then_some(found)
    }

    /// The nearest `f64`.
    pub(in crate::expr) fn round(self) -> f64 {
        self.high + self.low
    }

    fn times(self, factor: f64) -> Twofold {
        self.mul(Twofold { high: factor, low: 0.0 })
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
