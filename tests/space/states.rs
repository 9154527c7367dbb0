//! The mechanisms of the reference files at all their instants: places, orientations, speeds and accelerations of every body.

use super::mechanisms::*;
use reuleaux::SpatialBody;
use reuleaux_tests::common::decimal::Decimal;
use reuleaux_tests::common::reference::{Value, file, list, number, text};

/// Bounds relative to the largest entry, times max(1, κ/1000): of places and orientations, of speeds, of accelerations.
const BOUNDS: [f64; 3] = [1e-14, 4e-14, 4e-13];

/// The largest error of some numbers, relative to the largest of them, or to 1 where all are zero.
fn error(found: &[f64], wanted: &[Decimal]) -> f64 {
    assert_eq!(found.len(), wanted.len());
    let largest = wanted.iter().map(|entry| entry.value.abs()).fold(0.0, f64::max);
    let largest = if largest > 0.0 { largest } else { 1.0 };
    found.iter().zip(wanted).map(|(found, wanted)| wanted.error_of(*found) / largest).fold(0.0, f64::max)
}

fn decimals(value: &Value) -> Vec<Decimal> {
    match value {
        Value::Array(all) => all.iter().flat_map(decimals).collect(),
        entry => vec![Decimal::parse(text(entry))],
    }
}

/// The error of an orientation, whichever sign its quaternion has.
fn turned_by(body: &SpatialBody<f64>, wanted: &Value) -> f64 {
    let wanted = decimals(wanted);
    let found = body.orientation();
    let found = [found.w, found.i, found.j, found.k];
    let opposite = found.map(|part| -part);
    error(&found, &wanted).min(error(&opposite, &wanted))
}

/// Follows a mechanism through the instants of a file.
macro_rules! follows {
    ($test:ident, $name:literal, $kind:ident, [$($body:ident),*]) => {
        #[test]
        fn $test() {
            let reference = file(concat!("space/", $name, ".json"));
            let mechanism = $kind::default();
            let times: Vec<f64> = list(&reference["states"]).iter().map(|state| number(&state["t"])).collect();
            let mut worst = [0.0_f64; 4];
            for (state, wanted) in mechanism.sweep(times.iter().copied()).zip(list(&reference["states"])) {
                let state = state.unwrap_or_else(|failure| panic!("{}: {failure}", $name));
                let bodies = [$(state.$body()),*];
                let kappa = (Decimal::parse(text(&wanted["kappa_inf"])).value / 1000.0).max(1.0);
                let places: Vec<f64> = bodies.iter().flat_map(|body| body.position.iter().copied().collect::<Vec<f64>>()).collect();
                let speeds: Vec<f64> = bodies.iter().flat_map(|body| body.velocity.iter().chain(body.angular_velocity.iter()).copied().collect::<Vec<f64>>()).collect();
                let rates: Vec<f64> = bodies.iter().flat_map(|body| body.acceleration.iter().chain(body.angular_acceleration.iter()).copied().collect::<Vec<f64>>()).collect();
                let turns = bodies.iter().zip(list(&wanted["p"])).map(|(body, wanted)| turned_by(body, wanted)).fold(0.0, f64::max);
                let errors = [error(&places, &decimals(&wanted["r"])), turns, error(&speeds, &decimals(&wanted["w"])), error(&rates, &decimals(&wanted["wdot"]))];
                worst = std::array::from_fn(|k| worst[k].max(errors[k] / kappa));
            }
            println!("{}: {worst:?}", $name);
            let bounds = [BOUNDS[0], BOUNDS[0], BOUNDS[1], BOUNDS[2]];
            assert!(worst.iter().zip(bounds).all(|(error, bound)| *error <= bound), "{}: {worst:?}", $name);
        }
    };
}

follows!(bevel_differential, "bevel_differential", BevelDifferential, [carrier, side1, side2, planet]);
follows!(cardan_shaft, "cardan_shaft", CardanShaft, [input, middle, output]);
follows!(four_bar_in_space, "four_bar_in_space", FourBarInSpace, [crank, coupler, rocker]);
follows!(hooke_joint, "hooke_joint", HookeJoint, [shaft1, shaft2]);
follows!(rscr_four_bar, "rscr_four_bar", RscrFourBar, [crank, coupler, rocker]);
follows!(rssr_four_bar, "rssr_four_bar", RssrFourBar, [crank, rocker]);
follows!(rsur_four_bar, "rsur_four_bar", RsurFourBar, [crank, coupler, rocker]);
follows!(sarrus_linkage, "sarrus_linkage", SarrusLinkage, [a1, a2, platform, b1, b2]);
follows!(screw_jack, "screw_jack", ScrewJack, [spindle, nut]);
follows!(spatial_slider_crank, "spatial_slider_crank", SpatialSliderCrank, [crank, rod, slider]);
follows!(
    stewart_legs,
    "stewart_legs",
    StewartLegs,
    [platform, cylinder1, rod1, cylinder2, rod2, cylinder3, rod3, cylinder4, rod4, cylinder5, rod5, cylinder6, rod6]
);
follows!(stewart_platform, "stewart_platform", StewartPlatform, [platform]);
follows!(ur5_arm, "ur5_arm", Ur5Arm, [link1, link2, link3, link4, link5, link6]);
follows!(worm_gear, "worm_gear", WormGear, [worm, wheel]);
