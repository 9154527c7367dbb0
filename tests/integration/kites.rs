//! Kites: four-bars with two pairs of equal neighbours, whose other branch, the rocker at rest along the ground, crosses where all links are in line.

use std::f64::consts::TAU;

use reuleaux::mechanism;
use reuleaux_tests::samples;

mechanism! {
    /// A crank and a coupler of one length, a rocker as long as the ground.
    #[allow(far_start)]
    mechanism Kite {
        param short: Length = 1m;
        param long: Length = 1.5m;
        param start: Angle = 1rad;
        param speed: AngularVelocity = -1rad_s;
        ground { point C = (long, 0m); }
        body crank   { point A = (short, 0m); }
        body coupler { point B = (short, 0m);  start angle = -0.5rad; }
        body rocker  { point B = (long, 0m);  start angle = 120deg; }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        drive motor = drive_angle(crank, start + speed * t);
    }
}

impl Kite {
    /// Sweeps in a number of steps through the place where the crank lies along the ground, until it is 1 rad further, and compares the tip of the
    /// rocker with the mirror image of the origin about the line from A to C.
    fn passes(&self, steps: u32) {
        let way = if self.speed < 0.0 { self.start + 1.0 } else { TAU - self.start + 1.0 };
        let end = way / self.speed.abs();
        for state in self.sweep((0..=steps).map(|step| end * f64::from(step) / f64::from(steps))) {
            let state = state.unwrap_or_else(|failure| panic!("{steps} steps of {self:?}: {failure}"));
            let (sine, cosine) = (self.start + self.speed * state.t).sin_cos();
            let (along, across) = (self.long - self.short * cosine, -self.short * sine);
            let twice = 2.0 * self.long * across / (along * along + across * across);
            let (x, y) = (twice * across, -twice * along);
            let (sine, cosine) = state.rocker().angle.sin_cos();
            let off = (self.long * cosine + self.long - x).hypot(self.long * sine - y);
            // The other branch is off by about 1.
            assert!(off < 50.0 * f64::EPSILON * (1.0 + state.condition), "{steps} steps of {self:?}: {off:e} at {}", state.t);
        }
    }
}

/// From 0.5 rad in three steps, a step from 1e-8 rad before the crossing to 1e-7 rad behind it led to the rocker at rest.
#[test]
fn a_step_next_to_the_crossing_does_not_change_the_branch() {
    for start in (0..200).step_by(200 / samples(20, 200)).skip(1) {
        for steps in [1, 2, 3] {
            Kite { short: 1.0, long: 3.0, start: 0.01 * f64::from(start), speed: 2.0 }.passes(steps);
            Kite { short: 3.0, long: 1.0, start: 0.01 * f64::from(start), speed: -3.0 }.passes(steps);
        }
    }
}

/// Where A passes close to C, the coupler turns many times as fast as the crank.
#[test]
fn kites_of_almost_equal_sides_pass_the_crossing() {
    for (short, long) in [(1.0, 1.1), (1.0, 1.05), (0.69, 0.72), (1.0, 1.02), (1.0, 1.005), (1.02, 1.0), (1.005, 1.0)] {
        for start in [1.0, 0.5, 2.0].into_iter().take(samples(1, 3)) {
            for speed in [-1.0, -3.7, 2.0] {
                for steps in [1, 3, 10, 41, 300] {
                    Kite { short, long, start, speed }.passes(steps);
                }
            }
        }
    }
}
