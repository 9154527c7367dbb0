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
        drive turn = drive_angle(clock, polynomial_345((t - begin) / duration));
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
