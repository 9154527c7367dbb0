//! Curves over the abscissa, drawn by plotters.

use plotters::backend::SVGBackend;
use plotters::chart::{ChartBuilder, ChartContext, LabelAreaPosition};
use plotters::coord::cartesian::Cartesian2d;
use plotters::drawing::{DrawingArea, DrawingAreaErrorKind, IntoDrawingArea};
use plotters::element::{Circle, PathElement};
use plotters::style::{Color, RGBColor, ShapeStyle, TRANSPARENT};

use super::FONTS;
use super::axis::{Axis, LARGEST};
use crate::recording::{Plot, Series};
use crate::unviewable::Unviewable;

/// Drawing units of plotters for each picture unit. It draws at whole units; this makes them fine enough.
pub(crate) const FINE: i32 = 8;

/// Room for numbers and unit of the ordinate, in picture units.
pub(crate) const LEFT: f64 = 60.0;

/// Room for one half of the last number of the abscissa.
pub(crate) const RIGHT: f64 = 14.0;

/// Room above the curves.
pub(crate) const ABOVE: f64 = 4.0;

/// Height of the curves.
pub(crate) const HEIGHT: f64 = 104.0;

/// Room for numbers and name of the abscissa.
const BELOW: f64 = 36.0;

/// Room below a diagram without them.
const NEXT: f64 = 4.0;

/// Least distance of circles.
const APART: f64 = 18.0;

/// plotters writes letters smaller by this factor.
const LETTERS: f64 = 1.24;

const GRID: RGBColor = RGBColor(222, 222, 222);
const BLACK: RGBColor = RGBColor(28, 28, 28);

/// Curves of one unit over the common abscissa.
pub(super) struct Diagram<'a> {
    pub(super) plot: &'a Plot,
    /// Colours of the series, `#rrggbb`.
    pub(super) inks: &'a [&'a str],
    pub(super) over: &'a Axis,
    /// Values of the abscissa.
    pub(super) values: &'a [f64],
    /// Name of the abscissa, below the last diagram.
    pub(super) below: Option<&'a str>,
}

type Paper<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;
type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<Axis, Axis>>;
type Drawing = Result<(), DrawingAreaErrorKind<std::io::Error>>;

impl Diagram<'_> {
    /// Shapes in drawing units, and the height in picture units, of a diagram `width` picture units wide.
    pub(super) fn drawn(&self, width: f64) -> Result<(String, f64), Unviewable> {
        let height = ABOVE + HEIGHT + if self.below.is_some() { BELOW } else { NEXT };
        let mut svg = String::new();
        let paper = SVGBackend::with_string(&mut svg, (fine(width).unsigned_abs(), fine(height).unsigned_abs())).into_drawing_area();
        self.draw(&paper).map_err(|reason| Unviewable::Diagram(reason.to_string()))?;
        drop(paper);
        let shapes = svg.split_once(">\n").and_then(|(_, rest)| rest.rsplit_once("</svg>")).map(|(shapes, _)| shapes);
        Ok((shapes.unwrap_or_default().to_owned(), height))
    }

    fn draw(&self, paper: &Paper) -> Drawing {
        let values = self.plot.series.iter().flat_map(|series| &series.values).copied();
        let up = Axis::up(values, &self.plot.unit);
        // The curves have names of their own.
        let unit = up.named("");
        let (margin, numbers) = if self.below.is_some() { (0.0, BELOW) } else { (NEXT, 0.0) };
        let mut chart = ChartBuilder::on(paper)
            .margin_top(fine(ABOVE))
            .margin_right(fine(RIGHT))
            .margin_bottom(fine(margin))
            .set_label_area_size(LabelAreaPosition::Left, fine(LEFT))
            .set_label_area_size(LabelAreaPosition::Bottom, fine(numbers))
            .build_cartesian_2d(self.over.clone(), up)?;
        axes(&mut chart, self.below.unwrap_or_default(), &unit)?;
        for (series, ink) in self.plot.series.iter().zip(self.inks) {
            if series.is_dotted {
                self.circles(&chart, series, colour(ink))?;
            } else {
                self.curve(&chart, series, colour(ink))?;
            }
        }
        paper.present()
    }

    /// The points of a series; `None` where the value has no place on an axis.
    fn points(&self, series: &Series) -> Vec<Option<(f64, f64)>> {
        self.values.iter().zip(&series.values).map(|(x, y)| (y.abs() <= LARGEST).then_some((*x, *y))).collect()
    }

    /// Lines between points; a point between two gaps is a dot.
    fn curve(&self, chart: &Chart, series: &Series, colour: RGBColor) -> Drawing {
        for piece in self.points(series).split(Option::is_none) {
            let piece: Vec<(f64, f64)> = piece.iter().flatten().copied().collect();
            match piece.as_slice() {
                [] => {}
                [one] => chart.plotting_area().draw(&Circle::new(*one, fine(1.2), colour.filled()))?,
                _ => chart.plotting_area().draw(&PathElement::new(piece, colour.stroke_width(fine(1.6).unsigned_abs())))?,
            }
        }
        Ok(())
    }

    /// Circles at points that are apart from each other.
    fn circles(&self, chart: &Chart, series: &Series, colour: RGBColor) -> Drawing {
        let mut before: Option<(i32, i32)> = None;
        for point in self.points(series).into_iter().flatten() {
            let (x, y) = chart.backend_coord(&point);
            let apart = |(left, top): (i32, i32)| f64::from(x - left).hypot(f64::from(y - top)) >= APART * f64::from(FINE);
            if before.is_none_or(apart) {
                chart.plotting_area().draw(&Circle::new(
                    point,
                    fine(2.5),
                    ShapeStyle::from(colour).stroke_width(fine(1.0).unsigned_abs()),
                ))?;
                before = Some((x, y));
            }
        }
        Ok(())
    }
}

/// Draws grid, numbers and names of the axes.
fn axes(chart: &mut Chart, below: &str, unit: &str) -> Drawing {
    let font = (FONTS, 12.0 * LETTERS * f64::from(FINE));
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(GRID.stroke_width(fine(0.7).unsigned_abs()))
        .axis_style(BLACK.stroke_width(fine(0.9).unsigned_abs()))
        .set_all_tick_mark_size(fine(3.0))
        .label_style(font)
        .axis_desc_style(font)
        .x_desc(below)
        .y_desc(unit)
        .draw()
}

/// `size` picture units, in drawing units.
fn fine(size: f64) -> i32 {
    (size * f64::from(FINE)).round() as i32
}

/// A colour from `#rrggbb`.
fn colour(ink: &str) -> RGBColor {
    let part = |at: usize| ink.get(at..at + 2).and_then(|digits| u8::from_str_radix(digits, 16).ok()).unwrap_or(0);
    RGBColor(part(1), part(3), part(5))
}
