//! Inputs that jump, begin anew after a turn, are noisy, cannot be reached or are no numbers.

use std::f64::consts::TAU;

use reuleaux::{Motion, mechanism};

use crate::motion::{Measured, MeasuredInputs};

fn at(theta: f64) -> MeasuredInputs<f64> {
    MeasuredInputs { theta: Motion::at(theta) }
}

/// The rocker's angle by Freudenstein's equation, with the coupler above.
fn rocker(crank: f64) -> f64 {
    let (a, b, c, d) = (0.1, 0.35, 0.3, 0.4);
    let (k1, k2, k3) = (d / a, d / c, (a * a - b * b + c * c + d * d) / (2.0 * a * c));
    let cosine = f64::cos(crank);
    let (p, q, r) = (cosine - k1 - k2 * cosine + k3, -2.0 * f64::sin(crank), k1 - (k2 + 1.0) * cosine + k3);
    2.0 * ((-q - (q * q - 4.0 * p * r).sqrt()) / (2.0 * p)).atan()
}

#[test]
fn a_jump_of_any_size_stays_on_the_branch() {
    let mechanism = Measured::default();
    let mut state = mechanism.solve(0.0, at(0.5)).unwrap();
    // At one time, a moment later, and long after.
    for pause in [0.0, 1e-3, 100.0] {
        for theta in [0.6, 2.0, -1.0, 3.0, 9.0, -20.0, 0.5] {
            let t = state.t + pause;
            mechanism.advance(&mut state, t, at(theta)).unwrap();
            assert_eq!((state.t, state.1), (t, at(theta)));
            assert!((state.crank().angle - theta).abs() < 1e-14 && (state.rocker().angle - rocker(theta)).abs() < 1e-13);
            assert!(state.qd.amax() < 1e-13, "what rests has no rates left of the way");
        }
    }
}

#[test]
fn rates_after_a_jump_are_those_of_the_input() {
    let mechanism = Measured::default();
    let inputs = MeasuredInputs { theta: Motion::new(2.5, 4.0, -3.0) };
    let mut state = mechanism.solve(0.0, at(0.5)).unwrap();
    mechanism.advance(&mut state, 0.0, inputs).unwrap();
    let direct = mechanism.solve(0.0, inputs).unwrap();
    let near = mechanism.solve_near(0.0, &state.q, inputs).unwrap();
    for other in [&direct, &near] {
        assert!((state.qd - other.qd).amax() < 1e-13 && (state.qdd - other.qdd).amax() < 1e-12);
    }
    let step = 1e-5;
    let around = [-1.0, 1.0].map(|sign| rocker(2.5 + 4.0 * sign * step - 1.5 * step * step));
    assert!((state.rocker().angular_velocity - (around[1] - around[0]) / (2.0 * step)).abs() < 1e-8);
}

#[test]
fn an_encoder_that_begins_anew_is_unwrapped() {
    let mechanism = Measured::default();
    let mut state = mechanism.solve(0.0, at(0.0)).unwrap();
    for step in 1..=4000 {
        // Eight turns at 1 ms, read modulo a turn and rounded to 12 bits.
        let t = 1e-3 * f64::from(step);
        let read = (2.0 * TAU * t).rem_euclid(TAU);
        let read = (read / TAU * 4096.0).round() / 4096.0 * TAU;
        let theta = Motion::moving(read, 2.0 * TAU).nearest_turn(state.crank().angle);
        mechanism.advance(&mut state, t, MeasuredInputs { theta }).unwrap();
        assert!((state.crank().angle - 2.0 * TAU * t).abs() < TAU / 4096.0);
        assert!((state.rocker().angle - rocker(theta.value)).abs() < 1e-13);
    }
    // As it is read, it goes back by a turn; that is where it goes.
    mechanism.advance(&mut state, 4.001, at(0.01)).unwrap();
    assert!((state.crank().angle - 0.01).abs() < 1e-14);
}

#[test]
fn what_cannot_be_reached_leaves_the_state_as_it_is() {
    let mechanism = Measured { crank_length: 0.3, ..Default::default() };
    // With this crank the linkage opens at cos θ = (a² + d² − (b − c)²) / 2 a d … for the rocker in line with the coupler.
    let mut state = mechanism.solve(0.0, at(40f64.to_radians())).unwrap();
    let limit = ((0.3f64 * 0.3 + 0.4 * 0.4 - 0.65 * 0.65) / (2.0 * 0.3 * 0.4)).acos();
    let before = state.clone();
    for t in [0.0, 1e-3, 5.0] {
        let failure = mechanism.advance(&mut state, t, at(limit + 0.01)).unwrap_err();
        assert_eq!(state, before);
        let last = failure.last.expect("a state on the way");
        assert!((last.q[2] - limit).abs() < 1e-6, "{} {limit}", last.q[2]);
        assert_eq!(failure.mechanism, "Measured");
    }
    mechanism.advance(&mut state, 1.0, at(limit - 0.01)).unwrap();
    for wrong in [f64::NAN, f64::INFINITY] {
        for theta in [Motion::at(wrong), Motion::moving(0.0, wrong), Motion::new(0.0, 0.0, wrong)] {
            let failure = mechanism.solve_from(1.0, &state, MeasuredInputs { theta }).unwrap_err().to_string();
            assert!(failure.starts_with("`Measured` cannot be solved with `theta"), "{failure}");
        }
    }
}

#[test]
fn change_points_are_passed_between_two_steps_of_a_loop() {
    mechanism! {
        /// All bars are in line twice in a turn.
        pub mechanism Parallelogram {
            input theta: Angle = 60deg;
            ground { point C = (400mm, 0mm); }
            body crank   { point A = (100mm, 0mm); }
            body coupler { point B = (400mm, 0mm); }
            body rocker  { point B = (100mm, 0mm);  start angle = 60deg; }
            joint o = revolute(ground.position, crank.position);
            joint a = revolute(crank.A, coupler.position);
            joint b = revolute(coupler.B, rocker.B);
            joint c = revolute(rocker.position, ground.C);
            drive motor = drive_angle(crank, theta);
        }
    }
    let mechanism = Parallelogram::default();
    let theta = |t: f64| ParallelogramInputs { theta: Motion::moving(1.0 + 3.0 * t, 3.0) };
    let mut state = mechanism.solve(0.0, theta(0.0)).unwrap();
    for step in 1..=500 {
        let t = 1e-2 * f64::from(step);
        mechanism.advance(&mut state, t, theta(t)).unwrap();
        assert!(state.coupler().angle.abs() < 1e-7 && (state.rocker().angle - (1.0 + 3.0 * t)).abs() < 1e-7, "{t}");
    }
    // Backwards in time, in steps that have to be divided.
    for step in [2.5, 1.5, 0.5] {
        let mut state = mechanism.solve(0.0, theta(0.0)).unwrap();
        for t in (1..=5).map(|count| -step * f64::from(count)) {
            mechanism.advance(&mut state, t, theta(t)).unwrap_or_else(|failure| panic!("{t} s: {failure}"));
            assert!(state.coupler().angle.abs() < 1e-7 && (state.rocker().angle - (1.0 + 3.0 * t)).abs() < 1e-7, "{t}");
        }
    }
}

mechanism! {
    /// A crank that is commanded and shaken, a cylinder between its pin and that of a rocker, as far from the origin as one likes.
    mechanism Shaken {
        param away: Length = 0mm;
        input theta: Angle = 40deg;
        ground { point O = (away, 0mm);  point C = (away + 400mm, 0mm); }
        body crank  { point A = (100mm, 0mm); }
        body tube   { axis along = (1, 0); }
        body piston { }
        body rocker { point B = (300mm, 0mm);  start angle = 70deg; }
        joint o = revolute(ground.O, crank.position);
        joint a = revolute(crank.A, tube.position);
        joint slide = translational(tube.along, tube.position, piston.position);
        joint b = revolute(piston.position, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        drive motor = drive_angle(crank, theta + 100mrad * sin(t * 3rad_s));
        drive cylinder = drive_along(slide, 350mm);
    }
}

/// Laws of time stand still while inputs are led along, however large the condition is.
#[test]
fn inputs_jump_beside_laws_of_time_far_from_the_origin() {
    for away in [0.0, 1e2, 1e3, 1e4, 1e5] {
        let mechanism = Shaken { away, ..Default::default() };
        for theta in [0.7, 1.5, -1.0] {
            let state =
                mechanism.solve(0.0, ShakenInputs { theta: Motion::moving(theta, 2.0) }).unwrap_or_else(|failure| panic!("{failure}"));
            // From the triangle of both pins and the rocker's pivot, without rounding of the place.
            let (x, y) = (0.4 - 0.1 * theta.cos(), -0.1 * theta.sin());
            let (distance, side) = (x.hypot(y), 0.35);
            let inner = ((distance * distance + 0.09 - side * side) / (0.6 * distance)).acos();
            let right = (-y).atan2(-x) - inner;
            let off = 2.0 * (0.5 * (state.rocker().angle - right)).sin().abs();
            assert!(off < 16.0 * f64::EPSILON * state.condition, "{away:e}, {theta}: {off:e}");
            assert!((state.crank().angular_velocity - 2.3).abs() < 1e-14);
        }
    }
}

mechanism! {
    /// A slide whose place is commanded, and the crank that it turns.
    mechanism Pushed {
        input x: Length = 120mm;
        body crank { point A = (50mm, 0mm); }
        body rod   { point B = (100mm, 0mm);  start angle = -20deg; }
        body slide { }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, rod.position);
        joint b = revolute(rod.B, slide.position);
        joint guide = translational((1, 0), ground.position, slide.position);
        drive push = drive_x(slide.position, x);
    }
}

/// The rates at both ends of a long pause do not last for all of it.
#[test]
fn rates_at_the_ends_of_a_long_pause_lead_nowhere_else() {
    let mechanism = Pushed::default();
    let to = |x: f64, rate: f64| PushedInputs { x: Motion::moving(x, rate) };
    let right = |x: f64| ((x * x + 0.05 * 0.05 - 0.1 * 0.1) / (2.0 * 0.05 * x)).acos();
    for (t, rate) in [(0.0, 0.05), (10.0, 0.05), (1e4, 0.05), (-3.0, 1.0), (100.0, -50.0)] {
        let state = mechanism.solve(t, to(0.13, rate)).unwrap_or_else(|failure| panic!("{t} s, {rate} m/s: {failure}"));
        assert!((state.crank().angle - right(0.13)).abs() < 1e-14, "{t} s, {rate} m/s: {}", state.crank().angle);
        assert!((state.slide().velocity.x - rate).abs() <= 1e-14 * rate.abs(), "{t} s, {rate} m/s");
    }
    let mut state = mechanism.solve(1.0, to(0.13, 0.1)).unwrap();
    for (t, x, rate) in [(2.0, 0.12, -0.1), (5.0, 0.11, 0.3), (105.0, 0.14, 0.1), (5.0, 0.13, 0.3), (4.9, 0.12, -0.1), (-300.0, 0.13, 2.0)]
    {
        mechanism.advance(&mut state, t, to(x, rate)).unwrap_or_else(|failure| panic!("{t} s: {failure}"));
        assert!((state.crank().angle - right(x)).abs() < 1e-14 && (state.slide().velocity.x - rate).abs() < 1e-15, "{t} s");
    }
}
