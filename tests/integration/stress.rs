//! Ill-conditioned families, each case solved from the guess in its file.
//!
//! An entry of q may have the error that the file gives as attainable; an entry of q̇ or q̈ may have that error plus four roundings of
//! the largest entry. If branches cannot be distinguished in doubles, a warning is required instead of digits.

use reuleaux::{Cause, Mechanism, State};
use reuleaux_tests::common::declared::{Declared, vector};
use reuleaux_tests::common::reference::{Value, decimals, file, files, list, number, numbers, text};
use reuleaux_tests::stress::*;

/// 2⁻⁵³
const ROUNDING: f64 = f64::EPSILON / 2.0;

/// Condition at which half of the digits are lost.
const ALARMING: f64 = 1e8;

/// The families below.
const FAMILIES: [&str; 8] =
    ["change_point", "collinear_dyad", "dead_point", "far_origin", "many_turns", "mixed_scales", "small_distance", "unit_ratio"];

/// Largest errors of the entries of q, q̇ and q̈, relative to those allowed.
fn shares<const N: usize>(case: &Value, state: &State<f64, N>) -> [f64; 3] {
    [(&state.q, "q"), (&state.qd, "qd"), (&state.qdd, "qdd")].map(|(found, key)| {
        let (reference, attainable) = (decimals(&case[key]), numbers(&case["attainable"][key]));
        let greatest = reference.iter().map(|entry| entry.value.abs()).fold(0.0, f64::max);
        let entries = found.iter().zip(reference).zip(attainable);
        let shares = entries.map(|((x, entry), attainable)| {
            let at_rest = if key == "q" { 0.0 } else { 4.0 * ROUNDING * greatest };
            let error = entry.error_of(*x);
            if error == 0.0 { 0.0 } else { error / (attainable + at_rest) }
        });
        shares.fold(0.0, f64::max)
    })
}

/// True if the branches can be distinguished in doubles.
fn is_resolvable(case: &Value) -> bool {
    case["branches_resolvable_in_double"] != Value::Bool(false)
}

/// Solves the cases of a family to which this mechanism belongs.
fn check<M: Declared + Mechanism<f64, N>, const N: usize>(family: &str, is_meant: impl Fn(&Value) -> bool) {
    let file = file(&format!("stress/{family}.json"));
    let cases: Vec<&Value> = list(&file["cases"]).iter().filter(|case| is_resolvable(case) && is_meant(case)).collect();
    assert!(!cases.is_empty(), "no cases of {family}");
    let mut open = Vec::new();
    for case in cases {
        let (mechanism, label) = (of::<M>(&case["model"]), text(&case["label"]));
        let found = mechanism.solve_near(number(&case["t"]), &vector(&numbers(&case["initial_guess"])));
        match found {
            Ok(state) => {
                let shares = shares(case, &state);
                println!("{family}, {label}: largest errors over what is allowed {shares:.2?}, condition {:.1e}", state.condition);
                open.extend((!shares.iter().all(|share| *share <= 1.0)).then(|| format!("{label}: {shares:?}")));
            }
            Err(failure) => open.push(format!("{label}: {failure}")),
        }
    }
    assert!(open.is_empty(), "{family}: {open:#?}");
}

fn all(_: &Value) -> bool {
    true
}

fn on(model: &'static str) -> impl Fn(&Value) -> bool {
    move |case| text(&case["parameters"]["model"]) == model
}

#[test]
fn parallelogram_near_its_change_point_keeps_its_branch() {
    check::<FourBar, _>("change_point", all);
}

#[test]
fn almost_straight_dyad_is_at_the_rounding_limit() {
    check::<Dyad, _>("collinear_dyad", all);
}

#[test]
fn four_bar_near_its_dead_point_is_at_the_rounding_limit() {
    check::<RockerDrivenFourBar, _>("dead_point", all);
}

#[test]
fn four_bar_far_from_the_origin_is_at_the_rounding_limit() {
    check::<FourBar, _>("far_origin", all);
}

reuleaux::mechanism! {
    /// A block on a rod of 50 mm, 1000 km from the origin: 30 mm above the rod's other end it is 40 mm beside it.
    mechanism FarRod {
        param height: Length = 30mm;
        body block { start position = (1000000.04m, 1000000.03m); }
        joint upright = absolute_angle(block, 0);
        joint rod = absolute_distance(block.position, (1000000m, 1000000m), 50mm);
        drive lift = drive_y(block.position, 1000000m + height + 10mm * sin(1rad_s * t));
    }
}

#[test]
fn rod_far_from_the_origin_is_not_at_a_dead_point() {
    let state = FarRod::default().solve(0.0).unwrap_or_else(|failure| panic!("{failure}"));
    // x² + y² = (50 mm)² with ẏ = 10 mm/s: ẋ = −y ẏ/x = −7.5 mm/s. A place there has a rounding error of 6e-11 m.
    let (place, velocity) = (state.block().position, state.block().velocity);
    assert!((place.x - 1_000_000.04).abs() < 3e-10 && (velocity.x + 7.5e-3).abs() < 1e-10, "{place} {velocity}");
}

#[test]
fn four_bar_after_many_turns_is_at_the_rounding_limit() {
    check::<FourBar, _>("many_turns", all);
}

#[test]
fn lengths_of_all_sizes_are_at_the_rounding_limit() {
    check::<SmallAndLarge, _>("mixed_scales", all);
}

#[test]
fn small_distance_on_a_rail_is_at_the_rounding_limit() {
    check::<Rail, _>("small_distance", on("rail"));
}

#[test]
fn small_distance_of_an_arm_is_at_the_rounding_limit() {
    check::<Arm, _>("small_distance", on("rocker"));
}

#[test]
fn slider_crank_with_equal_lengths_is_at_the_rounding_limit() {
    check::<InLineSliderCrank, _>("unit_ratio", all);
}

#[test]
fn branches_too_near_for_doubles_are_reported() {
    for (family, file) in files("stress") {
        for case in list(&file["cases"]).iter().filter(|case| !is_resolvable(case)) {
            assert_eq!(family, "change_point", "no mechanism for {}", case["label"]);
            let mechanism = of::<FourBar>(&case["model"]);
            let found = mechanism.solve_near(number(&case["t"]), &vector(&numbers(&case["initial_guess"])));
            let is_reported = match &found {
                Ok(state) => state.condition >= ALARMING,
                Err(failure) => matches!(failure.cause, Cause::Singular { .. }),
            };
            assert!(is_reported, "{}: {found:?}", case["label"]);
        }
    }
}

#[test]
fn no_family_is_left_out() {
    for (family, _) in files("stress") {
        assert!(FAMILIES.contains(&family.as_str()), "{family}");
    }
}
