//! Six mechanisms over one cycle: positions, velocities and accelerations at 25 instants.

use reuleaux::nalgebra::SVector;
use reuleaux::{Mechanism, State};
use reuleaux_tests::common::declared::{Declared, Instant, vector};
use reuleaux_tests::common::reference::{Value, decimals, file, list, number, numbers, relative_error, worse};
use reuleaux_tests::mechanisms::*;

/// Largest errors of q, q̇ and q̈, relative to the largest entry of the vector.
const ALLOWED: [f64; 3] = [1e-14, 2e-14, 2e-13];

/// Errors of a state and of its point of interest, relative to the largest entry.
fn errors<M: Declared, const N: usize>(mechanism: &M, found: &State<f64, N>, reference: &Value) -> [f64; 3] {
    let vectors = [(&found.q, "q"), (&found.qd, "qd"), (&found.qdd, "qdd")];
    let [q, qd, qdd] = vectors.map(|(vector, key)| relative_error(vector.as_slice(), &decimals(&reference[key])));
    let [q_, qd_, qdd_] = [&found.q, &found.qd, &found.qdd].map(|vector| vector.as_slice().to_vec());
    let outputs = mechanism.outputs(&Instant { t: found.t, q: q_, qd: qd_, qdd: qdd_ });
    let point = &list(&reference["points"])[0];
    // Relative to the largest entry of the whole vector and of the point, whose motion is computed from the vector.
    let of_point = |order: usize, of: &str, key: &str| {
        let (all, point) = (decimals(&reference[of]), decimals(&point[key]));
        let largest = all.iter().chain(&point).map(|entry| entry.value.abs()).fold(0.0, f64::max);
        point.iter().zip(&outputs).map(|(entry, output)| entry.error_of(output[order]) / largest).fold(0.0, worse)
    };
    [worse(q, of_point(0, "q", "r")), worse(qd, of_point(1, "qd", "v")), worse(qdd, of_point(2, "qdd", "a"))]
}

/// Number of steps of a fine sweep, and the largest average number of corrections per step.
const STEPS: u32 = 1000;
const MOST_CORRECTIONS: f64 = 1.05;

/// Solves a mechanism in all ways and prints the largest errors.
fn check<M: Declared + Default + Mechanism<f64, N>, const N: usize>(name: &str) {
    let (mechanism, file) = (M::default(), file(&format!("mechanisms/{name}.json")));
    let states = list(&file["states"]);
    let times: Vec<f64> = states.iter().map(|state| number(&state["t"])).collect();
    let mut largest = [0.0_f64; 3];
    let mut note = |way: &str, found: &State<f64, N>, reference: &Value| {
        let errors = errors(&mechanism, found, reference);
        assert!(errors.iter().zip(ALLOWED).all(|(error, allowed)| *error <= allowed), "{name} {way} at {} s: {errors:?}", found.t);
        largest = std::array::from_fn(|i| largest[i].max(errors[i]));
    };

    let rough = list(&file["rough_guesses"]).iter().map(|guess| numbers(&guess["q"]));
    for guess in std::iter::once(numbers(&file["initial_guess"]["q"])).chain(rough) {
        let guess: SVector<f64, N> = vector(&guess);
        let mut state = mechanism.solve_near(times[0], &guess).unwrap_or_else(|failure| panic!("{failure} from {guess}"));
        note("from a guess", &state, &states[0]);
        for reference in &states[1..] {
            state = mechanism.solve_from(number(&reference["t"]), &state).unwrap_or_else(|failure| panic!("{failure}"));
            note("from the state before", &state, reference);
        }
    }
    for (found, reference) in mechanism.sweep(times.iter().copied()).zip(states) {
        note("in a sweep", &found.unwrap_or_else(|failure| panic!("{failure}")), reference);
    }
    for reference in states {
        let found = mechanism.solve(number(&reference["t"])).unwrap_or_else(|failure| panic!("{failure}"));
        note("from the start", &found, reference);
    }
    // A step factorises Φ_q at the prediction and once more after a correction: usually twice.
    let (begin, end) = (times[0], times[times.len() - 1]);
    let steps = (0..=STEPS).map(|step| begin + (end - begin) * f64::from(step) / f64::from(STEPS));
    let formed = mechanism.sweep(steps).skip(1).map(|state| state.unwrap_or_else(|failure| panic!("{failure}")).iterations);
    let corrections = formed.map(|times| times.saturating_sub(1)).sum::<usize>() as f64 / f64::from(STEPS);
    assert!(corrections <= MOST_CORRECTIONS, "{name}: {corrections} corrections a step");
    println!(
        "{name}: {corrections} corrections a step, largest relative errors of q {:.1e}, q̇ {:.1e}, q̈ {:.1e}",
        largest[0], largest[1], largest[2]
    );
}

#[test]
fn four_bar_is_at_the_rounding_limit() {
    check::<FourBarCrankRocker, _>("four_bar_crank_rocker");
}

#[test]
fn slider_crank_is_at_the_rounding_limit() {
    check::<SliderCrank, _>("slider_crank");
}

#[test]
fn quick_return_is_at_the_rounding_limit() {
    check::<QuickReturn, _>("quick_return");
}

#[test]
fn theo_jansen_leg_is_at_the_rounding_limit() {
    check::<TheoJansenLeg, _>("theo_jansen_leg");
}

#[test]
fn hydraulic_loader_is_at_the_rounding_limit() {
    check::<HydraulicLoader, _>("hydraulic_loader");
}

#[test]
fn two_stage_gear_train_is_at_the_rounding_limit() {
    check::<TwoStageGearTrain, _>("two_stage_gear_train");
}

#[test]
fn gear_train_of_pairs_is_at_the_rounding_limit() {
    check::<GearTrainOfPairs, _>("two_stage_gear_train");
}
