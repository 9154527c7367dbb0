//! The frames of a motion taken apart, for programs that show them by other means than one text for each.

use crate::element::{Element, number};
use crate::picture::{Reel, Sheet};
use crate::plane::Rectangle;
use crate::scene::{Scene, Vector};
use crate::svg;
use crate::undrawable::Undrawable;

/// The frames of a motion as shapes and words: what [`frames`](crate::frames()) writes, before it is written.
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
    /// What stands below every frame, as SVG.
    foot: String,
    /// What all of it covers.
    frame: Rectangle,
}

/// A shape or a word.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// `path`, `circle` or `text`.
    pub tag: &'static str,
    /// Its classes in the [style sheet](Film::style).
    pub class: String,
    /// Where it is: attributes by name. Numbers are in units of the picture, to a tenth.
    pub geometry: Vec<(&'static str, String)>,
    /// What the pointer is told that rests on a shape; may be empty.
    pub title: String,
    /// What a word says.
    pub text: String,
    /// The least x and y of a box around it, in units of the picture. Marks whose boxes are apart do not hide each other.
    pub low: [f64; 2],
    /// The largest x and y.
    pub high: [f64; 2],
}

/// Half of the widest line, and a little more.
const REACH: f64 = 6.5;

impl Film {
    /// Draws scenes with one view, in which `places` (m, in ground) are seen as well.
    ///
    /// # Errors
    /// Why one of them cannot be drawn, or [`Undrawable::Empty`] where there is none.
    pub fn of(scenes: &[Scene], places: &[Vector]) -> Result<Film, Undrawable> {
        let reel = Reel::of(scenes, places)?.ok_or(Undrawable::Empty)?;
        let captions = reel.sheets.first().map_or(&[][..], |sheet| &sheet.canvas.captions);
        let (foot, frame) = svg::foot(captions, &reel.scale, reel.frame);
        Ok(Film { reel, foot, frame })
    }

    /// How many frames there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.reel.sheets.len()
    }

    /// Shapes from below to above, and then words; nothing where there is no such frame.
    #[must_use]
    pub fn marks(&self, frame: usize) -> Vec<Mark> {
        self.reel.sheets.get(frame).map(marks).unwrap_or_default()
    }

    /// Where a place (m, in ground) is seen, in units of the picture.
    #[must_use]
    pub fn at(&self, place: impl Into<Vector>) -> [f64; 2] {
        let seen = self.reel.eye.at(place.into());
        [seen.x, seen.y]
    }

    /// The least x and y of the picture, and its width and height: a view box.
    #[must_use]
    pub fn frame(&self) -> [f64; 4] {
        let (low, size) = (self.frame.low, self.frame.size());
        [low.x, low.y, size.x, size.y]
    }

    /// What stands below every frame, such as the scale, as SVG.
    #[must_use]
    pub fn foot(&self) -> &str {
        &self.foot
    }

    /// The style sheet, for marks inside an element of class `reuleaux`.
    #[must_use]
    pub fn style(&self) -> String {
        svg::style(self.reel.sheets.iter().any(|sheet| sheet.canvas.is_in_space))
    }

    /// How many bodies, joints and drives there are, as a sentence.
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
