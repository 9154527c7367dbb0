//! Laws that turn a crank once while a motion by forces is at rest beside it, far faster than its steps.

use std::f64::consts::TAU;

use reuleaux::{Integrator, mechanism};

mechanism! {
    /// A double crank is turned once, beside a slow oscillator.
    mechanism DoubleCrank {
        param duration: Time = 1s;
        ground { point D = (50mm, 0mm); }
        body crank    { point A = (150mm, 0mm); }
        body coupler  { point B = (180mm, 0mm); }
        body follower { point B = (160mm, 0mm);  start angle = 60deg; }
        body weight   { mass = 1kg; }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, follower.B);
        joint c = revolute(follower.position, ground.D);
        joint guide = translational((1, 0), (0m, 2m), weight.position);
        drive input = drive_angle(crank, 1turn * cycloidal((t - 50s) / duration));
        force slow = { at weight.position: (-0.01N_m * weight.x, 0N); }
        freedom x = weight.x from 1m;
    }
}

mechanism! {
    /// A crank-rocker is turned once, beside a slow oscillator.
    mechanism CrankRocker {
        param duration: Time = 1s;
        ground { point D = (400mm, 0mm); }
        body crank   { point A = (100mm, 0mm); }
        body coupler { point B = (350mm, 0mm); }
        body rocker  { point B = (300mm, 0mm);  start angle = 70deg; }
        body weight  { mass = 1kg; }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.D);
        joint guide = translational((1, 0), (0m, 2m), weight.position);
        drive input = drive_angle(crank, 1turn * cycloidal((t - 50s) / duration));
        force slow = { at weight.position: (-0.01N_m * weight.x, 0N); }
        freedom x = weight.x from 1m;
    }
}

/// The follower turns as often as its crank, however long the steps of the oscillator are.
#[test]
fn a_crank_that_turns_within_a_step_takes_its_follower_with_it() {
    for duration in [5.0, 0.5, 0.05, 0.005] {
        let mechanism = DoubleCrank { duration };
        let mut state = mechanism.initial_state().unwrap();
        let start = state.follower().angle;
        mechanism.advance(&mut state, 100.0, &mut Integrator::new(1e-9)).unwrap();
        let turns = [state.crank().angle / TAU, (state.follower().angle - start) / TAU];
        assert!(turns.iter().all(|turns| (turns - 1.0).abs() < 1e-8), "{duration} s: {turns:?}");
        assert!((state.weight().position.x - 10_f64.cos()).abs() < 1e-8, "{duration} s: {:?}", state.weight());
    }
}

/// At all times of a sweep, also within the motion, the rocker is where it is in the mechanism without forces.
#[test]
fn a_sweep_goes_on_where_a_crank_turns_within_a_step() {
    for duration in [5.0, 0.5, 0.2] {
        let mechanism = CrankRocker { duration };
        let times = (0..=1200).map(|step| 0.05 * f64::from(step));
        for state in mechanism.sweep(times, Integrator::new(1e-8)) {
            let state = state.unwrap_or_else(|stopped| panic!("{duration} s: {stopped}"));
            let (t, crank, rocker) = (state.t, state.crank().angle, state.rocker().angle);
            let u = ((t - 50.0) / duration).clamp(0.0, 1.0);
            assert!((crank - (TAU * u - (TAU * u).sin())).abs() < 1e-12, "{duration} s, {t} s");
            // The rocker hangs on the diagonal from the crank pin to D: its angle by the law of cosines.
            let (x, y) = (0.4 - 0.1 * crank.cos(), -0.1 * crank.sin());
            let (diagonal, toward) = (x.hypot(y), (-y).atan2(-x));
            let inside = ((0.09 + diagonal * diagonal - 0.1225) / (0.6 * diagonal)).acos();
            let off = (rocker - (toward - inside)) / TAU;
            assert!((off - off.round()).abs() < 1e-8 && rocker.abs() < 3.2, "{duration} s, {t} s: {rocker} beside {}", toward - inside);
        }
    }
}
