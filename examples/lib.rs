//! Drawing for the gallery. In: points in m, as solved by an example. Out: `gallery/<name>.svg`, the same bytes on every run.
//!
//! A [`Plate`] is one picture: a [`Scene`], the mechanism at a few phases with equal scales, and below it [`Diagram`]s with a common
//! abscissa. Each example draws its own mechanism with the few shapes of a textbook: links, pins, pivots, walls.

use std::error::Error;
use std::f64::consts::TAU;
use std::path::Path;
use std::{env, fs};

use reuleaux::nalgebra::Vector3;
use reuleaux::view::View;
use reuleaux::{PlanarBody, SpatialBody};

mod drawing;

pub use drawing::{Abscissa, Diagram, Ink, Place, Plate, Scene, gear, meshing, place, polar, rectangle};

/// Angle of view to the right (rad) of pictures in space.
const SIDE: f64 = 0.6;
/// Angle of view above the horizon (rad).
const HEIGHT: f64 = 0.42;
/// Size of a moving picture in the gallery, in bytes.
const SIZE: usize = 30_000;

/// Writes a moving picture: the page with its plots beside the running program, and the drawing alone as `gallery/moving/<name>.svg`.
///
/// # Errors
/// The reason why the states cannot be shown or a file cannot be written.
pub fn show<S>(name: &str, view: &View<S>) -> Result<(), Box<dyn Error>> {
    let page = env::current_exe()?.with_file_name(name).with_extension("html");
    view.write(&page)?;
    let drawing = Path::new(env!("CARGO_MANIFEST_DIR")).join("gallery/moving").join(name).with_extension("svg");
    fs::write(&drawing, view.animated_svg_within(SIZE)?)?;
    println!("{}\n{}", drawing.display(), page.display());
    Ok(())
}

/// `count` + 1 numbers from `first` to `last` (both included) at equal steps.
pub fn steps(first: f64, last: f64, count: u32) -> impl Iterator<Item = f64> + Clone {
    (0..=count).map(move |i| first + (last - first) * f64::from(i) / f64::from(count))
}

/// Corners of a circle of this radius (m) about the origin.
pub fn round(radius: f64) -> Vec<Place> {
    steps(0.0, TAU, 36).skip(1).map(|angle| polar(radius, angle)).collect()
}

/// Largest |a − b| of the pairs; NaN if any is NaN.
pub fn largest_difference(pairs: impl IntoIterator<Item = (f64, f64)>) -> f64 {
    pairs.into_iter().map(|(a, b)| (a - b).abs()).fold(0.0, |largest: f64, d| if largest.is_nan() || d <= largest { largest } else { d })
}

/// Third corner of a triangle on `p` and `q`, at distance `to_p` (m) from `p` and `to_q` (m) from `q`, to the left of the line from `p`
/// to `q`: a pair of links in closed form. NaN if the links do not reach.
pub fn apex(p: Place, q: Place, to_p: f64, to_q: f64) -> Place {
    let base = (q - p).norm();
    let along = (base * base + to_p * to_p - to_q * to_q) / (2.0 * base);
    let across = (to_p * to_p - along * along).sqrt();
    let unit = (q - p) / base;
    p + unit * along + place(-unit.y, unit.x) * across
}

/// Position in ground of `local` (m, in the body's frame).
pub fn on(body: &PlanarBody<f64>, local: Place) -> Place {
    body.position + turned(local, polar(1.0, body.angle))
}

/// Position of `local` if the body's origin is at `pivot` and its `arm` points to `seen`: all in m, `local` and `arm` in its frame.
pub fn carried(local: Place, pivot: Place, arm: Place, seen: Place) -> Place {
    let direction = turned(seen - pivot, place(arm.x, -arm.y)) / arm.norm_squared();
    pivot + turned(local, direction)
}

/// Product of two vectors as complex numbers: rotates and scales one by the other.
fn turned(a: Place, b: Place) -> Place {
    place(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x)
}

/// Projection of a point in space (m) into the picture: seen from the right in front and from above, z upwards, without perspective.
pub fn seen(at: &Vector3<f64>) -> Place {
    let ((sin, cos), (rise, fall)) = (SIDE.sin_cos(), HEIGHT.sin_cos());
    place(cos * at.x + sin * at.y, rise * (cos * at.y - sin * at.x) + fall * at.z)
}

/// Projection of a circle of this radius (m) about `centre` in the plane normal to `axis`.
pub fn ring(centre: &Vector3<f64>, axis: &Vector3<f64>, radius: f64) -> Vec<Place> {
    let other = if axis.x.abs() < 0.6 * axis.norm() { Vector3::x() } else { Vector3::y() };
    let one = axis.cross(&other).normalize();
    let two = axis.cross(&one).normalize();
    steps(0.0, TAU, 72).map(|angle| seen(&(centre + (one * angle.cos() + two * angle.sin()) * radius))).collect()
}

/// Nodes and weights of Gauss-Legendre quadrature from `from` to `to`: exact for polynomials up to the ninth degree.
pub fn gauss(from: f64, to: f64) -> [(f64, f64); 5] {
    let (middle, half) = ((from + to) / 2.0, (to - from) / 2.0);
    let (root, part) = (2.0 * (10.0_f64 / 7.0).sqrt(), 13.0 * 70.0_f64.sqrt());
    let [inner, outer] = [5.0 - root, 5.0 + root].map(|square| square.sqrt() / 3.0);
    let [heavy, light] = [322.0 + part, 322.0 - part].map(|weight| weight / 900.0);
    [(-outer, light), (-inner, heavy), (0.0, 128.0 / 225.0), (inner, heavy), (outer, light)]
        .map(|(at, weight)| (middle + half * at, half * weight))
}

/// Rim of a bevel gear with its teeth, `back` (m) from the common apex in the frame of its body.
pub fn crown(back: Vector3<f64>, radius: f64, teeth: u32) -> Vec<Vector3<f64>> {
    let other = back.abs().normalize().cross(&Vector3::z());
    let corner = |step: u32| {
        let angle = TAU * f64::from(step) / f64::from(2 * teeth);
        let at = radius * if step.is_multiple_of(2) { 1.07 } else { 0.93 };
        back + (other * angle.cos() + Vector3::z() * angle.sin()) * at
    };
    (0..2 * teeth).map(corner).collect()
}

/// A bevel gear as its pitch cone: the circle at its back, `back` (m) from the common apex in its frame, and lines towards the apex.
pub fn bevel(scene: &mut Scene, ink: Ink, body: &SpatialBody<f64>, back: Vector3<f64>, radius: f64, teeth: u32) {
    let (height, axis) = (body.vector(back).value, back.abs().normalize());
    scene.surface(ink, ring(&height, &body.vector(axis).value, radius));
    let other = axis.cross(&Vector3::z());
    for angle in steps(0.0, TAU * f64::from(teeth - 1) / f64::from(teeth), teeth - 1) {
        let rim = body.point((other * angle.cos() + Vector3::z() * angle.sin()) * radius).value + height;
        scene.line(ink, [seen(&rim), seen(&(rim * 0.7))]);
    }
}
