//! Arrays of inputs, in space, in single precision, beside freedoms, in sweeps.

use reuleaux::nalgebra::Vector3;
use reuleaux::{Integrator, Motion, mechanism};

use crate::motion::{Measured, MeasuredInputs};

mechanism! {
    /// An arm in space with a measured angle in each hinge.
    pub mechanism Arm in space {
        for i in 0..2 { input joint_angle_of[i]: Angle; }
        ground { axis z = (0, 0, 1) from (1, 0, 0); }
        body upper { axis z = (0, 0, 1) from (1, 0, 0);  axis y = (0, 1, 0) from (1, 0, 0);  point end = (300mm, 0mm, 0mm); }
        body lower { axis y = (0, 1, 0) from (1, 0, 0);  point end = (200mm, 0mm, 0mm); }
        joint base = revolute(ground.position, ground.z, upper.position, upper.z);
        joint elbow = revolute(upper.end, upper.y, lower.position, lower.y);
        drive first = drive_rotation(base, joint_angle_of[0]);
        drive second = drive_rotation(elbow, joint_angle_of[1]);
        output tool = lower.end;
    }
}

#[test]
fn an_arm_in_space_follows_an_array_of_inputs() {
    let arm = Arm::default();
    let [a, b] = [Motion::new(0.7, 2.0, 0.0), Motion::new(-0.4, 1.5, 0.0)];
    let state = arm.solve(0.0, ArmInputs { joint_angle_of: [a, b] }).unwrap();
    let tool = arm.tool(&state);
    let ((sa, ca), (sb, cb)) = (a.value.sin_cos(), b.value.sin_cos());
    let reach = 0.3 + 0.2 * cb;
    let value = Vector3::new(ca * reach, sa * reach, -0.2 * sb);
    let inward = -0.2 * sb * b.rate;
    let rate = Vector3::new(-sa * a.rate * reach + ca * inward, ca * a.rate * reach + sa * inward, -0.2 * cb * b.rate);
    assert!((tool.value - value).norm() < 1e-15 && (tool.rate - rate).norm() < 1e-14);
    let (second, along) = (-0.2 * cb * b.rate * b.rate, 2.0 * inward * a.rate);
    let centripetal = second - reach * a.rate * a.rate;
    let acceleration = Vector3::new(ca * centripetal - sa * along, sa * centripetal + ca * along, 0.2 * sb * b.rate * b.rate);
    assert!((tool.acceleration - acceleration).norm() < 1e-14);
    assert_eq!(Arm::<f64>::PLAN.blocks().count(), 0);
}

#[test]
fn a_loop_in_single_precision_stays_within_it() {
    let mechanism = Measured::<f32>::with_defaults();
    let theta = |t: f32| MeasuredInputs { theta: Motion::moving(0.7 + 6.0 * t, 6.0) };
    let mut state = mechanism.solve(0.0, theta(0.0)).unwrap();
    let exact = Measured::default();
    for step in 1..=1000u16 {
        let t = 1e-3 * f32::from(step);
        mechanism.advance(&mut state, t, theta(t)).unwrap();
    }
    let expected = exact.solve(1.0, MeasuredInputs { theta: Motion::moving(f64::from(theta(1.0).theta.value), 6.0) }).unwrap();
    assert!((f64::from(state.rocker().angle) - expected.rocker().angle).abs() < 1e-5);
}

#[test]
fn a_sweep_takes_a_time_with_inputs_for_each_state() {
    let mechanism = Measured::default();
    let times = (0..50).map(|step| 0.01 * f64::from(step));
    let inputs = |t: f64| MeasuredInputs { theta: Motion::moving(1.0 + t, 1.0) };
    let swept: Vec<_> = mechanism.sweep(times.clone().map(|t| (t, inputs(t)))).collect::<Result<_, _>>().unwrap();
    assert_eq!(swept.len(), 50);
    for (state, t) in swept.iter().zip(times) {
        assert_eq!((state.t, state.1), (t, inputs(t)));
    }
    let failing = [(0.0, inputs(0.0)), (1.0, MeasuredInputs { theta: Motion::at(f64::NAN) }), (2.0, inputs(2.0))];
    let found: Vec<bool> = mechanism.sweep(failing).map(|state| state.is_ok()).collect();
    assert_eq!(found, [true, false]);
}

mechanism! {
    /// A cart that is pushed.
    pub mechanism Cart {
        input push: Force;
        body cart { mass = 4kg; }
        joint rail = translational((1, 0), ground.position, cart.position);
        force motor = { at cart.position: (push, 0N); }
        freedom way = cart.x;
    }
}

#[test]
fn beside_freedoms_a_force_is_held_until_it_is_set_again() {
    let mut cart = Cart::default();
    let mut state = cart.initial_state().unwrap();
    let (mut integrator, mut speed, mut place) = (Integrator::new(1e-12), 0.0, 0.0);
    for step in 1..=20 {
        let push = f64::from(step % 5) - 1.5;
        cart.inputs.push = Motion::at(push);
        cart.advance(&mut state, 0.1 * f64::from(step), &mut integrator).unwrap();
        place += 0.1 * speed + 0.005 * push / 4.0;
        speed += 0.1 * push / 4.0;
        assert!((state.cart().position.x - place).abs() < 1e-12 && (state.cart().velocity.x - speed).abs() < 1e-12, "{step}");
        assert!((cart.energy(&state).power - push * speed).abs() < 1e-12);
    }
}
