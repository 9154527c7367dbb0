//! Disc cams and their followers, with the cam outline computed from the profile function.

use crate::canvas::{Ink, Layer, Near, Stroke, Subject};
use crate::drawing::Drawing;
use crate::placed::{PlacedScene, Sign};
use crate::plane::{Place, Rectangle, polar};
use crate::scene::STEPS;
use core::f64::consts::TAU;

/// Contact geometry of the follower.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Tip {
    Knife,
    /// A roller of this radius (m).
    Roller(f64),
    /// A flat face with this normal.
    Flat(Place),
}

/// A cam with its follower, in m.
#[derive(Clone, Debug)]
pub(crate) struct Cam {
    joint: usize,
    body: Option<usize>,
    pub(crate) middle: Place,
    pub(crate) outline: Vec<Place>,
    /// The outline in the frame of the cam, about its centre.
    shape: Vec<Place>,
    /// Angle of the cam (rad).
    turned: f64,
    /// True if the profile is a Rust function, whose values the compiler does not know.
    is_unknown: bool,
    pub(crate) follower: Option<usize>,
    /// The follower's reference point: knife edge, roller centre or a point of the face.
    pub(crate) at: Place,
    pub(crate) tip: Tip,
}

pub(crate) fn cams(scene: &PlacedScene) -> Vec<Cam> {
    scene.joints.iter().enumerate().filter_map(|(number, joint)| cam(scene, number, joint)).collect()
}

/// Bounding box of the cam outlines.
pub(crate) fn frame(cams: &[Cam]) -> Rectangle {
    Rectangle::around(cams.iter().flat_map(|cam| cam.outline.iter().copied()))
}

fn cam(scene: &PlacedScene, number: usize, joint: &Sign) -> Option<Cam> {
    let (body, middle) = joint.point("O")?;
    let (law, (follower, at), tip) = match joint.kind.as_str() {
        "cam_knife" => ("R", joint.point("F")?, Tip::Knife),
        "cam_roller" => ("R", joint.point("C")?, Tip::Roller(joint.number("roller")?.0)),
        "cam_flat" => ("h", joint.point("F")?, Tip::Flat(joint.axis("n")?.1)),
        _ => return None,
    };
    let turned = body.map_or(0.0, |body| scene.bodies[body].angle);
    let known = joint.function(law);
    let shape = match known {
        Some(values) => outline(values, tip),
        None => (0..STEPS).map(|step| polar((at - middle).norm() - radius(tip), angle(step))).collect(),
    };
    let outline = shape.iter().map(|at| middle + at.turned(turned)).collect();
    Some(Cam { joint: number, body, middle, outline, shape, turned, is_unknown: known.is_none(), follower, at, tip })
}

fn radius(tip: Tip) -> f64 {
    if let Tip::Roller(radius) = tip { radius } else { 0.0 }
}

fn angle(step: usize) -> f64 {
    step as f64 * TAU / STEPS as f64
}

/// Outline of a cam about its centre, from its law sampled over one revolution.
fn outline(values: &[f64], tip: Tip) -> Vec<Place> {
    let slope = |step: usize| {
        let (before, after) = (values[(step + STEPS - 1) % STEPS], values[(step + 1) % STEPS]);
        (after - before) / (2.0 * TAU / STEPS as f64)
    };
    let at = |step: usize| {
        let (value, direction) = (values[step], polar(1.0, angle(step)));
        match tip {
            Tip::Knife => direction * value,
            // The surface is offset from the pitch curve by the roller radius, along the inward normal.
            Tip::Roller(radius) => {
                let pitch = direction * (value + radius);
                let tangent = direction * slope(step) + direction.perp() * (value + radius);
                pitch + tangent.unit().perp() * radius
            }
            // The face is tangent to the cam at distance h from its centre; the contact point is offset by h' along the face.
            Tip::Flat(_) => direction * value + direction.perp() * slope(step),
        }
    };
    (0..STEPS).map(at).collect()
}

impl Drawing<'_> {
    pub(crate) fn cams(&mut self, cams: &[Cam]) {
        for cam in cams {
            self.cam(cam);
        }
    }

    fn cam(&mut self, cam: &Cam) {
        let (title, name) = (self.title(cam.joint), self.scene.joints[cam.joint].name.clone());
        let (at, middle) = (self.view.at(cam.at), self.view.at(cam.middle));
        let outline: Vec<Place> = cam.outline.iter().map(|at| self.view.at(*at)).collect();
        let reach = outline.iter().map(|at| (*at - middle).norm()).fold(0.0, f64::max);
        let number = cam.body.unwrap_or(usize::MAX);
        if cam.is_unknown {
            self.canvas.circle(Layer::Wheel, Ink::Dashed, self.scene.name(cam.body), middle, reach);
        } else {
            let shape = cam.shape.iter().map(|at| self.view.along(*at) * self.view.scale).collect();
            self.canvas.draw(Layer::Wheel, Ink::Wheel(number), self.scene.name(cam.body), Stroke::Rigid(vec![shape], middle, -cam.turned));
        }
        if let Some(body) = cam.body
            && !std::mem::replace(&mut self.links[body].is_shown, true)
            && !self.links[body].has_extent()
        {
            let name = self.scene.bodies[body].name.clone();
            self.canvas.wish(Subject::Body, &name, Near::Area(outline.iter().step_by(6).copied().collect()));
        }
        let follower = cam.follower.unwrap_or(usize::MAX);
        let outward = (at - middle).unit();
        let contact = match cam.tip {
            Tip::Knife => {
                let (back, side) = (at + outward * 13.0, outward.perp() * 5.0);
                self.canvas.area(Layer::Block, Ink::Block(follower), &title, &[at, back + side, back - side]);
                at
            }
            Tip::Roller(radius) => {
                let radius = self.view.length(radius);
                self.canvas.circle(Layer::Block, Ink::Paper, &title, at, radius);
                self.canvas.circle(Layer::Pin, Ink::Paper, &title, at, 2.4);
                at - outward * radius
            }
            Tip::Flat(normal) => {
                let face = self.view.along(normal).perp() * (0.55 * reach).max(16.0);
                self.canvas.line(Layer::Block, Ink::Bar(follower), &title, &[at - face, at + face]);
                at
            }
        };
        self.canvas.wish(Subject::Joint, &name, Near::Point(contact, 8.0));
    }
}
