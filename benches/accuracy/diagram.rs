//! Time against error, a panel for each mechanism, both axes logarithmic.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::speed::{Panel, Precision};

type Fallible = Result<(), Box<dyn std::error::Error>>;
type Area<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;

const INKS: [(Precision, &str, RGBColor); 3] = [
    (Precision::Single, "f32", RGBColor(0, 114, 178)),
    (Precision::Double, "f64", RGBColor(213, 40, 0)),
    (Precision::Polished, "f64, polished", RGBColor(0, 140, 102)),
];
const GRID: RGBColor = RGBColor(222, 222, 222);
const COLUMNS: usize = 3;
const PANEL: (u32, u32) = (300, 240);
const LEGEND: u32 = 40;
/// From the smallest to the largest error and time in ns, and the decades between two numbers.
const ERROR: (i32, i32, i32) = (-18, 2, 4);
const TIME: (i32, i32, i32) = (1, 7, 1);

/// Draws all mechanisms to a file.
pub(crate) fn draw(path: &str, mechanisms: &[Panel]) -> Fallible {
    let rows = mechanisms.len().div_ceil(COLUMNS);
    let size = (PANEL.0 * COLUMNS as u32, PANEL.1 * rows as u32 + LEGEND);
    let root = SVGBackend::new(path, size).into_drawing_area();
    // A ground of its own: the page around it may be light or dark.
    root.fill(&WHITE)?;
    let (panels, below) = root.split_vertically(PANEL.1 * rows as u32);
    for (mechanism, area) in mechanisms.iter().zip(panels.split_evenly((rows, COLUMNS))) {
        panel(&area, mechanism)?;
    }
    legend(&below)?;
    root.present()?;
    Ok(())
}

fn panel(area: &Area<'_>, mechanism: &Panel) -> Fallible {
    let decades = |(low, high, _): (i32, i32, i32)| f64::from(low)..f64::from(high);
    let labels = |(low, high, step): (i32, i32, i32)| ((high - low) / step + 1) as usize;
    let mut chart = ChartBuilder::on(area)
        .margin(8)
        .margin_right(14)
        .caption(&mechanism.name, ("sans-serif", 16))
        .x_label_area_size(40)
        .y_label_area_size(52)
        .build_cartesian_2d(decades(ERROR), decades(TIME))?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(GRID)
        .x_labels(labels(ERROR))
        .y_labels(labels(TIME))
        .x_label_formatter(&|decade| format!("1e{decade:.0}"))
        .y_label_formatter(&|decade| duration(*decade))
        .x_desc("largest relative error")
        .y_desc("time per state")
        .label_style(("sans-serif", 12))
        .draw()?;
    for mark in &mechanism.marks {
        let Some((_, _, ink)) = INKS.iter().find(|(precision, ..)| *precision == mark.precision) else { continue };
        let at = |order: usize| (mark.errors[order].log10().clamp(f64::from(ERROR.0), f64::from(ERROR.1)), mark.time.log10());
        chart.draw_series([PathElement::new((0..3).map(at).collect::<Vec<_>>(), ink.mix(0.5))])?;
        chart.draw_series([TriangleMarker::new(at(2), 6, ink.filled())])?;
        chart.draw_series([Circle::new(at(1), 5, ink.stroke_width(2))])?;
        chart.draw_series([Circle::new(at(0), 4, ink.filled())])?;
    }
    Ok(())
}

/// A power of ten of nanoseconds.
fn duration(decade: f64) -> String {
    let unit = ["ns", "µs", "ms", "s"][(decade / 3.0).floor().clamp(0.0, 3.0) as usize];
    format!("{:.0} {unit}", 10f64.powf(decade.rem_euclid(3.0)))
}

fn legend(area: &Area<'_>) -> Fallible {
    let words = || ("sans-serif", 14).into_font().color(&BLACK).pos(Pos::new(HPos::Left, VPos::Center));
    let mut x = 60;
    for (_, name, ink) in INKS {
        area.draw(&Rectangle::new([(x - 5, 13), (x + 5, 23)], ink.filled()))?;
        area.draw(&Text::new(name, (x + 12, 18), words()))?;
        x += 60 + 8 * name.len() as i32;
    }
    x += 60;
    area.draw(&Circle::new((x, 18), 4, BLACK.filled()))?;
    area.draw(&Text::new("position", (x + 12, 18), words()))?;
    area.draw(&Circle::new((x + 110, 18), 5, BLACK.stroke_width(2)))?;
    area.draw(&Text::new("velocity", (x + 122, 18), words()))?;
    area.draw(&TriangleMarker::new((x + 220, 18), 6, BLACK.filled()))?;
    area.draw(&Text::new("acceleration", (x + 232, 18), words()))?;
    Ok(())
}
