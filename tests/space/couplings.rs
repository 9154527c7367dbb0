//! Shafts coupled at an angle: the constant-velocity joint beside Hooke's joint.

use reuleaux::nalgebra::{Unit, UnitQuaternion, Vector3};
use reuleaux::{Integrator, mechanism};

mechanism! {
    /// One shaft turns two others at an angle to it, by a constant-velocity joint and by a cross.
    pub mechanism Shafts in space {
        param bend: Angle = 30deg;
        param speed: AngularVelocity = 60rpm;
        param torque: Torque = 5Nm;
        let way = (cos(bend), sin(bend), 0);
        ground { axis x = (1, 0, 0) from (0, 0, 1);  axis way = (cos(bend), sin(bend), 0) from (0, 0, 1); }
        body input  { axis x = (1, 0, 0) from (0, 0, 1);  axis arm = (0, 0, 1); }
        body even   { axis x = (1, 0, 0) from (0, 0, 1); }
        body uneven { axis x = (1, 0, 0) from (0, 0, 1);  axis arm = (0, 1, 0); }
        joint bearing = revolute(ground.position, ground.x, input.position, input.x);
        joint rzeppa = constant_velocity(input.position, input.x, even.position, even.x);
        joint cross_pin = universal(input.position, input.arm, uneven.position, uneven.arm);
        joint even_bearing = parallel_axes(ground.way, even.x);
        joint uneven_bearing = parallel_axes(ground.way, uneven.x);
        drive motor = drive_rotation(bearing, speed * t);
        force brake = { on even: -torque * way; }
        output even = even_bearing.angle;
        output uneven = uneven_bearing.angle;
    }
}

mechanism! {
    /// Shafts in a plane along no axis of ground.
    pub mechanism Tilted in space {
        param bend: Angle = 30deg;
        param speed: AngularVelocity = 60rpm;
        ground {
            axis first = (2/3, 1/3, 2/3) from (1/3, 2/3, -2/3);
            axis way = cos(bend) * (2/3, 1/3, 2/3) + sin(bend) * (2/3, -2/3, -1/3) from (1/3, 2/3, -2/3);
        }
        body input { axis x = (1, 0, 0) from (0, 0, 1); }
        body even  { axis x = (1, 0, 0) from (0, 0, 1); }
        joint bearing = revolute(ground.position, ground.first, input.position, input.x);
        joint rzeppa = constant_velocity(input.position, input.x, even.position, even.x);
        joint even_bearing = parallel_axes(ground.way, even.x);
        drive motor = drive_rotation(bearing, speed * t);
        output even = even_bearing.angle;
    }
}

mechanism! {
    /// Two flywheels, coupled at an angle, that a torque sets in motion.
    pub mechanism Flywheels in space {
        param bend: Angle = 40deg;
        ground { axis x = (1, 0, 0) from (0, 0, 1);  axis way = (cos(bend), sin(bend), 0) from (0, 0, 1); }
        body input { axis x = (1, 0, 0) from (0, 0, 1);  inertia = (0.1kgm2, 0.06kgm2, 0.06kgm2); }
        body even  { axis x = (1, 0, 0) from (0, 0, 1);  inertia = (0.3kgm2, 0.2kgm2, 0.2kgm2); }
        joint bearing = revolute(ground.position, ground.x, input.position, input.x);
        joint rzeppa = constant_velocity(input.position, input.x, even.position, even.x);
        joint even_bearing = parallel_axes(ground.way, even.x);
        force engine = { on input: (2Nm, 0Nm, 0Nm); }
        freedom turning = bearing.angle at 3rad_s;
        output even = even_bearing.angle;
    }
}

mechanism! {
    #[allow(far_start)]
    /// The same shafts, one of which is assembled half a turn on.
    pub mechanism HalfATurnOn in space {
        param bend: Angle = 30deg;
        ground { axis x = (1, 0, 0) from (0, 0, 1);  axis way = (cos(bend), sin(bend), 0) from (0, 0, 1); }
        body input { axis x = (1, 0, 0) from (0, 0, 1); }
        body even { axis x = (1, 0, 0) from (0, 0, 1);  start orientation = turn((0, 0, 1), 30deg) * turn((1, 0, 0), 170deg); }
        joint bearing = revolute(ground.position, ground.x, input.position, input.x);
        joint rzeppa = constant_velocity(input.position, input.x, even.position, even.x);
        joint even_bearing = parallel_axes(ground.way, even.x);
        drive motor = drive_rotation(bearing, 60rpm * t);
        output even = even_bearing.angle;
    }
}

mechanism! {
    /// The drive of a wheel that is steered and cambered while it turns.
    pub mechanism Steered in space {
        let speed = 60rpm;
        ground { axis x = (1, 0, 0) from (0, 0, 1);  axis z = (0, 0, 1); }
        body fork    { axis z = (0, 0, 1);  axis y = (0, 1, 0); }
        body knuckle { axis y = (0, 1, 0);  axis x = (1, 0, 0) from (0, 0, 1); }
        body input   { axis x = (1, 0, 0) from (0, 0, 1); }
        body wheel   { axis x = (1, 0, 0) from (0, 0, 1); }
        joint king_pin = revolute(ground.position, ground.z, fork.position, fork.z);
        joint ball = revolute(fork.position, fork.y, knuckle.position, knuckle.y);
        joint bearing = revolute(ground.position, ground.x, input.position, input.x);
        joint hub = parallel_axes(knuckle.x, wheel.x);
        joint rzeppa = constant_velocity(input.position, input.x, wheel.position, wheel.x);
        drive motor = drive_rotation(bearing, speed * t);
        drive steering = drive_rotation(king_pin, 35deg * sin(5rad_s * t));
        drive camber = drive_rotation(ball, 25deg * sin(3rad_s * t + 20deg));
    }
}

fn times() -> impl Iterator<Item = f64> {
    (0..300).map(|step| f64::from(step) / 100.0)
}

#[test]
fn coupled_shafts_turn_equally_at_every_bend() {
    // At 90° the cross of the other joint folds.
    for bend in [0.0_f64, 1.0, 15.0, 30.0, 45.0, 60.0, 80.0, 100.0, 120.0] {
        let shafts = Shafts { bend: bend.to_radians(), ..Default::default() };
        for state in shafts.sweep(times()) {
            let state = state.expect("it turns");
            let even = shafts.even(&state);
            assert!((even.value - shafts.speed * state.t).abs() < 2e-15, "{bend}°: {even:?}");
            assert!((even.rate - shafts.speed).abs() < 2e-14, "{bend}°: {even:?}");
            assert!(even.acceleration.abs() < 3e-13, "{bend}°: {even:?}");
        }
    }
}

/// The plane of the shafts, from which both angles are counted, is known to ε / (π − β).
#[test]
fn shafts_folded_onto_each_other_keep_the_digits_of_their_plane() {
    for short in [1e-1_f64, 1e-3, 1e-5, 1e-6] {
        let shafts = Tilted { bend: std::f64::consts::PI - short, ..Default::default() };
        for state in shafts.sweep(times()) {
            let state = state.expect("it turns");
            let (even, lost) = (shafts.even(&state), f64::EPSILON / short);
            // Four roundings of the plane's direction, which turns with the shafts in the rate.
            assert!((even.value - shafts.speed * state.t).abs() < 4.0 * lost, "{short}: {even:?}");
            assert!((even.rate - shafts.speed).abs() < 4.0 * lost * shafts.speed, "{short}: {even:?}");
        }
    }
}

#[test]
fn a_cross_in_its_place_turns_unevenly() {
    for bend in [15.0_f64, 30.0, 60.0] {
        let shafts = Shafts { bend: bend.to_radians(), ..Default::default() };
        let cos = shafts.bend.cos();
        for state in shafts.sweep(times()) {
            let state = state.expect("it turns");
            let (sin_input, cos_input) = (shafts.speed * state.t).sin_cos();
            let uneven = shafts.uneven(&state);
            // tan φ₂ = cos β tan φ₁: the sine of the difference of both sides' angles vanishes.
            let off = uneven.value.sin() * cos_input - cos * sin_input * uneven.value.cos();
            let ratio = cos / (1.0 - (1.0 - cos * cos) * sin_input * sin_input);
            assert!(off.abs() < 4e-15, "{bend}°: {off:e}");
            assert!((uneven.rate / shafts.speed - ratio).abs() < 4e-14, "{bend}°: {uneven:?} and {ratio}");
        }
    }
}

#[test]
fn what_a_shaft_is_loaded_with_the_motor_feels() {
    for bend in [0.0_f64, 30.0, 60.0] {
        let shafts = Shafts { bend: bend.to_radians(), ..Default::default() };
        for state in shafts.sweep(times().step_by(7)) {
            let state = state.expect("it turns");
            let motor = shafts.loads(&state).motor();
            assert!((motor.effort - shafts.torque).abs() < 1e-13, "{motor:?}");
            assert!((motor.power - shafts.torque * shafts.speed).abs() < 1e-12, "{motor:?}");
        }
    }
}

/// Coupled shafts are one flywheel: θ = ω₀ t + T t² / 2(J₁ + J₂), about whatever axes they turn.
#[test]
fn a_torque_accelerates_both_flywheels_as_one() {
    for bend in [0.0_f64, 40.0, 75.0] {
        let wheels = Flywheels { bend: bend.to_radians() };
        let mut state = wheels.initial_state().expect("a state");
        let mut integrator = Integrator::new(1e-11);
        for step in 1..=20 {
            let t = 0.2 * f64::from(step);
            wheels.advance(&mut state, t, &mut integrator).expect("it turns");
            let even = wheels.even(&state);
            assert!((even.value - 3.0 * t - 2.5 * t * t).abs() < 1e-9 && (even.rate - 3.0 - 5.0 * t).abs() < 1e-9, "{bend}°: {even:?}");
            assert!((wheels.energy(&state).kinetic - 0.2 * (3.0 + 5.0 * t).powi(2)).abs() < 1e-8);
        }
    }
}

#[test]
fn the_start_chooses_between_two_assemblies_half_a_turn_apart() {
    for bend in [5.0_f64, 30.0, 60.0] {
        let shafts = HalfATurnOn { bend: bend.to_radians() };
        for state in shafts.sweep(times()) {
            let state = state.expect("it turns");
            let even = shafts.even(&state);
            let expected = std::f64::consts::PI + std::f64::consts::TAU * state.t;
            assert!((even.value - expected).abs() < 8e-15, "{bend}°: {even:?}");
            assert!((even.rate - std::f64::consts::TAU).abs() < 4e-14, "{bend}°: {even:?}");
        }
    }
}

/// A wheel's orientation is that of the input, bent the shortest way from the direction of the input to its own; the angular velocity
/// of one shaft against the other lies in the plane that bisects them.
#[test]
fn a_wheel_that_is_steered_is_bent_and_not_turned() {
    let x = Vector3::x_axis();
    let axis_angle = |axis: Unit<Vector3<f64>>, angle: f64| UnitQuaternion::from_axis_angle(&axis, angle);
    let steered = Steered::default();
    for state in steered.sweep(times()) {
        let state = state.expect("it turns");
        let steering = axis_angle(Vector3::z_axis(), 35_f64.to_radians() * (5.0 * state.t).sin());
        let camber = axis_angle(Vector3::y_axis(), 25_f64.to_radians() * (3.0 * state.t + 20_f64.to_radians()).sin());
        let way = steering * camber * x;
        let bend = UnitQuaternion::rotation_between(&x, &way).expect("less than half a turn");
        let expected = bend * axis_angle(x, std::f64::consts::TAU * state.t);
        let (wheel, input) = (state.wheel(), state.input());
        assert!(wheel.orientation().angle_to(&expected) < 1e-7, "{:e}", wheel.orientation().angle_to(&expected));
        assert!((wheel.orientation() * Vector3::z() - expected * Vector3::z()).norm() < 2e-14);
        let slip = (wheel.angular_velocity - input.angular_velocity).dot(&(x.into_inner() + way.into_inner()));
        assert!(slip.abs() < 1e-13, "{slip:e}");
    }
}
