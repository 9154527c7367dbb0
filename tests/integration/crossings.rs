//! Positions where two branches of a mechanism cross: it could go on as either, so it goes on as none.

use std::f64::consts::PI;

use reuleaux::nalgebra::SVector;
use reuleaux::{Cause, Failure, Mechanism, mechanism};

mechanism! {
    /// A parallelogram; when its links are in line it could go on as an antiparallelogram.
    mechanism Parallelogram {
        param start: Angle = 61deg;
        ground { point A = (0m, 0m);  point B = (2m, 0m); }
        body crank  { point P = (500mm, 0mm); }
        body rod    { point Q = (2m, 0m); }
        body rocker { point P = (500mm, 0mm); }
        joint a = revolute(ground.A, crank.position);
        joint b = revolute(ground.B, rocker.position);
        joint c = revolute(crank.P, rod.position);
        joint d = revolute(rod.Q, rocker.P);
        drive input = drive_angle(crank, start + 10rpm * t);
    }
}

mechanism! {
    /// Crank and rod are equally long; when the piston passes the axle it could stay there.
    mechanism Isosceles {
        ground { axis way = (1, 0); }
        body crank  { point A = (50mm, 0mm); }
        body rod    { point B = (50mm, 0mm); }
        body piston { start x = 80mm; }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, rod.position);
        joint b = revolute(rod.B, piston.position);
        joint guide = translational(ground.way, ground.position, piston.position);
        drive input = drive_angle(crank, 31deg + 60deg_s * t);
    }
}

/// In however many steps, and by `solve`, it ends where the branches cross, and not after it.
fn ends_at<M: Mechanism<f64, 9>>(mechanism: &M, crossing: f64, end: f64) {
    let is_there = |failure: &Failure<f64, 9>| {
        assert!(matches!(failure.cause, Cause::Singular { .. }), "{failure}");
        assert!((failure.time - crossing).abs() < 1e-4, "{failure}, but the crossing is at {crossing} s");
    };
    for steps in (2..=60).chain([200, 400, 1000, 2000, 5000]) {
        let times = (0..=steps).map(|step| end * f64::from(step) / f64::from(steps));
        let mut last = 0.0;
        let failure = mechanism.sweep(times).find_map(|state| state.map(|state| last = state.t).err());
        is_there(&failure.unwrap_or_else(|| panic!("{steps} steps pass the crossing")));
        assert!(last <= crossing, "{steps} steps go on to {last} s");
    }
    for step in 1..=20 {
        let t = crossing + (end - crossing) * f64::from(step) / 20.0;
        is_there(&mechanism.solve(t).expect_err("it is behind the crossing"));
    }
}

#[test]
fn a_parallelogram_ends_in_line() {
    ends_at(&Parallelogram::default(), 119.0 / 60.0, 4.0);
}

#[test]
fn a_piston_ends_at_the_axle() {
    ends_at(&Isosceles::default(), 59.0 / 60.0, 2.0);
}

/// Where a step leads exactly to the crossing there is no state with rates.
#[test]
fn the_crossing_itself_is_no_state() {
    let parallelogram = Parallelogram { start: 60f64.to_radians() };
    for t in [2.0, 2.0 - 1e-9, 2.0 + 1e-9] {
        assert!(matches!(parallelogram.solve(t).expect_err("in line").cause, Cause::Singular { .. }));
    }
    assert!(parallelogram.solve(1.99).is_ok());
}

/// From wherever one comes, and even from the crossing itself, where every equation holds.
#[test]
fn a_guess_at_the_crossing_finds_no_state() {
    let parallelogram = Parallelogram { start: 60f64.to_radians() };
    let straight = SVector::from([0.0, 0.0, PI, -0.5, 0.0, 0.0, 2.0, 0.0, PI]);
    let singular = |failure: Failure<f64, 9>| assert!(matches!(failure.cause, Cause::Singular { .. }), "{failure}");
    singular(parallelogram.solve_near(2.0, &straight).expect_err("in line"));
    for off in (0..16).map(|digits| 0.3 * 0.1f64.powi(digits)) {
        for sign in [-1.0, 1.0] {
            let aside = SVector::<f64, 9>::from_fn(|k, _| sign * off * (1.0 + k as f64 / 3.0).sin());
            singular(parallelogram.solve_near(2.0, &(straight + aside)).expect_err("in line"));
        }
    }
}
