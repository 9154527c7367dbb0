//! How many samples a long test takes.

/// `all` if the environment variable `REULEAUX_SAMPLES` is set, as in `.ci/run`; otherwise `few`, so that the usual test run is short.
#[must_use]
pub fn samples(few: usize, all: usize) -> usize {
    if std::env::var_os("REULEAUX_SAMPLES").is_some() { all } else { few }
}
