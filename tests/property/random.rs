//! Random parameters and states, the same on every run.

use fastrand::Rng;
use reuleaux_tests::common::declared::{Declared, Instant};

/// A random number generator for each declaration.
pub(crate) fn generator(name: &str) -> Rng {
    Rng::with_seed(name.bytes().fold(20_260_101, |seed, byte| seed * 31 % 1_000_000_007 + u64::from(byte)))
}

/// A number between `low` and `high`.
pub(crate) fn between(rng: &mut Rng, low: f64, high: f64) -> f64 {
    low + (high - low) * rng.f64()
}

/// A parameter from 0.5 to 2: radii, teeth, axes and durations must not be zero.
pub(crate) fn parameter(rng: &mut Rng) -> f64 {
    between(rng, 0.5, 2.0)
}

/// The declaration with random parameters, and these parameters by name.
pub(crate) fn mechanism<D: Declared>(rng: &mut Rng) -> (D, Vec<(String, f64)>) {
    let mut parameters = Vec::new();
    let mechanism = D::with(&mut |name| {
        let value = parameter(rng);
        parameters.push((name.to_owned(), value));
        value
    });
    (mechanism, parameters)
}

/// A time and n coordinates with their rates, which satisfy no equations.
pub(crate) fn instant(rng: &mut Rng, n: usize) -> Instant {
    let mut vector = |size: f64| (0..n).map(|_| between(rng, -size, size)).collect::<Vec<f64>>();
    let (q, qd, qdd) = (vector(3.0), vector(2.0), vector(2.0));
    Instant { t: between(rng, -2.0, 2.0), q, qd, qdd }
}
