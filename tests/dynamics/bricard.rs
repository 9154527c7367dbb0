//! Bricard's linkage falls: six hinges that hold once too often, between six bodies with one freedom.

use reuleaux::nalgebra::{Matrix3, SMatrix, SVector, Vector3};
use reuleaux::{Integrator, SpatialBody, Stopped, mechanism};
use reuleaux_tests::common::decimal::Decimal;
use reuleaux_tests::common::reference::{Value, file, list, text};

use crate::compare::{TOLERANCES, error};

mechanism! {
    /// `bricard.json`. Bodies are turned as ground is where a is zero.
    pub(crate) mechanism Bricard in space {
        param start: Angle = 0rad;
        param speed: AngularVelocity = 0rad_s;
        /// By which the last rod is too long.
        param excess: Length = 0m;
        gravity = (0m_s2, -9.81m_s2, 0m_s2);
        ground { axis x = (1, 0, 0);  axis y = (0, 1, 0);  point end = (0m, 0m, 1m); }
        body rod1 {
            axis y = (0, 1, 0);  axis z = (0, 0, 1);  point end = (1m, 0m, 0m);
            mass = 1kg;  center = (0.5m, 0m, 0m);  inertia = block(1m, 0.1m, 0.1m);
        }
        body rod2 {
            axis z = (0, 0, 1);  axis x = (1, 0, 0);  point end = (0m, -1m, 0m);
            mass = 1kg;  center = (0m, -0.5m, 0m);  inertia = block(0.1m, 1m, 0.1m);  start position = (1m, 0m, 0m);
        }
        body rod3 {
            axis x = (1, 0, 0);  axis y = (0, 1, 0);  point end = (0m, 0m, 1m);
            mass = 1kg;  center = (0m, 0m, 0.5m);  inertia = block(0.1m, 0.1m, 1m);  start position = (1m, -1m, 0m);
        }
        body rod4 {
            axis y = (0, 1, 0);  axis z = (0, 0, 1);  point end = (-1m, 0m, 0m);
            mass = 1kg;  center = (-0.5m, 0m, 0m);  inertia = block(1m, 0.1m, 0.1m);  start position = (1m, -1m, 1m);
        }
        body rod5 {
            axis z = (0, 0, 1);  axis x = (1, 0, 0);  point end = (0m, 1m + excess, 0m);
            mass = 1kg;  center = (0m, 0.5m, 0m);  inertia = block(0.1m, 1m, 0.1m);  start position = (0m, -1m, 1m);
        }
        joint one = revolute(ground.position, ground.y, rod1.position, rod1.y);
        joint two = revolute(rod1.end, rod1.z, rod2.position, rod2.z);
        joint three = revolute(rod2.end, rod2.x, rod3.position, rod3.x);
        joint four = revolute(rod3.end, rod3.y, rod4.position, rod4.y);
        joint five = revolute(rod4.end, rod4.z, rod5.position, rod5.z);
        redundant joint six = revolute(rod5.end, rod5.x, ground.end, ground.x);
        freedom fall = one.angle from start at speed;
        output a = one.angle;
        output b = two.angle;
        output last_a = five.angle;
        output plotted = rod2.end;
    }
}

fn decimal(state: &Value, name: &str) -> Decimal {
    Decimal::parse(text(&state[name]))
}

/// Errors of positions, speeds and accelerations: of both angles, of the plotted point and of the hinges between rods.
fn errors(mechanism: &Bricard, state: &BricardState, wanted: &Value) -> [f64; 3] {
    let (a, b, last_a, plotted) = (mechanism.a(state), mechanism.b(state), mechanism.last_a(state), mechanism.plotted(state));
    let hinges = [state.rod2(), state.rod3(), state.rod4(), state.rod5()];
    let hinges: Vec<f64> = hinges.iter().flat_map(|rod| rod.position.iter().copied().collect::<Vec<f64>>()).collect();
    let of = |name: &str, found: f64| decimal(wanted, name).error_of(found) / decimal(wanted, name).value.abs().max(1.0);
    let places = [error(&hinges, &wanted["joints"]), error(plotted.value.as_slice(), &wanted["P3"]), of("a", a.value), of("b", b.value)];
    [
        places.into_iter().fold(of("a", last_a.value), f64::max),
        of("a_dot", a.rate).max(error(plotted.rate.as_slice(), &wanted["P3_dot"])),
        of("a_ddot", a.acceleration).max(error(plotted.acceleration.as_slice(), &wanted["P3_ddot"])),
    ]
}

/// Started from every state of the file, between which a comes close to π and back to 0.
#[test]
fn bricards_linkage_accelerates_as_in_the_reference() {
    for wanted in list(&file("bricard.json")["states"]) {
        let mechanism = Bricard { start: decimal(wanted, "a").value, speed: decimal(wanted, "a_dot").value, ..Bricard::default() };
        let state = mechanism.initial_state().unwrap_or_else(|stopped| panic!("{}: {stopped}", mechanism.start));
        let [places, speeds, accelerations] = errors(&mechanism, &state, wanted);
        assert!(places < 1e-14 && speeds < 1e-14 && accelerations < 1e-12, "{}: {places:e} {speeds:e} {accelerations:e}", mechanism.start);
    }
}

#[test]
fn bricards_linkage_falls_and_comes_back() {
    let reference = file("bricard.json");
    let mechanism = Bricard::default();
    for tolerance in TOLERANCES {
        let mut state = mechanism.initial_state().expect("a state");
        let mut integrator = Integrator::new(tolerance);
        let total = |state: &BricardState| mechanism.energy(state).kinetic + mechanism.energy(state).potential;
        let (start, largest) = (total(&state), 5.0 * 9.81);
        for wanted in list(&reference["states"]) {
            let time = wanted["t"].as_f64().expect("a time");
            mechanism.advance(&mut state, time, &mut integrator).unwrap_or_else(|stopped| panic!("{stopped}"));
            let [places, speeds, accelerations] = errors(&mechanism, &state, wanted);
            println!("{tolerance:e} {time:4.1} s: {places:.1e} {speeds:.1e} {accelerations:.1e} {:.1e}", total(&state) - start);
            assert!(places <= tolerance && speeds <= tolerance && accelerations <= tolerance, "{tolerance:e} at {time} s");
            assert!((total(&state) - start).abs() <= tolerance * largest, "{tolerance:e} at {time} s");
        }
    }
}

/// With a rod that is too long the linkage would not move: nothing of its motion is handed out.
#[test]
fn a_linkage_that_does_not_fit_has_no_motion() {
    for excess in [1e-3, -1e-6] {
        let mechanism = Bricard { start: 1.0, excess, ..Bricard::default() };
        let found = mechanism.initial_state();
        assert!(
            matches!(found, Err(Stopped::DoesNotHold { joint: "six", residual, .. }) if residual.abs() > 0.1 * excess.abs()),
            "{found:?}"
        );
        let mut good = Bricard::default().initial_state().expect("a state");
        let stopped = mechanism.advance(&mut good, 0.1, &mut Integrator::new(1e-9));
        assert!(matches!(stopped, Err(Stopped::DoesNotHold { joint: "six", .. })), "{stopped:?}");
    }
}

/// A rod in a state: mass times acceleration of its centre less its weight, and the same of moments about its centre.
fn unbalanced(rod: &SpatialBody<f64>, along: Vector3<f64>) -> [Vector3<f64>; 2] {
    let centre = along / 2.0;
    let arms = Matrix3::from_diagonal(&along.map(|part| if part == 0.0 { 1.01 / 12.0 } else { 1.0 / 600.0 }));
    let inertia = rod.rotation * arms * rod.rotation.transpose();
    let spin = rod.angular_velocity;
    [rod.point(centre).acceleration + Vector3::new(0.0, 9.81, 0.0), inertia * rod.angular_acceleration + spin.cross(&(inertia * spin))]
}

/// The load that the hinges pass on from rod to rod in a circle: the wrench (force, moment about the origin) on which no hinge gives way.
fn self_stress(axes: &[[Vector3<f64>; 2]; 6]) -> [Vector3<f64>; 2] {
    let mut power = SMatrix::<f64, 6, 6>::zeros();
    for (row, [at, axis]) in axes.iter().enumerate() {
        power.fixed_view_mut::<1, 3>(row, 0).copy_from(&at.cross(axis).transpose());
        power.fixed_view_mut::<1, 3>(row, 3).copy_from(&axis.transpose());
    }
    let svd = power.svd(false, true);
    assert!(svd.singular_values[4] > 1e-3 && svd.singular_values[5] < 1e-13, "{}", svd.singular_values);
    let right = svd.v_t.expect("right vectors");
    let least: SVector<f64, 6> = right.row(svd.singular_values.imin()).transpose();
    [least.fixed_rows::<3>(0).into_owned(), least.fixed_rows::<3>(3).into_owned()]
}

/// The loads balance every rod, hinges pass no moment about their axes, and those which the circular load reaches are marked.
#[test]
fn loads_of_bricards_linkage_balance_and_are_not_unique() {
    let (x, y, z) = (Vector3::x(), Vector3::y(), Vector3::z());
    for wanted in list(&file("bricard.json")["states"]).iter().filter(|wanted| decimal(wanted, "a").value.abs() > 1e-3) {
        let mechanism = Bricard { start: decimal(wanted, "a").value, speed: decimal(wanted, "a_dot").value, ..Bricard::default() };
        let state = mechanism.initial_state().expect("a state");
        let rods = [state.rod1(), state.rod2(), state.rod3(), state.rod4(), state.rod5()];
        let loads = mechanism.loads(&state);
        // The last one acts on the last rod, too, since the body after it rests.
        let hinges = [loads.one(), loads.two(), loads.three(), loads.four(), loads.five(), loads.six()];
        let ground = Vector3::new(0.0, 0.0, 1.0);
        let places: [Vector3<f64>; 6] = std::array::from_fn(|k| rods.get(k).map_or(ground, |rod| rod.position));
        let axes: [Vector3<f64>; 6] = std::array::from_fn(|k| rods.get(k).map_or(x, |rod| rod.vector([y, z, x, y, z][k]).value));
        for (k, along) in [x, -y, z, -x, y].into_iter().enumerate() {
            let (before, after) = (hinges[k], if k == 4 { hinges[5] } else { hinges[k + 1].on_other() });
            let centre = rods[k].point(along / 2.0).value;
            let [force, moment] = unbalanced(&rods[k], along);
            let torque =
                before.torque + after.torque + (places[k] - centre).cross(&before.force) + (places[k + 1] - centre).cross(&after.force);
            let off = (before.force + after.force - force).norm().max((torque - moment).norm());
            assert!(off < 1e-11, "rod {} at {}: {off:e}", k + 1, mechanism.start);
        }
        let [force, moment] = self_stress(&std::array::from_fn(|k| [places[k], axes[k]]));
        for (k, hinge) in hinges.iter().enumerate() {
            assert!(hinge.torque.dot(&axes[k]).abs() < 1e-12, "hinge {} at {}", k + 1, mechanism.start);
            let share = force.norm().max((moment - places[k].cross(&force)).norm());
            assert!(share > 1e-3 && !hinge.is_unique, "hinge {} at {}: {share:e}", k + 1, mechanism.start);
        }
    }
}
