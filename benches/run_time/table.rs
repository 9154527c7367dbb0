//! What was measured, as a table in Markdown.

use std::fmt::Write as _;

use crate::measure::Line;

/// One table with all workloads under each other.
pub(crate) fn table(workloads: &[(&str, Vec<Line>)]) -> String {
    let mut text = "| workload | contender | stops at | time per step | ratio | position error | acceleration error |\n".to_owned();
    text += "| --- | --- | ---: | ---: | ---: | ---: | ---: |\n";
    for (workload, lines) in workloads {
        for Line { name, tolerance, time, ratio, errors } in lines {
            let share = |value: Option<f64>| value.map_or(String::new(), |value| format!("{value:.0e}"));
            let (tolerance, position, acceleration) = (share(*tolerance), share(Some(errors.position)), share(errors.acceleration));
            let _ =
                writeln!(text, "| {workload} | {name} | {tolerance} | {} | {ratio:.2} | {position} | {acceleration} |", duration(*time));
        }
    }
    text
}

/// Nanoseconds in the unit that suits them.
fn duration(nanoseconds: f64) -> String {
    let (value, unit) = match nanoseconds {
        value if value < 1e3 => (value, "ns"),
        value if value < 1e6 => (value / 1e3, "µs"),
        value => (value / 1e6, "ms"),
    };
    let digits = if value < 10.0 && unit != "ns" { 2 } else { usize::from(value < 100.0) };
    format!("{value:.digits$} {unit}")
}
