//! Pictures of measurements: time against error in panels, both axes logarithmic, above one legend.

use std::error::Error;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

pub use plotters::style::{BLACK, RGBColor};

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

const GRID: RGBColor = RGBColor(222, 222, 222);
const PANEL: (u32, u32) = (340, 280);
/// Between rows of the legend.
const ROW: u32 = 22;

/// Points of one ink.
#[derive(Clone, Debug)]
pub struct Series {
    /// Error and nanoseconds of each.
    pub points: Vec<(f64, f64)>,
    /// Of all of them.
    pub ink: RGBColor,
    /// Whether they are discs, not circles.
    pub is_filled: bool,
    /// Whether a line joins them.
    pub is_joined: bool,
    /// Radius of a point.
    pub size: i32,
}

/// One of the pictures in the picture; what is first lies on top.
#[derive(Clone, Debug)]
pub struct Panel {
    /// Above it.
    pub caption: String,
    /// All points.
    pub series: Vec<Series>,
}

/// What an ink means.
#[derive(Clone, Debug)]
pub struct Meaning {
    /// In words.
    pub words: String,
    /// The ink.
    pub ink: RGBColor,
    /// Whether it is said of discs, not of circles.
    pub is_filled: bool,
}

/// All panels.
#[derive(Clone, Debug)]
pub struct Picture {
    /// How many panels stand side by side.
    pub columns: usize,
    /// Powers of ten of the smallest and the largest error, and how many decades apart the numbers stand.
    pub error: (i32, i32, usize),
    /// Powers of ten of the shortest and the longest time in ns.
    pub time: (i32, i32),
    /// In words what the error is, and what the time is.
    pub words: [&'static str; 2],
    /// In rows.
    pub panels: Vec<Panel>,
    /// In rows.
    pub legend: Vec<Meaning>,
}

impl Picture {
    /// Draws it to a file.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn draw(&self, path: &str) -> Result<(), Box<dyn Error>> {
        let rows = self.panels.len().div_ceil(self.columns);
        let legend = ROW * self.legend.len().div_ceil(self.columns) as u32 + 14;
        let root = SVGBackend::new(path, (PANEL.0 * self.columns as u32, PANEL.1 * rows as u32 + legend)).into_drawing_area();
        // A ground of its own: the page around it may be light or dark.
        root.fill(&WHITE)?;
        let (panels, below) = root.split_vertically(PANEL.1 * rows as u32);
        for (panel, area) in self.panels.iter().zip(panels.split_evenly((rows, self.columns))) {
            self.panel(&area, panel)?;
        }
        self.legend(&below)?;
        root.present()?;
        Ok(())
    }

    fn panel(&self, area: &Area<'_>, panel: &Panel) -> Result<(), Box<dyn Error>> {
        let (error, time) = (self.error, self.time);
        let mut chart = ChartBuilder::on(area)
            .margin(8)
            .margin_right(14)
            .caption(&panel.caption, ("sans-serif", 16))
            .x_label_area_size(40)
            .y_label_area_size(58)
            .build_cartesian_2d(f64::from(error.0)..f64::from(error.1), f64::from(time.0)..f64::from(time.1))?;
        let power = |decade: &f64| format!("1e{decade:.0}");
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(GRID)
            .x_labels(((error.1 - error.0) as usize).div_ceil(error.2) + 1)
            .y_labels((time.1 - time.0) as usize + 1)
            .x_label_formatter(&power)
            .y_label_formatter(&|decade| duration(*decade))
            .x_desc(self.words[0])
            .y_desc(self.words[1])
            .label_style(("sans-serif", 12))
            .draw()?;
        // The last one drawn lies on top.
        for series in panel.series.iter().rev() {
            let within = |(of, nanoseconds): &(f64, f64)| (of.log10().clamp(f64::from(error.0), f64::from(error.1)), nanoseconds.log10());
            let places: Vec<(f64, f64)> = series.points.iter().map(within).collect();
            if series.is_joined {
                chart.draw_series([PathElement::new(places.clone(), series.ink.mix(0.5))])?;
            }
            let style = if series.is_filled { series.ink.filled() } else { series.ink.stroke_width(2) };
            chart.draw_series(places.into_iter().map(|place| Circle::new(place, series.size, style)))?;
        }
        Ok(())
    }

    fn legend(&self, area: &Area<'_>) -> Result<(), Box<dyn Error>> {
        let style = ("sans-serif", 14).into_font().color(&BLACK).pos(Pos::new(HPos::Left, VPos::Center));
        for (index, Meaning { words, ink, is_filled }) in self.legend.iter().enumerate() {
            let place = (64 + (index % self.columns) as i32 * PANEL.0 as i32, 14 + (index / self.columns) as i32 * ROW as i32);
            area.draw(&Circle::new(place, 5, if *is_filled { ink.filled() } else { ink.stroke_width(2) }))?;
            area.draw(&Text::new(words.as_str(), (place.0 + 12, place.1), style.clone()))?;
        }
        Ok(())
    }
}

/// A power of ten of nanoseconds.
fn duration(decade: f64) -> String {
    let unit = ["ns", "µs", "ms", "s"][(decade / 3.0).floor().clamp(0.0, 3.0) as usize];
    format!("{:.0} {unit}", 10f64.powf(decade.rem_euclid(3.0)))
}
