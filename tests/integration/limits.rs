//! Motions that end: at a dead point, whose time is found, or by growing without bound.

use std::f64::consts::{FRAC_PI_4, PI};

use reuleaux::{Cause, mechanism};

mechanism! {
    /// A four-bar whose crank cannot make a full turn.
    #[closure(start)]
    mechanism Rocking {
        param crank_length: Length = 200mm;
        param coupler_length: Length = 260mm;
        param rocker_length: Length = 210mm;
        param base: Length = 400mm;
        ground { point O = (0mm, 0mm);  point C = (base, 0mm); }
        body crank   { point A = (crank_length, 0mm);  start angle = 60deg; }
        body coupler { point B = (coupler_length, 0mm); }
        body rocker  { point B = (rocker_length, 0mm);  start angle = 110deg; }
        joint o = revolute(ground.O, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(ground.C, rocker.position);
        drive motor = drive_angle(crank, 60deg + 90deg_s * t);
    }
}

mechanism! {
    /// A slide on a rail and in the slot of an arm that becomes parallel to the rail after one second.
    mechanism Runaway {
        param height: Length = 100mm;
        ground { axis way = (1, 0);  point above = (0mm, height); }
        body arm { axis slot = (1, 0);  start angle = 45deg; }
        body slide { start x = 100mm; }
        joint pivot = revolute(ground.position, arm.position);
        joint rail = translational(ground.way, ground.above, slide.position);
        joint pin = point_on_line(arm.position, arm.slot, slide.position);
        drive turn = drive_angle(arm, 45deg - 45deg_s * t);
    }
}

/// The crank stops where coupler and rocker are in line: (b + c)² = a² + d² − 2 a d cos φ.
#[test]
fn the_time_of_a_dead_point_is_right() {
    for (crank, coupler, rocker, base) in [(0.2, 0.26, 0.21, 0.4), (0.3, 0.2, 0.25, 0.4), (0.25, 0.3, 0.2, 0.45), (0.2, 0.3, 0.15, 0.4)] {
        let rocking = Rocking { crank_length: crank, coupler_length: coupler, rocker_length: rocker, base };
        let reach: f64 = coupler + rocker;
        let most = ((crank * crank + base * base - reach * reach) / (2.0 * crank * base)).acos();
        let end = (most - PI / 3.0) / (PI / 2.0);
        for steps in [1, 3, 10, 77, 1000] {
            let times = (0..=steps).map(|step| 1.5 * end * f64::from(step) / f64::from(steps));
            let failure = rocking.sweep(times).find_map(Result::err).expect("it stops");
            assert!(matches!(failure.cause, Cause::Singular { .. }), "{failure}");
            let last = failure.last.expect("it began").t;
            println!("{:.1e} {:.1e}", failure.time - end, last - end);
            assert!((failure.time - end).abs() < 1e-13, "{steps} steps: {:e} off", failure.time - end);
            assert!(last <= failure.time && end - last < 1e-12, "{steps} steps: the last state is {:e} before the end", end - last);
        }
    }
}

#[test]
fn a_slide_that_runs_away_diverges_in_time() {
    let runaway = Runaway::default();
    for steps in [1, 2, 7, 30, 400] {
        let times = (0..=steps).map(|step| 2.0 * f64::from(step) / f64::from(steps));
        let mut last = None;
        let failure = runaway.sweep(times).find_map(|state| state.map(|state| last = Some(state)).err()).expect("it diverges");
        let Cause::Diverges { coordinate, value } = failure.cause else { panic!("{steps} steps: {failure}") };
        assert_eq!((coordinate.body, coordinate.name), ("slide", "x"));
        println!("{failure}");
        assert!(value > 100.0 * 0.1 && (failure.time - 1.0).abs() < 1e-3, "{failure}");
        let states = last.map(|state| (state.t, state.slide().position.x)).into_iter();
        for (t, x) in states.chain(failure.last.map(|state| (state.t, state.q[3]))) {
            let right = 0.1 / (FRAC_PI_4 * (1.0 - t)).tan();
            assert!((x - right).abs() <= 1e-13 * (1.0 + right * right / 0.1), "{x} instead of {right} at {t}");
        }
    }
}
