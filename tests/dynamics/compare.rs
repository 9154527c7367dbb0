//! Follows a mechanism through the instants of a reference file.

use reuleaux_tests::common::decimal::Decimal;
use reuleaux_tests::common::reference::{Value, list, number, text};

/// Error of numbers relative to the largest entry of their vector, which counts as 1 at least.
pub(crate) fn error(found: &[f64], wanted: &Value) -> f64 {
    let mut flat = Vec::new();
    for entry in list(wanted) {
        match entry {
            Value::Array(parts) => flat.extend(parts),
            other => flat.push(other),
        }
    }
    let wanted: Vec<Decimal> = flat.into_iter().map(|entry| Decimal::parse(text(entry))).collect();
    assert_eq!(found.len(), wanted.len());
    let largest = wanted.iter().map(|entry| entry.value.abs()).fold(1.0, f64::max);
    found.iter().zip(wanted).map(|(found, wanted)| wanted.error_of(*found) / largest).fold(0.0, f64::max)
}

/// Condition of the equations of motion in a state, 1000 at least, and sensitivity of the motion to errors before.
pub(crate) fn amplification(state: &Value) -> (f64, f64) {
    let of = |name: &str| state.get(name).map_or(1.0, |entry| Decimal::parse(text(entry)).value);
    ((of("kappa_inf") / 1000.0).max(1.0), of("sensitivity_inf").max(1.0))
}

pub(crate) fn times(reference: &Value) -> Vec<f64> {
    list(&reference["states"])
        .iter()
        .map(|state| match &state["t"] {
            Value::String(text) => Decimal::parse(text).value,
            other => number(other),
        })
        .collect()
}

/// Tolerances of the integrator.
pub(crate) const TOLERANCES: [f64; 3] = [1e-6, 1e-9, 1e-12];

/// The motion of a file at three tolerances. `$found` gives positions, speeds, accelerations and multipliers of a state as vectors, with
/// their names in the file.
macro_rules! motion {
    ($test:ident, $name:literal, $kind:ident, $found:path) => {
        #[test]
        fn $test() {
            use $crate::compare::{TOLERANCES, amplification, error, times};
            let reference = reuleaux_tests::common::reference::file(concat!("dynamics/", $name, ".json"));
            let mechanism = <$kind>::default();
            for tolerance in TOLERANCES {
                let mut state = mechanism.initial_state().unwrap_or_else(|stopped| panic!("{stopped}"));
                let mut integrator = reuleaux::Integrator::new(tolerance);
                for (time, wanted) in times(&reference).into_iter().zip(reuleaux_tests::common::reference::list(&reference["states"])) {
                    mechanism.advance(&mut state, time, &mut integrator).unwrap_or_else(|stopped| panic!("{stopped}"));
                    let [mut at_once, mut apart] = [state.clone(), state.clone()];
                    let loads = mechanism.accelerate_with_loads(&mut at_once).unwrap_or_else(|stopped| panic!("{stopped}"));
                    mechanism.accelerate(&mut apart).unwrap_or_else(|stopped| panic!("{stopped}"));
                    assert_eq!((loads, at_once), (mechanism.loads(&apart), apart.clone()));
                    // A state that counts as changed.
                    let mut touched = state.clone();
                    touched.0.qd *= 1.0;
                    let loads = mechanism.accelerate_with_loads(&mut touched).unwrap_or_else(|stopped| panic!("{stopped}"));
                    assert_eq!((loads, touched), (mechanism.loads(&apart), apart));
                    let (kappa, sensitivity) = amplification(wanted);
                    for (name, found) in $found(&mechanism, &state) {
                        let level = if matches!(name, "qdd" | "wdot" | "lambda") { kappa } else { 1.0 };
                        let error = error(&found, &wanted[name]) / level;
                        let bound = tolerance * sensitivity;
                        assert!(error <= bound, "{} at {time} s and {tolerance:e}: {name} {error:e}", $name);
                    }
                }
            }
        }
    };
}
