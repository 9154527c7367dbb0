//! Φ, Φ_q, ν and γ of every type of constraint at random states, which do not satisfy it.
//!
//! The bound of an entry is the rounding error of a plain evaluation in doubles; 16 times this bound, plus eight roundings of the largest
//! entry of the row, is allowed.

mod emitted;
mod literal;
mod multiples;

use reuleaux_tests::common::decimal::Decimal;
use reuleaux_tests::common::declared::{Instant, Rows};
use reuleaux_tests::common::reference::{Value, decimals, file, list, number, numbers, text};

/// 2⁻⁵³
const ROUNDING: f64 = f64::EPSILON / 2.0;

/// The cases of a type.
fn cases(of: &str) -> Vec<Value> {
    let file = file("unit_constraints.json");
    let cases: Vec<Value> = list(&file["cases"]).iter().filter(|case| text(&case["constraint"]["type"]) == of).cloned().collect();
    assert!(!cases.is_empty(), "no case of `{of}`");
    cases
}

/// Time, positions and velocities of a case; a case without a time has constraints that do not depend on it.
fn instant(case: &Value) -> Instant {
    let of = |key: &str| list(&case["bodies"]).iter().flat_map(|body| numbers(&body[key])).collect();
    Instant { t: case["t"].as_f64().unwrap_or(0.25), q: of("q"), qd: of("qd"), qdd: Vec::new() }
}

/// Largest error relative to the allowed one, for the rows of the case that `rows` lists, in its order.
fn share(case: &Value, found: &Rows, rows: &[usize]) -> f64 {
    let mut largest = 0.0_f64;
    for (at, row) in rows.iter().enumerate() {
        let line = |key: &str| (vec![Decimal::parse(text(&case[key][row]))], vec![number(&case[format!("{key}_bound")][row])]);
        let jacobian = (decimals(&case["J"][row]), numbers(&case["J_bound"][row]));
        let lines = [
            (vec![found.phi[at]], line("Phi")),
            (found.jacobian[at].clone(), jacobian),
            (vec![found.nu[at]], line("nu")),
            (vec![found.gamma[at]], line("gamma")),
        ];
        for (line, (found, (reference, bounds))) in ["Φ", "Φ_q", "ν", "γ"].iter().zip(lines) {
            let greatest = reference.iter().map(|entry| entry.value.abs()).fold(0.0, f64::max);
            assert_eq!(found.len(), reference.len());
            for ((x, reference), bound) in found.iter().zip(&reference).zip(bounds) {
                let (error, allowed) = (reference.error_of(*x), 16.0 * bound + 8.0 * ROUNDING * greatest);
                assert!(error <= allowed, "{line} of row {row} is {x:e} instead of {:e}, {error:e} > {allowed:e}: {case}", reference.value);
                largest = if allowed > 0.0 { largest.max(error / allowed) } else { largest };
            }
        }
    }
    largest
}

/// All rows of a case.
fn all(case: &Value) -> Vec<usize> {
    (0..list(&case["Phi"]).len()).collect()
}
