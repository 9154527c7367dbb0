//! Every file of `reference/mechanisms` and `reference/stress`, including those without a declaration of their own: the model is written
//! in the language with literals and compiled, and the interpreter evaluates it at the file's states.

use reuleaux_tests::common::declared::{Instant, Rows};
use reuleaux_tests::common::interpreter::Interpreter;
use reuleaux_tests::common::reference::{Value, files, list, number, worse};
use reuleaux_tests::common::text::declaration;

/// Doubles nearest to decimal strings.
fn nearest(value: &Value) -> Vec<f64> {
    list(value).iter().map(|entry| entry.as_str().unwrap().parse().unwrap()).collect()
}

/// Residuals of Φ, of Φ_q q̇ = ν and of Φ_q q̈ = γ, relative to the sum of the magnitudes of their terms, at least 1.
fn residuals(interpreter: &mut Interpreter, at: &Instant) -> [f64; 3] {
    let Rows { phi, jacobian, nu, gamma } = interpreter.rows(&[], at, &[]);
    let size = |row: &[f64], x: &[f64]| row.iter().zip(x).map(|(entry, x)| (entry * x).abs()).sum::<f64>();
    let mut largest = [0.0; 3];
    for (row, line) in jacobian.iter().enumerate() {
        // A rounding error of q moves Φ by the product with the row; the lengths in the row's terms are of this size as well.
        let lengths = 1.0 + size(line, &at.q);
        let product = |x: &[f64]| line.iter().zip(x).map(|(entry, x)| entry * x).sum::<f64>();
        let rates = 1.0 + size(line, &at.qd);
        let accelerations = size(line, &at.qdd) + rates * rates;
        let found = [phi[row] / lengths, (product(&at.qd) - nu[row]) / rates, (product(&at.qdd) - gamma[row]) / accelerations];
        largest = std::array::from_fn(|i| worse(largest[i], found[i].abs()));
    }
    largest
}

#[test]
fn literal_declarations_of_all_mechanisms_hold_at_the_files_states() {
    for (name, file) in files("mechanisms") {
        let mut interpreter = Interpreter::of(&declaration(&file, "Model", ""));
        assert_eq!(interpreter.size.1, list(&file["coordinates"]).len());
        let mut largest = [0.0; 3];
        for state in list(&file["states"]) {
            let at = Instant { t: number(&state["t"]), q: nearest(&state["q"]), qd: nearest(&state["qd"]), qdd: nearest(&state["qdd"]) };
            let found = residuals(&mut interpreter, &at);
            largest = std::array::from_fn(|i| worse(largest[i], found[i]));
        }
        println!("{name}: residuals {largest:?}");
        assert!(largest.iter().all(|residual| *residual <= 4e-15), "{name}: {largest:?}");
    }
}

#[test]
fn the_compiler_closes_all_mechanisms_from_the_files_guesses() {
    for (name, file) in files("mechanisms") {
        let start = Interpreter::of(&declaration(&file, "Model", "")).start;
        let first = &list(&file["states"])[0];
        assert_eq!(number(&first["t"]), 0.0, "{name}");
        for (x, expected) in start.iter().zip(nearest(&first["q"])) {
            assert!((x - expected).abs() <= 1e-12 * (1.0 + expected.abs()), "{name}: {x} for {expected}");
        }
    }
}

/// Only positions: near a singular position, the rounding of the file's q alone changes the rates.
#[test]
fn literal_declarations_of_all_stress_models_hold_at_the_files_solutions() {
    for (family, file) in files("stress") {
        for case in list(&file["cases"]) {
            let mut interpreter = Interpreter::of(&declaration(&case["model"], "Model", "#[equations_only]"));
            let at = Instant { t: number(&case["t"]), q: nearest(&case["q"]), qd: nearest(&case["qd"]), qdd: nearest(&case["qdd"]) };
            let [residual, ..] = residuals(&mut interpreter, &at);
            assert!(residual <= 1e-15, "{family}, {}: {residual:e}", case["label"]);
        }
    }
}
