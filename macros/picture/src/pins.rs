//! Hinges and their supports on ground.

use crate::canvas::{Canvas, Ink, Layer, Near, Stroke, Subject};
use crate::plane::{Place, place, polar};
use core::f64::consts::{FRAC_PI_2, PI};

/// The radius of a hinge.
pub(crate) const RADIUS: f64 = 4.6;

/// Hinges nearer to each other than this coincide in the picture.
const NEAR: f64 = 1.0;

/// Number of joints that are named at one place.
const MOST_NAMES: usize = 4;

/// Kind of connection at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Look {
    /// Bodies rotate relative to each other.
    Hinge,
    /// Bodies are rigidly connected.
    Weld,
}

/// A place where bodies are connected.
#[derive(Clone, Debug)]
pub(crate) struct Pin {
    pub(crate) at: Place,
    has_hinge: bool,
    has_weld: bool,
    pub(crate) is_on_ground: bool,
    /// Names of the joints with their tooltips.
    names: Vec<(String, String)>,
}

/// All connections.
#[derive(Clone, Debug, Default)]
pub(crate) struct Pins {
    pub(crate) pins: Vec<Pin>,
}

impl Pins {
    /// Connects bodies at a place, with the label `name` and the tooltip `title`.
    pub(crate) fn join(&mut self, at: Place, look: Look, is_on_ground: bool, name: &str, title: &str) {
        let pin = match self.pins.iter().position(|pin| (pin.at - at).norm() < NEAR) {
            Some(known) => &mut self.pins[known],
            None => {
                self.pins.push(Pin { at, has_hinge: false, has_weld: false, is_on_ground: false, names: Vec::new() });
                let last = self.pins.len() - 1;
                &mut self.pins[last]
            }
        };
        pin.has_hinge |= look == Look::Hinge;
        pin.has_weld |= look == Look::Weld;
        pin.is_on_ground |= is_on_ground;
        if !pin.names.iter().any(|(known, _)| known == name) {
            pin.names.push((name.to_owned(), title.to_owned()));
        }
    }

    /// True if there is a joint at this place.
    pub(crate) fn is_at(&self, at: Place) -> bool {
        self.pins.iter().any(|pin| (pin.at - at).norm() < NEAR)
    }

    /// Direction (rad) from a hinge on ground towards its support; `links` are the directions in which links leave the place.
    pub(crate) fn ground_of(&self, at: Place, links: &[f64]) -> Option<f64> {
        self.pins.iter().find(|pin| pin.is_on_ground && (pin.at - at).norm() < NEAR).map(|_| freest(links))
    }

    /// Draws all connections; `links` returns the directions in which links leave a place.
    pub(crate) fn draw(&self, canvas: &mut Canvas, links: impl Fn(Place) -> Vec<f64>) {
        for pin in &self.pins {
            let title =
                pin.names.iter().filter(|(_, title)| !title.is_empty()).map(|(_, title)| title.as_str()).collect::<Vec<_>>().join("; ");
            let names = together(pin.names.iter().map(|(name, _)| name.as_str()).filter(|name| !name.is_empty()));
            if pin.is_on_ground {
                support(canvas, &title, pin.at, freest(&links(pin.at)));
            }
            if pin.has_weld {
                // The weld surrounds a hinge if bodies that are rigidly connected rotate about it together.
                let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| pin.at + place(x, y) * 5.6);
                canvas.area(Layer::Pin, Ink::Solid, &title, &corners);
            }
            if pin.has_hinge {
                let radius = if pin.has_weld { 3.4 } else { RADIUS };
                canvas.circle(Layer::Pin, Ink::Paper, &title, pin.at, radius);
            }
            if !names.is_empty() {
                canvas.wish(Subject::Joint, &names, Near::Point(pin.at, RADIUS + 3.0));
            }
        }
    }
}

/// Joins several names into one label: names that differ only in an index count once, and at most the first few are listed.
pub(crate) fn together<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let mut kinds: Vec<(String, &str, bool)> = Vec::new();
    for name in names {
        let kind: String = name.split('[').map(|part| part.split_once(']').map_or(part, |(_, rest)| rest)).collect();
        match kinds.iter_mut().find(|(known, ..)| *known == kind) {
            Some((_, _, is_array)) => *is_array = true,
            None => kinds.push((kind, name, false)),
        }
    }
    let shown = |(kind, name, is_array): &(String, &str, bool)| match (is_array, name.split_once('[')) {
        (true, Some((stem, _))) => format!("{stem}[…]{}", kind.strip_prefix(stem).unwrap_or_default()),
        _ => (*name).to_owned(),
    };
    let mut shown: Vec<String> = kinds.iter().map(shown).collect();
    if shown.len() > MOST_NAMES {
        shown.truncate(MOST_NAMES);
        shown.push("…".into());
    }
    shown.join(", ")
}

/// Downwards, unless a link goes there; otherwise to a side, or upwards.
fn freest(links: &[f64]) -> f64 {
    let is_free = |angle: &f64| links.iter().all(|link| libm::cos(link - angle) < 0.75);
    [FRAC_PI_2, PI, 0.0, -FRAC_PI_2].into_iter().find(is_free).unwrap_or(FRAC_PI_2)
}

/// A pivot on ground: a triangle on hatched ground in the direction `angle` (rad).
fn support(canvas: &mut Canvas, title: &str, at: Place, angle: f64) {
    let (down, right) = (polar(1.0, angle), polar(1.0, angle - FRAC_PI_2));
    let (left_foot, right_foot) = (at + down * 17.0 - right * 9.0, at + down * 17.0 + right * 9.0);
    canvas.area(Layer::Ground, Ink::Paper, title, &[at, left_foot, right_foot]);
    ground(canvas, title, at + down * 17.0 - right * 15.0, at + down * 17.0 + right * 15.0, down);
}

/// The edge of ground between two places, hatched on the side of `into`.
pub(crate) fn ground(canvas: &mut Canvas, title: &str, a: Place, b: Place, into: Place) {
    let way = (b - a).unit();
    let length = (b - a).norm();
    let strokes = (length / 6.0).floor().max(1.0) as usize;
    let step = length / strokes as f64;
    let stroke = |number: usize| {
        let from = a + way * (step * (number as f64 + 0.9));
        vec![from, from - way * 5.0 + into * 6.0]
    };
    canvas.line(Layer::Ground, Ink::Line, title, &[a, b]);
    canvas.draw(Layer::Ground, Ink::Thin, title, Stroke::Open((0..strokes).map(stroke).collect()));
}
