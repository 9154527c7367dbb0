//! Instructions of one warm step of each workload, held against those that were counted before:
//! `cargo run --release -p reuleaux-benches --bin instructions [-- --write]`.
//!
//! In: `instructions.json` beside this file. Out: a table; with `--write` the file. It fails where a step takes over 2 % more
//! instructions than written there. Each workload runs twice under callgrind, the second time for twice as many steps, so that
//! everything before the steps cancels. Counts depend on the compiler's version, not on how busy the machine is.

use std::collections::BTreeMap;
use std::error::Error;
use std::fs;
use std::path::Path;
use std::process::Command;

use reuleaux_benches::workloads::Make;
use reuleaux_benches::{times, workloads};

/// By how much a step may grow.
const TOLERANCE: f64 = 0.02;

/// Steps of the shorter run.
const STEPS: usize = 300;

type Counts = BTreeMap<String, f64>;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => compare(),
        ["--write"] => write(),
        ["steps", workload, steps] => follow(workload, steps.parse()?),
        _ => Err("there is `--write` and nothing else".into()),
    }
}

/// What runs under callgrind.
fn follow(name: &str, steps: usize) -> Result<(), Box<dyn Error>> {
    let (_, generated) = all().into_iter().find(|(workload, _)| workload == name).ok_or("no such workload")?;
    generated().sweep(&times()[..steps]);
    Ok(())
}

/// Names of all workloads, with what is generated for them.
fn all() -> Vec<(String, Make)> {
    let cams = workloads::cams().into_iter().map(|(name, generated)| (name.to_owned(), generated));
    workloads::all().into_iter().map(|workload| (workload.linkage.name.to_owned(), workload.generated)).chain(cams).collect()
}

fn compare() -> Result<(), Box<dyn Error>> {
    let before: Counts = serde_json::from_str(&fs::read_to_string(baseline())?)?;
    let counts = count()?;
    println!("| workload | instructions per step | before | change |\n| --- | ---: | ---: | ---: |");
    let mut slower = Vec::new();
    for (name, count) in &counts {
        let Some(before) = before.get(name) else {
            println!("| {name} | {count:.0} | | |");
            continue;
        };
        let change = count / before - 1.0;
        println!("| {name} | {count:.0} | {before:.0} | {:+.1} % |", change * 100.0);
        if change > TOLERANCE {
            slower.push(name.as_str());
        }
    }
    if slower.is_empty() { Ok(()) } else { Err(format!("takes more instructions than before: {}", slower.join(", ")).into()) }
}

fn write() -> Result<(), Box<dyn Error>> {
    fs::write(baseline(), serde_json::to_string_pretty(&count()?)? + "\n")?;
    println!("{} written", baseline());
    Ok(())
}

fn baseline() -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("instructions.json").display().to_string()
}

/// Instructions per step of all workloads.
fn count() -> Result<Counts, Box<dyn Error>> {
    let mut counts = Counts::new();
    for (name, _) in all() {
        let steps = instructions(&name, 2 * STEPS)? - instructions(&name, STEPS)?;
        counts.insert(name, (steps / STEPS as f64).round());
    }
    Ok(counts)
}

/// Instructions of a whole run with this many steps.
fn instructions(name: &str, steps: usize) -> Result<f64, Box<dyn Error>> {
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(std::env::current_exe()?)
        .args(["steps", name, &steps.to_string()])
        .output()
        .map_err(|error| format!("`valgrind` is needed to count instructions: {error}"))?;
    let report = String::from_utf8_lossy(&output.stderr);
    let collected = report.lines().find_map(|line| line.split_once("Collected : ")).ok_or_else(|| report.to_string())?;
    Ok(collected.1.trim().parse()?)
}
