//! Parses literals to exact numbers; `None` if one does not fit.

use super::Exact;

/// Largest number of digits in a numerator.
const MOST: usize = 37;

/// Fewest digits when rounding. The error of the last one is then ten thousand times finer than that of an `f64`.
const FEWEST: usize = 20;

impl Exact {
    /// Parses an unsigned decimal literal such as `12.5e-3` or `1_000`, exactly.
    ///
    /// `None` if the text is not a literal or does not fit.
    #[must_use]
    pub fn decimal(literal: &str) -> Option<Exact> {
        let (digits, exponent) = significant(literal)?;
        if digits.len() > MOST { None } else { scaled(&digits, exponent, Exact::ONE) }
    }

    /// Parses a decimal literal in a unit of this size: exactly, or rounded to as many digits as fit.
    ///
    /// `None` if the text is not a literal, is out of range, or has to be rounded to fewer than twenty digits.
    #[must_use]
    pub fn measured(literal: &str, size: Exact) -> Option<Exact> {
        let (digits, exponent) = significant(literal)?;
        let longest = digits.len().min(MOST);
        (FEWEST.min(longest)..=longest).rev().find_map(|kept| {
            let (rounded, shift) = rounded(&digits, kept);
            scaled(&rounded, exponent.checked_add(shift)?, size)
        })
    }
}

/// A whole number of at most 37 digits times a power of ten, times a size.
fn scaled(digits: &[u8], exponent: i64, size: Exact) -> Option<Exact> {
    let value = digits.iter().fold(0_i128, |value, digit| 10 * value + i128::from(*digit));
    let exact = Exact::reduced(value, 1, 0)?;
    let with_power = |exact: Exact| {
        let (mut exact, mut rest) = (exact, exponent);
        // A number other than 0 leaves the range after at most 120 factors.
        while rest != 0 && !exact.is_zero() {
            let ten = Exact::integer(10);
            exact = if rest > 0 { exact.checked_mul(ten)? } else { exact.checked_div(ten)? };
            rest -= rest.signum();
        }
        Some(exact)
    };
    // A product that does not fit in one order may fit in the other.
    with_power(exact).and_then(|exact| exact.checked_mul(size)).or_else(|| with_power(exact.checked_mul(size)?))
}

/// The first digits, rounded, and the power of ten that stands for the others.
fn rounded(digits: &[u8], kept: usize) -> (Vec<u8>, i64) {
    let mut first = digits[..kept].to_vec();
    if digits.get(kept).is_some_and(|next| *next >= 5) {
        let last = first.iter().rposition(|digit| *digit != 9);
        match last {
            Some(last) => {
                first[last] += 1;
                first[last + 1..].fill(0);
            }
            // 999… becomes 1000…
            None => {
                first.fill(0);
                first.insert(0, 1);
            }
        }
    }
    (first, (digits.len() - kept) as i64)
}

/// The digits of a literal without leading and trailing zeros, and the power of ten of the last digit.
fn significant(literal: &str) -> Option<(Vec<u8>, i64)> {
    let (mantissa, exponent) = match literal.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, power_of_ten(exponent)?),
        None => (literal, 0),
    };
    let (mut digits, mut decimals): (Vec<u8>, i64) = (Vec::new(), 0);
    let (mut after_point, mut any) = (false, false);
    for character in mantissa.chars() {
        match character {
            '_' if any => {}
            '.' if !after_point => after_point = true,
            '0'..='9' => {
                any = true;
                decimals += i64::from(after_point);
                if character != '0' || !digits.is_empty() {
                    digits.push(character as u8 - b'0');
                }
            }
            _ => return None,
        }
    }
    let written = digits.len();
    digits.truncate(digits.iter().rposition(|digit| *digit != 0).map_or(0, |last| last + 1));
    any.then_some(())?;
    let zeros = (written - digits.len()) as i64;
    Some((digits, exponent.checked_add(zeros - decimals)?))
}

fn power_of_ten(exponent: &str) -> Option<i64> {
    let digits: String = exponent.chars().filter(|&c| c != '_').collect();
    // An exponent with more digits than fit in an `i32` is out of range in any case.
    digits.parse::<i32>().ok().map(i64::from)
}
