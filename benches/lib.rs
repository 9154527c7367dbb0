//! Mechanisms that are measured, and everything that is measured on them: the generated solver, what one would write by hand,
//! and other people's solvers, each of which follows a tracked point through a thousand steps.

#[cfg(test)]
mod agreement;
pub mod contender;
pub mod exact;
pub mod hand;
pub mod linkage;
pub mod multibody;
pub mod picture;
pub mod released;
pub mod served;
#[cfg(feature = "ezpz")]
mod sketch;
pub mod table;
pub mod workloads;

use std::error::Error;
use std::process::Command;
use std::time::Instant;

/// Steps of a period of one second.
pub const STEPS: usize = 1000;

/// The times of a period after t = 0, in s.
#[must_use]
pub fn times() -> Vec<f64> {
    (1..STEPS).map(|k| k as f64 / STEPS as f64).collect()
}

/// Measurements of each way, of which the median counts.
const MEASUREMENTS: usize = 51;

/// Nanoseconds of one call of each of the ways, which take turns; `calls` for one measurement.
pub fn measured(ways: &mut [&mut dyn FnMut()], calls: usize) -> Vec<f64> {
    let mut times = vec![Vec::new(); ways.len()];
    for _ in 0..MEASUREMENTS {
        for (way, times) in ways.iter_mut().zip(&mut times) {
            let begin = Instant::now();
            (0..calls).for_each(|_| way());
            times.push(begin.elapsed().as_nanos() as f64 / calls as f64);
        }
    }
    let median = |mut times: Vec<f64>| {
        times.sort_by(f64::total_cmp);
        times[MEASUREMENTS / 2]
    };
    times.into_iter().map(median).collect()
}

/// Median nanoseconds of each way, and the median of its ratio to the first; all have their turn in each round.
pub fn turns(ways: &mut [Box<dyn FnMut() + '_>], rounds: usize) -> Vec<(f64, f64)> {
    let mut times = vec![Vec::with_capacity(rounds); ways.len()];
    for _ in 0..rounds {
        for (way, times) in ways.iter_mut().zip(&mut times) {
            let begin = Instant::now();
            way();
            times.push(begin.elapsed().as_nanos() as f64);
        }
    }
    let middle = |mut values: Vec<f64>| {
        values.sort_by(f64::total_cmp);
        values[values.len() / 2]
    };
    let ratios = |own: &[f64]| own.iter().zip(&times[0]).map(|(time, first)| time / first).collect();
    times.iter().map(|own| (middle(own.clone()), middle(ratios(own)))).collect()
}

/// Steps of the shorter of two runs of which instructions are counted.
const COUNTED: usize = 300;

/// Instructions of one step of this program, run under callgrind with these arguments and a number of steps; once for twice as many, so
/// that everything before the steps cancels.
///
/// # Errors
/// Without `valgrind`, and if the program fails.
pub fn instructions_of(arguments: &[&str]) -> Result<f64, Box<dyn Error>> {
    let counted = |steps: usize| -> Result<f64, Box<dyn Error>> {
        let output = Command::new("valgrind")
            .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
            .arg(std::env::current_exe()?)
            .args(arguments)
            .arg(steps.to_string())
            .output()
            .map_err(|error| format!("`valgrind` is needed to count instructions: {error}"))?;
        let report = String::from_utf8_lossy(&output.stderr);
        let collected = report.lines().find_map(|line| line.split_once("Collected : ")).ok_or_else(|| report.to_string())?;
        Ok(collected.1.trim().parse()?)
    };
    Ok((counted(2 * COUNTED)? - counted(COUNTED)?) / COUNTED as f64)
}
