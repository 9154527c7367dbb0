//! Spatial mechanisms: a parallel projection from a direction that is chosen for visibility, unless one is asked for.
//!
//! ```text
//! Scene ─placed─▶ Placed (m) ─view─▶ Placed (units of the picture) ─drawing, symbols, slides, balls, wheels, drives─▶ Canvas
//! ```
//!
//! Shapes are drawn from back to front. Labels and SVG are handled as in the plane.

mod balls;
mod customs;
mod drawing;
mod drives;
mod pen;
mod placed;
mod slides;
mod symbols;
mod vector;
mod view;
mod wheels;

#[cfg(test)]
mod tests;

use crate::canvas::Canvas;
use crate::labels::Placed as Word;
use crate::plane::{Place, Rectangle, place};
use crate::scene::Scene;
use crate::svg::Axes;
use crate::undrawable::Undrawable;
pub(crate) use vector::vec3;
pub(crate) use view::Sight;

use customs::Customs;
use placed::Placed;
use view::Camera;
use wheels::Wheels;

/// Usual size of the drawing; exceeded only if the shortest link would become too short.
const USUAL: Place = Place { x: 420.0, y: 330.0 };

/// Largest size of the drawing.
const LARGEST: Place = Place { x: 620.0, y: 500.0 };

/// Wanted length of the shortest link.
const SHORTEST: f64 = 70.0;

/// Canvases in one projection.
pub(crate) struct Stage {
    /// One for each scene.
    pub(crate) canvases: Vec<Canvas>,
    pub(crate) sight: Sight,
}

/// Draws all scenes in one projection.
pub(crate) fn stage(scenes: &[Scene]) -> Result<Stage, Undrawable> {
    let placed = scenes.iter().map(Placed::of).collect::<Result<Vec<_>, _>>()?;
    let camera = camera(scenes, &placed)?;
    let sight = sight(&placed, camera)?;
    let seen: Vec<Placed> = placed.iter().map(|scene| scene.seen(sight.scale, |at| sight.enlarge(at))).collect();
    let customs = Customs::of(&seen);
    let canvases = seen.iter().map(|scene| drawing::draw(scene, &sight, &customs)).collect();
    Ok(Stage { canvases, sight })
}

/// Least projected distance of two distinct points, relative to the size of the mechanism.
pub(crate) fn clearance(scene: &Scene) -> Result<f64, Undrawable> {
    let placed = Placed::of(scene)?;
    let camera = camera(std::slice::from_ref(scene), std::slice::from_ref(&placed))?;
    Ok(view::clearance(&placed, &camera))
}

/// The first direction that is asked for, or a good one.
fn camera(scenes: &[Scene], placed: &[Placed]) -> Result<Camera, Undrawable> {
    match scenes.iter().find_map(|scene| scene.toward) {
        Some([x, y, z]) => Camera::from_direction(vec3(x, y, z)).ok_or(Undrawable::Unseen),
        None => Ok(Camera::best(placed)),
    }
}

/// Projection with room for all scenes.
fn sight(scenes: &[Placed], camera: Camera) -> Result<Sight, Undrawable> {
    let mut frame = Rectangle::empty();
    let (mut near, mut far) = (f64::INFINITY, f64::NEG_INFINITY);
    let mut shortest = f64::INFINITY;
    for scene in scenes {
        frame = scene.places().map(|at| camera.project(at)).fold(frame, Rectangle::with);
        let depths = scene.places().map(|at| at.dot(camera.toward));
        (near, far) = depths.fold((near, far), |(near, far), depth| (near.min(depth), far.max(depth)));
        for wheel in Wheels::of(scene).wheels {
            let around = Rectangle::centred(camera.project(wheel.at), place(2.0, 2.0) * wheel.radius);
            frame = frame.with(around.low).with(around.high);
            shortest = shortest.min(3.0 * wheel.radius);
        }
        let lengths = scene.bodies.iter().filter_map(placed::Solid::bar).map(|(one, two)| (two - one).norm());
        shortest = lengths.filter(|length| *length > 0.0).fold(shortest, f64::min);
    }
    let size = frame.size();
    if !(frame.low.is_finite() && frame.high.is_finite() && size.is_finite()) {
        return Err(Undrawable::Nowhere);
    }
    // A shorter distance between points is an offset, not a link.
    let shortest = shortest.max(0.04 * size.norm());
    // A mechanism that is seen end on is not enlarged without bound.
    let least = 0.05 * (far - near);
    let fit = |most: Place| (most.x / size.x.max(least)).min(most.y / size.y.max(least));
    let (least, most) = (fit(USUAL), fit(LARGEST));
    let scale = if most.is_finite() { (SHORTEST / shortest).clamp(least, most) } else { 100.0 };
    let scale = if scale.is_finite() && scale > 0.0 { scale } else { 1.0 };
    Ok(Sight::new(camera, frame.middle(), scale))
}

impl Stage {
    /// The axes of ground in a corner that is free in all frames, or below the picture.
    pub(crate) fn axes<'a>(&self, sheets: impl Iterator<Item = (&'a Canvas, &'a [Word])> + Clone, frame: Rectangle) -> Axes {
        let camera = &self.sight.camera;
        let seen = [camera.right, camera.up];
        let way = |of: fn(vector::Vec3) -> f64| place(of(seen[0]), -of(seen[1]));
        let mut axes = Axes::new([way(|v| v.x), way(|v| v.y), way(|v| v.z)], self.sight.scale);
        let own = axes.frame();
        let (low, high) = (frame.low - own.low, frame.high - own.high);
        let is_free = |origin: &Place| {
            let taken = Rectangle { low: own.low + *origin, high: own.high + *origin }.grown(5.0);
            sheets.clone().all(|(canvas, words)| {
                let mut segments = canvas.items.iter().flat_map(|item| item.shape.segments());
                !segments.any(|(a, b)| taken.is_crossed(a, b)) && !words.iter().any(|word| word.frame.overlaps(taken))
            })
        };
        let corners = [place(low.x, high.y), place(high.x, high.y), low, place(high.x, low.y)];
        // Candidates that extend beyond the frame.
        let more = corners.into_iter().zip([place(-1.0, 1.0), place(1.0, 1.0), place(-1.0, -1.0), place(1.0, -1.0)]);
        let candidates: Vec<Place> =
            [0.0, 12.0, 24.0, 38.0].into_iter().flat_map(|out| more.clone().map(move |(at, way)| at + way * out)).collect();
        let below = place(low.x, frame.high.y - own.low.y + 6.0);
        axes.origin = candidates.into_iter().find(is_free).unwrap_or(below);
        axes
    }
}
