//! Error bounds, certificates and polished states compared with reference numbers, and certificates requested for states that are no
//! solutions.

mod kinds;
mod polished;
mod space;
mod wrong;

use reuleaux::nalgebra::SVector;
use reuleaux::{Enclosure, Family, Mechanism, Stages, State};
use reuleaux_tests::common::decimal::Decimal;
use reuleaux_tests::common::declared::{Declared, vector};
use reuleaux_tests::common::reference::{Value, decimals, file, list, number, numbers, text};
use reuleaux_tests::mechanisms::*;
use reuleaux_tests::stress::*;

/// Accuracy of the reference, relative to the largest entry.
const WRITTEN: f64 = 1e-22;

/// Effect of constant folding, relative to the largest entry: the compiler folds 2 · 0.35 to the double nearest to 0.7, the reference
/// takes twice the double nearest to 0.35. Parameters are doubles in both.
const CONSTANTS: f64 = f64::EPSILON / 2.0;

/// Allowed excess of a bound over the error, relative to the largest entry; and absolute size of zero.
const ROUNDING: f64 = f64::EPSILON / 16.0;
const NOTHING: f64 = 1e-20;

/// Compares bounds with true errors.
fn bounds_hold<const N: usize>(label: &str, found: &SVector<f64, N>, bounds: &SVector<f64, N>, reference: &[Decimal], constants: f64) {
    let size = reference.iter().map(|entry| entry.value.abs()).fold(0.0, f64::max);
    for ((x, bound), entry) in found.iter().zip(bounds).zip(reference) {
        let error = entry.error_of(*x);
        assert!(error <= bound + (WRITTEN + constants) * size, "{label}: an error of {error:e} is beyond {bound:e}");
        assert!(*bound <= 2.0 * error + (ROUNDING + constants) * size + NOTHING, "{label}: a bound of {bound:e} for an error of {error:e}");
    }
}

fn state_is_bounded<M, const N: usize>(label: &str, mechanism: &M, state: &State<f64, N>, reference: &Value, constants: f64)
where
    M: Mechanism<f64, N> + Family<f64>,
    M::Over<Enclosure>: Stages<Enclosure, N>,
{
    let bound = mechanism.error_bound(state).unwrap_or_else(|doubt| panic!("{label}: {doubt}"));
    let certificate = mechanism.certify(state).unwrap_or_else(|doubt| panic!("{label}: {doubt}"));
    assert_eq!(certificate.within, bound, "{label}");
    let each = [(&state.q, &bound.q, "q"), (&state.qd, &bound.qd, "qd"), (&state.qdd, &bound.qdd, "qdd")];
    for (found, bound, key) in each {
        bounds_hold(&format!("{label}, {key}"), found, bound, &decimals(&reference[key]), constants);
    }
}

fn mechanism_is_bounded<M, const N: usize>(name: &str)
where
    M: Declared + Default + Mechanism<f64, N> + Family<f64>,
    M::Over<Enclosure>: Stages<Enclosure, N>,
{
    let (mechanism, file) = (M::default(), file(&format!("mechanisms/{name}.json")));
    let states = list(&file["states"]);
    let times = states.iter().map(|state| number(&state["t"]));
    for (found, reference) in mechanism.sweep(times).zip(states) {
        state_is_bounded(name, &mechanism, &found.unwrap_or_else(|failure| panic!("{failure}")), reference, CONSTANTS);
    }
}

#[test]
fn states_of_six_mechanisms_are_within_their_bounds() {
    mechanism_is_bounded::<FourBarCrankRocker, _>("four_bar_crank_rocker");
    mechanism_is_bounded::<SliderCrank, _>("slider_crank");
    mechanism_is_bounded::<QuickReturn, _>("quick_return");
    mechanism_is_bounded::<TheoJansenLeg, _>("theo_jansen_leg");
    mechanism_is_bounded::<HydraulicLoader, _>("hydraulic_loader");
    mechanism_is_bounded::<TwoStageGearTrain, _>("two_stage_gear_train");
    mechanism_is_bounded::<GearTrainOfPairs, _>("two_stage_gear_train");
}

fn family_is_bounded<M, const N: usize>(family: &str, is_meant: impl Fn(&Value) -> bool)
where
    M: Declared + Mechanism<f64, N> + Family<f64>,
    M::Over<Enclosure>: Stages<Enclosure, N>,
{
    let file = file(&format!("stress/{family}.json"));
    for case in list(&file["cases"]).iter().filter(|case| is_meant(case)) {
        let (mechanism, label) = (of::<M>(&case["model"]), text(&case["label"]));
        let Ok(state) = mechanism.solve_near(number(&case["t"]), &vector(&numbers(&case["initial_guess"]))) else {
            assert_eq!(case["branches_resolvable_in_double"], Value::Bool(false), "{family}, {label}");
            continue;
        };
        state_is_bounded(&format!("{family}, {label}"), &mechanism, &state, case, 0.0);
    }
}

fn on(model: &'static str) -> impl Fn(&Value) -> bool {
    move |case| text(&case["parameters"]["model"]) == model
}

#[test]
fn states_of_stress_families_are_within_their_bounds() {
    family_is_bounded::<FourBar, _>("change_point", |_| true);
    family_is_bounded::<Dyad, _>("collinear_dyad", |_| true);
    family_is_bounded::<RockerDrivenFourBar, _>("dead_point", |_| true);
    family_is_bounded::<FourBar, _>("far_origin", |_| true);
    family_is_bounded::<FourBar, _>("many_turns", |_| true);
    family_is_bounded::<SmallAndLarge, _>("mixed_scales", |_| true);
    family_is_bounded::<Rail, _>("small_distance", on("rail"));
    family_is_bounded::<Arm, _>("small_distance", on("rocker"));
    family_is_bounded::<InLineSliderCrank, _>("unit_ratio", |_| true);
}

/// Solves from guesses a hundred times as far off as those of the file; returns the numbers of cases and of solved cases.
fn far_guesses_are_judged<M, const N: usize>(family: &str, is_meant: impl Fn(&Value) -> bool) -> [usize; 2]
where
    M: Declared + Mechanism<f64, N> + Family<f64>,
    M::Over<Enclosure>: Stages<Enclosure, N>,
{
    let file = file(&format!("stress/{family}.json"));
    let mut counts = [0; 2];
    for case in list(&file["cases"]).iter().filter(|case| is_meant(case)) {
        let (mechanism, label) = (of::<M>(&case["model"]), text(&case["label"]));
        let (solution, guess) = (decimals(&case["q"]), numbers(&case["initial_guess"]));
        let far: Vec<f64> = guess.iter().zip(&solution).map(|(guess, q)| q.value + 100.0 * (guess - q.value)).collect();
        counts[0] += 1;
        if let Ok(state) = mechanism.solve_near(number(&case["t"]), &vector(&far)) {
            counts[1] += 1;
            let proven = mechanism.certify(&state);
            assert!(proven.is_ok(), "{family}, {label}: {proven:?} at a condition of {:e}", state.condition);
        }
    }
    counts
}

#[test]
fn far_guesses_lead_to_solutions_or_to_verdicts() {
    let counts = [
        far_guesses_are_judged::<FourBar, _>("change_point", |_| true),
        far_guesses_are_judged::<Dyad, _>("collinear_dyad", |_| true),
        far_guesses_are_judged::<RockerDrivenFourBar, _>("dead_point", |_| true),
        far_guesses_are_judged::<FourBar, _>("far_origin", |_| true),
        far_guesses_are_judged::<FourBar, _>("many_turns", |_| true),
        far_guesses_are_judged::<SmallAndLarge, _>("mixed_scales", |_| true),
        far_guesses_are_judged::<Rail, _>("small_distance", on("rail")),
        far_guesses_are_judged::<Arm, _>("small_distance", on("rocker")),
        far_guesses_are_judged::<InLineSliderCrank, _>("unit_ratio", |_| true),
    ];
    let [cases, solved] = [0, 1].map(|k| counts.iter().map(|count| count[k]).sum::<usize>());
    assert!(2 * solved > cases, "most guesses lead to a solution: {solved} of {cases}");
}
