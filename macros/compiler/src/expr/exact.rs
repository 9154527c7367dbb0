//! Exact numbers: a rational times a power of π.
//!
//! Literals and unit factors come in; the nearest `f64` goes out, rounded once. An operation whose exact result does not fit returns
//! `None`, and the caller keeps it as an operation.

mod decimal;
mod rounding;
mod twofold;

pub(super) use twofold::Twofold;

/// A rational number times an integer power of π.
///
/// Always reduced: one value, one representation. Numerator and denominator stay below 2¹²⁰, so
/// that a remainder can be doubled and a numerator multiplied by 12 without overflow.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Exact {
    numerator: i128,
    denominator: i128,
    pi: i8,
}

const LIMIT: u128 = 1 << 120;

impl Exact {
    /// 0
    pub const ZERO: Exact = Exact { numerator: 0, denominator: 1, pi: 0 };
    /// 1
    pub const ONE: Exact = Exact { numerator: 1, denominator: 1, pi: 0 };
    /// π
    pub const PI: Exact = Exact { numerator: 1, denominator: 1, pi: 1 };

    /// A whole number.
    #[must_use]
    pub const fn integer(value: i64) -> Exact {
        Exact { numerator: value as i128, denominator: 1, pi: 0 }
    }

    /// A quotient of whole numbers; `None` when the divisor is 0 or the result does not fit.
    #[must_use]
    pub fn ratio(numerator: i128, denominator: i128) -> Option<Exact> {
        Exact::reduced(numerator, denominator, 0)
    }

    /// The numerator of the rational factor; carries the sign.
    #[must_use]
    pub(crate) const fn numerator(self) -> i128 {
        self.numerator
    }

    /// The denominator of the rational factor; positive.
    #[must_use]
    pub const fn denominator(self) -> i128 {
        self.denominator
    }

    /// The power of π.
    #[must_use]
    pub(crate) const fn pi_power(self) -> i8 {
        self.pi
    }

    /// True if the number is 0.
    #[must_use]
    pub const fn is_zero(self) -> bool {
        self.numerator == 0
    }

    /// True if the number is 1.
    #[must_use]
    pub fn is_one(self) -> bool {
        self == Exact::ONE
    }

    /// −1, 0 or 1.
    #[must_use]
    pub const fn signum(self) -> i32 {
        self.numerator.signum() as i32
    }

    /// −x
    #[must_use]
    pub const fn neg(self) -> Exact {
        Exact { numerator: -self.numerator, ..self }
    }

    /// |x|
    #[must_use]
    pub const fn abs(self) -> Exact {
        Exact { numerator: self.numerator.abs(), ..self }
    }

    /// x + y; `None` when it does not fit, as for different powers of π.
    #[must_use]
    pub(crate) fn checked_add(self, other: Exact) -> Option<Exact> {
        if self.is_zero() {
            return Some(other);
        }
        if other.is_zero() {
            return Some(self);
        }
        if self.pi != other.pi {
            return None;
        }
        let common = greatest_common_divisor(self.denominator, other.denominator);
        let own = self.numerator.checked_mul(other.denominator / common)?;
        let others = other.numerator.checked_mul(self.denominator / common)?;
        let denominator = (self.denominator / common).checked_mul(other.denominator)?;
        Exact::reduced(own.checked_add(others)?, denominator, self.pi)
    }

    /// x − y; `None` when it does not fit.
    #[must_use]
    pub fn checked_sub(self, other: Exact) -> Option<Exact> {
        self.checked_add(other.neg())
    }

    /// x · y; `None` when it does not fit.
    #[must_use]
    pub(crate) fn checked_mul(self, other: Exact) -> Option<Exact> {
        // Reducing crosswise first keeps the products as small as the result.
        let left = Exact::reduced(self.numerator, other.denominator, 0)?;
        let right = Exact::reduced(other.numerator, self.denominator, 0)?;
        let numerator = left.numerator.checked_mul(right.numerator)?;
        let denominator = left.denominator.checked_mul(right.denominator)?;
        Exact::reduced(numerator, denominator, self.pi.checked_add(other.pi)?)
    }

    /// x / y; `None` when y is 0 or the result does not fit.
    #[must_use]
    pub(crate) fn checked_div(self, other: Exact) -> Option<Exact> {
        let inverse = Exact::reduced(other.denominator, other.numerator, other.pi.checked_neg()?)?;
        self.checked_mul(inverse)
    }

    /// √x if it is exact, for squares of rationals times an even power of π.
    #[must_use]
    pub(crate) fn checked_sqrt(self) -> Option<Exact> {
        if self.numerator < 0 || self.pi % 2 != 0 {
            return None;
        }
        let numerator = exact_root(self.numerator)?;
        Exact::reduced(numerator, exact_root(self.denominator)?, self.pi / 2)
    }

    fn reduced(numerator: i128, denominator: i128, pi: i8) -> Option<Exact> {
        if denominator == 0 {
            return None;
        }
        if numerator == 0 {
            return Some(Exact::ZERO);
        }
        let common = gcd(numerator.unsigned_abs(), denominator.unsigned_abs());
        let (above, below) = (numerator.unsigned_abs() / common, denominator.unsigned_abs() / common);
        if above >= LIMIT || below >= LIMIT {
            return None;
        }
        let negative = (numerator < 0) != (denominator < 0);
        let numerator = if negative { -(above as i128) } else { above as i128 };
        Some(Exact { numerator, denominator: below as i128, pi })
    }
}

fn greatest_common_divisor(a: i128, b: i128) -> i128 {
    // Both are below the limit, so that the result fits again.
    gcd(a.unsigned_abs(), b.unsigned_abs()) as i128
}

fn gcd(mut a: u128, mut b: u128) -> u128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

fn exact_root(square: i128) -> Option<i128> {
    let root = square.checked_isqrt()?;
    (root * root == square).then_some(root)
}
