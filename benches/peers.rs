//! What `peers/space_forces.py` measured in space and of motions that follow from forces: `cargo run --release -p reuleaux-benches --bin peers`.
//!
//! In: `peers/space_forces.json`. Out: tables of `README.md` beside this file, and its pictures `space.svg` and `motion.svg`.

use std::error::Error;
use std::fs;
use std::path::Path;

use reuleaux_benches::picture::{BLACK, Meaning, Panel, Picture, RGBColor, Series};
use reuleaux_benches::table::{Cell, duration, table};
use serde_json::{Map, Value};

/// Contenders with their inks, in the order of the legend.
type Inks = [(&'static str, &'static str, RGBColor)];

const IN_SPACE: [(&str, &str, RGBColor); 7] = [
    ("reuleaux", "reuleaux", RGBColor(213, 40, 0)),
    ("by hand, sine and cosine of the runtime", "by hand, sine and cosine of the runtime", RGBColor(0, 0, 0)),
    ("by hand", "by hand", RGBColor(120, 120, 120)),
    ("CasADi straight lines, -O3", "CasADi straight lines", RGBColor(100, 70, 200)),
    ("CasADi fast_newton, -O3", "CasADi fast_newton", RGBColor(190, 130, 0)),
    ("Pinocchio's templates printed by CasADi, -O3", "Pinocchio's templates printed by CasADi", RGBColor(0, 140, 102)),
    ("Pinocchio, C++ -O3", "Pinocchio, C++", RGBColor(120, 190, 60)),
];
const OF_MOTIONS: [(&str, &str, RGBColor); 6] = [
    ("reuleaux", "reuleaux", RGBColor(213, 40, 0)),
    ("by hand", "by hand, our integrator", RGBColor(0, 0, 0)),
    ("CVODE, Adams", "CVODE, Adams", RGBColor(100, 70, 200)),
    ("CVODE, BDF", "CVODE, BDF", RGBColor(190, 130, 0)),
    ("DOP853 of numbalsoda", "DOP853 of numbalsoda", RGBColor(0, 140, 102)),
    ("heyoka", "heyoka", RGBColor(80, 170, 220)),
];
/// Errors that motions are asked for.
const ASKED: [f64; 5] = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12];

fn main() -> Result<(), Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let results: Value = serde_json::from_str(&fs::read_to_string(folder.join("peers/space_forces.json"))?)?;
    let [space, dynamics, motion] = ["space", "dynamics", "motion"].map(|part| lines(&results[part]));
    print!("{}\n{}\n{}", in_space(&space), of_forces(&dynamics), of_motions(&motion));
    let path = |name: &str| folder.join(name).display().to_string();
    let meanings = |inks: &Inks| -> Vec<Meaning> { inks.iter().map(|(_, words, ink)| meaning(words, *ink, true)).collect() };
    let kinds = [meaning("pose", BLACK, true), meaning("accelerations", BLACK, false)];
    let panels = space.iter().map(|(problem, lines)| panel(problem, lines, &IN_SPACE, &[("errors", 0), ("errors", 2)])).collect();
    let legend = [meanings(&IN_SPACE), kinds.to_vec()].concat();
    let words = ["largest relative error", "time per step"];
    Picture { columns: 3, error: (-17, -11, 2), time: (1, 4), words, panels, legend }.draw(&path("space.svg"))?;
    let panels = motion.iter().map(|(problem, lines)| panel(problem, lines, &OF_MOTIONS, &[("error", 0)])).collect();
    let (words, legend) = (["error at the end", "time"], meanings(&OF_MOTIONS));
    Picture { columns: 2, error: (-15, 1, 4), time: (4, 8), words, panels, legend }.draw(&path("motion.svg"))
}

/// Problems with a line for each contender, by the names of the problems.
type Lines = Vec<(String, Vec<Map<String, Value>>)>;

fn lines(part: &Value) -> Lines {
    let line = |line: &Value| line.as_object().cloned().unwrap_or_default();
    let problem = |problem: &Value| {
        let name = problem["problem"].as_str().unwrap_or_default();
        (name.to_owned(), problem["lines"].as_array().into_iter().flatten().map(line).collect())
    };
    part.as_array().into_iter().flatten().map(problem).collect()
}

fn number(line: &Map<String, Value>, name: &str) -> f64 {
    line.get(name).and_then(Value::as_f64).unwrap_or(f64::NAN)
}

fn text<'a>(line: &'a Map<String, Value>, name: &str) -> &'a str {
    line.get(name).and_then(Value::as_str).unwrap_or_default()
}

/// An error, or one of several.
fn error(line: &Map<String, Value>, (name, place): (&str, usize)) -> Option<f64> {
    let found = line.get(name)?;
    found.get(place).unwrap_or(found).as_f64()
}

fn cells(lines: &[Map<String, Value>], errors: &[(&str, usize)]) -> Vec<Cell> {
    let is_strictest = |line: &&Map<String, Value>| {
        let tolerance = |line: &Map<String, Value>| line.get("tolerance").and_then(Value::as_f64).unwrap_or(0.0);
        lines.iter().all(|other| text(other, "name") != text(line, "name") || tolerance(line) <= tolerance(other))
    };
    let cell = |line: &Map<String, Value>| Cell {
        name: text(line, "name").to_owned(),
        time: number(line, "time"),
        ratio: number(line, "ratio"),
        errors: errors.iter().map(|kind| error(line, *kind)).collect(),
    };
    lines.iter().filter(is_strictest).map(cell).collect()
}

fn in_space(problems: &Lines) -> String {
    let kinds = [("errors", 0), ("errors", 1), ("errors", 2)];
    let cells: Vec<(&str, Vec<Cell>)> = problems.iter().map(|(name, lines)| (name.as_str(), cells(lines, &kinds))).collect();
    table(&cells, &["pose", "velocities", "accelerations"])
}

fn of_forces(problems: &Lines) -> String {
    let cells: Vec<(&str, Vec<Cell>)> = problems.iter().map(|(name, lines)| (name.as_str(), cells(lines, &[("error", 0)]))).collect();
    table(&cells, &["error"])
}

/// The shortest time in which a contender reaches each error, at any of its tolerances.
fn of_motions(problems: &Lines) -> String {
    let asked: Vec<String> = ASKED.iter().map(|error| format!("{error:e}")).collect();
    let mut table = format!("| | | {} |\n| --- | --- |{}\n", asked.join(" | "), " ---: |".repeat(ASKED.len()));
    for (problem, lines) in problems {
        for (contender, words, _) in OF_MOTIONS {
            let own: Vec<_> = lines.iter().filter(|line| text(line, "name") == contender).collect();
            let shortest = |asked: f64| {
                let enough = own.iter().filter(|line| number(line, "error") <= asked).map(|line| number(line, "time"));
                enough.reduce(f64::min).map_or(String::new(), duration)
            };
            if !own.is_empty() {
                table += &format!("| {problem} | {words} | {} |\n", ASKED.map(shortest).join(" | "));
            }
        }
    }
    table
}

fn meaning(words: &str, ink: RGBColor, is_filled: bool) -> Meaning {
    Meaning { words: words.to_owned(), ink, is_filled }
}

/// Discs for the first of these errors, circles for another one.
fn panel(problem: &str, lines: &[Map<String, Value>], inks: &Inks, kinds: &[(&str, usize)]) -> Panel {
    let mut series = Vec::new();
    for (contender, _, ink) in inks {
        for (place, kind) in kinds.iter().enumerate() {
            let own = lines.iter().filter(|line| text(line, "name") == *contender);
            let points = own.filter_map(|line| Some((error(line, *kind)?, number(line, "time")))).collect();
            let size = if *contender == "reuleaux" { 5 } else { 4 };
            series.push(Series { points, ink: *ink, is_filled: place == 0, is_joined: place == 0, size });
        }
    }
    Panel { caption: problem.to_owned(), series }
}
