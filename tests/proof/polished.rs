//! States rounded from 32 digits.

use reuleaux::Real;
use reuleaux::{Enclosure, Family, Mechanism, Stages, State};
use reuleaux_tests::common::declared::{Declared, vector};
use reuleaux_tests::common::reference::{Value, decimals, file, list, number, numbers, text};
use reuleaux_tests::common::twofold::Twofold;
use reuleaux_tests::stress::*;

/// Half a unit in the last place, plus the width of an enclosure.
const NEAREST: f64 = f64::EPSILON / 2.0 * 1.001;

fn states<M: Declared + Mechanism<f64, N>, const N: usize>(
    family: &str,
    is_meant: impl Fn(&Value) -> bool,
    mut check: impl FnMut(&str, &M, State<f64, N>, &Value),
) {
    let file = file(&format!("stress/{family}.json"));
    for case in list(&file["cases"]).iter().filter(|case| is_meant(case)) {
        let mechanism = of::<M>(&case["model"]);
        if let Ok(state) = mechanism.solve_near(number(&case["t"]), &vector(&numbers(&case["initial_guess"]))) {
            check(text(&case["label"]), &mechanism, state, case);
        }
    }
}

fn family_is_nearest<M, const N: usize>(family: &str, is_meant: impl Fn(&Value) -> bool)
where
    M: Declared + Mechanism<f64, N> + Family<f64>,
    M::Over<Enclosure>: Stages<Enclosure, N>,
{
    states(family, is_meant, |label, mechanism: &M, mut state, case| {
        mechanism.polish(&mut state).unwrap_or_else(|doubt| panic!("{family}, {label}: {doubt}"));
        for (found, key) in [(&state.q, "q"), (&state.qd, "qd"), (&state.qdd, "qdd")] {
            let reference = decimals(&case[key]);
            for ((x, entry), attainable) in found.iter().zip(reference).zip(numbers(&case["attainable"][key])) {
                // An entry that is negligible beside the others may have an error as large as the enclosure.
                let allowed = NEAREST * x.abs() + 1e-8 * attainable;
                assert!(entry.error_of(*x) <= allowed, "{family}, {label}, {key}: {x} is off by {:e}", entry.error_of(*x));
            }
        }
    });
}

#[test]
fn polished_states_of_stress_families_are_the_nearest() {
    family_is_nearest::<FourBar, _>("change_point", |_| true);
    family_is_nearest::<Dyad, _>("collinear_dyad", |_| true);
    family_is_nearest::<RockerDrivenFourBar, _>("dead_point", |_| true);
    family_is_nearest::<FourBar, _>("far_origin", |_| true);
    family_is_nearest::<FourBar, _>("many_turns", |_| true);
    family_is_nearest::<SmallAndLarge, _>("mixed_scales", |_| true);
    family_is_nearest::<Rail, _>("small_distance", |case| text(&case["parameters"]["model"]) == "rail");
    family_is_nearest::<Arm, _>("small_distance", |case| text(&case["parameters"]["model"]) == "rocker");
    family_is_nearest::<InLineSliderCrank, _>("unit_ratio", |_| true);
}

/// Angle, rate and acceleration of the first bar of a dyad by the law of cosines, in 32 digits.
fn first_bar(dyad: &Dyad, t: f64) -> [Twofold; 3] {
    let [a, b, v] = [dyad.bar1_B_x, dyad.bar2_C_x, dyad.c1].map(Twofold::from);
    let one = Twofold::of(1.0);
    let two = Twofold::of(2.0);
    let d = Twofold::from(dyad.c0) + v * t.into();
    // cos φ = (a² − b² + d²) / (2 a d)
    let cosine = (a * a - b * b + d * d) / (two * a * d);
    // sin² φ = (a + b + d)(a + b − d)(a − b + d)(b − a + d) / (2 a d)², which is small near a toggle, without cancellation.
    let area = (a + b + d) * (a + b - d) * (a - b + d) * (b - a + d);
    let sine = area.sqrt() / (two * a * d);
    // First and second derivative of cos φ by d.
    let first = (one - (a * a - b * b) / (d * d)) / (two * a);
    let second = (a * a - b * b) / (d * d * d) / a;
    // −sin φ φ̇ = c′ v;  −cos φ φ̇² − sin φ φ̈ = c″ v²
    let rate = -(first * v) / sine;
    let acceleration = -(second * v * v + cosine * rate * rate) / sine;
    [sine.atan2(cosine), rate, acceleration]
}

/// A polished state has all digits, even where doubles lose more and more of them.
#[test]
fn polished_states_of_dyads_near_their_toggle_are_the_nearest() {
    for (a, b, ratio) in [(1.0, 0.7, 1.0), (0.8, 0.55, -0.3), (1.3, 1.1, 0.8)] {
        let mut worst = 0.0_f64;
        for digits in 2..=12 {
            let gap = 10.0_f64.powi(-digits) * (1.0 + 0.3 * ratio);
            let dyad = Dyad { bar1_B_x: a, bar2_C_x: b, c0: (a + b) * (1.0 - gap), c1: ratio };
            let [angle, rate, acceleration] = first_bar(&dyad, 0.0);
            let (first, second) = (angle.high, -(a / b * angle.high.sin()).asin());
            let guess = [0.0, 0.0, first, a, 0.0, second, dyad.c0, 0.0, 0.0];
            let mut state = dyad.solve_near(0.0, &vector(&guess)).unwrap_or_else(|failure| panic!("gap {gap:e}: {failure}"));
            let relative = |state: &State<f64, 9>| {
                [(state.q[2], angle), (state.qd[2], rate), (state.qdd[2], acceleration)]
                    .map(|(found, exact)| ((Twofold::from(found) - exact).high / exact.high).abs())
            };
            let plain = relative(&state);
            worst = plain.into_iter().fold(worst, f64::max);
            dyad.polish(&mut state.0).unwrap_or_else(|doubt| panic!("gap {gap:e}: {doubt}"));
            let polished = relative(&state);
            println!("gap {gap:.0e}: plain {plain:?}, polished {polished:?}");
            assert!(polished.iter().all(|error| *error <= NEAREST), "gap {gap:e}: {polished:?}");
        }
        assert!(worst > 1e-7, "nothing was lost: {worst:e}");
    }
}
