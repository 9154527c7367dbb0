//! Measurements as tables in Markdown: a row for each contender, a column for each workload.

use std::fmt::Write as _;

/// What a contender took for a workload.
#[derive(Clone, Debug)]
pub struct Cell {
    /// The contender.
    pub name: String,
    /// In ns.
    pub time: f64,
    /// How many times as much as the first contender.
    pub ratio: f64,
    /// Its errors, of several kinds.
    pub errors: Vec<Option<f64>>,
}

/// Contenders in the order in which they occur, with the largest error of each of these kinds in the last columns.
#[must_use]
pub fn table(workloads: &[(&str, Vec<Cell>)], kinds: &[&str]) -> String {
    let mut contenders: Vec<&str> = Vec::new();
    for cell in workloads.iter().flat_map(|(_, cells)| cells) {
        if !contenders.contains(&cell.name.as_str()) {
            contenders.push(&cell.name);
        }
    }
    let headings: Vec<&str> = workloads.iter().map(|(workload, _)| *workload).chain(kinds.iter().copied()).collect();
    let mut text = format!("| | {} |\n| --- |{}\n", headings.join(" | "), " ---: |".repeat(headings.len()));
    for contender in contenders {
        let cells: Vec<Option<&Cell>> = workloads.iter().map(|(_, cells)| cells.iter().find(|cell| cell.name == contender)).collect();
        let took = |cell: &Option<&Cell>| cell.map_or(String::new(), |cell| format!("{}, {}", duration(cell.time), Ratio(cell.ratio)));
        let error = |kind: usize| {
            let largest = cells.iter().flatten().filter_map(|cell| cell.errors[kind]).reduce(f64::max);
            largest.map_or(String::new(), |error| format!("{error:.0e}"))
        };
        let entries: Vec<String> = cells.iter().map(took).chain((0..kinds.len()).map(error)).collect();
        let _ = writeln!(text, "| {contender} | {} |", entries.join(" | "));
    }
    text
}

/// Times as many.
struct Ratio(f64);

impl std::fmt::Display for Ratio {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let digits = if self.0 < 9.95 { 1 } else { 0 };
        write!(f, "{:.digits$}×", self.0)
    }
}

/// Nanoseconds in the unit that suits them.
#[must_use]
pub fn duration(nanoseconds: f64) -> String {
    let (value, unit) = match nanoseconds {
        value if value < 1e3 => (value, "ns"),
        value if value < 1e6 => (value / 1e3, "µs"),
        value => (value / 1e6, "ms"),
    };
    let digits = usize::from(value < 9.95 && unit != "ns");
    format!("{value:.digits$} {unit}")
}
