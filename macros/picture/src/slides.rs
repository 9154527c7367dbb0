//! Blocks on guides, pins in slots, rods and cylinders.

use crate::canvas::{Ink, Layer, Near, Stroke, Subject};
use crate::drawing::{Drawing, Track};
use crate::habits::Guide;
use crate::pins::{Look, RADIUS, ground};
use crate::placed::Sign;
use crate::plane::{Place, place, polar};
use crate::springs::{drawn, symbol};
use core::f64::consts::PI;

/// Half the size of a block, along its guide and across.
const BLOCK: Place = Place { x: 17.0, y: 10.0 };

/// Half the length of a guide on ground as drawn; the guide itself is unbounded.
const GUIDE: f64 = 40.0;

/// Half the length of a slot.
const SLOT: f64 = 30.0;

/// Distance of a follower's guide from its cam.
const ABOVE_CAM: f64 = 44.0;

impl Drawing<'_> {
    /// Body `j` slides along a line in body `i`: a block on a guide.
    pub(crate) fn slide(&mut self, joint: usize, (i, along): (Option<usize>, Place), start: Place, (j, held): (Option<usize>, Place)) {
        let (title, name) = (self.title(joint), self.scene.joints[joint].name.clone());
        let (along, start, held) = (self.view.along(along), self.view.at(start), self.view.at(held));
        let at = self.beside_cam(j, held, along);
        let (side, [first, last]) = self.guide(joint, (i, start), at, along);
        self.tracks.push(Track { held, at, along, side });
        if let (None, None) = (i, j) {
            return;
        }
        match i {
            None => ground(&mut self.canvas, &title, first - along * GUIDE + side * BLOCK.y, last + along * GUIDE + side * BLOCK.y, side),
            Some(i) => self.extend(i, start, [first, last], along, BLOCK.x + 9.0),
        }
        let corner = |x: f64, y: f64| at + along * (x * BLOCK.x) + side * (y * BLOCK.y);
        let corners = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
        match j {
            // A support on ground leaves room for the bar.
            None => {
                for side in [side, -side] {
                    let edge = at + side * (BLOCK.y - 4.0);
                    ground(&mut self.canvas, &title, edge - along * BLOCK.x, edge + along * BLOCK.x, side);
                }
            }
            Some(j) => {
                if (at - held).norm() > 1.0 {
                    let beyond = at + (at - held).unit() * (BLOCK.x + 9.0);
                    self.links[j].reach(held);
                    self.links[j].reach(beyond);
                }
                let body = self.scene.bodies[j].name.clone();
                self.canvas.area(Layer::Block, Ink::Block(j), &body, &corners);
                if !std::mem::replace(&mut self.links[j].is_shown, true) && !self.links[j].has_extent() {
                    self.canvas.wish(Subject::Body, &body, Near::Area(corners.to_vec()));
                }
            }
        }
        let rail = side * (BLOCK.y + if i.is_none() { 6.0 } else { 0.0 });
        self.canvas.wish(Subject::Joint, &name, Near::Segments(vec![(first + rail - along * GUIDE, last + rail + along * GUIDE)]));
    }

    /// A point of body `j` moves along a line in body `i`: a pin in a slot.
    pub(crate) fn slot(&mut self, joint: usize, (i, along): (Option<usize>, Place), start: Place, (j, held): (Option<usize>, Place)) {
        let (title, name) = (self.title(joint), self.scene.joints[joint].name.clone());
        let (along, start, at) = (self.view.along(along), self.view.at(start), self.view.at(held));
        let (side, [first, last]) = self.guide(joint, (i, start), at, along);
        let (one, two) = (first - along * SLOT, last + along * SLOT);
        let half = RADIUS + 2.4;
        match i {
            None => ground(&mut self.canvas, &title, one + side * half, two + side * half, side),
            Some(i) => self.extend(i, start, [first, last], along, SLOT),
        }
        let turn = along.angle();
        let end = |middle: Place, from: f64| (0..=6).map(move |step| middle + polar(half, turn + from + PI * f64::from(step) / 6.0));
        let outline: Vec<Place> = end(two, -PI / 2.0).chain(end(one, PI / 2.0)).collect();
        self.canvas.area(Layer::Rod, Ink::Paper, &title, &outline);
        self.pins.join(at, Look::Hinge, false, &name, &title);
        self.tracks.push(Track { held: at, at, along, side });
        if let Some(j) = j {
            self.links[j].is_shown = true;
            if !self.links[j].has_extent() {
                let body = self.scene.bodies[j].name.clone();
                self.canvas.wish(Subject::Body, &body, Near::Point(at, 12.0));
            }
        }
    }

    /// Two points keep their distance: a rod.
    pub(crate) fn rod(&mut self, joint: usize, (i, p): (Option<usize>, Place), (j, q): (Option<usize>, Place)) {
        let (title, name) = (self.title(joint), self.scene.joints[joint].name.clone());
        let (p, q) = (self.view.at(p), self.view.at(q));
        self.canvas.line(Layer::Rod, Ink::Line, &title, &[p, q]);
        self.pins.join(p, Look::Hinge, i.is_none(), "", "");
        self.pins.join(q, Look::Hinge, j.is_none(), "", "");
        self.canvas.wish(Subject::Joint, &name, Near::Segments(vec![(p, q)]));
    }

    /// A spring, a damper, or both between two points.
    pub(crate) fn force(&mut self, joint: usize, (i, p): (Option<usize>, Place), (j, q): (Option<usize>, Place)) {
        let (title, name) = (self.title(joint), self.scene.joints[joint].name.clone());
        let ends = |other: &Sign| Some([other.point("P")?, other.point("Q")?]);
        let joints: Vec<_> = self.scene.joints.iter().map(|other| (other.kind.as_str(), ends(other))).collect();
        let symbol_here = drawn(joint, &joints, |one, two| one.0 == two.0 && (self.view.at(one.1) - self.view.at(two.1)).norm() < 1.0);
        let (p, q) = (self.view.at(p), self.view.at(q));
        if let Some(kind) = symbol_here {
            let lines = symbol(kind, |part, across| p + (q - p) * part + (q - p).unit().perp() * across);
            self.canvas.draw(Layer::Rod, Ink::Line, &title, Stroke::Open(lines));
        }
        for (at, body) in [(p, i), (q, j)] {
            self.pins.join(at, Look::Hinge, body.is_none(), "", "");
        }
        self.canvas.wish(Subject::Joint, &name, Near::Segments(vec![(p, q)]));
    }

    /// The distance of two points is driven: a cylinder.
    pub(crate) fn cylinder(&mut self, joint: usize, (i, p): (Option<usize>, Place), (j, q): (Option<usize>, Place)) {
        let (title, name) = (self.title(joint), self.scene.joints[joint].name.clone());
        let (p, q) = (self.view.at(p), self.view.at(q));
        let (way, length) = ((q - p).unit(), (q - p).norm());
        let side = way.perp() * 6.5;
        let (least, stroke) = self.stroke(joint, length);
        let (bottom, top) = (p + way * (0.08 * least), p + way * (0.62 * least));
        self.canvas.line(Layer::Rod, Ink::Line, &title, &[p, q]);
        self.canvas.area(Layer::Block, Ink::Paper, &title, &[bottom + side, top + side, top - side, bottom - side]);
        let piston = p + way * (stroke * least);
        self.canvas.line(Layer::Block, Ink::Line, &title, &[piston + side, piston - side]);
        self.canvas.line(Layer::Block, Ink::Line, &title, &[piston, top]);
        self.pins.join(p, Look::Hinge, i.is_none(), "", "");
        self.pins.join(q, Look::Hinge, j.is_none(), "", "");
        self.canvas.wish(Subject::Drive, &name, Near::Segments(vec![(bottom + side, top + side), (bottom - side, top - side)]));
    }

    /// Length of the barrel (the least length of the cylinder over the motion), and position of the piston as a fraction of that length.
    fn stroke(&mut self, joint: usize, length: f64) -> (f64, f64) {
        let own = Guide::new(length, 0.0);
        self.habits.slide(joint, own);
        match self.known.guide(joint) {
            Some(Guide { low, high, .. }) if low < high => (low, 0.16 + 0.4 * (length - low) / (high - low)),
            _ => (length, 0.42),
        }
    }

    /// Connects two bodies rigidly.
    pub(crate) fn weld(&mut self, joint: usize, (i, p): (Option<usize>, Place), (j, _): (Option<usize>, Place)) {
        let (title, name) = (self.title(joint), self.scene.joints[joint].name.clone());
        let at = self.view.at(p);
        self.pins.join(at, Look::Weld, false, &name, &title);
        if i.is_none() || j.is_none() {
            ground(&mut self.canvas, &title, at + place(-15.0, 5.0), at + place(15.0, 5.0), place(0.0, 1.0));
        }
    }

    /// A condition without a symbol: a dashed line between its points.
    pub(crate) fn condition(&mut self, joint: usize) {
        let (title, name) = (self.title(joint), self.scene.joints[joint].name.clone());
        let points: Vec<Place> = self.scene.joints[joint].points().map(|(_, at)| self.view.at(at)).collect();
        let role = if self.scene.joints[joint].is_drive { Subject::Drive } else { Subject::Joint };
        match points.as_slice() {
            [] => self.canvas.captions.push(title),
            [at] => self.canvas.wish(role, &name, Near::Point(*at, RADIUS + 4.0)),
            several => {
                self.canvas.line(Layer::Rod, Ink::Dashed, &title, several);
                let segments = several.windows(2).map(|pair| (pair[0], pair[1])).collect();
                self.canvas.wish(role, &name, Near::Segments(segments));
            }
        }
    }

    /// The side of a guide on which ground lies, and the extreme positions of the sliding body.
    fn guide(&mut self, joint: usize, (body, start): (Option<usize>, Place), at: Place, along: Place) -> (Place, [Place; 2]) {
        let normal = along.perp();
        let below = if normal.y < 0.0 { -normal } else { normal };
        // Ground stands still, so coordinates along its guides count from the origin of the picture.
        let from = if body.is_none() { Place::default() } else { start };
        let here = (at - from).dot(along);
        let own = Guide::new(here, self.pull(at).dot(below));
        self.habits.slide(joint, own);
        let known = self.known.guide(joint).unwrap_or(own);
        let side = free_side(at, normal, below, if body.is_none() { known.pull() } else { own.pull() });
        (side, [known.low, known.high].map(|end| at + along * (end - here)))
    }

    /// Extends the body by the line from `start` to the ends of the travel, and `beyond` them, unless its outline covers that line
    /// already.
    fn extend(&mut self, body: usize, start: Place, [first, last]: [Place; 2], along: Place, beyond: f64) {
        self.extend_to(body, start, first, along, beyond);
        if last != first {
            self.extend_to(body, start, last, along, beyond);
        }
    }

    fn extend_to(&mut self, body: usize, start: Place, at: Place, along: Place, beyond: f64) {
        let link = &mut self.links[body];
        let ends = link.points.iter().filter(|point| (**point - at).cross(along).abs() < 3.0).map(|point| (*point - at).dot(along));
        let (low, high) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), next| (low.min(next), high.max(next)));
        let (from, side) = ((start - at).dot(along), along * beyond);
        if from.abs() < 1.0 {
            // The guide is centred on the block.
            if high < beyond && -low < beyond {
                link.bars.push((at - side, at + side));
            }
        } else if from < 0.0 && high < beyond {
            link.bars.push((start, at + side));
        } else if from > 0.0 && -low < beyond {
            link.bars.push((start, at - side));
        }
    }

    /// Mean direction in which links and rods leave a place.
    fn pull(&self, at: Place) -> Place {
        let ways = self.links.iter().flat_map(|link| link.directions(at)).map(|angle| polar(1.0, angle));
        let rods = self
            .scene
            .joints
            .iter()
            .filter(|joint| joint.kind.ends_with("distance"))
            .map(|joint| joint.points().map(|(_, end)| self.view.at(end)).collect::<Vec<_>>());
        let rods = rods.filter_map(|ends| match ends[..] {
            [p, q] if (p - at).norm() < 1.0 => Some((q - p).unit()),
            [p, q] if (q - at).norm() < 1.0 => Some((p - q).unit()),
            _ => None,
        });
        ways.chain(rods).fold(Place::default(), |sum, way| sum + way)
    }

    /// Position of a follower's block, outside the cam.
    fn beside_cam(&self, body: Option<usize>, held: Place, along: Place) -> Place {
        let own = self.followers.iter().find(|follower| follower.body == body && (follower.at - held).norm() < 60.0);
        let Some(follower) = own else { return held };
        let way = if (held - follower.cam).dot(along) < 0.0 { -along } else { along };
        let ahead = (follower.at - held).dot(way).max(0.0);
        held + way * (ahead + follower.size + ABOVE_CAM)
    }
}

/// The side of a guide on which ground lies: below, or away from the links.
fn free_side(at: Place, normal: Place, below: Place, pull: f64) -> Place {
    // Ground lies opposite the links that pull on the block.
    if below.y > 0.35 {
        return if pull > 0.1 { -below } else { below };
    }
    if pull.abs() > 0.1 {
        return if pull > 0.0 { -below } else { below };
    }
    // The picture is centred at its origin.
    if (-at).dot(normal) > 0.0 { -normal } else { normal }
}
