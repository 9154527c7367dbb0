//! The motion laws of the library, and tables with each kind of end, as outputs over time.

use crate::declared;

declared! {
    /// The motion laws from 0 s to 1 s, of a body that stands still.
    Laws (still: Length = 1) {
        body clock { point P = (0, 0); }
        drive there = drive_x(clock.P, still);
        drive aside = drive_y(clock.P, 0);
        drive upright = drive_angle(clock, 0);
        let u = t / 1s;
    } outputs LawsState {
        harmonic = [harmonic(u)];
        cycloidal = [cycloidal(u)];
        polynomial_345 = [polynomial_345(u)];
        polynomial_4567 = [polynomial_4567(u)];
        modified_trapezoidal = [modified_trapezoidal(u)];
        smooth_step = [smooth_step(u)];
        double_harmonic = [double_harmonic(u)];
        double_harmonic_end = [double_harmonic_end(u)];
        half_cycloidal_start = [half_cycloidal_start(u)];
        half_cycloidal_end = [half_cycloidal_end(u)];
        linear = [linear(u)];
        modified_sine = [modified_sine(u)];
    }
}
declared! {
    /// The same law with a rise, a beginning and a duration.
    Rises (rise: Length = 0.03, begin: Time = 0.4, duration: Time = 2.5) {
        body clock { point P = (0, 0); }
        drive lift = drive_x(clock.P, rise * cycloidal((t - begin) / duration));
        drive aside = drive_y(clock.P, rise * modified_trapezoidal((t - begin) / duration));
        drive turn = drive_angle(clock, 1rad * polynomial_345((t - begin) / duration));
    } outputs RisesState {
        lift = [clock.x];
        aside = [clock.y];
        turn = [clock.angle];
    }
}

/// The points of the tables below.
pub const POINTS: [(f64, f64); 6] = [(-0.5, 1.0), (0.0, 1.75), (0.25, -0.5), (1.0, 0.125), (1.125, 2.0), (2.5, 1.0)];

declared! {
    /// One table with each kind of end.
    Tables (still: Length = 1) {
        body clock { point P = (0, 0); }
        drive there = drive_x(clock.P, still);
        drive aside = drive_y(clock.P, 0);
        drive upright = drive_angle(clock, 0);
        let u = t / 1s;
    } outputs TablesState {
        periodic = [table(u, [(-0.5, 1), (0, 1.75), (0.25, -0.5), (1, 0.125), (1.125, 2), (2.5, 1)], periodic)];
        linear = [table(u, [(-0.5, 1), (0, 1.75), (0.25, -0.5), (1, 0.125), (1.125, 2), (2.5, 1)], linear)];
        hold = [table(u, [(-0.5, 1), (0, 1.75), (0.25, -0.5), (1, 0.125), (1.125, 2), (2.5, 1)], hold)];
    }
}

declared! {
    /// Programs of segments over an angle, which repeat, and over a time, which end or repeat.
    Programs (speed: AngularVelocity = 2, base: Length = 0.04, lift: Length = 0.012, up: Angle = 2, pause: Time = 0.125) {
        function square(u: Number) -> Number = u^2 * (3 - 2 * u);
        function turning(psi: Angle) -> Length = segments(psi, base, [
            rise(lift, up, cycloidal), dwell(30deg), fall(lift / 2, 90deg, polynomial_345),
            fall(lift / 2, 330deg - 90deg - up, square),
        ], periodic);
        body clock { point P = (0, 0); }
        drive there = drive_x(clock.P, turning(speed * t));
        drive aside = drive_y(clock.P, segments(t - 1s, 0mm, [
            rise(10mm, 0.25s, half_cycloidal_start), rise(40mm, 0.5s, linear), rise(10mm, 0.25s, half_cycloidal_end), dwell(pause),
            fall(60mm, 0.25s, modified_sine),
        ]));
        drive upright = drive_angle(clock, segments(t, 1, [rise(0.5, 0.25s, harmonic), fall(0.5, 0.25s, cycloidal), dwell(pause)], periodic));
    } outputs ProgramsState {
        turning = [clock.x];
        once = [clock.y];
        repeated = [clock.angle];
    }
}
