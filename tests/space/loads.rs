//! Multipliers of the driven mechanisms of the reference files at all their instants.

use super::mechanisms::*;
use reuleaux_tests::common::decimal::Decimal;
use reuleaux_tests::common::reference::{file, list, number, text};

/// Bound relative to the largest multiplier, times max(1, κ/1000).
const BOUND: f64 = 1e-12;

/// Follows a mechanism through the instants of a file and compares its multipliers, or with redundant joints what its drives have to do.
macro_rules! loads {
    ($test:ident, $name:literal, $kind:ident $(, $drive:ident)?) => {
        #[test]
        fn $test() {
            let reference = file(concat!("space/", $name, ".json"));
            let mechanism = $kind::default();
            let times: Vec<f64> = list(&reference["states"]).iter().map(|state| number(&state["t"])).collect();
            let mut worst = 0.0_f64;
            for (state, wanted) in mechanism.sweep(times.iter().copied()).zip(list(&reference["states"])) {
                let state = state.unwrap_or_else(|failure| panic!("{}: {failure}", $name));
                let loads = mechanism.loads(&state);
                let kappa = (Decimal::parse(text(&wanted["kappa_inf"])).value / 1000.0).max(1.0);
                let all: Vec<Decimal> = list(&wanted["lambda"]).iter().map(|entry| Decimal::parse(text(entry))).collect();
                let largest = all.iter().map(|entry| entry.value.abs()).fold(f64::MIN_POSITIVE, f64::max);
                #[allow(unused_mut, unused_assignments)]
                let mut pairs: Vec<(f64, Decimal)> = loads.multipliers.iter().copied().zip(all).collect();
                $(
                    assert!(loads.is_unique.iter().any(|unique| !unique), "{}", $name);
                    let drive = loads.$drive();
                    assert!(drive.is_unique);
                    pairs = vec![(drive.effort, Decimal::parse(text(&wanted["driver_forces"][0])))];
                )?
                for (found, wanted) in pairs {
                    worst = worst.max(wanted.error_of(found) / largest / kappa);
                }
            }
            println!("{}: {worst:e}", $name);
            assert!(worst <= BOUND, "{}: {worst:e}", $name);
        }
    };
}

loads!(bevel_differential, "bevel_differential", BevelDifferential);
loads!(cardan_shaft, "cardan_shaft", CardanShaft);
loads!(four_bar_in_space, "four_bar_in_space", FourBarInSpace, j4);
loads!(hooke_joint, "hooke_joint", HookeJoint);
loads!(rscr_four_bar, "rscr_four_bar", RscrFourBar);
loads!(rssr_four_bar, "rssr_four_bar", RssrFourBar);
loads!(rsur_four_bar, "rsur_four_bar", RsurFourBar);
loads!(sarrus_linkage, "sarrus_linkage", SarrusLinkage, j6);
loads!(screw_jack, "screw_jack", ScrewJack);
loads!(spatial_slider_crank, "spatial_slider_crank", SpatialSliderCrank);
loads!(stewart_legs, "stewart_legs", StewartLegs);
loads!(stewart_platform, "stewart_platform", StewartPlatform);
loads!(ur5_arm, "ur5_arm", Ur5Arm);
loads!(worm_gear, "worm_gear", WormGear);
