//! Time against error, a panel for each workload, both axes logarithmic.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use reuleaux_benches::workloads::name;

use crate::measure::Line;

type Fallible = Result<(), Box<dyn std::error::Error>>;
type Area<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;

/// Contenders with the beginning of their names, in the order of the legend. Peers in C appear as compiled for the same target as
/// the Rust ones, without `-march=native`.
const INKS: [(&str, &str, RGBColor); 12] = [
    (name::GENERATED, name::GENERATED, RGBColor(213, 40, 0)),
    (name::CLOSED, "dyads in closed form, Rust", RGBColor(0, 0, 0)),
    (name::CLOSED_WHOLE, name::CLOSED_WHOLE, RGBColor(90, 90, 90)),
    (name::ANGLES, name::ANGLES, RGBColor(0, 114, 178)),
    (name::ABSOLUTE_PREDICTED, name::ABSOLUTE_PREDICTED, RGBColor(0, 140, 102)),
    (name::ABSOLUTE, name::ABSOLUTE, RGBColor(120, 190, 60)),
    (name::EZPZ, "ezpz (positions)", RGBColor(170, 51, 119)),
    ("SymPy C, dense LU, predictor, -O3", "SymPy C, dense LU, predictor", RGBColor(190, 130, 0)),
    ("SymPy C, KLU, predictor, -O3", "SymPy C, KLU, predictor", RGBColor(120, 80, 20)),
    ("CasADi fast_newton, predictor, -O3", "CasADi fast_newton, predictor", RGBColor(100, 70, 200)),
    ("pylinkage, numba", "pylinkage, numba", RGBColor(80, 170, 220)),
    ("Exudyn", "Exudyn", RGBColor(170, 170, 170)),
];
const GRID: RGBColor = RGBColor(222, 222, 222);
const COLUMNS: usize = 3;
const PANEL: (u32, u32) = (340, 280);
const LEGEND: u32 = 132;
/// From the smallest to the largest error and time in ns, and the decades that are numbered.
const ERROR: (i32, i32, usize) = (-17, 0, 4);
const TIME: (i32, i32, usize) = (1, 7, 1);

/// Draws all workloads to a file.
pub(crate) fn plot(path: &str, workloads: &[(&str, Vec<Line>)]) -> Fallible {
    let rows = workloads.len().div_ceil(COLUMNS);
    let size = (PANEL.0 * COLUMNS as u32, PANEL.1 * rows as u32 + LEGEND);
    let root = SVGBackend::new(path, size).into_drawing_area();
    // A ground of its own: the page around it may be light or dark.
    root.fill(&WHITE)?;
    let (panels, below) = root.split_vertically(PANEL.1 * rows as u32);
    for ((workload, lines), area) in workloads.iter().zip(panels.split_evenly((rows, COLUMNS))) {
        panel(&area, workload, lines)?;
    }
    legend(&below)?;
    root.present()?;
    Ok(())
}

fn panel(area: &Area<'_>, workload: &str, lines: &[Line]) -> Fallible {
    let decades = |(low, high, _): (i32, i32, usize)| f64::from(low)..f64::from(high);
    let mut chart = ChartBuilder::on(area)
        .margin(8)
        .margin_right(14)
        .caption(workload, ("sans-serif", 16))
        .x_label_area_size(40)
        .y_label_area_size(52)
        .build_cartesian_2d(decades(ERROR), decades(TIME))?;
    let power = |decade: &f64| format!("1e{decade:.0}");
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(GRID)
        .x_labels(((ERROR.1 - ERROR.0) as usize).div_ceil(ERROR.2) + 1)
        .y_labels((TIME.1 - TIME.0) as usize + TIME.2)
        .x_label_formatter(&power)
        .y_label_formatter(&|decade| duration(*decade))
        .x_desc("largest relative error")
        .y_desc("time per step")
        .label_style(("sans-serif", 12))
        .draw()?;
    // The last one drawn lies on top.
    for (contender, _, ink) in INKS.iter().rev() {
        let own: Vec<&Line> = lines.iter().filter(|line| line.name == *contender).collect();
        let at = |error: f64, line: &Line| (error.log10().clamp(f64::from(ERROR.0), f64::from(ERROR.1)), line.time.log10());
        let positions: Vec<_> = own.iter().map(|line| at(line.errors.position, line)).collect();
        let accelerations = own.iter().filter_map(|line| Some(at(line.errors.acceleration?, line)));
        let size = if *contender == name::GENERATED { 5 } else { 4 };
        chart.draw_series(accelerations.map(|place| Circle::new(place, size, ink.stroke_width(2))))?;
        chart.draw_series([PathElement::new(positions.clone(), ink.mix(0.5))])?;
        chart.draw_series(positions.into_iter().map(|place| Circle::new(place, size, ink.filled())))?;
    }
    Ok(())
}

/// A power of ten of nanoseconds.
fn duration(decade: f64) -> String {
    let unit = ["ns", "µs", "ms", "s"][(decade / 3.0).floor().clamp(0.0, 3.0) as usize];
    format!("{:.0} {unit}", 10f64.powf(decade.rem_euclid(3.0)))
}

fn legend(area: &Area<'_>) -> Fallible {
    let words = |size: i32| ("sans-serif", size).into_font().color(&BLACK).pos(Pos::new(HPos::Left, VPos::Center));
    for (index, (_, words_of, ink)) in INKS.iter().enumerate() {
        let place = (64 + (index % COLUMNS) as i32 * PANEL.0 as i32, 14 + (index / COLUMNS) as i32 * 22);
        area.draw(&Circle::new(place, 5, ink.filled()))?;
        area.draw(&Text::new(*words_of, (place.0 + 12, place.1), words(14)))?;
    }
    let place = (64, 14 + INKS.len().div_ceil(COLUMNS) as i32 * 22 + 6);
    area.draw(&Circle::new(place, 5, BLACK.filled()))?;
    area.draw(&Text::new("position, as a share of the mechanism's size", (place.0 + 12, place.1), words(14)))?;
    area.draw(&Circle::new((place.0 + PANEL.0 as i32, place.1), 5, BLACK.stroke_width(2)))?;
    area.draw(&Text::new("acceleration, as a share of the largest", (place.0 + PANEL.0 as i32 + 12, place.1), words(14)))?;
    Ok(())
}
