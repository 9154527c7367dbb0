//! Multipliers of the driven mechanisms of the reference files at all their instants.

use super::mechanisms::*;
use reuleaux::mechanism;
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

mechanism! {
    /// A door with a torsion spring that is wound up over more than a turn.
    mechanism Door in space {
        param stiffness: Torque = 2Nm;
        ground { axis z = (0, 0, 1) from (1, 0, 0); }
        body leaf { axis z = (0, 0, 1) from (1, 0, 0);  point handle = (0.8m, 0m, 0m);  mass = 3kg;  center = (0.4m, 0m, 0m);  inertia = (1kgm2, 1kgm2, 1kgm2); }
        joint hinge = revolute(ground.position, ground.z, leaf.position, leaf.z);
        force spring = { on leaf: (0Nm, 0Nm, -stiffness * hinge.angle); };
        drive motor = drive_rotation(hinge, 1rad_s * t);
    }
}

#[test]
fn forces_by_the_angle_of_a_joint_count_whole_turns() {
    let door = Door::default();
    for state in door.sweep((0..100).map(|step| 0.1 * f64::from(step))) {
        let state = state.expect("a state");
        assert!((door.loads(&state).motor().effort - 2.0 * state.t).abs() < 1e-13, "{}", state.t);
    }
}

#[test]
fn equations_between_angles_have_multipliers_by_name() {
    let gear = WormGear::default();
    let state = gear.solve(0.3).expect("a state");
    let loads = gear.loads(&state);
    let [mesh] = loads.j2();
    assert!(mesh != 0.0 && loads.multipliers.iter().any(|multiplier| *multiplier == mesh));
}

#[test]
fn a_driven_body_has_its_kinetic_energy() {
    let door = Door::default();
    let state = door.solve(0.5).expect("a state");
    let [mass, arm, inertia, speed] = [3.0, 0.4, 1.0, 1.0];
    let wanted = 0.5 * (mass * arm * arm + inertia) * speed * speed;
    assert!((door.energy(&state).kinetic - wanted).abs() < 1e-15 && door.energy(&state).potential == 0.0);
    assert!((door.energy(&state).power + 2.0 * 0.5 * speed).abs() < 1e-15);
}

#[test]
fn a_load_is_stated_on_either_body_and_along_the_axes_of_one() {
    let door = Door::default();
    for state in door.sweep((0..10).map(|step| 0.1 * f64::from(step))) {
        let state = state.expect("a state");
        let on_leaf = door.loads(&state).hinge();
        // The centre of mass moves on a circle: the hinge pulls towards itself, along the leaf.
        let along = on_leaf.in_axes_of(&state.leaf()).force;
        assert!((along.x + 3.0 * 0.4).abs() < 1e-14 && along.y.abs() < 1e-14 && along.z.abs() < 1e-14, "{along}");
        let on_ground = on_leaf.on_other();
        assert!((on_ground.force + on_leaf.force).norm() + (on_ground.torque + on_leaf.torque).norm() < 1e-15);
    }
}

#[test]
fn loads_of_parameters_without_numbers_are_no_numbers() {
    let state = Door::default().solve(0.5).expect("a state");
    let loads = Door { stiffness: f64::NAN }.loads(&state);
    assert!(loads.motor().effort.is_nan() && loads.motor().power.is_nan());
}

mechanism! {
    /// A load on a rail askew that a cylinder with fixed ends moves along.
    mechanism Pushed in space {
        gravity = (0, 0, -10m_s2);
        ground { axis way = (2, 1, 2) from (1, 0, -1);  point end = (-2m, -1m, -2m); }
        body load { mass = 3kg;  inertia = (1kgm2, 1kgm2, 1kgm2);  axis way = (2, 1, 2) from (1, 0, -1); }
        joint rail = translational(ground.position, ground.way, load.position, load.way);
        drive cylinder = drive_distance(ground.end, load.position, 3m + 100mm_s * t);
    }
}

#[test]
fn the_effort_of_a_distance_in_space_is_the_force_along_it() {
    let pushed = Pushed::default();
    for state in pushed.sweep((0..10).map(|step| 0.3 * f64::from(step))) {
        // The way rises by 2 in 3.
        let cylinder = pushed.loads(&state.expect("a state")).cylinder();
        assert!((cylinder.effort - 20.0).abs() < 1e-12 && (cylinder.power - 2.0).abs() < 1e-12, "{cylinder:?}");
    }
}
