//! Invariances: position of a mechanism, order and names of its declaration, order of a joint's sides, units.

mod loader;
mod motion;
mod names;
mod order;
mod scale;
mod sides;
mod turns;
mod units;

use proptest::test_runner::{Config, RngSeed};
use reuleaux::State;

/// Configuration with this number of cases, reproducible.
fn cases(cases: u32) -> Config {
    Config { cases, failure_persistence: None, rng_seed: RngSeed::Fixed(1876), ..Config::default() }
}

/// Largest difference of q, q̇ and q̈, relative to the largest entry.
fn difference<const N: usize>(one: &State<f64, N>, two: &State<f64, N>) -> f64 {
    let vectors = [(one.q, two.q), (one.qd, two.qd), (one.qdd, two.qdd)];
    vectors.into_iter().map(|(one, two)| (one - two).amax() / one.amax().max(1.0)).fold(0.0, f64::max)
}
