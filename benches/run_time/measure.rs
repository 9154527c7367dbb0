//! Times and errors of all contenders of a workload.

use std::time::{Duration, Instant};

use reuleaux_benches::contender::{Contender, Entry, Seen};
use reuleaux_benches::workloads::Workload;
use reuleaux_benches::{exact, times};

/// How long one contender may take in one round; a slower one goes through the beginning of the period only.
const TURN: Duration = Duration::from_millis(5);

/// Measurements of one contender.
#[derive(Clone, Debug)]
pub(crate) struct Line {
    /// The contender.
    pub(crate) name: String,
    /// The residual at which it stops, if it was told one.
    pub(crate) tolerance: Option<f64>,
    /// ns per step.
    pub(crate) time: f64,
    /// Its time over that of the first contender.
    pub(crate) ratio: f64,
    /// Largest errors in the period.
    pub(crate) errors: Errors,
}

/// Distances from the reference.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Errors {
    /// Of the position, as a share of the mechanism's size.
    pub(crate) position: f64,
    /// Of the acceleration, as a share of the largest one.
    pub(crate) acceleration: Option<f64>,
}

/// All contenders in turn in each round; medians of the rounds, and of the ratios in each round.
pub(crate) fn measure(workload: &Workload, rounds: usize) -> Vec<Line> {
    let mut entries = (workload.contenders)(&workload.linkage);
    let times = times();
    let exact = exact::motion(&workload.linkage, &times);
    let errors: Vec<Errors> =
        entries.iter_mut().map(|entry| errors(&mut *entry.contender, &times, &exact, workload.linkage.size)).collect();
    let steps: Vec<usize> = entries.iter_mut().map(|entry| affordable(&mut *entry.contender, &times)).collect();

    let mut nanoseconds: Vec<Vec<f64>> = vec![Vec::new(); entries.len()];
    for _ in 0..rounds {
        for ((entry, steps), nanoseconds) in entries.iter_mut().zip(&steps).zip(&mut nanoseconds) {
            let start = Instant::now();
            entry.contender.sweep(&times[..*steps]);
            nanoseconds.push(start.elapsed().as_secs_f64() * 1e9 / *steps as f64);
        }
    }
    let first = nanoseconds[0].clone();
    let line = |((Entry { name, tolerance, .. }, errors), nanoseconds): ((Entry, Errors), Vec<f64>)| {
        let ratios = nanoseconds.iter().zip(&first).map(|(time, first)| time / first).collect();
        Line { name: name.to_owned(), tolerance, time: median(nanoseconds), ratio: median(ratios), errors }
    };
    entries.into_iter().zip(errors).zip(nanoseconds).map(line).collect()
}

/// How many steps take about a turn's time.
fn affordable(contender: &mut dyn Contender, times: &[f64]) -> usize {
    let few = &times[..10];
    contender.sweep(few);
    let start = Instant::now();
    contender.sweep(few);
    let turn = TURN.as_secs_f64() / (start.elapsed().as_secs_f64() / few.len() as f64);
    (turn as usize).clamp(few.len(), times.len())
}

fn errors(contender: &mut dyn Contender, times: &[f64], exact: &[Seen], size: f64) -> Errors {
    let distance = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    let largest = exact.iter().filter_map(|exact| exact.acceleration).map(|a| a[0].hypot(a[1])).fold(0.0, f64::max);
    let mut errors = Errors { position: 0.0, acceleration: None };
    contender.restart();
    for (&t, exact) in times.iter().zip(exact) {
        contender.step(t);
        let seen = contender.seen();
        errors.position = errors.position.max(distance(seen.place, exact.place) / size);
        if let (Some(seen), Some(exact)) = (seen.acceleration, exact.acceleration) {
            errors.acceleration = Some(errors.acceleration.unwrap_or(0.0).max(distance(seen, exact) / largest));
        }
    }
    errors
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
