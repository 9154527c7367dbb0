//! Mechanisms that are measured, and everything that is measured on them: the generated solver, what one would write by hand,
//! and other people's solvers, each of which follows a tracked point through a thousand steps.

#[cfg(test)]
mod agreement;
pub mod contender;
pub mod exact;
pub mod hand;
pub mod linkage;
#[cfg(feature = "ezpz")]
mod sketch;
pub mod workloads;

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
