//! Pictures of mechanisms.

mod diagram;
mod gear;
mod ink;
mod outline;
mod plate;
mod scene;

pub use diagram::{Abscissa, Diagram};
pub use gear::{gear, meshing};
pub use ink::Ink;
pub use outline::rectangle;
pub use plate::Plate;
pub use scene::Scene;

/// A point in the plane, in m.
pub type Place = reuleaux::nalgebra::Vector2<f64>;

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

/// Drawing units per unit of the picture. The SVG backend draws at whole units; this makes them fine enough.
const FINE: i32 = 4;

/// `size` units of the picture, in drawing units.
fn fine(size: f64) -> i32 {
    (size * f64::from(FINE)).round() as i32
}

/// The width of a stroke of `size` units of the picture, in drawing units.
fn stroke(size: f64) -> u32 {
    fine(size).unsigned_abs()
}

/// Result of drawing.
type Fallible = Result<(), Box<dyn std::error::Error>>;

/// A part of the picture, in drawing units from its own corner.
type Area<'a> = plotters::drawing::DrawingArea<plotters::backend::SVGBackend<'a>, plotters::coord::Shift>;
