//! A straight scale with round numbers.

use std::ops::Range;

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};

/// Largest number of steps on the abscissa.
const ACROSS: f64 = 8.0;

/// Largest number of steps on an ordinate.
const UP: f64 = 7.0;

/// Margin above and below curves, as a part of their height.
const MARGIN: f64 = 0.07;

/// Steps of angles in °: parts and multiples of a right angle, from 10° on.
const DEGREES: [f64; 8] = [10.0, 15.0, 30.0, 45.0, 60.0, 90.0, 120.0, 180.0];

/// A straight scale with numbers at the multiples of a step.
#[derive(Clone, Debug)]
pub(crate) struct Axis {
    pub(crate) range: Range<f64>,
    pub(crate) step: f64,
    /// Exponent of the power of ten in the unit.
    power: i32,
    unit: String,
}

impl Axis {
    /// An abscissa from the least to the largest of these values.
    pub(crate) fn over(values: &[f64], unit: &str) -> Axis {
        let Range { start, end } = span(values.iter().copied());
        Axis::of(start..end, unit, ACROSS)
    }

    /// An ordinate with room for these values.
    pub(crate) fn up(values: impl Iterator<Item = f64>, unit: &str) -> Axis {
        let Range { start, end } = span(values);
        let margin = MARGIN * (end - start);
        Axis::of(start - margin..end + margin, unit, UP)
    }

    fn of(range: Range<f64>, unit: &str, most: f64) -> Axis {
        let step = step((range.end - range.start) / most, unit == "°");
        let largest = range.start.abs().max(range.end.abs());
        let is_plain = largest < 1e5 && step >= 0.999e-4;
        let power = if is_plain { 0 } else { (largest.log10() / 3.0).floor() as i32 * 3 };
        Axis { range, step, power, unit: unit.to_owned() }
    }

    /// The unit of the numbers, with its power of ten.
    pub(crate) fn unit(&self) -> String {
        if self.power == 0 {
            return self.unit.clone();
        }
        let superscript = |digit: char| digit.to_digit(10).and_then(|digit| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(digit as usize)).unwrap_or('⁻');
        let exponent: String = self.power.to_string().chars().map(superscript).collect();
        format!("10{exponent} {}", self.unit).trim_end().to_owned()
    }

    /// A name with the unit.
    pub(crate) fn named(&self, name: &str) -> String {
        let unit = self.unit();
        if unit.is_empty() { name.to_owned() } else { format!("{name} in {unit}").trim_start().to_owned() }
    }

    /// Numbers on the axis.
    pub(crate) fn ticks(&self) -> Vec<f64> {
        let [first, last] = [self.range.start / self.step - 1e-6, self.range.end / self.step + 1e-6];
        (first.ceil() as i64..=last.floor() as i64).map(|number| number as f64 * self.step).collect()
    }

    /// A number as it is written: with enough decimals to distinguish multiples of the step, and a true minus sign.
    pub(crate) fn written(&self, value: f64) -> String {
        let (value, step) = (value / 10_f64.powi(self.power), self.step / 10_f64.powi(self.power));
        let decimals = (-(step.log10() + 1e-9).floor()).clamp(0.0, 12.0) as usize;
        let value = if value.abs() < 1e-6 * step { 0.0 } else { value };
        format!("{value:.decimals$}").replace('-', "−")
    }
}

/// Numbers beyond this one have no place on an axis.
pub(super) const LARGEST: f64 = 1e300;

/// Least and largest value with a place; around values that agree to rounding, a range that tells them apart from zero.
fn span(values: impl Iterator<Item = f64>) -> Range<f64> {
    let ends = |(low, high): (f64, f64), value: f64| (low.min(value), high.max(value));
    let (low, high) = values.filter(|value| value.abs() <= LARGEST).fold((f64::INFINITY, f64::NEG_INFINITY), ends);
    let largest = low.abs().max(high.abs());
    if low > high {
        -1.0..1.0
    } else if high - low > 1e-9 * largest {
        low..high
    } else if largest < f64::MIN_POSITIVE {
        -1.0..1.0
    } else {
        (low - 0.1 * largest)..(high + 0.1 * largest)
    }
}

/// The least round number that is not below `least`.
fn step(least: f64, is_degrees: bool) -> f64 {
    let least = least.max(f64::MIN_POSITIVE) * (1.0 - 1e-9);
    let decimal = |least: f64| {
        let power = 10_f64.powf(least.log10().floor());
        [1.0, 2.0, 5.0, 10.0].map(|factor| factor * power).into_iter().find(|step| *step >= least).unwrap_or(10.0 * power)
    };
    if is_degrees && least > 5.0 {
        DEGREES.into_iter().find(|step| *step >= least).unwrap_or_else(|| 360.0 * decimal(least / 360.0))
    } else {
        decimal(least)
    }
}

impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        let part = (value - self.range.start) / (self.range.end - self.range.start);
        limit.0 + (part * f64::from(limit.1 - limit.0)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.ticks()
    }
}

impl ValueFormatter<f64> for Axis {
    fn format(value: &f64) -> String {
        value.to_string()
    }

    fn format_ext(&self, value: &f64) -> String {
        self.written(*value)
    }
}
