//! Motions and parameters that lead over whole turns from rest to rest: a double crank, whose follower turns as often as its crank.

use std::f64::consts::TAU;

use reuleaux::{Cause, mechanism};
use reuleaux_tests::samples;

mechanism! {
    /// A double crank that waits, turns and waits.
    mechanism Indexed {
        param at: Time = 0s;
        param duration: Time = 1s;
        ground { point D = (50mm, 0mm); }
        body crank    { point A = (150mm, 0mm); }
        body coupler  { point B = (180mm, 0mm); }
        body follower { point B = (160mm, 0mm);  start angle = 60deg; }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, follower.B);
        joint c = revolute(follower.position, ground.D);
        drive input = drive_angle(crank, 1turn * cycloidal((t - at) / duration));
        output follower = follower.angle;
    }
}

mechanism! {
    /// A double crank at constant speed, from a time that is a parameter.
    mechanism Delayed {
        param delay: Time = 0s;
        param speed: AngularVelocity = 60rpm;
        ground { point D = (50mm, 0mm); }
        body crank    { point A = (150mm, 0mm); }
        body coupler  { point B = (180mm, 0mm); }
        body follower { point B = (160mm, 0mm);  start angle = 60deg; }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, follower.B);
        joint c = revolute(follower.position, ground.D);
        drive input = drive_angle(crank, speed * (t - delay));
    }
}

/// Turns of the crank and of the follower since `start`.
fn turns(crank: f64, follower: f64, start: f64) -> [f64; 2] {
    [crank / TAU, (follower - start) / TAU]
}

/// Durations from 1 s to 1 ms.
fn durations() -> impl Iterator<Item = f64> {
    (0..100).map(|k| 10_f64.powf(-0.03 * f64::from(k)))
}

/// The rates of a law that has yet to begin are rounding errors, and tell nothing of how far it leads.
#[test]
fn a_law_that_begins_at_rest_is_followed_whatever_the_time_asked_for() {
    for duration in durations() {
        let indexed = Indexed { at: 0.0, duration };
        let start = indexed.solve(0.0).unwrap().follower().angle;
        for t in [2.0, 5.0, 20.0] {
            let state = indexed.solve(t).unwrap_or_else(|failure| panic!("{duration} s, {t} s: {failure}"));
            let found = turns(state.crank().angle, state.follower().angle, start);
            assert!(found.iter().all(|turns| (turns - 1.0).abs() < 1e-14), "{duration} s, {t} s: {found:?}");
        }
    }
}

#[test]
fn a_law_between_the_times_of_a_sweep_is_followed() {
    for duration in durations().filter(|duration| *duration > 0.005) {
        let indexed = Indexed { at: 1.0, duration };
        for times in [vec![0.0, 4.0], vec![0.0, 2.0, 4.0]] {
            let mut states = indexed.sweep(times).map(|state| state.unwrap_or_else(|failure| panic!("{duration} s: {failure}")));
            let (first, last) = (states.next().unwrap(), states.last().unwrap());
            let found = turns(last.crank().angle, last.follower().angle, first.follower().angle);
            assert!(found.iter().all(|turns| (turns - 1.0).abs() < 1e-14), "{duration} s: {found:?}");
        }
    }
}

/// The way from the defaults to the parameters may be of many turns.
#[test]
fn parameters_may_turn_a_drive_by_many_turns() {
    let start = Delayed::default().solve(0.0).unwrap().follower().angle;
    for delay in (1..40).step_by(samples(3, 1)).map(f64::from).chain([100.0, 500.0]) {
        let delayed = Delayed { delay, ..Default::default() };
        let state = delayed.solve(0.0).unwrap_or_else(|failure| panic!("{delay} s: {failure}"));
        let found = turns(state.crank().angle, state.follower().angle, start);
        assert!(found.iter().all(|turns| (turns + delay).abs() < 1e-12 * delay), "{delay} s: {found:?}");
        let prepared = delayed.prepared().solve(0.0).unwrap();
        assert_eq!(prepared.follower().angle, state.follower().angle, "{delay} s");
    }
}

/// A state of other parameters, between which the drive turns by whole turns, is refused rather than left behind.
#[test]
fn a_drive_that_turns_on_by_a_parameter_leaves_nothing_behind() {
    let mut state = Delayed::default().solve(10.0).unwrap();
    let before = state.clone();
    let faster = Delayed { speed: 1.1 * TAU, ..Default::default() };
    let failure = faster.advance(&mut state, 10.0).unwrap_err();
    assert!(matches!(failure.cause, Cause::StateTooFar { .. }), "{failure}");
    assert_eq!(state, before);
    assert_eq!(
        turns(11.0 * TAU, faster.solve(10.0).unwrap().follower().angle, Delayed::default().solve(0.0).unwrap().follower().angle)[1].round(),
        11.0
    );
}

mechanism! {
    /// A wheel without a loop, at a speed that is a parameter, and one whose angle jumps.
    mechanism Wheels {
        param speed: AngularVelocity = 60rpm;
        body wheel  { }
        body jumper { }
        joint o = revolute(ground.position, wheel.position);
        joint p = revolute(ground.position, jumper.position);
        drive turning = drive_angle(wheel, speed * t);
        let later = 90deg;
        drive jumping = drive_angle(jumper, if t < 1s { 0deg } else { later });
    }
}

/// Without a loop there is nothing to be left behind.
#[test]
fn angles_without_a_loop_may_jump() {
    let wheels = Wheels::default();
    let state = wheels.solve(100.0).unwrap();
    assert_eq!(state.jumper().angle, TAU / 4.0);
    let (mut changed, faster) = (state.clone(), Wheels { speed: 1.1 * TAU });
    faster.advance(&mut changed, 100.0).unwrap();
    assert_eq!(changed.wheel().angle, 1.1 * TAU * 100.0);
    let far = Wheels { speed: 1e6 };
    assert_eq!(far.solve(1.0).unwrap().wheel().angle, 1e6);
}
