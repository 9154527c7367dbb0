//! From scenes to pictures: a single picture, or the frames of a motion in one style.

use crate::canvas::Canvas;
use crate::clearance::clearance;
use crate::drawing::Setting;
use crate::habits::Habits;
use crate::labels::{ALL_NAMED, Placed, labels};
use crate::placed::PlacedScene;
use crate::plane::{Place, Rectangle, place};
use crate::scene::{Scene, Vector};
use crate::space::{self, Sight, vec3};
use crate::springs::KINDS;
use crate::svg::{self, Captions, Scale};
use crate::undrawable::Undrawable;
use crate::view::{Extent, View};

/// In mechanisms with more bodies nothing is named: labels would hide the bodies.
const MOST_NAMED: usize = 60;

/// A drawn mechanism.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    svg: String,
    labels: Vec<Label>,
    names_all: bool,
    is_in_space: bool,
}

/// A label in the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// The text.
    pub text: String,
    /// Least x and y of the box that is kept free for the label, in picture units.
    pub low: [f64; 2],
    /// Largest x and y of the box.
    pub high: [f64; 2],
}

impl Picture {
    /// Inline SVG without a blank line, in the colours of the surrounding page.
    #[must_use]
    pub fn svg(&self) -> &str {
        &self.svg
    }

    /// The picture as an SVG file of its own, on white.
    #[must_use]
    pub fn page(&self) -> String {
        on_white(&self.svg, self.is_in_space)
    }

    /// The labels with their places.
    #[must_use]
    pub fn labels(&self) -> &[Label] {
        &self.labels
    }

    /// True if every item with room for a label has one; in a picture of many bodies the other names appear as tooltips.
    #[must_use]
    pub fn names_all(&self) -> bool {
        self.names_all
    }
}

/// Draws the frames of a motion with one view and one size; ground stands still, and labels keep their places where possible.
///
/// ```
/// use reuleaux_picture::{GROUND, Pose, Scene, frames};
///
/// let pendulum = |angle: f64| {
///     let mut scene = Scene::new("Pendulum");
///     scene.body("bob", Pose::plane(0.0, 0.0, angle));
///     scene.point("bob", [1.0, 0.0]);
///     scene.joint("pivot", "revolute").point("P", GROUND, [0.0, 0.0]).point("Q", "bob", [0.0, 0.0]);
///     scene
/// };
/// let frames = frames(&[pendulum(-2.0), pendulum(-1.5), pendulum(-1.0)])?;
/// assert_eq!(frames.len(), 3);
/// # Ok::<(), reuleaux_picture::Undrawable>(())
/// ```
///
/// # Errors
/// The reason why one of the scenes cannot be drawn.
pub fn frames(scenes: &[Scene]) -> Result<Vec<Picture>, Undrawable> {
    let Some(reel) = Reel::of(scenes, &[])? else { return Ok(Vec::new()) };
    Ok(reel.sheets.iter().map(|sheet| reel.picture(sheet)).collect())
}

/// The [frames](frames()) of a motion as one animated SVG on white, which repeats with `period` (s).
///
/// Programs that do not animate SVG show the first frame.
///
/// # Errors
/// The reason why one of the scenes cannot be drawn.
pub fn animation(scenes: &[Scene], period: f64) -> Result<String, Undrawable> {
    let Some(reel) = Reel::of(scenes, &[])? else { return Err(Undrawable::Empty) };
    let Reel { captions: [title, description], scale, frame, .. } = &reel;
    let period = if period > 0.0 && period.is_finite() { period } else { 1.0 };
    let sheets: Vec<(Canvas, Vec<Placed>)> = reel.sheets.iter().map(|sheet| (sheet.canvas.clone(), sheet.labels.clone())).collect();
    Ok(on_white(&svg::animation(&sheets, scale, *frame, &Captions { title, description }, period), matches!(scale, Scale::Axes(_))))
}

impl Scene {
    /// Draws the scene.
    ///
    /// # Errors
    /// The reason why there is no picture.
    pub fn draw(&self) -> Result<Picture, Undrawable> {
        let reel = Reel::of(std::slice::from_ref(self), &[])?.ok_or(Undrawable::Empty)?;
        reel.sheets.first().map(|sheet| reel.picture(sheet)).ok_or(Undrawable::Empty)
    }

    /// The picture as inline SVG, or a sentence with the reason why there is none.
    #[must_use]
    pub fn svg(&self) -> String {
        match self.draw() {
            Ok(picture) => picture.svg().to_owned(),
            Err(undrawable) => svg::sentence(&self.name, &undrawable.sentence()),
        }
    }

    /// Least distance between parts that a reader has to tell apart (hinges from each other and from the links of other bodies), relative
    /// to the size of the mechanism.
    ///
    /// # Errors
    /// The reason why there is no picture.
    pub fn clearance(&self) -> Result<f64, Undrawable> {
        if self.is_in_space() {
            return space::clearance(self);
        }
        PlacedScene::of(self).map(|scene| clearance(&scene))
    }
}

/// Frames before they are written as SVG.
#[derive(Clone, Debug)]
pub(crate) struct Reel {
    pub(crate) sheets: Vec<Sheet>,
    pub(crate) scale: Scale,
    pub(crate) eye: Eye,
    pub(crate) frame: Rectangle,
    /// Title and description.
    pub(crate) captions: [String; 2],
    names_all: bool,
}

/// One frame.
#[derive(Clone, Debug)]
pub(crate) struct Sheet {
    pub(crate) canvas: Canvas,
    pub(crate) labels: Vec<Placed>,
}

/// Projection into the picture.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Eye {
    Plane(View),
    Space(Sight),
}

impl Eye {
    /// From m to picture units.
    pub(crate) fn at(&self, at: Vector) -> Place {
        match self {
            Eye::Plane(view) => view.at(place(at.x, at.y)),
            Eye::Space(sight) => sight.at(sight.enlarge(vec3(at.x, at.y, at.z.unwrap_or(0.0)))),
        }
    }
}

impl Reel {
    /// Draws scenes with one view, which also contains these points (m); `None` if there is no scene.
    pub(crate) fn of(scenes: &[Scene], places: &[Vector]) -> Result<Option<Reel>, Undrawable> {
        if scenes.iter().any(Scene::is_in_space) {
            return Reel::in_space(scenes, places);
        }
        let placed = scenes.iter().map(PlacedScene::of).collect::<Result<Vec<_>, _>>()?;
        let settings: Vec<Setting> = placed.iter().map(Setting::of).collect();
        let Some(extent) = settings.iter().map(Setting::extent).reduce(Extent::and) else { return Ok(None) };
        if !extent.is_finite() {
            return Err(Undrawable::Nowhere);
        }
        let view = View::of(&extent);
        let mut known = Habits::default();
        if let [_, _, ..] = settings.as_slice() {
            settings.iter().for_each(|setting| known.learn(setting.draw(view, &Habits::default()).habits));
        }
        let canvases = settings.iter().map(|setting| setting.draw(view, &known).canvas).collect();
        let reel = Reel::from(scenes, canvases, Eye::Plane(view), places, |_, _| Scale::Bar(view));
        Ok(reel)
    }

    /// Draws spatial mechanisms.
    fn in_space(scenes: &[Scene], places: &[Vector]) -> Result<Option<Reel>, Undrawable> {
        let mut stage = space::stage(scenes)?;
        let canvases = std::mem::take(&mut stage.canvases);
        Ok(Reel::from(scenes, canvases, Eye::Space(stage.sight), places, |sheets, frame| {
            Scale::Axes(stage.axes(sheets.iter().map(|sheet| (&sheet.canvas, sheet.labels.as_slice())), frame))
        }))
    }

    /// Places the labels.
    fn from(
        scenes: &[Scene],
        canvases: Vec<Canvas>,
        eye: Eye,
        places: &[Vector],
        scale: impl Fn(&[Sheet], Rectangle) -> Scale,
    ) -> Option<Reel> {
        let mut sheets: Vec<Sheet> = Vec::new();
        for (scene, mut canvas) in scenes.iter().zip(canvases) {
            let is_named = |text: &str| is_named(scene.bodies.len(), text);
            canvas.wishes.retain(|wish| is_named(&wish.text));
            canvas.captions.retain(|caption| is_named(caption));
            let before = sheets.last().map_or(&[][..], |before| &before.labels);
            let labels = labels(&canvas, before, scene.bodies.len() > ALL_NAMED);
            sheets.push(Sheet { canvas, labels });
        }
        let frames = sheets.iter().map(|sheet| svg::frame(&sheet.canvas, &sheet.labels));
        let frame = frames.reduce(|all, next| all.with(next.low).with(next.high))?;
        let frame = places.iter().map(|at| eye.at(*at)).filter(|at| at.is_finite()).fold(frame, Rectangle::with);
        let captions = scenes.first().map(captions).unwrap_or_default();
        let names_all = scenes.iter().all(|scene| scene.bodies.len() <= ALL_NAMED);
        let scale = scale(&sheets, frame);
        Some(Reel { sheets, scale, eye, frame, captions, names_all })
    }

    fn picture(&self, sheet: &Sheet) -> Picture {
        let [title, description] = &self.captions;
        let svg = svg::svg(&sheet.canvas, &sheet.labels, &self.scale, self.frame, &Captions { title, description });
        let label = |label: &Placed| {
            let Rectangle { low, high } = label.frame;
            Label { text: label.text.clone(), low: [low.x, low.y], high: [high.x, high.y] }
        };
        Picture {
            svg,
            labels: sheet.labels.iter().map(label).collect(),
            names_all: self.names_all,
            is_in_space: matches!(self.scale, Scale::Axes(_)),
        }
    }
}

fn on_white(svg: &str, is_in_space: bool) -> String {
    // In space the mechanism need not be centred in the picture.
    let (corner, size) = if is_in_space { ("-100%", "300%") } else { ("-50%", "200%") };
    let paper = format!("</style>\n<rect x=\"{corner}\" y=\"{corner}\" width=\"{size}\" height=\"{size}\" fill=\"#fff\"/>");
    svg.replacen("</style>", &paper, 1)
}

fn captions(scene: &Scene) -> [String; 2] {
    let (bodies, drives) = (scene.bodies.len(), scene.joints.iter().filter(|joint| joint.is_drive).count());
    let forces = scene.joints.iter().filter(|joint| KINDS.contains(&joint.kind.as_str())).count();
    let joints = scene.joints.len() - drives - forces;
    let description =
        format!("{}, {}, {}.", counted(bodies, "body", "bodies"), counted(joints, "joint", "joints"), counted(drives, "drive", "drives"));
    [format!("{}, assembled", scene.name), description]
}

fn counted(number: usize, one: &str, many: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { many })
}

/// True if this name is shown in a mechanism with so many bodies.
fn is_named(bodies: usize, text: &str) -> bool {
    bodies <= ALL_NAMED || bodies <= MOST_NAMED && !is_repetition(text)
}

/// True if one of its indices is above 0, or stands for several.
fn is_repetition(name: &str) -> bool {
    name.split('[').skip(1).any(|part| part.starts_with(|digit: char| ('1'..='9').contains(&digit) || digit == '…'))
}
