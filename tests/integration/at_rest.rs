//! Motions that begin at rest, where rates are rounding errors, reached by one call.

use reuleaux::mechanism;

mechanism! {
    /// A four-bar whose crank turns from rest to rest.
    mechanism FromRest {
        param duration: Time = 1s;
        ground { point C = (400mm, 0mm); }
        body crank   { point A = (100mm, 0mm); }
        body coupler { point B = (350mm, 0mm); }
        body rocker  { point B = (300mm, 0mm);  start angle = 70deg; }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        drive input = drive_angle(crank, 200deg * cycloidal(t / duration));
    }
}

/// Some durations give rates of 1e-16 at the beginning, some none.
#[test]
fn a_motion_from_rest_is_reached_at_all_times() -> Result<(), Box<dyn std::error::Error>> {
    for duration in [0.628, 0.7, 1.0, 1.090597, 1.3] {
        let mechanism = FromRest { duration };
        for step in 1..=40 {
            let t = f64::from(step) * 0.05;
            let by_steps = mechanism.sweep((0..=step).map(|k| f64::from(k) * 0.05)).last().ok_or("no state")??;
            let state = mechanism.solve(t).map_err(|failure| format!("{duration} s: {failure}"))?;
            let difference = state.rocker().angle - by_steps.rocker().angle;
            assert!(difference.abs() < 1e-13, "{duration} s, {t} s: {difference:e}");
        }
    }
    Ok(())
}
