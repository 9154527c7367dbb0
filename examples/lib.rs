//! Shared code of the gallery: its files, shapes of bodies, and a little geometry.
//!
//! An example makes one [`View`] of its states, with the curves of points, the shapes of bodies and the diagrams of quantities beside
//! independent results; [`show`] writes everything that the gallery shows of it, the same bytes on every run.

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use reuleaux::PlanarBody;
use reuleaux::view::View;

mod shapes;

pub use shapes::{Place, differential, gear, meshing, place, polar, rectangle, ring, rod, round};

/// Size of a moving picture in the gallery, in bytes.
const SIZE: usize = 30_000;

/// Writes the pictures of a mechanism: the page with its diagrams beside the running program, the drawing in motion as
/// `gallery/moving/<name>.svg`, and as `gallery/<name>.svg` the figure of one state above others, with the diagrams below it.
///
/// # Errors
/// The reason why the states cannot be shown or a file cannot be written.
pub fn show<S>(name: &str, view: &View<S>, state: usize, others: &[usize]) -> Result<(), Box<dyn Error>> {
    figure(name, view, state, others)?;
    play(name, view)
}

/// Writes a figure only, as `gallery/<name>.svg`.
///
/// # Errors
/// The reason why the states cannot be shown or the file cannot be written.
pub fn figure<S>(name: &str, view: &View<S>, state: usize, others: &[usize]) -> Result<(), Box<dyn Error>> {
    let figure = Path::new(env!("CARGO_MANIFEST_DIR")).join("gallery").join(name).with_extension("svg");
    fs::write(&figure, view.figure(state, others)?)?;
    println!("{}", figure.display());
    Ok(())
}

/// Writes the drawing of one state above others, without diagrams, as `gallery/<name>.svg`.
///
/// # Errors
/// The reason why the states cannot be shown or the file cannot be written.
pub fn still<S>(name: &str, view: &View<S>, state: usize, others: &[usize]) -> Result<(), Box<dyn Error>> {
    let drawing = Path::new(env!("CARGO_MANIFEST_DIR")).join("gallery").join(name).with_extension("svg");
    fs::write(&drawing, view.still(state, others)?)?;
    println!("{}", drawing.display());
    Ok(())
}

/// Writes a moving picture: the page with its plots beside the running program, and the drawing alone as `gallery/moving/<name>.svg`.
///
/// # Errors
/// The reason why the states cannot be shown or a file cannot be written.
pub fn play<S>(name: &str, view: &View<S>) -> Result<(), Box<dyn Error>> {
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

/// Nodes and weights of Gauss-Legendre quadrature from `from` to `to`: exact for polynomials up to the ninth degree.
pub fn gauss(from: f64, to: f64) -> [(f64, f64); 5] {
    let (middle, half) = ((from + to) / 2.0, (to - from) / 2.0);
    let (root, part) = (2.0 * (10.0_f64 / 7.0).sqrt(), 13.0 * 70.0_f64.sqrt());
    let [inner, outer] = [5.0 - root, 5.0 + root].map(|square| square.sqrt() / 3.0);
    let [heavy, light] = [322.0 + part, 322.0 - part].map(|weight| weight / 900.0);
    [(-outer, light), (-inner, heavy), (0.0, 128.0 / 225.0), (inner, heavy), (outer, light)]
        .map(|(at, weight)| (middle + half * at, half * weight))
}
