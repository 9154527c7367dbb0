//! Measurements as a table in Markdown: a row for each contender, a column for each workload.

use std::fmt::Write as _;

use crate::measure::Line;

/// Contenders that were given several tolerances appear with the strictest; the picture has them all.
pub(crate) fn table(workloads: &[(&str, Vec<Line>)]) -> String {
    let mut contenders: Vec<&str> = Vec::new();
    for line in workloads.iter().flat_map(|(_, lines)| lines) {
        if !contenders.contains(&line.name.as_str()) {
            contenders.push(&line.name);
        }
    }
    let headings: Vec<&str> = workloads.iter().map(|(workload, _)| *workload).collect();
    let mut text = format!("| | {} | position error | acceleration error |\n", headings.join(" | "));
    let _ = writeln!(text, "| --- |{}", " ---: |".repeat(headings.len() + 2));
    for contender in contenders {
        let strictest = |(_, lines): &'_ (&str, Vec<Line>)| strictest(lines, contender).cloned();
        let lines: Vec<Option<Line>> = workloads.iter().map(strictest).collect();
        let cell =
            |line: &Option<Line>| line.as_ref().map_or(String::new(), |line| format!("{}, {}", duration(line.time), Ratio(line.ratio)));
        let cells: Vec<String> = lines.iter().map(cell).collect();
        let position = lines.iter().flatten().map(|line| line.errors.position).reduce(f64::max);
        let acceleration = lines.iter().flatten().filter_map(|line| line.errors.acceleration).reduce(f64::max);
        let share = |value: Option<f64>| value.map_or(String::new(), |value| format!("{value:.0e}"));
        let _ = writeln!(text, "| {contender} | {} | {} | {} |", cells.join(" | "), share(position), share(acceleration));
    }
    text
}

/// The line of a contender with the smallest tolerance.
fn strictest<'a>(lines: &'a [Line], contender: &str) -> Option<&'a Line> {
    let tolerance = |line: &Line| line.tolerance.unwrap_or(0.0);
    lines.iter().filter(|line| line.name == contender).min_by(|a, b| tolerance(a).total_cmp(&tolerance(b)))
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
fn duration(nanoseconds: f64) -> String {
    let (value, unit) = match nanoseconds {
        value if value < 1e3 => (value, "ns"),
        value if value < 1e6 => (value / 1e3, "µs"),
        value => (value / 1e6, "ms"),
    };
    let digits = usize::from(value < 9.95 && unit != "ns");
    format!("{value:.digits$} {unit}")
}
