//! Objectivity: a rigid motion of all bodies changes no row, and neither does the sign of a quaternion; angles come back from many turns.

use super::mechanisms::{ScrewJack, WormGear};
use super::units::{Rows, rows};
use reuleaux_tests::common::reference::{Value, file, list, number, text};

/// Cases whose rows do not know of ground.
fn cases() -> Vec<Value> {
    let all = ["space/unit_constraints.json", "space/unit_velocity_rows.json"].map(|name| list(&file(name)["cases"]).to_vec()).concat();
    let is_free = |case: &Value| {
        let (constraint, kind) = (&case["constraint"], text(&case["constraint"]["type"]));
        let has_ground = constraint.to_string().contains("\"ground\"");
        // A multi-point constraint holds what its terms say, also against a common motion.
        !has_ground && !kind.contains("absolute") && kind != "mpc"
    };
    all.into_iter().filter(is_free).collect()
}

#[test]
fn a_common_rigid_motion_satisfies_every_row() {
    for case in cases() {
        let Rows { jacobian, .. } = rows(&case);
        let places: Vec<Vec<f64>> = list(&case["bodies"]).iter().map(|body| list(&body["r"]).iter().map(number).collect()).collect();
        for motion in 0..6 {
            let unit = |k: usize| f64::from(u8::from(k == motion));
            let (v, w) = ([unit(0), unit(1), unit(2)], [unit(3), unit(4), unit(5)]);
            // Three rows that keep two points together are a vector, which turns with the bodies.
            let is_vector = ["spherical", "revolute", "universal", "weld"].contains(&text(&case["constraint"]["type"]));
            for row in jacobian.iter().skip(if is_vector && motion >= 3 { 3 } else { 0 }) {
                let mut terms = Vec::new();
                for (body, r) in places.iter().enumerate() {
                    let swing = [w[1] * r[2] - w[2] * r[1], w[2] * r[0] - w[0] * r[2], w[0] * r[1] - w[1] * r[0]];
                    for k in 0..3 {
                        terms.extend([row[6 * body + k] * (v[k] + swing[k]), row[6 * body + 3 + k] * w[k]]);
                    }
                }
                let size = terms.iter().map(|term| term.abs()).fold(0.0, f64::max);
                let rest: f64 = terms.iter().sum();
                assert!(rest.abs() <= 1e-13 * size, "{}: {rest:e} of {size:e}", text(&case["id"]));
            }
        }
    }
}

#[test]
fn the_sign_of_a_quaternion_changes_nothing() {
    for case in cases() {
        let mut other = case.clone();
        for body in other["bodies"].as_array_mut().expect("bodies") {
            for part in body["p"].as_array_mut().expect("a quaternion") {
                *part = Value::from(-number(part));
            }
        }
        let (one, two) = (rows(&case), rows(&other));
        assert_eq!((one.phi, one.jacobian, one.nu, one.gamma), (two.phi, two.jacobian, two.nu, two.gamma), "{}", text(&case["id"]));
    }
}

#[test]
fn many_turns_forward_and_back_return_to_the_start() -> Result<(), Box<dyn std::error::Error>> {
    let (worm, screw) = (WormGear::default(), ScrewJack::default());
    let (first, start) = (worm.solve(0.0)?, screw.solve(0.0)?);
    let (mut state, mut jack) = (first.clone(), start.clone());
    for step in (1..=200).chain((0..200).rev()) {
        let t = f64::from(step) * 0.05;
        worm.advance(&mut state, t)?;
        screw.advance(&mut jack, t)?;
    }
    assert!((state.q - first.q).amax() == 0.0, "{:e}", (state.q - first.q).amax());
    assert!((jack.q - start.q).amax() <= 1e-16, "{:e}", (jack.q - start.q).amax());
    Ok(())
}
