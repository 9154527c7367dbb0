//! Shapes of bodies besides their hinges, for `view.outline(…)`: corners in m, in the frame of the body.

mod gear;

use std::f64::consts::{PI, TAU};

use reuleaux::nalgebra::{Vector2, Vector3};

use crate::steps;

pub use gear::{differential, gear, meshing};

/// A point in the plane, in m.
pub type Place = Vector2<f64>;

/// The point (`x`, `y`), in m.
#[must_use]
pub fn place(x: f64, y: f64) -> Place {
    Place::new(x, y)
}

/// The point at distance `radius` (m) from the origin in the direction `angle` (rad).
#[must_use]
pub fn polar(radius: f64, angle: f64) -> Place {
    place(radius * angle.cos(), radius * angle.sin())
}

/// A circle of this radius (m) about the origin.
#[must_use]
pub fn round(radius: f64) -> Vec<Place> {
    steps(0.0, TAU, 36).skip(1).map(|angle| polar(radius, angle)).collect()
}

/// A rectangle about `centre` (m), rotated by `angle` (rad), with these sides (m).
#[must_use]
pub fn rectangle(centre: Place, angle: f64, width: f64, height: f64) -> [Place; 4] {
    let (along, across) = (polar(width / 2.0, angle), polar(height / 2.0, angle + PI / 2.0));
    [centre - along - across, centre + along - across, centre + along + across, centre - along + across]
}

/// A circle in space of this radius (m) about `centre` (m), normal to `axis`.
#[must_use]
pub fn ring(centre: &Vector3<f64>, axis: &Vector3<f64>, radius: f64) -> Vec<Vector3<f64>> {
    let other = if axis.x.abs() < 0.6 * axis.norm() { Vector3::x() } else { Vector3::y() };
    let one = axis.cross(&other).normalize();
    let two = axis.cross(&one).normalize();
    steps(0.0, TAU, 30).skip(1).map(|angle| centre + (one * angle.cos() + two * angle.sin()) * radius).collect()
}

/// A flat bar in space from the origin to `end` (m), with `half` (m) of its width.
#[must_use]
pub fn rod(end: Vector3<f64>, half: Vector3<f64>) -> [Vector3<f64>; 4] {
    [-half, half, end + half, end - half]
}
