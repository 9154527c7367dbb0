//! The frames of a motion as separate shapes, for programs that write them in formats of their own.

use crate::element::{Element, number};
use crate::picture::{Reel, Sheet};
use crate::plane::Rectangle;
use crate::scene::{Scene, Vector};
use crate::svg;
use crate::undrawable::Undrawable;

/// The frames of a motion as shapes and labels: the content that [`frames`](crate::frames()) writes as SVG.
///
/// ```
/// use reuleaux_picture::{Film, GROUND, Pose, Scene};
///
/// let pendulum = |angle: f64| {
///     let mut scene = Scene::new("Pendulum");
///     scene.body("bob", Pose::plane(0.0, 0.0, angle));
///     scene.point("bob", [1.0, 0.0]);
///     scene.joint("pivot", "revolute").point("P", GROUND, [0.0, 0.0]).point("Q", "bob", [0.0, 0.0]);
///     scene
/// };
/// let film = Film::of(&[pendulum(-2.0), pendulum(-1.5)], &[])?;
/// let bob = |frame: usize| film.marks(frame).into_iter().find(|mark| mark.title == "bob").map(|mark| mark.geometry);
/// assert_ne!(bob(0), bob(1));
/// assert_eq!(bob(2), None);
/// # Ok::<(), reuleaux_picture::Undrawable>(())
/// ```
#[derive(Clone, Debug)]
pub struct Film {
    reel: Reel,
    /// SVG below every frame: captions and scale.
    foot: String,
    /// Bounding box of all frames.
    frame: Rectangle,
}

/// A shape or a label.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// `path`, `circle` or `text`.
    pub tag: &'static str,
    /// Classes in the [style sheet](Film::style).
    pub class: String,
    /// Geometry, as attributes by name. Numbers are in picture units, rounded to a tenth.
    pub geometry: Vec<(&'static str, String)>,
    /// Tooltip of a shape; may be empty.
    pub title: String,
    /// Text of a label; empty for a shape.
    pub text: String,
    /// Corner of the bounding box with the least x and y, in picture units. Marks with disjoint boxes do not hide each other.
    pub low: [f64; 2],
    /// Corner with the largest x and y.
    pub high: [f64; 2],
}

/// Half the width of the widest line, and a small allowance.
const REACH: f64 = 6.5;

impl Film {
    /// Draws scenes with one view, which also contains the points `places` (m, in ground).
    ///
    /// # Errors
    /// The reason why one of the scenes cannot be drawn, or [`Undrawable::Empty`] if there is none.
    pub fn of(scenes: &[Scene], places: &[Vector]) -> Result<Film, Undrawable> {
        let reel = Reel::of(scenes, places)?.ok_or(Undrawable::Empty)?;
        let captions = reel.sheets.first().map_or(&[][..], |sheet| &sheet.canvas.captions);
        let (foot, frame) = svg::foot(captions, &reel.scale, reel.frame);
        Ok(Film { reel, foot, frame })
    }

    /// Number of frames.
    #[must_use]
    pub fn count(&self) -> usize {
        self.reel.sheets.len()
    }

    /// The shapes of a frame from bottom to top, then its labels; empty if there is no such frame.
    #[must_use]
    pub fn marks(&self, frame: usize) -> Vec<Mark> {
        self.reel.sheets.get(frame).map(marks).unwrap_or_default()
    }

    /// Position in the picture, in picture units, of a point in ground (m).
    #[must_use]
    pub fn at(&self, place: impl Into<Vector>) -> [f64; 2] {
        let seen = self.reel.eye.at(place.into());
        [seen.x, seen.y]
    }

    /// Least x and y, width and height of the picture, as an SVG view box.
    #[must_use]
    pub fn frame(&self) -> [f64; 4] {
        let (low, size) = (self.frame.low, self.frame.size());
        [low.x, low.y, size.x, size.y]
    }

    /// SVG below every frame: captions and scale.
    #[must_use]
    pub fn foot(&self) -> &str {
        &self.foot
    }

    /// The style sheet for marks inside an element of class `reuleaux`.
    #[must_use]
    pub fn style(&self) -> String {
        svg::style(self.reel.sheets.iter().any(|sheet| sheet.canvas.is_in_space))
    }

    /// The numbers of bodies, joints and drives, as a sentence.
    #[must_use]
    pub fn description(&self) -> &str {
        &self.reel.captions[1]
    }
}

fn marks(sheet: &Sheet) -> Vec<Mark> {
    let shapes = svg::in_order(&sheet.canvas).into_iter().map(|item| {
        let Element { tag, class, geometry } = Element::of(item);
        let Rectangle { low, high } = item.shape.frame().grown(REACH);
        let (low, high) = ([low.x, low.y], [high.x, high.y]);
        Mark { tag, class, geometry, title: svg::told(item).to_owned(), text: String::new(), low, high }
    });
    let words = sheet.labels.iter().map(|label| {
        let base = svg::baseline(label.frame.middle());
        let class = if svg::is_italic(label) { "i" } else { "" }.to_owned();
        let geometry = vec![("x", number(base.x)), ("y", number(base.y))];
        let Rectangle { low, high } = label.frame;
        let (low, high) = ([low.x, low.y], [high.x, high.y]);
        Mark { tag: "text", class, geometry, title: String::new(), text: label.text.clone(), low, high }
    });
    shapes.chain(words).collect()
}
