//! Shapes in drawing order and labels that are not placed yet, in picture units with y downwards.

use crate::plane::{Place, Rectangle, polar};
use core::f64::consts::TAU;

/// Largest number of sides by which an outline is approximated.
const MOST_SIDES: usize = 60;

/// Drawing layers, from bottom to top.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Layer {
    Wheel,
    Ground,
    DrawnBody,
    Rod,
    Block,
    Pin,
    Arrow,
}

/// Stroke and fill style of a shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ink {
    /// A thin line.
    Thin,
    /// A short-dashed line, for a condition without a symbol of its own.
    Dashed,
    /// A line of ordinary width.
    Line,
    /// Filled.
    Solid,
    /// Filled with the colour of the page, with an outline.
    Paper,
    /// A link of this body that is a line.
    Bar(usize),
    /// A link of this body that is an area.
    Plate(usize),
    /// A block of this body: an opaque area.
    Block(usize),
    /// A wheel of this body: a faint area.
    Wheel(usize),
    /// A thin line in the colour of this body.
    Of(usize),
    /// A dash-dotted line: the axis of a joint.
    Axis,
    /// A line of ordinary width on a wider line in the page colour, which separates it from the shapes behind.
    Rod,
    /// A wide line in the page colour, which interrupts the shapes behind a bar that passes in front of them.
    Halo,
    /// A part of this body that is a line, narrower than a bar.
    Fork(usize),
    /// A highlight on the face turned to the light.
    Shine,
    /// A translucent area, through which the shapes behind show faintly.
    Glass,
}

/// A line or an area.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Stroke {
    /// Lines through places.
    Open(Vec<Vec<Place>>),
    /// An area with these corners.
    Closed(Vec<Place>),
    Circle(Place, f64),
    /// Part of a circle: centre, radius, start and end angle (rad, from x towards y).
    Arc(Place, f64, f64, f64),
    /// A circle seen at an angle: centre, semi-major axis as a vector, length of the semi-minor axis.
    Ellipse(Place, Place, f64),
    /// An area fixed in a body: its outlines in the frame of the body, of which those inside others are holes if they turn the other way;
    /// and position and rotation (rad) of the frame.
    Rigid(Vec<Vec<Place>>, Place, f64),
    /// A cylinder: the centres of its ends, and the semi-axes of the ellipse that each end is seen as.
    Tube([Place; 2], Place, f64),
}

/// A shape with its style and its tooltip.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct DrawnItem {
    pub(crate) layer: Layer,
    pub(crate) ink: Ink,
    pub(crate) shape: Stroke,
    /// Tooltip.
    pub(crate) title: String,
}

/// Kind of item that a label names; kinds are placed in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Subject {
    Drive,
    Joint,
    Output,
    Body,
}

/// Region in which a label may be placed.
#[derive(Clone, Debug)]
pub(crate) enum Near {
    /// Beside a point, at least this distance away.
    Point(Place, f64),
    /// Beside one of these segments.
    Segments(Vec<(Place, Place)>),
    /// In the middle of an area with these corners, or beside its sides.
    Area(Vec<Place>),
    /// Inside a circle near its rim, or outside.
    Rim(Place, f64),
}

/// A label that has no place yet.
#[derive(Clone, Debug)]
pub(crate) struct Wish {
    pub(crate) text: String,
    pub(crate) role: Subject,
    pub(crate) near: Near,
}

/// The drawing so far.
#[derive(Clone, Debug, Default)]
pub(crate) struct Canvas {
    pub(crate) items: Vec<DrawnItem>,
    pub(crate) wishes: Vec<Wish>,
    /// Lines below the picture, for items that have no place in it.
    pub(crate) captions: Vec<String>,
    /// In space items are drawn from back to front in their order; in the plane the layers decide.
    pub(crate) is_in_space: bool,
}

impl Canvas {
    /// Adds a shape unless the same one is there already.
    pub(crate) fn draw(&mut self, layer: Layer, ink: Ink, title: &str, shape: Stroke) {
        let item = DrawnItem { layer, ink, shape, title: title.to_owned() };
        if !self.items.contains(&item) {
            self.items.push(item);
        }
    }

    pub(crate) fn line(&mut self, layer: Layer, ink: Ink, title: &str, places: &[Place]) {
        self.draw(layer, ink, title, Stroke::Open(vec![places.to_vec()]));
    }

    pub(crate) fn area(&mut self, layer: Layer, ink: Ink, title: &str, corners: &[Place]) {
        self.draw(layer, ink, title, Stroke::Closed(corners.to_vec()));
    }

    pub(crate) fn circle(&mut self, layer: Layer, ink: Ink, title: &str, middle: Place, radius: f64) {
        self.draw(layer, ink, title, Stroke::Circle(middle, radius));
    }

    pub(crate) fn wish(&mut self, role: Subject, text: &str, near: Near) {
        self.wishes.push(Wish { text: text.to_owned(), role, near });
    }
}

impl Stroke {
    /// Segments of the outline; curves are approximated by polylines.
    pub(crate) fn segments(&self) -> Vec<(Place, Place)> {
        let pairs = |places: &[Place]| places.windows(2).map(|pair| (pair[0], pair[1])).collect::<Vec<_>>();
        match self {
            Stroke::Open(lines) => lines.iter().flat_map(|line| pairs(line)).collect(),
            Stroke::Closed(corners) => {
                let closing = corners.last().zip(corners.first()).map(|(last, first)| (*last, *first));
                pairs(corners).into_iter().chain(closing).collect()
            }
            Stroke::Circle(middle, radius) => pairs(&arc(*middle, *radius, 0.0, TAU)),
            Stroke::Arc(middle, radius, from, to) => pairs(&arc(*middle, *radius, *from, *to)),
            Stroke::Ellipse(middle, major, minor) => pairs(&ellipse(*middle, *major, *minor)),
            Stroke::Rigid(outlines, at, angle) => outlines.iter().flat_map(|corners| sides(corners, *at, *angle)).collect(),
            Stroke::Tube([from, to], major, minor) => {
                let ends = [pairs(&ellipse(*from, *major, *minor)), pairs(&ellipse(*to, *major, *minor))].concat();
                [ends, vec![(*from + *major, *to + *major), (*from - *major, *to - *major)]].concat()
            }
        }
    }

    /// Bounding box of the outline, without the width of the stroke.
    pub(crate) fn frame(&self) -> Rectangle {
        Rectangle::around(self.segments().into_iter().flat_map(|(a, b)| [a, b]))
    }
}

/// Sides of an outline in a frame; of one with many corners, such as a gear, a polygon of fewer.
fn sides(corners: &[Place], at: Place, angle: f64) -> Vec<(Place, Place)> {
    let few: Vec<Place> =
        corners.iter().step_by(corners.len().div_ceil(MOST_SIDES).max(1)).map(|corner| at + corner.turned(angle)).collect();
    few.iter().copied().zip(few.iter().copied().cycle().skip(1)).collect()
}

/// Points on an ellipse.
fn ellipse(middle: Place, major: Place, minor: f64) -> Vec<Place> {
    let minor = major.perp().unit() * minor;
    let at = |step: i32| {
        let (sine, cosine) = libm::sincos(TAU * f64::from(step) / 16.0);
        middle + major * cosine + minor * sine
    };
    (0..=16).map(at).collect()
}

/// Points on a circle.
fn arc(middle: Place, radius: f64, from: f64, to: f64) -> Vec<Place> {
    let steps = ((to - from).abs() / TAU * 24.0).ceil().max(1.0) as usize;
    (0..=steps).map(|step| middle + polar(radius, from + (to - from) * step as f64 / steps as f64)).collect()
}
