//! Loads of joints whose bodies do not get opposite ones: each wheel by its own equation of motion.

use super::space::{FloatingGears, GearsOnGround};
use reuleaux::nalgebra::{Matrix3, Vector3};
use reuleaux::{Integrator, SpatialBody, SpatialLoad, constraint, mechanism};

mechanism! {
    /// Wheels on shafts of their own, a belt, a planetary train, a differential and a rack; every wheel has its centre of mass on its shaft.
    mechanism Train {
        ground { point A = (1m, 0m);  point B = (2m, 0m);  point C = (3m, 0m);  point R = (2m, -0.3m); }
        body wheel   { mass = 1kg;  inertia = 0.1kgm2; }
        body pinion  { mass = 1kg;  inertia = 0.02kgm2; }
        body sun     { mass = 2kg;  inertia = 0.03kgm2; }
        body ring    { mass = 5kg;  inertia = 0.4kgm2; }
        body arm     { mass = 3kg;  inertia = 0.2kgm2; }
        body shaft   { mass = 1kg;  inertia = 0.05kgm2; }
        body bar     { mass = 4kg; }
        joint of_wheel = revolute(ground.position, wheel.position);
        joint of_pinion = revolute(ground.A, pinion.position);
        joint of_sun = revolute(ground.B, sun.position);
        joint of_ring = revolute(ground.B, ring.position);
        joint of_arm = revolute(ground.B, arm.position);
        joint of_shaft = revolute(ground.C, shaft.position);
        joint guide = translational((1, 0), ground.R, bar.position);
        joint mesh = gear_pair(wheel, pinion, 1, 3);
        joint strap = belt(pinion, sun, 2, 1);
        joint planets = planetary(sun, ring, arm, 20, 60);
        joint split = differential(wheel, shaft, arm, 2);
        joint rack = rack_pinion(ring, bar.position, (1, 0), ground.R, 300mm);
        force brake = { on wheel: -5Nm; }
        force pull = { at bar.position: (-7N, 0N); }
        drive motor = drive_angle(pinion, 1rad * sin(2rad_s * t));
        drive swing = drive_angle(arm, 0.7rad * cos(3rad_s * t));
    }
}

#[test]
fn every_wheel_of_a_train_gets_the_torque_that_turns_it() {
    let train = Train::default();
    for k in 0..20 {
        let state = train.solve(0.13 * f64::from(k)).expect("a state");
        let loads = train.loads(&state);
        let wheel = loads.mesh_on_wheel().torque + loads.split_on_wheel().torque - 5.0;
        let pinion = loads.mesh().torque + loads.strap_on_pinion().torque + loads.motor().effort;
        let sun = loads.strap().torque + loads.planets_on_sun().torque;
        let ring = loads.planets_on_ring().torque + loads.rack_on_ring().torque;
        let arm = loads.planets().torque + loads.split().torque + loads.swing().effort;
        let shaft = loads.split_on_shaft().torque;
        let balances = [
            (0.1 * state.wheel().angular_acceleration, wheel),
            (0.02 * state.pinion().angular_acceleration, pinion),
            (0.03 * state.sun().angular_acceleration, sun),
            (0.4 * state.ring().angular_acceleration, ring),
            (0.2 * state.arm().angular_acceleration, arm),
            (0.05 * state.shaft().angular_acceleration, shaft),
            (4.0 * state.bar().acceleration.x, loads.rack().force.x - 7.0),
        ];
        for (wanted, found) in balances {
            assert!((wanted - found).abs() < 1e-11, "{k}: {balances:?}");
        }
    }
}

#[test]
fn a_wheel_that_turns_evenly_gives_its_torque_to_the_other_by_their_ratio() {
    mechanism! {
        mechanism Pair {
            ground { point A = (1m, 0m); }
            body large { mass = 1kg;  inertia = 0.1kgm2; }
            body small { mass = 1kg;  inertia = 0.02kgm2; }
            joint of_large = revolute(ground.position, large.position);
            joint of_small = revolute(ground.A, small.position);
            slice joint mesh = gear_pair(large, small, 1, 3);
            force brake = { on large: -5Nm; }
            drive motor = drive_angle(small, 2rad_s * t);
        }
    }
    let pair = Pair::default();
    let state = pair.solve(0.4).expect("a state");
    let loads = pair.loads(&state);
    assert!((loads.mesh_on_large().torque - 5.0).abs() < 1e-14 && (loads.mesh().torque - 15.0).abs() < 1e-14);
    assert_eq!(pair.load_of_mesh_on_large(&state), loads.mesh_on_large());
    assert_eq!(pair.load_of_mesh(&state), loads.mesh());
}

/// How far a load about the centre of mass is from m (a − g) and I α + ω × I ω, less `torque`, with the inertia in axes of the body.
fn off(body: &SpatialBody<f64>, (mass, inertia): (f64, Matrix3<f64>), load: SpatialLoad<f64, false>, torque: Vector3<f64>) -> f64 {
    let inertia = body.rotation * inertia * body.rotation.transpose();
    let turning = inertia * body.angular_acceleration + body.angular_velocity.cross(&(inertia * body.angular_velocity));
    let force = (body.acceleration + Vector3::new(0.0, 0.0, 9.81)) * mass;
    (force - load.force).amax().max((turning - torque - load.torque).amax())
}

#[test]
fn every_node_of_a_gear_joint_gets_the_load_that_moves_it() {
    let gears = GearsOnGround::default();
    let state = gears.initial_state().expect("a state");
    let loads = gears.loads(&state);
    let [motor, load] = [Vector3::new(0.0, 0.0, 1.5), Vector3::new(0.0, -0.8, 0.0)];
    let first = off(&state.n1(), (1.0, Matrix3::identity() * 0.02), loads.gears_on_n1(), motor);
    let second = off(&state.n2(), (3.0, Matrix3::identity() * 0.3), loads.gears(), load);
    assert!(first < 1e-13 && second < 1e-12, "{first:e} {second:e}");

    let floating = FloatingGears::default();
    let state = floating.initial_state().expect("a state");
    let loads = floating.loads(&state);
    let axis = |local: Vector3<f64>| state.n0().rotation * local;
    let motor = axis(Vector3::new(0.0, 0.0, 1.0)) * (0.05 + 0.1 * 0.3_f64.sin());
    let load = axis(Vector3::new(0.0, 0.6, 0.8)) * -0.04;
    let of_n1 = Matrix3::from_diagonal(&Vector3::new(0.003, 0.003, 0.005));
    let of_n2 = Matrix3::new(0.006, 0.0005, 0.0, 0.0005, 0.007, 0.0002, 0.0, 0.0002, 0.004);
    let first = off(&state.n1(), (0.8, of_n1), loads.gears_on_n1(), motor);
    let second = off(&state.n2(), (1.1, of_n2), loads.gears_on_n2(), load);
    assert!(first < 1e-13 && second < 1e-13, "{first:e} {second:e}");
}

constraint! {
    /// A rope from P through a ring at F to Q.
    pub constraint rope(P: Point, F: Point, Q: Point, length: Length) {
        norm(P - F) + norm(Q - F) == length;
    }
}

mechanism! {
    /// Two weights on a rope over a pulley. At the start its ends are in line, and only there are its forces opposite.
    mechanism Hoist {
        use crate::gears::rope;
        gravity = (0, -9.81m_s2);
        body left  { mass = 2kg;  start position = (-1m, 0m); }
        body right { mass = 3kg;  start position = (1m, 0m); }
        joint upright = absolute_angle(left, 0);
        joint straight = absolute_angle(right, 0);
        joint line = rope(left.position, (0m, 0m), right.position, 2m);
        drive across = drive_x(left.position, -1m + 0.1m_s * t);
        drive along = drive_y(left.position, -0.5m_s * t);
        drive height = drive_y(right.position, -0.7m_s * t);
    }
}

mechanism! {
    /// Two weights on a rope through a ring, let go with both ends in line.
    mechanism Swung in space {
        use crate::gears::rope;
        gravity = (0, 0, -9.81m_s2);
        ground { axis z = (0, 0, 1); }
        body left  { axis z = (0, 0, 1);  mass = 2kg; }
        body right { axis z = (0, 0, 1);  mass = 3kg;  start position = (1m, 0m, 0m); }
        joint upright = absolute_orientation(ground.z, left.z);
        joint straight = absolute_orientation(ground.z, right.z);
        joint line = rope(left.position, (0m, 0m, 0m), right.position, 2m);
        freedom x = left.position.x from -1m;
        freedom y = left.position.y from 0m;
        freedom z = left.position.z from 0m;
        freedom aside = right.position.y from 0m;
        freedom height = right.position.z from 0m;
    }
}

/// Newton's law of each weight, at poses where the ends of the rope are not in line.
#[test]
fn both_ends_of_a_rope_get_a_load_though_they_begin_in_line() {
    let hoist = Hoist::default();
    for time in [0.0, 0.3, 0.8] {
        let state = hoist.solve(time).expect("a state");
        let loads = hoist.loads(&state);
        let [left, right] = [state.left().position, state.right().position].map(|place| -place.normalize());
        // Nothing else pushes the right weight across.
        let tension = 3.0 * state.right().acceleration.x / right.x;
        assert!((loads.line().force - right * tension).norm() < 1e-13 && (loads.line_on_left().force - left * tension).norm() < 1e-13);
    }
    let swung = Swung::default();
    let mut state = swung.initial_state().expect("a state");
    let mut integrator = Integrator::new(1e-10);
    for time in [0.0, 0.1, 0.25] {
        swung.advance(&mut state, time, &mut integrator).expect("it moves");
        let (loads, gravity) = (swung.loads(&state), Vector3::new(0.0, 0.0, -9.81));
        let (left, right) = ((state.left().acceleration - gravity) * 2.0, (state.right().acceleration - gravity) * 3.0);
        assert!((loads.line_on_left().force - left).norm() < 1e-12 && (loads.line().force - right).norm() < 1e-12);
    }
}
