//! The assembled mechanism as a picture, for its page of documentation.
//!
//! In: a [`Model`] with its sketch, the [`System`] and the [`Assembly`]. Out: a [`Picture`]: inline SVG, and a sentence about it.
//! Bodies are bars and plates, joints the symbols of ISO 3952, drives arrows. Not done here: deciding anything that is solved.
//!
//! ```text
//! Assembly ─pose─▶ Scene (m) ─draw─▶ Canvas (shapes) ─labels─▶ words in their places ─svg─▶ text
//! ```

mod cams;
mod canvas;
mod drawing;
mod drives;
mod eye;
mod gears;
mod labels;
mod links;
mod pins;
mod plane;
mod pose;
mod scene;
mod slides;
mod svg;
mod view;
mod wheels;

use crate::assembly::Assembly;
use crate::model::Model;
use crate::model::sketch::MOST_DRAWN;
use crate::quantity::Ambient;
use crate::system::System;
use plane::Rectangle;

/// In mechanisms with more bodies only the first of an array is named.
const ALL_NAMED: usize = 20;

/// In mechanisms with more bodies names would hide what they name.
const MOST_NAMED: usize = 60;

/// With more joints and drives, or more points, there is no picture: each place would have to be held against every other.
const MOST_PLACES: usize = 1000;

/// A mechanism as it is drawn.
#[derive(Clone, Debug)]
pub struct Picture {
    svg: Option<String>,
    words: String,
    labels: Vec<Label>,
}

/// A name in the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// What it says.
    pub text: String,
    /// The least x and y of the box that is kept free for it, in units of the picture.
    pub low: [f64; 2],
    /// The largest x and y.
    pub high: [f64; 2],
}

impl Picture {
    /// Inline SVG without a blank line, if there is a picture.
    #[must_use]
    pub fn svg(&self) -> Option<&str> {
        self.svg.as_deref()
    }

    /// The same as a file of its own, on white.
    #[must_use]
    pub fn page(&self) -> Option<String> {
        let svg = self.svg.as_ref()?;
        Some(svg.replacen("</style>", "</style>\n<rect x=\"-50%\" y=\"-50%\" width=\"200%\" height=\"200%\" fill=\"#fff\"/>", 1))
    }

    /// What there is to say about the picture, or why there is none.
    #[must_use]
    pub fn words(&self) -> &str {
        &self.words
    }

    /// The names in the picture, where they stand.
    #[must_use]
    pub fn labels(&self) -> &[Label] {
        &self.labels
    }

    fn none(why: String) -> Picture {
        Picture { svg: None, words: why, labels: Vec::new() }
    }
}

/// Draws the mechanism where it is assembled.
pub(crate) fn draw(model: &Model, system: &System, assembly: &Assembly) -> Picture {
    let bodies = model.bodies.len();
    if model.ambient == Ambient::Space {
        return Picture::none("There is no picture of mechanisms in space yet.".into());
    }
    if bodies > MOST_DRAWN {
        return Picture::none(format!("There is no picture: in one of {bodies} bodies nothing could be told apart."));
    }
    let (joints, points) = (model.joints.len(), model.sketch.points.len());
    if let Some((count, what)) = [(joints, "joints"), (points, "points")].into_iter().find(|(count, _)| *count > MOST_PLACES) {
        return Picture::none(format!("There is no picture: in one of {count} {what} nothing could be told apart."));
    }
    if !assembly.is_closed {
        return Picture::none("There is no picture: no assembly was found at the declared defaults.".into());
    }
    let Some((instant, scene)) = pose::pose(model, system, assembly) else {
        return Picture::none("There is no picture: not every place is a number at the declared defaults.".into());
    };
    let size =
        scene.bodies.iter().filter_map(|body| plane::farthest(&body.points)).map(|(one, two)| (two - one).norm()).fold(0.0, f64::max);
    let (mut canvas, view) = drawing::draw(&scene, if size > 0.0 { size } else { 1.0 });
    let is_named = |text: &str| bodies <= ALL_NAMED || bodies <= MOST_NAMED && !is_repetition(text);
    canvas.wishes.retain(|wish| is_named(&wish.text));
    canvas.captions.retain(|caption| is_named(caption));
    let placed = labels::labels(&canvas);
    let joints = model.joints.iter().filter(|joint| !joint.is_drive).count();
    let drives = model.joints.len() - joints;
    let title = format!("{}, assembled", model.name).replace("r#", "");
    let description =
        format!("{}, {}, {}.", counted(bodies, "body", "bodies"), counted(joints, "joint", "joints"), counted(drives, "drive", "drives"));
    let svg = svg::svg(&canvas, &placed, view, &svg::Captions { title: &title, description: &description });
    let labels = placed.into_iter().map(|label| {
        let Rectangle { low, high } = label.frame;
        Label { text: label.text, low: [low.x, low.y], high: [high.x, high.y] }
    });
    Picture { svg: Some(svg), words: words(instant.time, bodies), labels: labels.collect() }
}

fn words(time: f64, bodies: usize) -> String {
    let mut words = if time == 0.0 {
        "Assembled at the declared defaults, at t = 0.".to_owned()
    } else {
        format!("At the declared defaults, at t = {} s: at t = 0 parts lie on each other.", rounded(time))
    };
    if bodies > ALL_NAMED {
        words += " The other names show where the pointer rests.";
    }
    words
}

/// One of its indices is above 0.
fn is_repetition(name: &str) -> bool {
    name.split('[').skip(1).any(|part| part.starts_with(|digit: char| ('1'..='9').contains(&digit)))
}

/// To three digits.
fn rounded(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap_or(value)
}

fn counted(number: usize, one: &str, many: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { many })
}

#[cfg(test)]
mod tests;
