//! Decimal strings with more digits than a double has.

/// A decimal number as the nearest double and the remainder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decimal {
    /// The nearest double.
    pub value: f64,
    /// The number minus `value`, to some fifteen digits.
    pub rest: f64,
}

/// Digits kept when the nearest double is subtracted; `i128` holds 38.
const DIGITS: usize = 36;

impl Decimal {
    /// Parses decimal numbers such as `-1.25e-3`.
    ///
    /// # Panics
    /// If the text is not a number of at most 36 digits.
    #[must_use]
    pub fn parse(text: &str) -> Self {
        let value: f64 = text.parse().unwrap_or_else(|_| panic!("`{text}` is not a number"));
        // Rust prints any requested number of digits of a double exactly.
        let (written, nearest) = (digits(text), digits(&format!("{value:.*e}", DIGITS - 1)));
        let lowest = written.1.min(nearest.1);
        let shifted = |(mantissa, exponent): (i128, i32)| mantissa * 10_i128.pow((exponent - lowest).unsigned_abs());
        let rest = if written.0 == 0 { 0.0 } else { (shifted(written) - shifted(nearest)) as f64 * 10_f64.powi(lowest) };
        Self { value, rest }
    }

    /// |x − the number|, accurate even far below the spacing of doubles.
    #[must_use]
    pub fn error_of(self, x: f64) -> f64 {
        ((x - self.value) - self.rest).abs()
    }
}

/// Mantissa with [`DIGITS`] digits, and exponent of ten.
fn digits(text: &str) -> (i128, i32) {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let exponent: i32 = exponent.parse().expect("an exponent");
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let value: i128 = format!("{whole}{fraction}").parse().expect("digits");
    let exponent = exponent - fraction.len() as i32;
    let missing = DIGITS as i32 - value.unsigned_abs().to_string().len() as i32;
    if value == 0 { (0, exponent) } else { (value * 10_i128.pow(missing.max(0).unsigned_abs()), exponent - missing.max(0)) }
}
