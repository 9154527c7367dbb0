//! Conserved quantities, events, and motions that are asked for too much.

use super::plane::{Cart, DoublePendulum};
use super::space::{FreeBody, SteadyTop};
use reuleaux::{Integrator, Motion, Stopped, mechanism};
use reuleaux_tests::common::decimal::Decimal;
use reuleaux_tests::common::reference::{file, text};

mechanism! {
    /// The simple pendulum of `pendulum.json`: all its mass at the end.
    pub(crate) mechanism Pendulum {
        gravity = (0, -9.81m_s2);
        param start: Angle = -180deg;
        body rod { point O = (0m, 0m);  mass = 1kg;  center = (1m, 0m); }
        joint pin = revolute((0m, 0m), rod.O);
        freedom swing = rod.angle from start;
    }
}

fn total(energy: reuleaux::Energy<f64>) -> f64 {
    energy.kinetic + energy.potential
}

#[test]
fn a_pendulum_turns_back_after_half_its_period() {
    let reference = file("pendulum.json");
    let period = Decimal::parse(text(&reference["simple"]["period"])).value;
    let mechanism = Pendulum::default();
    for tolerance in [1e-6, 1e-9, 1e-12] {
        let mut state = mechanism.initial_state().expect("a state");
        let mut integrator = Integrator::new(tolerance);
        for turn in 1..=4 {
            let has_turned = mechanism.advance_until(&mut state, 10.0, &mut integrator, |state| state.rod().angular_velocity);
            assert_eq!(has_turned, Ok(true));
            let error = state.t - f64::from(turn) * 0.5 * period;
            assert!(error.abs() < 10.0 * tolerance, "turn {turn} at {tolerance:e}: {error:e}");
        }
    }
}

#[test]
fn an_event_that_does_not_come_leaves_the_state_at_the_end() {
    let mechanism = Pendulum { start: -1.0 };
    let mut state = mechanism.initial_state().expect("a state");
    let found = mechanism.advance_until(&mut state, 1.0, &mut Integrator::new(1e-9), |state| state.rod().angle + 4.0);
    assert_eq!((found, state.t), (Ok(false), 1.0));
}

mechanism! {
    /// A stone thrown up: between two steps of the integrator it comes and goes.
    pub(crate) mechanism Stone {
        gravity = (0, -9.81m_s2);
        param push: Force = 0N;
        body stone { mass = 2kg;  inertia = 1kgm2; }
        joint upright = absolute_angle(stone, 0);
        joint straight = absolute_x(stone.position, 0m);
        force hand = { at stone.position: (0N, push); }
        freedom height = stone.y at 3m_s;
    }
}

#[test]
fn an_event_within_a_step_is_not_missed() {
    let mechanism = Stone::default();
    let mut state = mechanism.initial_state().expect("a state");
    let mut integrator = Integrator::new(1e-9);
    let root = (9.0_f64 - 2.0 * 9.81 * 0.4).sqrt();
    for wanted in [(3.0 - root) / 9.81, (3.0 + root) / 9.81] {
        let found = mechanism.advance_until(&mut state, 5.0, &mut integrator, |state| state.stone().position.y - 0.4);
        assert_eq!(found, Ok(true));
        assert!((state.t - wanted).abs() < 1e-12, "{} for {wanted}", state.t);
    }
    let found = mechanism.advance_until(&mut state, 5.0, &mut integrator, |_| f64::NAN);
    assert!(matches!(found, Err(Stopped::NotFinite { .. })));
}

/// A controller changes a parameter between two steps: the first stage has the new force.
#[test]
fn a_step_begins_with_the_parameters_at_hand() {
    let mut mechanism = Stone::default();
    let mut state = mechanism.initial_state().expect("a state");
    mechanism.push = 2.0 * 9.81;
    mechanism.step(&mut state, 0.1).expect("a step");
    assert!((state.stone().velocity.y - 3.0).abs() < 1e-15 && (state.stone().position.y - 0.3).abs() < 1e-15);
}

#[test]
fn a_pendulum_may_hang_at_rest() {
    let mechanism = Pendulum { start: -core::f64::consts::FRAC_PI_2 };
    let mut state = mechanism.initial_state().expect("a state");
    let mut integrator = Integrator::new(1e-12);
    mechanism.advance(&mut state, 100.0, &mut integrator).expect("a motion");
    assert!(integrator.accepted < 2000 && (state.rod().angle - mechanism.start).abs() < 1e-12);
}

/// A slow heavy motion beside a light quick one.
#[test]
fn a_light_body_beside_a_heavy_one_has_a_mass() {
    mechanism! {
        mechanism Pair {
            gravity = (0, -9.81m_s2);
            body heavy { mass = 1500kg;  center = (3m, 0m); }
            body light { mass = 10g;  center = (1cm, 0m); }
            joint one = revolute((0m, 0m), heavy.position);
            joint two = revolute((9m, 0m), light.position);
            freedom a = heavy.angle;
            freedom b = light.angle;
        }
    }
    let state = Pair::default().initial_state().expect("a state");
    assert!((state.heavy().angular_acceleration + 9.81 / 3.0).abs() < 1e-14);
    assert!((state.light().angular_acceleration + 9.81 / 0.01).abs() < 1e-11);
}

#[test]
fn energy_is_kept_over_a_hundred_thousand_steps() {
    let mechanism = Pendulum { start: -2.0 };
    let mut state = mechanism.initial_state().expect("a state");
    let start = total(mechanism.energy(&state));
    let mut worst = 0.0_f64;
    for _ in 0..100_000 {
        mechanism.step(&mut state, 0.01).expect("a step");
        worst = worst.max((total(mechanism.energy(&state)) - start).abs());
    }
    assert!(worst < 1e-9, "{worst:e}");
}

#[test]
fn energy_drifts_less_than_ten_times_the_tolerance() {
    for tolerance in [1e-6, 1e-9, 1e-12] {
        let mechanism = DoublePendulum::default();
        let mut state = mechanism.initial_state().expect("a state");
        let start = total(mechanism.energy(&state));
        mechanism.advance(&mut state, 5.0, &mut Integrator::new(tolerance)).expect("a motion");
        let drift = total(mechanism.energy(&state)) - start;
        // Its energies are of the order of 10 J.
        assert!(drift.abs() < 100.0 * tolerance, "{tolerance:e}: {drift:e}");
    }
}

#[test]
fn a_free_body_keeps_its_angular_momentum() {
    let mechanism = FreeBody::default();
    let mut state = mechanism.initial_state().expect("a state");
    let momentum = |state: &super::space::FreeBodyState| {
        let body = state.body();
        let local = body.rotation.transpose() * body.angular_velocity;
        body.rotation * nalgebra(&[0.02 * local[0], 0.035 * local[1], 0.05 * local[2]])
    };
    let start = momentum(&state);
    mechanism.advance(&mut state, 6.0, &mut Integrator::new(1e-12)).expect("a motion");
    assert!((momentum(&state) - start).norm() < 1e-12 * start.norm() * 10.0);
    assert!((state.body().rotation.determinant() - 1.0).abs() < 1e-14);
}

mechanism! {
    /// A loop of two cranks about skew axes, and a rod on two balls that spins. Undeclared, the rod lies along the axis of its spin.
    mechanism SpinningRod in space {
        gravity = (0, 0, -9.81m_s2);
        ground { axis x = (1, 0, 0);  axis y = (0, 1, 0);  point C = (500mm, 100mm, 20mm); }
        body crank { axis y = (0, 1, 0);  point A = (0mm, 0mm, 100mm);  mass = 1kg;  inertia = (0.001kgm2, 0.001kgm2, 0.001kgm2); }
        body rod {
            axis l = (1, 0, 0);  point B = (550mm, 0mm, 0mm);
            mass = 0.5kg;  center = (275mm, 0mm, 0mm);  inertia = (0.0002kgm2, 0.008kgm2, 0.008kgm2);
        }
        body rocker { axis x = (1, 0, 0);  point B = (0mm, 0mm, 250mm);  mass = 1kg;  inertia = (0.005kgm2, 0.005kgm2, 0.0004kgm2); }
        joint o = revolute(ground.position, ground.y, crank.position, crank.y);
        joint c = revolute(ground.C, ground.x, rocker.position, rocker.x);
        joint a = spherical(crank.A, rod.position);
        joint b = spherical(rod.B, rocker.B);
        freedom swing = o.angle;
        freedom spin = dot(rod.angular_velocity, z_axis(rod.l)) from 30rad_s;
        output spin_of_rod = dot(rod.angular_velocity, z_axis(rod.l));
    }
}

/// No force at a ball turns a rod about the line between both: its spin is constant where the rod is alike all around.
#[test]
fn a_rod_on_two_balls_keeps_its_spin() {
    for tolerance in [1e-6, 1e-9, 1e-12] {
        let mechanism = SpinningRod::default();
        let mut state = mechanism.initial_state().expect("a state");
        let start = total(mechanism.energy(&state));
        mechanism.advance(&mut state, 1.0, &mut Integrator::new(tolerance)).expect("a motion");
        let spin = mechanism.spin_of_rod(&state).value / 30.0 - 1.0;
        let drift = total(mechanism.energy(&state)) - start;
        assert!(spin.abs() < 100.0 * tolerance && drift.abs() < 100.0 * tolerance, "{tolerance:e}: {spin:e} {drift:e}");
    }
}

fn nalgebra(parts: &[f64; 3]) -> reuleaux::nalgebra::Vector3<f64> {
    reuleaux::nalgebra::Vector3::from(*parts)
}

/// Nodes and weights of Gauss and Legendre on [−1, 1], 8 of them, by symmetry.
const NODES: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];

#[test]
fn energy_changes_by_the_work_of_forces() {
    let mechanism = Cart::default();
    let mut state = mechanism.initial_state().expect("a state");
    let mut integrator = Integrator::new(1e-12);
    let (mut work, half) = (0.0, 0.01);
    let start = total(mechanism.energy(&state));
    for interval in 0..50 {
        let middle = (2 * interval + 1) as f64 * half;
        let mut nodes: Vec<(f64, f64)> = NODES.iter().flat_map(|(node, weight)| [(-node, *weight), (*node, *weight)]).collect();
        nodes.sort_by(|one, two| one.0.total_cmp(&two.0));
        for (node, weight) in nodes {
            mechanism.advance(&mut state, middle + half * node, &mut integrator).expect("a motion");
            work += half * weight * mechanism.energy(&state).power;
        }
    }
    mechanism.advance(&mut state, 100.0 * half, &mut integrator).expect("a motion");
    let rest = total(mechanism.energy(&state)) - start - work;
    assert!(rest.abs() < 1e-11, "{rest:e}");
}

#[test]
fn a_motion_goes_back_the_way_it_came() {
    let mechanism = SteadyTop::default();
    let start = mechanism.initial_state().expect("a state");
    let mut state = start.clone();
    let mut integrator = Integrator::new(1e-10);
    for time in [0.3, -0.2, 0.0] {
        mechanism.advance(&mut state, time, &mut integrator).expect("a motion");
    }
    assert!((state.top().rotation - start.top().rotation).norm() < 1e-8);
    assert!((state.top().angular_velocity - start.top().angular_velocity).norm() < 1e-6);
}

#[test]
fn what_is_not_a_number_stops_a_motion() {
    let mechanism = Pendulum::default();
    let good = mechanism.initial_state().expect("a state");
    let mut integrator = Integrator::new(1e-9);
    for time in [f64::NAN, f64::INFINITY] {
        let mut state = good.clone();
        assert!(matches!(mechanism.advance(&mut state, time, &mut integrator), Err(Stopped::NotFinite { .. })));
        assert_eq!(state, good);
    }
    let mut state = good.clone();
    state.0.q[2] = f64::NAN;
    assert!(mechanism.advance(&mut state, 1.0, &mut Integrator::new(1e-9)).is_err());
    assert!(mechanism.step(&mut state, 0.1).is_err());
    assert!(Pendulum { start: f64::NAN }.initial_state().is_err());
    for bad in [0.0, -1e-10, f64::NAN, f64::INFINITY] {
        let stopped = mechanism.advance(&mut good.clone(), 1.0, &mut Integrator::new(bad)).expect_err("no tolerance");
        assert!(format!("{stopped}").contains("`tolerance`"), "{stopped}");
        let mut steps = Integrator { longest: -bad.abs(), ..Integrator::new(1e-9) };
        assert!(matches!(mechanism.advance(&mut good.clone(), 1.0, &mut steps), Err(Stopped::BadIntegrator { field: "longest", .. })));
    }
    for bad in [f64::NAN, f64::INFINITY] {
        let steps = [Integrator { step: bad, ..Integrator::new(1e-9) }, Integrator { fastest: bad, ..Integrator::new(1e-9) }];
        for (mut integrator, wanted) in steps.into_iter().zip(["step", "fastest"]) {
            let stopped = mechanism.advance(&mut good.clone(), 1.0, &mut integrator).expect_err("no number");
            assert!(matches!(stopped, Stopped::BadIntegrator { field, .. } if field == wanted), "{stopped}");
        }
        let mut stiff = Integrator { step: bad, ..Integrator::stiff(1e-6) };
        assert!(matches!(mechanism.advance(&mut good.clone(), 1.0, &mut stiff), Err(Stopped::BadIntegrator { field: "step", .. })));
    }
    let mut few = Integrator { most: 2, ..Integrator::new(1e-9) };
    assert!(matches!(mechanism.advance(&mut good.clone(), 10.0, &mut few), Err(Stopped::TooManySteps { .. })));
}

mechanism! {
    /// A body on a spring in the plane, by its force or by its energy.
    pub(crate) mechanism Sprung {
        param by_force: Stiffness = 0N_m;
        param by_energy: Stiffness = 0N_m;
        gravity = (0, -9.81m_s2);
        body rod { point Q = (0.2m, 0.1m);  mass = 2kg;  center = (0.3m, 0m);  inertia = 0.1kgm2; }
        joint pin = revolute((0m, 0m), rod.position);
        force spring = spring((1m, 0.5m), rod.Q, stiffness: by_force, rest: 0.3m);
        energy stored = 0.5 * by_energy * (norm((1m, 0.5m) - rod.Q) - 0.3m)^2;
        freedom swing = rod.angle from 20deg at 1rad_s;
    }
}

mechanism! {
    /// The same in space, on a ball.
    pub(crate) mechanism SprungInSpace in space {
        param by_force: Stiffness = 0N_m;
        param by_energy: Stiffness = 0N_m;
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        ground { point P = (1m, 0.5m, 0.2m); }
        body rod { point Q = (0.2m, 0.1m, -0.1m);  mass = 2kg;  center = (0.3m, 0m, 0.1m);  inertia = (0.1kgm2, 0.12kgm2, 0.15kgm2); }
        joint pin = spherical((0m, 0m, 0m), rod.position);
        force spring = spring(ground.P, rod.Q, stiffness: by_force, rest: 0.3m);
        energy stored = 0.5 * by_energy * (norm(ground.P - rod.Q) - 0.3m)^2;
        freedom spin = rod.angular_velocity from (1rad_s, 2rad_s, 3rad_s);
    }
}

#[test]
fn the_force_of_an_energy_is_its_slope() {
    let [force, energy] = [(500.0, 0.0), (0.0, 500.0)].map(|(by_force, by_energy): (f64, f64)| Sprung { by_force, by_energy });
    let [with_force, with_energy] = [&force, &energy].map(|mechanism| mechanism.initial_state().expect("a state"));
    let off = with_force.rod().angular_acceleration - with_energy.rod().angular_acceleration;
    assert!(off.abs() < 1e-13 * with_force.rod().angular_acceleration.abs());
    let off = (force.loads(&with_force).pin().force - energy.loads(&with_energy).pin().force).norm();
    // One acts at its point, the other one on the coordinates: the pin carries the same.
    assert!(off < 1e-12 * force.loads(&with_force).pin().force.norm(), "{off:e}");

    let [force, energy] = [(500.0, 0.0), (0.0, 500.0)].map(|(by_force, by_energy): (f64, f64)| SprungInSpace { by_force, by_energy });
    let [with_force, with_energy] = [&force, &energy].map(|mechanism| mechanism.initial_state().expect("a state"));
    let off = (with_force.rod().angular_acceleration - with_energy.rod().angular_acceleration).norm();
    assert!(off < 1e-13 * with_force.rod().angular_acceleration.norm());
    let off = (force.loads(&with_force).pin().force - energy.loads(&with_energy).pin().force).norm();
    assert!(off < 1e-12 * force.loads(&with_force).pin().force.norm(), "{off:e}");
}

#[test]
fn declared_energies_are_kept() {
    let mechanism = SprungInSpace { by_force: 0.0, by_energy: 500.0 };
    let mut state = mechanism.initial_state().expect("a state");
    let start = total(mechanism.energy(&state));
    mechanism.advance(&mut state, 3.0, &mut Integrator::new(1e-11)).expect("a motion");
    let drift = total(mechanism.energy(&state)) - start;
    assert!(drift.abs() < 1e-8, "{drift:e}");
    assert!(mechanism.energy(&state).power.abs() < f64::MIN_POSITIVE);
}

mechanism! {
    /// A pendulum of each shape of the plane, each 2 kg about its centre.
    pub(crate) mechanism Shapes {
        gravity = (0, -9.81m_s2);
        body rod   { mass = 2kg;  center = (1m, 0m);  inertia = rod(0.6m); }
        body disk  { mass = 2kg;  center = (1m, 0m);  inertia = disk(0.3m); }
        body ring  { mass = 2kg;  center = (1m, 0m);  inertia = ring(0.3m); }
        body block { mass = 2kg;  center = (1m, 0m);  inertia = block(0.3m, 0.4m); }
        body ball  { mass = 2kg;  center = (1m, 0m);  inertia = ball(0.3m); }
        joint a = revolute((0m, 0m), rod.position);
        joint b = revolute((0m, 0m), disk.position);
        joint c = revolute((0m, 0m), ring.position);
        joint d = revolute((0m, 0m), block.position);
        joint e = revolute((0m, 0m), ball.position);
        freedom one = rod.angle;
        freedom two = disk.angle;
        freedom three = ring.angle;
        freedom four = block.angle;
        freedom five = ball.angle;
    }
}

mechanism! {
    /// A cylinder on a ball, released level.
    pub(crate) mechanism Cylinder in space {
        gravity = (0m_s2, 0m_s2, -9.81m_s2);
        body cylinder { mass = 2kg;  center = (0m, 0m, 1m);  inertia = cylinder(0.3m, 0.8m);  start orientation = turn((0, 1, 0), 90deg); }
        joint pin = spherical((0m, 0m, 0m), cylinder.position);
        freedom spin = cylinder.angular_velocity;
    }
}

#[test]
fn bodies_of_simple_shape_have_their_inertia() {
    let state = Shapes::default().initial_state().expect("a state");
    let fallen = [state.rod(), state.disk(), state.ring(), state.block(), state.ball()].map(|body| body.angular_acceleration);
    let inertia = [0.36 / 12.0, 0.09 / 2.0, 0.09, 0.25 / 12.0, 0.4 * 0.09];
    for (found, inertia) in fallen.into_iter().zip(inertia) {
        assert!((found + 9.81 / (1.0 + inertia)).abs() < 1e-13);
    }
    let state = Cylinder::default().initial_state().expect("a state");
    let wanted = 9.81 / (1.0 + (3.0 * 0.09 + 0.64) / 12.0);
    assert!((state.cylinder().angular_acceleration.norm() - wanted).abs() < 1e-13);
}

mechanism! {
    /// A pendulum under a gravity that can be changed.
    pub(crate) mechanism Elsewhere {
        param g: Acceleration = 9.81m_s2;
        gravity = (0, -g);
        body rod { point O = (0m, 0m);  mass = 1kg;  center = (1m, 0m); }
        joint pin = revolute((0m, 0m), rod.O);
        freedom swing = rod.angle from -60deg;
    }
}

#[test]
fn loads_follow_changed_parameters() {
    let (earth, moon) = (Elsewhere::default(), Elsewhere { g: 1.62 });
    let state = earth.initial_state().expect("a state");
    for (mechanism, g) in [(&earth, 9.81), (&moon, 1.62)] {
        // At rest the pin carries the part of the weight along the rod; the other part accelerates the mass.
        let load = mechanism.loads(&state).pin().in_axes_of(&state.rod());
        let wanted = -g * 60.0_f64.to_radians().sin();
        assert!((load.force.x - wanted).abs() < 1e-14 * g && load.force.y.abs() < 1e-14 * g, "{load:?} {wanted}");
    }
}

#[test]
fn a_sweep_gives_states_between_steps_as_good_as_those_at_their_ends() {
    let pendulum = Pendulum::<f64> { start: -2.0 };
    for tolerance in [1e-6, 1e-9, 1e-12] {
        let times = (0..400).map(|k| 0.01 * f64::from(k));
        // As many steps as there are times, with a far smaller tolerance.
        let (mut exact, mut fine) = (pendulum.initial_state().expect("a state"), Integrator::new(1e-13));
        let mut worst = 0.0_f64;
        for state in pendulum.sweep(times, Integrator::new(tolerance)) {
            let state = state.expect("a state");
            pendulum.advance(&mut exact, state.t, &mut fine).expect("a motion");
            let (found, wanted) = (state.rod(), exact.rod());
            worst = worst.max((found.angle - wanted.angle).abs()).max((found.angular_velocity - wanted.angular_velocity).abs() / 5.0);
            // Equations hold to rounding.
            assert!((found.angular_acceleration + 9.81 * found.angle.cos()).abs() < 1e-13);
        }
        assert!(worst < 10.0 * tolerance && worst > 0.0, "{tolerance:e}: {worst:e}");
    }
}

#[test]
fn a_sweep_may_turn_back_begin_anywhere_and_end_before_the_motion_stops() {
    let pendulum = Pendulum::<f64> { start: -2.0 };
    let integrator = Integrator::new(1e-11);
    let there: Vec<_> = pendulum.sweep([0.0, 0.7, 1.9, 0.7, 0.05, 0.0, -0.3], integrator).map(|state| state.expect("a state")).collect();
    assert!((there[1].rod().angle - there[3].rod().angle).abs() < 1e-9);
    // The motion is symmetric about the instant of rest at t = 0.
    let [before, after] = [-0.3, 0.3].map(|t| pendulum.sweep([t], integrator).next().expect("a time").expect("a state").rod().angle);
    assert!((before - after).abs() < 1e-9 && (before - there[6].rod().angle).abs() < 1e-9);
    let further = pendulum.sweep_from(&there[1], [1.9], integrator).next().expect("a time").expect("a state");
    assert!((further.rod().angle - there[2].rod().angle).abs() < 1e-9);
    // Not a time: an error, and nothing after it.
    let mut broken = pendulum.sweep([0.1, f64::NAN, 0.2], integrator);
    assert!(broken.next().is_some_and(|state| state.is_ok()));
    assert!(matches!(broken.next(), Some(Err(Stopped::NotFinite { .. }))) && broken.next().is_none());
}

#[test]
fn a_motion_can_be_watched_and_stopped() {
    let pendulum = Pendulum::<f64> { start: -2.0 };
    let (mut state, mut integrator) = (pendulum.initial_state().expect("a state"), Integrator::new(1e-9));
    let mut steps = 0;
    assert_eq!(
        pendulum.advance_while(&mut state, 1.0, &mut integrator, |_| {
            steps += 1;
            true
        }),
        Ok(true)
    );
    assert_eq!((steps, state.t), (integrator.accepted, 1.0));
    assert_eq!(pendulum.advance_while(&mut state, 9.0, &mut integrator, |state| state.t < 2.0), Ok(false));
    assert!(state.t >= 2.0 && state.t < 3.0);
}

mechanism! {
    /// A bead on a rail that climbs or falls with gravity, held by a spring whose other end is moved.
    mechanism Shaken {
        input end: Length;
        gravity = (0, -9.81m_s2 * (1 + 0.2 * sin(3rad_s * t)));
        body bead { mass = 2kg; }
        body weight { mass = 3kg; }
        joint level = absolute_angle(bead, 0);
        joint way = absolute_y(bead.position, 0m);
        joint upright = absolute_angle(weight, 0);
        joint shaft = absolute_x(weight.position, 1m);
        joint rope = { weight.y == 0.5 * bead.x; }
        energy spring = 0.5 * 30N_m * (bead.x - end - 0.3m * sin(2rad_s * t))^2;
        freedom x = bead.x from 0.1m at 0.2m_s;
    }
}

/// Ṫ + V̇ of the bead at x with ẋ, ẍ, from T = ½ (2 + ¾) ẋ², V = 15 (x − e − 0.3 sin 2t)² + 3 · 9.81 (1 + 0.2 sin 3t) x / 2.
fn rate_of_shaken(t: f64, [x, v, a]: [f64; 3], [e, ė]: [f64; 2]) -> f64 {
    let of_spring = 30.0 * (x - e - 0.3 * (2.0 * t).sin()) * (v - ė - 0.6 * (2.0 * t).cos());
    let weight = 3.0 * 9.81;
    2.75 * v * a + of_spring + 0.5 * weight * ((1.0 + 0.2 * (3.0 * t).sin()) * v + 0.6 * (3.0 * t).cos() * x)
}

#[test]
fn power_is_the_rate_of_potentials_that_are_moved_from_outside() {
    let mut mechanism = Shaken { inputs: ShakenInputs { end: Motion::at(0.0) } };
    let (mut state, mut integrator) = (mechanism.initial_state().expect("a state"), Integrator::new(1e-9));
    for k in 1..=20 {
        let t = 0.17 * f64::from(k);
        let end = [0.05 * f64::from(k % 3), 0.4 - 0.03 * f64::from(k)];
        mechanism.inputs.end = Motion::moving(end[0], end[1]);
        mechanism.advance(&mut state, t, &mut integrator).expect("a motion");
        let bead = state.bead();
        let rate = rate_of_shaken(t, [bead.position.x, bead.velocity.x, bead.acceleration.x], end);
        let power = mechanism.energy(&state).power;
        assert!((power - rate).abs() < 1e-12 * (1.0 + rate.abs()), "at {t}: {power} against {rate}");
        assert!(rate.abs() > 1e-3);
    }
}
