//! How many samples a long test takes.

/// `all` if the variable `REULEAUX_SAMPLES` is `all`, as in `.ci/run`; otherwise `few`, so that the usual test run is short.
#[must_use]
pub fn samples(few: usize, all: usize) -> usize {
    if std::env::var_os("REULEAUX_SAMPLES").is_some_and(|which| which == "all") { all } else { few }
}
