//! Reading literals. Digits come in, an exact number goes out, or nothing when it does not fit.

use super::Exact;

impl Exact {
    /// Reads an unsigned decimal literal such as `12.5e-3` or `1_000`, exactly.
    ///
    /// `None` when it is not one, or does not fit.
    #[must_use]
    pub fn decimal(digits: &str) -> Option<Exact> {
        let (mantissa, exponent) = match digits.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, power_of_ten(exponent)?),
            None => (digits, 0),
        };
        let (value, shift) = significant(mantissa)?;
        let mut exact = Exact::reduced(value, 1, 0)?;
        let ten = Exact::integer(10);
        let mut rest = exponent.checked_add(shift)?;
        // A number other than 0 leaves the range after at most 120 factors.
        while rest != 0 && !exact.is_zero() {
            exact = if rest > 0 { exact.checked_mul(ten)? } else { exact.checked_div(ten)? };
            rest -= rest.signum();
        }
        Some(exact)
    }
}

/// The digits of a mantissa without trailing zeros as a whole number, and the power of ten that
/// belongs to it.
fn significant(mantissa: &str) -> Option<(i128, i64)> {
    let (mut value, mut zeros, mut decimals) = (0_i128, 0_i64, 0_i64);
    let (mut after_point, mut any) = (false, false);
    for character in mantissa.chars() {
        match character {
            '_' if any => {}
            '.' if !after_point => after_point = true,
            '0'..='9' => {
                any = true;
                decimals += i64::from(after_point);
                zeros += 1;
                let digit = i128::from(character as u32 - '0' as u32);
                // Zeros wait for a digit behind them, so that `1.000…` always fits.
                if digit != 0 {
                    for _ in 0..zeros {
                        value = value.checked_mul(10)?;
                    }
                    value = value.checked_add(digit)?;
                    zeros = 0;
                }
            }
            _ => return None,
        }
    }
    any.then_some((value, zeros - decimals))
}

fn power_of_ten(exponent: &str) -> Option<i64> {
    let digits: String = exponent.chars().filter(|&c| c != '_').collect();
    // An exponent with more digits than `i32` takes does not fit in any case.
    digits.parse::<i32>().ok().map(i64::from)
}
