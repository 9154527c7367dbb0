//! A figure for print: the drawing of one state, and diagrams below it, as one SVG.
//!
//! In: the recording with all states, and the drawing of the few that are shown. Out: one file, with its parts one below the other.

pub(crate) mod axis;
pub(crate) mod diagram;

use std::collections::BTreeSet;
use std::fmt::Write;

use self::axis::Axis;
use self::diagram::Diagram;
use crate::recording::{Drawn, Plot, Recording, Series};
use crate::still::{self, COLOURS, escaped};
use crate::unviewable::Unviewable;

/// Width of a figure, in picture units.
pub(crate) const WIDTH: f64 = 540.0;

/// Margin around a figure.
const BORDER: f64 = 10.0;

/// Largest height of the drawing.
const DRAWING: f64 = 340.0;

/// Least scale of a drawing that is higher: its labels stay legible.
const REDUCED: f64 = 0.8;

/// Largest magnification of the drawing.
const MAGNIFIED: f64 = 1.25;

/// Height of a line of names.
const LINE: f64 = 17.0;

/// Width of a letter, on average and rounded up.
const LETTER: f64 = 6.9;

/// Fonts of all words.
const FONTS: &str = "Fira Sans,DejaVu Sans,Arial,sans-serif";

/// Colour of words, lines and independent results.
const INK: &str = "#1c1c1c";

pub(crate) fn svg(recording: &Recording, few: &Recording, drawn: &Drawn) -> Result<String, Unviewable> {
    let mut page = Page { shapes: String::new(), bottom: BORDER };
    page.title(&recording.title);
    page.drawing(drawn, few.scenes.len().saturating_sub(1));
    page.traces(recording);
    page.diagrams(recording)?;
    Ok(page.finished(&recording.title, drawn))
}

/// A figure in progress.
struct Page {
    shapes: String,
    /// Lower end of its parts so far.
    bottom: f64,
}

/// Sample beside a name.
enum Sample {
    Line,
    Circle,
}

impl Page {
    fn title(&mut self, title: &str) {
        let base = self.bottom + 15.0;
        let _ = writeln!(self.shapes, "<text x=\"{BORDER}\" y=\"{base}\" font-size=\"16\" font-weight=\"600\">{}</text>", escaped(title));
        self.bottom += 24.0;
    }

    /// The first state in the middle, as large as there is room.
    fn drawing(&mut self, drawn: &Drawn, others: usize) {
        let [left, top, width, height] = drawn.film.frame();
        let scale = (DRAWING / height).clamp(REDUCED, MAGNIFIED).min((WIDTH - 2.0 * BORDER) / width);
        let (x, y) = ((WIDTH - scale * width) / 2.0 - scale * left, self.bottom - scale * top);
        let shapes = still::above(drawn, others);
        let _ = writeln!(self.shapes, "<g class=\"reuleaux\" transform=\"translate({x:.2} {y:.2}) scale({scale:.4})\">\n{shapes}</g>");
        self.bottom += scale * height + 6.0;
    }

    /// The names of traces.
    fn traces(&mut self, recording: &Recording) {
        let names = recording.traces.iter().zip(COLOURS.iter().cycle()).map(|(trace, colour)| (trace.name.as_str(), *colour, Sample::Line));
        self.names(names.collect(), BORDER);
    }

    /// Diagrams over the common abscissa, in the colours after those of the traces.
    fn diagrams(&mut self, recording: &Recording) -> Result<(), Unviewable> {
        let abscissa = &recording.abscissa;
        let over = Axis::over(&abscissa.values, &abscissa.unit);
        let name = over.named(&abscissa.name);
        let mut colours = COLOURS.iter().copied().cycle().skip(recording.traces.len());
        for (number, plot) in recording.plots.iter().enumerate() {
            let mut curve = |series: &Series| if series.is_dotted { INK } else { colours.next().unwrap_or(INK) };
            let inks: Vec<&str> = plot.series.iter().map(&mut curve).collect();
            self.names(legend(plot, &inks), BORDER + diagram::LEFT);
            let below = (number + 1 == recording.plots.len()).then_some(name.as_str());
            let diagram = Diagram { plot, inks: &inks, over: &over, values: &abscissa.values, below };
            let (shapes, height) = diagram.drawn(WIDTH - 2.0 * BORDER)?;
            let scale = 1.0 / f64::from(diagram::FINE);
            let place = format!("translate({BORDER} {:.1}) scale({scale})", self.bottom);
            let _ = writeln!(self.shapes, "<g class=\"diagram\" transform=\"{place}\">\n{shapes}</g>");
            self.bottom += height + 4.0;
        }
        Ok(())
    }

    /// Names with samples, in as many lines as they need, from `left` on.
    fn names(&mut self, names: Vec<(&str, &str, Sample)>, left: f64) {
        if names.is_empty() {
            return;
        }
        let mut x = left;
        for (name, ink, sample) in names {
            let width = 26.0 + LETTER * name.chars().count() as f64;
            if x > left && x + width > WIDTH - BORDER {
                x = left;
                self.bottom += LINE;
            }
            let (middle, base) = (self.bottom + LINE / 2.0, self.bottom + LINE / 2.0 + 4.0);
            let _ = match sample {
                Sample::Line => writeln!(self.shapes, "<path d=\"M{x:.1} {middle:.1}h20\" stroke=\"{ink}\" stroke-width=\"1.8\"/>"),
                Sample::Circle => {
                    let centre = x + 10.0;
                    writeln!(self.shapes, "<circle cx=\"{centre:.1}\" cy=\"{middle:.1}\" r=\"2.5\" fill=\"none\" stroke=\"{ink}\"/>")
                }
            };
            let _ = writeln!(self.shapes, "<text x=\"{:.1}\" y=\"{base:.1}\">{}</text>", x + 25.0, escaped(name));
            x += width + 14.0;
        }
        self.bottom += LINE;
    }

    /// The whole file.
    fn finished(self, title: &str, drawn: &Drawn) -> String {
        let (height, style) = ((self.bottom + BORDER).ceil(), drawn.film.style());
        still::plain(format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"{WIDTH}\" height=\"{height}\" viewBox=\"0 0 {WIDTH} {height}\" \
             font-family=\"{FONTS}\" font-size=\"12\">\n<title>{}</title>\n<desc>{}</desc>\n<style>{style}{}{}</style>\n\
             <rect width=\"{WIDTH}\" height=\"{height}\" fill=\"#fff\"/>\n{}</svg>\n",
            escaped(title),
            escaped(drawn.film.description()),
            still::TRACE,
            still::PALE,
            self.shapes,
        ))
    }
}

/// Names and colours of curves and results. Results of one name, for several curves, are named once.
fn legend<'a>(plot: &'a Plot, inks: &[&'a str]) -> Vec<(&'a str, &'a str, Sample)> {
    let mut results = BTreeSet::new();
    let series = plot.series.iter().zip(inks).filter(|(series, _)| !series.is_dotted || results.insert(&series.name));
    let sample = |series: &Series| if series.is_dotted { Sample::Circle } else { Sample::Line };
    series.map(|(series, ink)| (series.name.as_str(), *ink, sample(series))).collect()
}
