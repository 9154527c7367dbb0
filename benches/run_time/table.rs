//! Measurements as a table in Markdown: a row for each contender, a column for each workload.

use reuleaux_benches::table::{self, Cell};

use crate::measure::Line;

/// Contenders that were given several tolerances appear with the strictest; the picture has them all.
pub(crate) fn table(workloads: &[(&str, Vec<Line>)]) -> String {
    let cells: Vec<(&str, Vec<Cell>)> = workloads.iter().map(|(workload, lines)| (*workload, strictest(lines))).collect();
    table::table(&cells, &["position error", "acceleration error"])
}

/// The line of each contender with the smallest tolerance.
fn strictest(lines: &[Line]) -> Vec<Cell> {
    let tolerance = |line: &Line| line.tolerance.unwrap_or(0.0);
    let is_strictest = |line: &&Line| lines.iter().all(|other| other.name != line.name || tolerance(line) <= tolerance(other));
    let cell = |line: &Line| Cell {
        name: line.name.clone(),
        time: line.time,
        ratio: line.ratio,
        errors: vec![Some(line.errors.position), line.errors.acceleration],
    };
    lines.iter().filter(is_strictest).map(cell).collect()
}
