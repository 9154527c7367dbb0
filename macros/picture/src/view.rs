//! From metres, y upwards, to units of the picture, y downwards.

use crate::cams::{self, Cam};
use crate::placed::{Figure, PlacedScene};
use crate::plane::{Place, Rectangle, place};
use crate::wheels::Wheels;

/// What is drawn fits into this, where nothing would become too small.
const USUAL: Place = Place { x: 440.0, y: 300.0 };

/// What is drawn never becomes larger.
const LARGEST: Place = Place { x: 660.0, y: 460.0 };

/// The shortest link should be this long.
const SHORTEST: f64 = 42.0;

/// How much there is to see, in m.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extent {
    /// What everything covers.
    pub(crate) frame: Rectangle,
    /// The shortest body, or what is to be seen like a link of that length.
    shortest: f64,
    /// The longest body, where the frame is a single place.
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

    /// Of both.
    pub(crate) fn and(self, other: Extent) -> Extent {
        let frame = self.frame.with(other.frame.low).with(other.frame.high);
        Extent { frame, shortest: self.shortest.min(other.shortest), size: self.size.max(other.size) }
    }

    pub(crate) fn is_finite(&self) -> bool {
        self.frame.low.is_finite() && self.frame.high.is_finite() && self.frame.size().is_finite()
    }
}

/// A place and a scale.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    middle: Place,
    /// Units of the picture for a metre.
    pub(crate) scale: f64,
}

impl View {
    /// So that all of an extent is seen.
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

    /// A direction.
    pub(crate) fn along(&self, direction: Place) -> Place {
        place(direction.x, -direction.y)
    }

    pub(crate) fn length(&self, length: f64) -> f64 {
        length * self.scale
    }
}
