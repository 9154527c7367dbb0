//! Outputs that contain velocities, and outputs with jerk, in whole states and in slices.

mod change_points;
mod jerk;
mod jerk_in_space;
mod splines;
mod tables;
mod velocities;
mod velocities_in_space;

/// Asserts that two numbers agree to so many parts of the larger one, or of 1.
#[track_caller]
fn near(found: f64, expected: f64, tolerance: f64) {
    let scale = expected.abs().max(1.0);
    assert!((found - expected).abs() <= tolerance * scale, "{found:e} instead of {expected:e}");
}
