//! Quantities in messages.

use core::fmt;

/// A quantity in common units with three digits: a length in mm or m, an angle in degrees.
pub(crate) struct Measure(pub(crate) f64, pub(crate) &'static str);

impl fmt::Display for Measure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let &Measure(value, unit) = self;
        let (shown, unit) = match unit {
            "m" if value.abs() < 10.0 => (value * 1e3, " mm"),
            "m" => (value, " m"),
            "rad" => (value.to_degrees(), "°"),
            "" | "1" => return write!(f, "{value:.2e}"),
            _ => return write!(f, "{value:.2e} {unit}"),
        };
        if shown != 0.0 && !(1e-3..1e6).contains(&shown.abs()) {
            return write!(f, "{shown:.2e}{unit}");
        }
        let decimals = if shown == 0.0 { 0 } else { (2.0 - libm::floor(libm::log10(shown.abs()))).max(0.0) as usize };
        write!(f, "{shown:.decimals$}{unit}")
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::Measure;
    use std::string::ToString;

    #[test]
    fn quantities_have_three_digits() {
        for (value, unit, shown) in [
            (0.01234, "m", "12.3 mm"),
            (-1.15e-3, "m", "-1.15 mm"),
            (2.5, "m", "2500 mm"),
            (1234.5, "m", "1234 m"),
            (3.0e-9, "m", "3.00e-6 mm"),
            (0.5, "rad", "28.6°"),
            (0.0, "rad", "0°"),
            (0.25, "m²", "2.50e-1 m²"),
            (-0.25, "", "-2.50e-1"),
            (f64::NAN, "m", "NaN m"),
            (f64::INFINITY, "m", "inf m"),
        ] {
            assert_eq!(Measure(value, unit).to_string(), shown);
        }
    }
}
