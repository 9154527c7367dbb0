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

/// Steps of a period of one second.
pub const STEPS: usize = 1000;

/// The times of a period after t = 0, in s.
#[must_use]
pub fn times() -> Vec<f64> {
    (1..STEPS).map(|k| k as f64 / STEPS as f64).collect()
}
