//! From metres, y upwards, to units of the picture, y downwards.

use super::plane::{Place, Rectangle, place};
use super::scene::Scene;

/// What is drawn fits into this, where nothing would become too small.
const USUAL: Place = Place { x: 440.0, y: 300.0 };

/// What is drawn never becomes larger.
const LARGEST: Place = Place { x: 660.0, y: 460.0 };

/// The shortest link should be this long.
const SHORTEST: f64 = 42.0;

/// A place and a scale.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    middle: Place,
    /// Units of the picture for a metre.
    pub(super) scale: f64,
}

impl View {
    /// So that all of `frame` (m) is seen; `size` (m) is the mechanism's own where the frame is a single place.
    /// `smallest` (m) is to be seen like a link of that length.
    pub(super) fn of(scene: &Scene, frame: Rectangle, smallest: f64, size: f64) -> View {
        let extent = frame.size();
        let fit = |most: Place| (most.x / extent.x).min(most.y / extent.y);
        let shortest = scene.bodies.iter().filter_map(length).fold(smallest, f64::min);
        let wanted = SHORTEST / shortest;
        let (least, most) = (fit(USUAL), fit(LARGEST));
        let scale = if most.is_finite() { wanted.clamp(least, most) } else { 100.0 / size };
        View { middle: frame.middle(), scale: if scale.is_finite() && scale > 0.0 { scale } else { 1.0 } }
    }

    pub(super) fn at(&self, at: Place) -> Place {
        let seen = (at - self.middle) * self.scale;
        place(seen.x, -seen.y)
    }

    /// A direction.
    pub(super) fn along(&self, direction: Place) -> Place {
        place(direction.x, -direction.y)
    }

    pub(super) fn length(&self, length: f64) -> f64 {
        length * self.scale
    }
}

/// The length of a body (m), if it has one.
fn length(body: &super::scene::Figure) -> Option<f64> {
    let (one, two) = super::plane::farthest(&body.points)?;
    Some((two - one).norm()).filter(|length| *length > 0.0)
}
