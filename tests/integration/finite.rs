//! Numbers that are finite at the start and not at the time asked for: no state is returned.

use reuleaux::{Cause, Mechanism, mechanism};

mechanism! {
    /// A computed coordinate: a slider whose law ends at two seconds, in a direction that is a parameter.
    mechanism Way {
        param height: Length = 1m;
        body slider {}
        joint still = absolute_angle(slider, 0rad);
        joint level = absolute_y(slider.position, height);
        drive way = drive_x(slider.position, 1m * sqrt(2 - t / 1s));
    }
}

mechanism! {
    /// An iterated coordinate: a drive between two links in the block of a loop, with a rate that becomes infinite at two seconds.
    mechanism Loop {
        ground { point C = (4m, 0m); }
        body crank { point A = (1m, 0m); start angle = 60deg; }
        body coupler { point B = (3.5m, 0m); }
        body rocker { point B = (3m, 0m); start angle = 110deg; }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(ground.C, rocker.position);
        drive input = drive_relative_angle(crank, coupler, -50deg + 5deg * sqrt(2 - t / 1s));
    }
}

mechanism! {
    /// A law that ends smoothly at the zero of its base: value, rate and acceleration vanish there, and it is undefined afterwards.
    mechanism Power {
        body crank {}
        joint o = revolute(ground.position, crank.position);
        drive input = drive_angle(crank, 60deg * (1 - t / 2s)^2.5 + 1rad * (1 - t / 2s)^2.2);
    }
}

mechanism! {
    /// A guide whose direction is a parameter.
    mechanism Guide {
        param across: Number = 1;
        ground { axis way = (across, 0); }
        body slider {}
        joint guide = translational(ground.way, ground.position, slider.position);
        drive motor = drive_x(slider.position, 1m * sin(1rad_s * t));
    }
}

/// The motion continues up to two seconds, and to no later time.
fn ends_at_two<M: Mechanism<f64, N>, const N: usize>(mechanism: &M) {
    for steps in [3, 7, 50, 64, 200] {
        for result in mechanism.sweep((0..=steps).map(|step| 4.0 * f64::from(step) / f64::from(steps))) {
            match result {
                Ok(state) => {
                    assert!(state.t < 2.0, "{state:?}");
                    assert!([state.q, state.qd, state.qdd].iter().flatten().all(|entry| entry.is_finite()), "{state:?}");
                }
                Err(failure) => assert!(failure.time >= 1.99, "{failure}"),
            }
        }
    }
    let mut state = mechanism.solve(1.9).expect("before the end");
    for t in [2.0, 2.0 + 1e-9, 2.1] {
        let before = state.clone();
        mechanism.advance(&mut state, t).expect_err("after the end");
        assert_eq!(state, before);
    }
}

#[test]
fn a_way_ends_where_its_rate_does() {
    ends_at_two(&Way::default());
}

#[test]
fn a_block_ends_where_a_rate_in_it_does() {
    ends_at_two(&Loop::default());
}

#[test]
fn a_parameter_that_is_no_number_ends_what_is_taken_along() {
    let mut way = Way::default();
    let mut state = way.solve(0.0).expect("a state");
    for height in [f64::NAN, f64::INFINITY] {
        way.height = height;
        let failure = way.advance(&mut state, 0.01).expect_err("no height");
        assert!(matches!(failure.cause, Cause::ParameterOutOfRange(_)), "{failure}");
    }
}

#[test]
fn a_power_vanishes_smoothly_with_its_base() {
    let power = Power::default();
    let crank = power.solve(2.0).expect("the last moment").crank();
    assert_eq!([crank.angle, crank.angular_velocity, crank.angular_acceleration], [0.0; 3]);
    let base: f64 = 0.25;
    let crank = power.solve(1.5).expect("before").crank();
    let (first, second) = (std::f64::consts::FRAC_PI_3, 1.0);
    let exact = first * base.powf(2.5) + second * base.powf(2.2);
    let rate = -0.5 * (2.5 * first * base.powf(1.5) + 2.2 * second * base.powf(1.2));
    let acceleration = 0.25 * (2.5 * 1.5 * first * base.powf(0.5) + 2.2 * 1.2 * second * base.powf(0.2));
    for (found, exact) in [(crank.angle, exact), (crank.angular_velocity, rate), (crank.angular_acceleration, acceleration)] {
        assert!((found - exact).abs() <= 1e-15 * exact.abs().max(1.0), "{found} for {exact}");
    }
    power.solve(2.001).expect_err("below zero");
}

mechanism! {
    /// An output whose base passes through zero.
    mechanism Rooted {
        body crank { }
        joint pivot = revolute(ground.position, crank.position);
        drive motor = drive_angle(crank, 1rad_s * t);
        output power = (t / 1s) ^ 2.5 with jerk;
    }
}

#[test]
fn a_power_of_a_negative_base_has_no_value_and_no_derivative() {
    let rooted = Rooted::default();
    let below = rooted.power(&rooted.solve(-2.0).expect("a state"));
    assert!([below.value, below.rate, below.acceleration, below.jerk].into_iter().all(f64::is_nan), "{below:?}");
    let at = rooted.power(&rooted.solve(0.0).expect("a state"));
    assert_eq!([at.value, at.rate, at.acceleration], [0.0; 3]);
}

mechanism! {
    /// Powers of a depth that is zero for half of the time.
    mechanism Pressed {
        param hard: Number = 1.5;
        body crank { }
        joint pivot = revolute(ground.position, crank.position);
        drive motor = drive_angle(crank, 1rad_s * t);
        output hertzian = max(t / 1s, 0) ^ 1.5;
        output other = max(0, t / 1s) ^ 1.3;
        output given = max(t / 1s, 0) ^ hard;
        output root = max(t / 1s, 0) ^ 0.5;
    }
}

/// t ≤ 0: zero with all derivatives. Above, tⁿ.
#[test]
fn powers_of_a_positive_part_have_derivatives_on_both_sides() {
    let pressed = Pressed::default();
    for t in [-2.0, -1e-9, 0.0] {
        let state = pressed.solve(t).expect("a state");
        for output in [pressed.hertzian(&state), pressed.other(&state), pressed.given(&state), pressed.root(&state)] {
            assert_eq!([output.value, output.rate, output.acceleration], [0.0; 3], "{t}");
        }
    }
    let state = pressed.solve(2.0).expect("a state");
    let each = [(pressed.hertzian(&state), 1.5), (pressed.other(&state), 1.3), (pressed.given(&state), 1.5), (pressed.root(&state), 0.5)];
    for (output, n) in each {
        let right = [2f64.powf(n), n * 2f64.powf(n - 1.0), n * (n - 1.0) * 2f64.powf(n - 2.0)];
        let found = [output.value, output.rate, output.acceleration];
        assert!(found.iter().zip(&right).all(|(found, right)| (found - right).abs() < 4e-15), "{n}: {found:?}, not {right:?}");
    }
    // An exponent that is not positive has no value at zero.
    let pressed = Pressed::<f64> { hard: -1.0 };
    let output = pressed.given(&pressed.solve(-2.0).expect("a state"));
    assert!(!output.value.is_finite(), "{output:?}");
}

#[test]
fn a_direction_that_vanishes_is_named() {
    let failure = Guide { across: 0.0 }.solve(0.0).expect_err("no direction");
    assert_eq!(failure.to_string(), "`Guide` cannot be solved with `across` = 0: an axis of length zero has no direction (`ground.way`)");
    assert!(Guide { across: 0.5 }.solve(0.0).is_ok());
}
