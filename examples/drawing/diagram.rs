//! Quantities over the crank angle or the time.

use std::ops::Range;

use plotters::chart::{ChartBuilder, ChartContext, LabelAreaPosition};
use plotters::coord::cartesian::Cartesian2d;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::element::{Circle, PathElement, Text};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{BLACK, Color, IntoFont, RGBColor, ShapeStyle, TRANSPARENT, TextStyle};

use super::{Area, Fallible, Ink, fine, stroke};

const GRID: RGBColor = RGBColor(222, 222, 222);
/// Room for the numbers and the name of the ordinate, in units of the picture.
const LEFT: f64 = 66.0;
/// Room for the numbers and the name of the abscissa.
pub(super) const BELOW: f64 = 42.0;
/// Room for the legend.
const ABOVE: f64 = 22.0;

/// Common abscissa of the diagrams of a plate.
#[derive(Clone, Debug)]
pub struct Abscissa {
    /// Name and unit.
    pub name: &'static str,
    /// Range.
    pub range: Range<f64>,
    /// Distance between numbers.
    pub step: f64,
}

/// Curves over a common abscissa.
#[derive(Clone, Debug)]
pub struct Diagram {
    name: &'static str,
    curves: Vec<Curve>,
}

#[derive(Clone, Debug)]
struct Curve {
    ink: Ink,
    name: &'static str,
    points: Vec<(f64, f64)>,
    is_dotted: bool,
}

type Chart<'a, 'b> = ChartContext<'a, plotters::backend::SVGBackend<'b>, Cartesian2d<Axis, Axis>>;

impl Diagram {
    /// A diagram whose ordinate has this name and unit.
    #[must_use]
    pub fn new(name: &'static str) -> Self {
        Self { name, curves: Vec::new() }
    }

    /// Adds a curve through these points.
    #[must_use]
    pub fn curve(self, ink: Ink, name: &'static str, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        self.with(Curve { ink, name, points: points.into_iter().collect(), is_dotted: false })
    }

    /// Adds circles at these points: independent results that a curve should go through.
    #[must_use]
    pub fn circles(self, name: &'static str, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        self.with(Curve { ink: Ink::Ground, name, points: points.into_iter().collect(), is_dotted: true })
    }

    fn with(mut self, curve: Curve) -> Self {
        self.curves.push(curve);
        self
    }

    pub(super) fn draw(&self, area: &Area, over: &Abscissa, is_last: bool) -> Fallible {
        let below = if is_last { fine(BELOW) } else { 0 };
        let x = Axis { range: over.range.clone(), step: over.step };
        let y = self.ordinate();
        let mut chart = ChartBuilder::on(area)
            .margin_top(fine(ABOVE))
            .margin_right(fine(14.0))
            .set_label_area_size(LabelAreaPosition::Left, fine(LEFT))
            .set_label_area_size(LabelAreaPosition::Bottom, below)
            .build_cartesian_2d(x, y)?;
        axes(&mut chart, if is_last { over.name } else { "" }, self.name)?;
        self.curves.iter().try_for_each(|curve| curve.draw(&chart))?;
        self.legend(area)
    }

    /// An axis with room for all points.
    fn ordinate(&self) -> Axis {
        let values = || self.curves.iter().flat_map(|curve| &curve.points).map(|point| point.1);
        let (low, high) = values().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), y| (low.min(y), high.max(y)));
        let margin = 0.08 * (high - low).max(1e-9 * high.abs()).max(f64::MIN_POSITIVE);
        Axis { range: low - margin..high + margin, step: round_number((high - low + 2.0 * margin) / 4.0) }
    }

    /// The names of the curves in a line above the diagram.
    fn legend(&self, area: &Area) -> Fallible {
        let (mut x, y) = (fine(LEFT), fine(ABOVE / 2.0));
        for curve in self.curves.iter().filter(|curve| !curve.name.is_empty()) {
            let (line, middle) = (ShapeStyle::from(curve.ink.line()).stroke_width(stroke(1.8)), x + fine(10.0));
            if curve.is_dotted {
                area.draw(&Circle::new((middle, y), fine(2.6), line.stroke_width(stroke(1.0))))?;
            } else {
                area.draw(&PathElement::new(vec![(x, y), (x + fine(20.0), y)], line))?;
            }
            let style = TextStyle::from(("sans-serif", fine(13.0)).into_font()).pos(Pos::new(HPos::Left, VPos::Center));
            area.draw(&Text::new(curve.name, (x + fine(26.0), y), style))?;
            x += fine(26.0 + 18.0 + 6.0 * curve.name.chars().count() as f64);
        }
        Ok(())
    }
}

impl Curve {
    fn draw(&self, chart: &Chart) -> Fallible {
        let area = chart.plotting_area();
        if self.is_dotted {
            let style = ShapeStyle::from(self.ink.line()).stroke_width(stroke(1.0));
            return Ok(self.points.iter().try_for_each(|&at| area.draw(&Circle::new(at, fine(2.6), style)))?);
        }
        Ok(area.draw(&PathElement::new(self.points.clone(), self.ink.line().stroke_width(stroke(1.8))))?)
    }
}

/// Draws grid, numbers and names of the axes.
fn axes(chart: &mut Chart, x: &str, y: &str) -> Fallible {
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(GRID.stroke_width(stroke(0.7)))
        .axis_style(BLACK.stroke_width(stroke(0.9)))
        .set_all_tick_mark_size(fine(3.0))
        .label_style(("sans-serif", fine(13.0)))
        .axis_desc_style(("sans-serif", fine(14.0)))
        .x_desc(x)
        .y_desc(y)
        .draw()?;
    Ok(())
}

/// A straight scale with numbers at the multiples of `step`.
struct Axis {
    range: Range<f64>,
    step: f64,
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
        let [first, last] = [self.range.start, self.range.end].map(|end| end / self.step);
        ((first - 1e-9).ceil() as i64..=(last + 1e-9).floor() as i64).map(|k| k as f64 * self.step).collect()
    }
}

impl ValueFormatter<f64> for Axis {
    fn format(value: &f64) -> String {
        value.to_string()
    }

    /// With enough decimals to distinguish multiples of the step, and a true minus sign.
    fn format_ext(&self, value: &f64) -> String {
        let decimals = (-(self.step.log10() + 1e-9).floor()).max(0.0) as usize;
        let value = if value.abs() < 1e-9 * self.step { 0.0 } else { *value };
        format!("{value:.decimals$}").replace('-', "−")
    }
}

/// The greatest of 1, 2 and 5 times a power of ten that does not exceed `size`.
pub(super) fn round_number(size: f64) -> f64 {
    let power = 10_f64.powf(size.log10().floor());
    power * [5.0, 2.0].into_iter().find(|factor| factor * power <= size * (1.0 + 1e-9)).unwrap_or(1.0)
}
