//! From a scene to shapes: each joint by its usual symbol, from the bottom layer to the top.
//!
//! Symbols are conventions (ISO 3952 and the textbooks), not properties of equations; only this crate asks for the name of a constraint.
//! A constraint without a symbol is a dashed line between its points.

use crate::cams::{self, Cam, Tip};
use crate::canvas::{Canvas, Ink, Layer, Near, Stroke, Subject};
use crate::habits::Habits;
use crate::links::DrawnBody;
use crate::pins::{Look, Pins};
use crate::placed::{PlacedArgument, PlacedScene, axis, point};
use crate::plane::{Place, place};
use crate::springs::KINDS;
use crate::view::{Extent, View};
use crate::wheels::Wheels;

/// A guide in the picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Track {
    /// The guided point.
    pub(crate) held: Place,
    /// Centre of the block.
    pub(crate) at: Place,
    pub(crate) along: Place,
    /// Direction from the guide towards ground.
    pub(crate) side: Place,
}

/// A cam's follower, in units of the picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Follower {
    pub(crate) body: Option<usize>,
    pub(crate) at: Place,
    /// Centre of the cam.
    pub(crate) cam: Place,
    /// Distance by which the follower extends beyond its reference point.
    pub(crate) size: f64,
}

/// A drawing in progress.
pub(crate) struct Drawing<'a> {
    pub(crate) scene: &'a PlacedScene,
    pub(crate) view: View,
    pub(crate) canvas: Canvas,
    pub(crate) pins: Pins,
    /// Indexed by body.
    pub(crate) links: Vec<DrawnBody>,
    pub(crate) tracks: Vec<Track>,
    pub(crate) followers: Vec<Follower>,
    /// Habits over the whole motion.
    pub(crate) known: &'a Habits,
    /// Habits of this scene.
    pub(crate) habits: Habits,
}

/// A scene with its wheels and cams.
#[derive(Clone, Debug)]
pub(crate) struct Setting<'a> {
    scene: &'a PlacedScene,
    wheels: Wheels,
    cams: Vec<Cam>,
}

/// A finished canvas with the habits recorded while it was drawn.
#[derive(Clone, Debug)]
pub(crate) struct Drawn {
    pub(crate) canvas: Canvas,
    pub(crate) habits: Habits,
}

impl Setting<'_> {
    pub(crate) fn of(scene: &PlacedScene) -> Setting<'_> {
        Setting { scene, wheels: Wheels::of(scene), cams: cams::cams(scene) }
    }

    /// Size of the scene, for the choice of a view.
    pub(crate) fn extent(&self) -> Extent {
        Extent::of(self.scene, &self.wheels, &self.cams)
    }

    /// Draws the scene in `view`; `known` are the habits of the whole motion.
    pub(crate) fn draw(&self, view: View, known: &Habits) -> Drawn {
        let Setting { scene, wheels, cams } = self;
        let mut drawing = Drawing {
            scene,
            view,
            canvas: Canvas::default(),
            pins: Pins::default(),
            links: scene.bodies.iter().map(|_| DrawnBody::default()).collect(),
            tracks: Vec::new(),
            followers: cams.iter().map(|cam| follower(&view, cam)).collect(),
            known,
            habits: Habits::default(),
        };
        drawing.start();
        drawing.outlines();
        drawing.wheels(wheels);
        drawing.cams(cams);
        for joint in 0..scene.joints.len() {
            drawing.joint(joint, wheels.shows(joint));
        }
        drawing.finish();
        drawing.drives(|body| wheels.largest(body).map(|(radius, is_ring)| (view.length(radius), is_ring)));
        Drawn { canvas: drawing.canvas, habits: drawing.habits }
    }
}

fn follower(view: &View, cam: &Cam) -> Follower {
    let size = if let Tip::Roller(radius) = cam.tip { view.length(radius) } else { 0.0 };
    Follower { body: cam.follower, at: view.at(cam.at), cam: view.at(cam.middle), size }
}

/// Directions (rad) in which links leave a place, in this scene and in the whole motion.
pub(crate) fn directions(links: &[DrawnBody], known: &Habits, at: Place) -> Vec<f64> {
    links.iter().flat_map(|link| link.directions(at)).chain(known.at(at)).collect()
}

impl Drawing<'_> {
    /// Gives bodies their points, in picture units.
    fn start(&mut self) {
        for (link, body) in self.links.iter_mut().zip(&self.scene.bodies) {
            body.points.iter().for_each(|at| link.reach(self.view.at(*at)));
        }
    }

    /// Draws the shapes of bodies.
    fn outlines(&mut self) {
        for (body, corners) in &self.scene.outlines {
            let (origin, angle) =
                body.map_or((Place::default(), 0.0), |body| (self.scene.bodies[body].origin, self.scene.bodies[body].angle));
            let own: Vec<Place> = corners.iter().map(|at| self.view.along(*at) * self.view.scale).collect();
            let (at, number) = (self.view.at(origin), body.unwrap_or(usize::MAX));
            if let Some(body) = body {
                let seen: Vec<Place> = own.iter().step_by(own.len().div_ceil(12).max(1)).map(|corner| at + corner.turned(-angle)).collect();
                if !std::mem::replace(&mut self.links[*body].is_shown, true) && !self.links[*body].has_extent() && !seen.is_empty() {
                    self.canvas.wish(Subject::Body, &self.scene.bodies[*body].name, Near::Area(seen));
                }
            }
            self.canvas.draw(Layer::Wheel, Ink::Wheel(number), self.scene.name(*body), Stroke::Rigid(vec![own], at, -angle));
        }
    }

    /// `o: revolute of ground and crank`; the name alone in a mechanism of very many bodies.
    pub(crate) fn title(&self, joint: usize) -> String {
        let sign = &self.scene.joints[joint];
        if self.scene.bodies.len() > crate::labels::ALL_NAMED {
            return sign.name.clone();
        }
        let body = |seen: &PlacedArgument| match seen {
            PlacedArgument::Point(body, _) | PlacedArgument::Body(body) => Some(*body),
            _ => None,
        };
        let mut bodies: Vec<Option<usize>> = sign.arguments.iter().filter_map(|(_, seen)| body(seen)).collect();
        bodies.extend(sign.bodies.iter().map(|body| Some(*body)));
        let mut names: Vec<&str> = Vec::new();
        for body in bodies {
            let name = self.scene.name(body);
            if !names.contains(&name) {
                names.push(name);
            }
        }
        let kind = if sign.kind.is_empty() { "equation" } else { &sign.kind };
        let names = match names.as_slice() {
            [] => return format!("{}: {kind}", sign.name),
            [rest @ .., last] if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
            all => all.join(""),
        };
        format!("{}: {kind} of {names}", sign.name)
    }

    /// Draws a joint. Arrows of drives are drawn after all other shapes.
    fn joint(&mut self, number: usize, is_drawn: bool) {
        let joint = &self.scene.joints[number];
        let (p, q, u) = (joint.point("P"), joint.point("Q"), joint.axis("u"));
        match (joint.kind.as_str(), p, q) {
            ("revolute", Some(p), Some(q)) => {
                let (title, name) = (self.title(number), joint.name.clone());
                self.pins.join(self.view.at(p.1), Look::Hinge, p.0.is_none() || q.0.is_none(), &name, &title);
            }
            ("weld", Some(p), Some(q)) => self.weld(number, p, q),
            ("translational", Some(p), Some(q)) if u.is_some() => self.slide(number, u.unwrap_or_default(), p.1, q),
            ("point_on_line", Some(p), Some(q)) if u.is_some() => self.slot(number, u.unwrap_or_default(), p.1, q),
            // The slot is parallel to the line through P and passes through Q.
            ("revolute_translational", Some(_), Some(q)) if u.is_some() => self.slot(number, u.unwrap_or_default(), q.1, q),
            ("distance", Some(p), Some(q)) => self.rod(number, p, q),
            (kind, Some(p), Some(q)) if KINDS.contains(&kind) => self.force(number, p, q),
            ("absolute_distance", Some(p), _) => self.rod(number, p, joint.point("C").unwrap_or(p)),
            ("drive_distance", Some(p), Some(q)) => self.cylinder(number, p, q),
            ("absolute_x", Some(p), _) => self.slot(number, (None, place(0.0, 1.0)), p.1, p),
            ("absolute_y", Some(p), _) => self.slot(number, (None, place(1.0, 0.0)), p.1, p),
            _ if is_drawn || joint.kind.starts_with("cam_") && joint.point("O").is_some() => {}
            _ if joint.is_drive && self.is_arrow(number) => {}
            _ => self.condition(number),
        }
    }

    /// Draws links below, hinges above them, and the output points.
    fn finish(&mut self) {
        for (number, link) in self.links.iter_mut().enumerate() {
            let body = &self.scene.bodies[number];
            if link.points.is_empty() && !link.is_shown {
                link.reach(self.view.at(body.origin));
            }
            // A dot under a hinge would be hidden.
            if let ([at], [], false) = (link.points.as_slice(), link.bars.as_slice(), link.is_shown)
                && self.pins.is_at(*at)
            {
                let at = *at;
                link.is_shown = true;
                self.canvas.circle(Layer::Pin, Ink::Of(number), &body.name, at, crate::pins::RADIUS + 3.0);
                self.canvas.wish(Subject::Body, &body.name, Near::Point(at, 10.0));
            }
            link.draw(&mut self.canvas, number, &body.name);
        }
        self.pins.draw(&mut self.canvas, |at| directions(&self.links, self.known, at));
        for pin in self.pins.pins.iter().filter(|pin| pin.is_on_ground) {
            self.habits.reach(pin.at, directions(&self.links, &Habits::default(), pin.at));
        }
        for (name, _, at) in &self.scene.outputs {
            let at = self.view.at(*at);
            let is_taken = |other: Place| (other - at).norm() < 1.0;
            let mut others = self.tracks.iter().map(|track| track.at).chain(self.followers.iter().map(|follower| follower.at));
            if self.pins.is_at(at) || others.any(is_taken) {
                continue;
            }
            let arm = |x: f64, y: f64| vec![at - place(x, y) * 4.0, at + place(x, y) * 4.0];
            self.canvas.draw(Layer::Pin, Ink::Line, name, Stroke::Open(vec![arm(1.0, 1.0), arm(1.0, -1.0)]));
            self.canvas.wish(Subject::Output, name, Near::Point(at, 6.0));
        }
    }

    /// Direction of the axis and the guided point of a driven sliding joint.
    pub(crate) fn driven_slide(&self, joint: usize) -> Option<(Place, Place)> {
        let slide = self.scene.joints[joint]
            .arguments
            .iter()
            .find_map(|(_, seen)| if let PlacedArgument::Joint(slide) = seen { Some(slide) } else { None })?;
        Some((self.view.along(axis(slide, "u")?.1), self.view.at(point(slide, "Q")?.1)))
    }
}
