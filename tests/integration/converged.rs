//! Near positions where two assemblies meet, Newton's method at first only halves the error; returned states have converged all the same.

use std::f64::consts::PI;

use reuleaux::{Cause, mechanism};
use reuleaux_tests::samples;

mechanism! {
    /// An arm of 1 m that is pushed towards the pivot of its push rod, 1 m from its own.
    mechanism Rocker {
        param d: Length = 100mm;
        param arm_length: Length = 1m;
        ground { point O = (0m, 0m);  point P = (1m, 0m); }
        body arm { point P = (0m, 0m);  point E = (arm_length, 0m);  start angle = 174deg; }
        joint p = revolute(ground.P, arm.P);
        drive push = drive_distance(ground.O, arm.E, d - 1m_s * t);
    }
}

mechanism! {
    /// A stage on a rail, moved by a piezo of some nanometres.
    mechanism Piezo {
        param middle: Length = 20e-9m;
        param stroke: Length = 15e-9m;
        ground { axis rail = (1, 0); }
        body stage { start x = 20e-9m; }
        joint guide = translational(ground.rail, ground.position, stage.position);
        drive piezo = drive_distance(ground.position, stage.position, middle + stroke * sin(1rad_s * t));
    }
}

/// The arm's angle is π − 2 asin(d / 2), its rate 1 / √(1 − d²/4) per second, towards π.
fn rocker_is_right(t: f64, rate: f64) {
    let d = 0.1 - t;
    let right = 1.0 / (1.0 - d * d / 4.0).sqrt();
    // An angle near π is rounded to half an ulp of π; relative to its distance from π, this error enters the rate.
    let allowed = 1e-14 + 4.0 * f64::EPSILON * PI / d;
    assert!((rate.abs() - right).abs() <= allowed, "at {t}: {rate} instead of {right}, {allowed:.1e} allowed");
}

#[test]
fn an_arm_close_to_its_fold_has_its_rate() {
    let rocker = Rocker::default();
    for digits in 2..=12 {
        for share in [1.0, 3.0, 0.7] {
            let t = 0.1 - share * 0.1f64.powi(digits);
            match rocker.solve(t) {
                Ok(state) => {
                    println!("{:.1e} {} condition {:.1e}", 0.1 - t, state.arm().angular_velocity, state.condition);
                    rocker_is_right(t, state.arm().angular_velocity);
                }
                Err(failure) => {
                    println!("{:.1e} {failure}", 0.1 - t);
                    assert!(matches!(failure.cause, Cause::Singular { .. }) && 0.1 - t < 3e-9, "{failure}");
                }
            }
            for state in rocker.sweep([0.0, 0.02, 0.04, 0.06, 0.08, t]).map_while(Result::ok) {
                rocker_is_right(state.t, state.arm().angular_velocity);
            }
        }
    }
}

/// The condition of a state does not depend on the path to it.
#[test]
fn a_condition_is_that_of_its_place() {
    let rocker = Rocker::default();
    for digits in 1..=8 {
        let t = 0.1 - 0.3 * 0.1f64.powi(digits);
        let alone = rocker.solve(t).unwrap().condition;
        for steps in [2, 5, 50, 500] {
            let last = rocker.sweep((0..=steps).map(|step| t * f64::from(step) / f64::from(steps))).last();
            let condition = last.unwrap().unwrap().condition;
            assert!((condition / alone - 1.0).abs() < 1e-6, "{condition:e} after {steps} steps, {alone:e} at once, at {t}");
        }
        let guess = rocker.solve(0.0).unwrap().q;
        let near = rocker.solve_near(t, &guess).unwrap().condition;
        assert!((near / alone - 1.0).abs() < 1e-6, "{near:e} from a guess, {alone:e} at once, at {t}");
    }
}

#[test]
fn a_stage_of_nanometres_is_right_to_its_own_size() {
    for scale in [1e3, 1.0, 1e-3, 1e-6] {
        let piezo = Piezo { middle: 20e-9 * scale, stroke: 15e-9 * scale };
        for steps in [3, 10, 100] {
            for state in piezo.sweep((0..=steps).map(|step| 2.0 * PI * f64::from(step) / f64::from(steps))) {
                let state = state.unwrap();
                let right = [20e-9 + 15e-9 * state.t.sin(), 15e-9 * state.t.cos(), -15e-9 * state.t.sin()].map(|value| scale * value);
                for (found, right) in [state.q[0], state.qd[0], state.qdd[0]].into_iter().zip(right) {
                    assert!((found - right).abs() < 1e-14 * 35e-9 * scale, "{found:e} instead of {right:e}, scale {scale}, {steps} steps");
                }
            }
        }
    }
}

mechanism! {
    /// Two bars that are nearly in line.
    mechanism Toggle {
        param one_length: Length = 1m;
        param other_length: Length = 1m;
        param reach: Length = 1.9m;
        ground { axis rail = (1, 0); }
        body one    { point B = (one_length, 0m);  start angle = 0.3rad; }
        body other  { point C = (other_length, 0m);  start angle = -0.3rad; }
        body slider { }
        joint a = revolute(ground.position, one.position);
        joint b = revolute(one.B, other.position);
        joint c = revolute(other.C, slider.position);
        joint guide = translational(ground.rail, ground.position, slider.position);
        drive push = drive_x(slider.position, reach - 1m_s * t);
    }
}

/// Rate of the first bar by the law of cosines: sin θ by Heron's formula, in which only a + b − x cancels, and this difference is exact.
fn rate_of_toggle([a, b, x]: [f64; 3]) -> f64 {
    let sum = a + b;
    let rest = (a - (sum - (sum - a))) + (b - (sum - a));
    let gap = (sum - x) + rest;
    let twice_area = 0.5 * ((sum + x) * gap * (x + a - b) * (x - a + b)).sqrt();
    let (sine, cosine) = (twice_area / (x * a), (a * a + x * x - b * b) / (2.0 * a * x));
    (x - a * cosine) / (a * x * sine)
}

/// A toggle ever closer to its stretched position: its rate is found down to a gap of 1e-14; below that, if a state is returned, the
/// error of its rate is at most a quarter.
#[test]
fn a_toggle_has_its_rate_or_none() {
    let mut random = fastrand::Rng::with_seed(10);
    for digits in 20..=68 {
        for _ in 0..samples(4, 12) {
            let [one_length, other_length] = [0.5 + random.f64(), 0.5 + random.f64()];
            let reach = one_length + other_length - (1.0 + random.f64()) * 0.1f64.powf(f64::from(digits) / 4.0);
            let right = rate_of_toggle([one_length, other_length, reach]);
            match (Toggle { one_length, other_length, reach }).solve(0.0) {
                Ok(state) => {
                    let error = (state.one().angular_velocity / right - 1.0).abs();
                    let gap = one_length + other_length - reach;
                    let allowed = 4.0 * f64::EPSILON * (1.0 + 1.0 / gap);
                    assert!(error < allowed.min(0.25), "{one_length} {other_length} {reach}: {error} {allowed}");
                }
                Err(failure) => assert!(matches!(failure.cause, Cause::Singular { .. }) && digits >= 56, "{digits}: {failure}"),
            }
        }
    }
}
