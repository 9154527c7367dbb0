//! Rounds exact numbers to the nearest `f64`, and takes the exact value of an `f64`.

use super::Exact;
use super::twofold::Twofold;

impl Exact {
    /// The exact value of an `f64`; `None` if it does not fit.
    #[must_use]
    pub fn binary(value: f64) -> Option<Exact> {
        if value == 0.0 {
            return Some(Exact::ZERO);
        }
        // Of what is not finite it is an extreme integer.
        let exponent = libm::ilogb(value).saturating_sub(52);
        if !value.is_finite() || exponent.saturating_abs() > 118 {
            return None;
        }
        let (whole, power) = (libm::scalbn(value, -exponent) as i128, 1_i128 << exponent.abs());
        if exponent < 0 { Exact::ratio(whole, power) } else { Exact::ratio(whole.checked_mul(power)?, 1) }
    }

    /// The nearest `f64`, ties to even.
    ///
    /// Without a power of π integer arithmetic proves the rounding. With one the number is computed to about 100 bits and then rounded.
    #[must_use]
    pub fn to_f64(self) -> f64 {
        let (numerator, denominator) = (self.numerator.unsigned_abs(), self.denominator.unsigned_abs());
        if self.pi != 0 {
            return self.twofold().round();
        }
        let magnitude = nearest(numerator, denominator);
        if self.numerator < 0 { -magnitude } else { magnitude }
    }

    /// The number to about 100 bits.
    pub(in crate::expr) fn twofold(self) -> Twofold {
        let [above, below] = [self.numerator, self.denominator].map(|part| Twofold::from_integer(part.unsigned_abs()));
        let ratio = above.div(below);
        let power = Twofold::PI.power(self.pi.unsigned_abs());
        let value = if self.pi < 0 { ratio.div(power) } else { ratio.mul(power) };
        if self.numerator < 0 { value.neg() } else { value }
    }
}

/// The `f64` nearest to a quotient. Both operands are below 2¹²⁰, the divisor is not 0.
fn nearest(mut numerator: u128, mut denominator: u128) -> f64 {
    if numerator == 0 {
        return 0.0;
    }
    // Shifted to equal lengths, the quotient lies between 1/2 and 2.
    let exponent = denominator.leading_zeros() as i32 - numerator.leading_zeros() as i32;
    if exponent >= 0 {
        denominator <<= exponent;
    } else {
        numerator <<= -exponent;
    }
    let mut quotient = 0_u64;
    for _ in 0..64 {
        let bit = numerator >= denominator;
        quotient = quotient << 1 | u64::from(bit);
        numerator = (numerator - if bit { denominator } else { 0 }) << 1;
    }
    // 63 bits hold the mantissa and the rounding bit; the last one says whether more follows.
    quotient |= u64::from(numerator != 0);
    libm::ldexp(quotient as f64, exponent - 63)
}
