//! From metres with y upwards to picture units with y downwards.

use crate::cams::{self, Cam};
use crate::placed::{Figure, PlacedScene};
use crate::plane::{Place, Rectangle, place};
use crate::wheels::Wheels;

/// Usual size of the drawing; exceeded only if the shortest link would become too short.
const USUAL: Place = Place { x: 440.0, y: 300.0 };

/// Largest size of the drawing.
const LARGEST: Place = Place { x: 660.0, y: 460.0 };

/// Wanted length of the shortest link.
const SHORTEST: f64 = 42.0;

/// Size of the contents, in m.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extent {
    /// Bounding box of the contents.
    pub(crate) frame: Rectangle,
    /// Length of the shortest body, or of a wheel that should be as large as such a body.
    shortest: f64,
    /// Length of the longest body, used if the frame is a single point.
    size: f64,
}

impl Extent {
    pub(crate) fn of(scene: &PlacedScene, wheels: &Wheels, cams: &[Cam]) -> Extent {
        let mut frame = Rectangle::around(scene.places());
        for other in [wheels.frame(), cams::frame(cams)] {
            if other.low.x <= other.high.x {
                frame = frame.with(other.low).with(other.high);
            }
        }
        let lengths = scene.bodies.iter().filter_map(Figure::length).filter(|length| *length > 0.0);
        Extent { frame, shortest: lengths.fold(wheels.smallest(), f64::min), size: scene.size() }
    }

    /// Extent of both.
    pub(crate) fn and(self, other: Extent) -> Extent {
        let frame = self.frame.with(other.frame.low).with(other.frame.high);
        Extent { frame, shortest: self.shortest.min(other.shortest), size: self.size.max(other.size) }
    }

    pub(crate) fn is_finite(&self) -> bool {
        self.frame.low.is_finite() && self.frame.high.is_finite() && self.frame.size().is_finite()
    }
}

/// Centre and scale.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    middle: Place,
    /// Picture units per metre.
    pub(crate) scale: f64,
}

impl View {
    /// A view that contains the extent.
    pub(crate) fn of(extent: &Extent) -> View {
        let size = extent.frame.size();
        let fit = |most: Place| (most.x / size.x).min(most.y / size.y);
        let wanted = SHORTEST / extent.shortest;
        let (least, most) = (fit(USUAL), fit(LARGEST));
        let scale = if most.is_finite() { wanted.clamp(least, most) } else { 100.0 / extent.size };
        View { middle: extent.frame.middle(), scale: if scale.is_finite() && scale > 0.0 { scale } else { 1.0 } }
    }

    pub(crate) fn at(&self, at: Place) -> Place {
        let seen = (at - self.middle) * self.scale;
        place(seen.x, -seen.y)
    }

    /// A direction in the picture.
    pub(crate) fn along(&self, direction: Place) -> Place {
        place(direction.x, -direction.y)
    }

    pub(crate) fn length(&self, length: f64) -> f64 {
        length * self.scale
    }
}
