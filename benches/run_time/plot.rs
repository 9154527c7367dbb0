//! Time against error, a panel for each workload.

use reuleaux_benches::picture::{BLACK, Meaning, Panel, Picture, RGBColor, Series};
use reuleaux_benches::workloads::name;

use crate::measure::Line;

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

/// Draws all workloads to a file.
pub(crate) fn plot(path: &str, workloads: &[(&str, Vec<Line>)]) -> Result<(), Box<dyn std::error::Error>> {
    let meaning = |words: &str, ink, is_filled| Meaning { words: words.to_owned(), ink, is_filled };
    let mut legend: Vec<Meaning> = INKS.iter().map(|(_, words, ink)| meaning(words, *ink, true)).collect();
    legend.push(meaning("position, as a share of the mechanism's size", BLACK, true));
    legend.push(meaning("acceleration, as a share of the largest", BLACK, false));
    let panels = workloads.iter().map(|(workload, lines)| panel(workload, lines)).collect();
    let words = ["largest relative error", "time per step"];
    Picture { columns: 3, error: (-17, 0, 4), time: (1, 7), words, panels, legend }.draw(path)
}

fn panel(workload: &str, lines: &[Line]) -> Panel {
    let of_contender = |(contender, _, ink): &(&str, &str, RGBColor)| {
        let own = || lines.iter().filter(|line| line.name == *contender);
        let size = if *contender == name::GENERATED { 5 } else { 4 };
        let positions = own().map(|line| (line.errors.position, line.time)).collect();
        let accelerations = own().filter_map(|line| Some((line.errors.acceleration?, line.time))).collect();
        let series = |points, is_filled| Series { points, ink: *ink, is_filled, is_joined: is_filled, size };
        [series(positions, true), series(accelerations, false)]
    };
    Panel { caption: workload.to_owned(), series: INKS.iter().flat_map(of_contender).collect() }
}
