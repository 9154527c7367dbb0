//! SVG elements of shapes.

use crate::canvas::{DrawnItem, Ink, Stroke};
use crate::plane::{Place, polar};
use core::f64::consts::{PI, TAU};

/// Colours of bodies in turn, with a lightness that contrasts with both white and black.
pub(crate) const COLOURS: [&str; 8] = ["#3f87c9", "#d06f24", "#3d9a50", "#a56cc1", "#1f9c99", "#cf5c68", "#94873a", "#7d7ad0"];

/// An SVG element without its contents.
pub(crate) struct Element {
    pub(crate) tag: &'static str,
    pub(crate) class: String,
    /// Geometry, as attributes by name.
    pub(crate) geometry: Vec<(&'static str, String)>,
}

impl Element {
    pub(crate) fn of(item: &DrawnItem) -> Element {
        let (tag, geometry) = geometry(&item.shape);
        Element { tag, class: class(item.ink), geometry }
    }

    /// All attributes, as text.
    pub(crate) fn attributes(&self) -> String {
        let geometry: String = self.geometry.iter().map(|(name, value)| format!(" {name}=\"{value}\"")).collect();
        format!("class=\"{}\"{geometry}", self.class)
    }
}

fn geometry(shape: &Stroke) -> (&'static str, Vec<(&'static str, String)>) {
    let data = match shape {
        Stroke::Circle(middle, radius) => {
            return ("circle", vec![("cx", number(middle.x)), ("cy", number(middle.y)), ("r", number(*radius))]);
        }
        Stroke::Open(lines) => lines.iter().map(|line| path(line)).collect::<String>(),
        Stroke::Closed(corners) => format!("{}Z", path(corners)),
        Stroke::Arc(middle, radius, from, to) => {
            let end = |angle: f64| *middle + polar(*radius, angle);
            let (large, sweep) = (u8::from((to - from).abs() > PI && (to - from).abs() < TAU), u8::from(to > from));
            let radius = number(*radius);
            format!("M{}A{radius} {radius} 0 {large} {sweep} {}", pair(end(*from)), pair(end(*to)))
        }
        Stroke::Ellipse(middle, major, minor) => {
            let half = format!("A{} 0 1 ", radii(*major, *minor));
            let (one, two) = (pair(*middle + *major), pair(*middle - *major));
            format!("M{one}{half}{two}{half}{one}Z")
        }
        Stroke::Rigid(outlines, at, angle) => {
            let data = outlines.iter().map(|corners| closed(corners)).collect();
            return ("path", vec![("d", data), ("transform", format!("translate({})rotate({})", pair(*at), number(angle * 180.0 / PI)))]);
        }
        Stroke::Tube([from, to], major, minor) => {
            let half = format!("A{} 0 {} ", radii(*major, *minor), u8::from(major.cross(*to - *from) > 0.0));
            let [one, two, three, four] = [*from + *major, *to + *major, *to - *major, *from - *major].map(pair);
            format!("M{one}L{two}{half}{three}L{four}{half}{one}Z")
        }
    };
    ("path", vec![("d", data)])
}

/// Semi-axes and rotation of an ellipse.
fn radii(major: Place, minor: f64) -> String {
    format!("{} {} {}", number(major.norm()), number(minor), number(major.angle() * 180.0 / PI))
}

fn class(ink: Ink) -> String {
    let of = |body: usize| if body == usize::MAX { "g".to_owned() } else { format!("c{}", body % COLOURS.len()) };
    match ink {
        Ink::Thin => "t".into(),
        Ink::Dashed => "d".into(),
        Ink::Line => "l".into(),
        Ink::Solid => "s".into(),
        Ink::Paper => "p".into(),
        Ink::Bar(body) => format!("b {}", of(body)),
        Ink::Plate(body) => format!("q {}", of(body)),
        Ink::Block(body) => format!("k {}", of(body)),
        Ink::Wheel(body) => format!("w {}", of(body)),
        Ink::Of(body) => format!("o {}", of(body)),
        Ink::Axis => "a".into(),
        Ink::Rod => "r".into(),
        Ink::Halo => "h".into(),
        Ink::Fork(body) => format!("f {}", of(body)),
        Ink::Shine => "v".into(),
        Ink::Glass => "e".into(),
    }
}

/// Closed path through points by short steps; they add up without errors, as the points themselves are rounded.
fn closed(corners: &[Place]) -> String {
    let rounded = |at: &Place| [(at.x * 10.0).round(), (at.y * 10.0).round()];
    let steps = corners.windows(2).map(|pair| {
        let ([a, b], [c, d]) = (rounded(&pair[0]), rounded(&pair[1]));
        format!("{} {}", number((c - a) / 10.0), number((d - b) / 10.0))
    });
    let first = corners.first().copied().unwrap_or_default();
    format!("M{}l{}Z", pair(first), steps.collect::<Vec<_>>().join(" "))
}

/// Path through points.
pub(crate) fn path(places: &[Place]) -> String {
    let command = |index: usize| ["M", "L"].get(index).copied().unwrap_or(" ");
    places.iter().enumerate().map(|(index, at)| format!("{}{}", command(index), pair(*at))).collect()
}

pub(crate) fn pair(at: Place) -> String {
    format!("{} {}", number(at.x), number(at.y))
}

/// Rounded to a tenth of a unit, without trailing zeros.
pub(crate) fn number(value: f64) -> String {
    let rounded = (value * 10.0).round() / 10.0;
    // Prints −0 as 0.
    format!("{}", if rounded == 0.0 { 0.0 } else { rounded })
}
