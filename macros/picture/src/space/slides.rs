//! Symbols of joints that slide: guides, sleeves, telescopes and screws.

use super::drawing::Drawing;
use super::placed::Of;
use super::symbols::{SIZE, block};
use super::vector::Vec3;
use crate::canvas::{Ink, Layer, Subject};

/// Half the width of a sleeve.
const SLEEVE: f64 = 6.5;

/// Symbol of a sliding joint.
#[derive(Clone, Copy, Debug)]
pub(super) enum Slide {
    /// A body on a guide of ground: the body and its position.
    Guide { mover: Option<usize>, at: Vec3 },
    /// One body telescopes into the other.
    Telescope { outer: Of, inner: Of },
    /// A sleeve on a bar.
    Sleeve { at: Vec3, outer: Option<usize>, inner: Option<usize> },
}

impl Drawing<'_> {
    pub(super) fn slide(&self, number: usize, p: Of, q: Of, axis: Vec3) -> Slide {
        let way = (q.at - p.at).dot(axis);
        match (p.body, q.body) {
            (None, mover) => Slide::Guide { mover, at: p.at + axis * way },
            (mover, None) => Slide::Guide { mover, at: q.at - axis * way },
            (outer, inner) => {
                if self.scene.joints[number].kind != "screw" && way.abs() > 2.6 * SIZE {
                    return Slide::Telescope { outer: p, inner: Of { body: inner, at: p.at + axis * way } };
                }
                // The body that turns in a bearing is the spindle; the other is the nut.
                let is_turned = |body: Option<usize>| {
                    self.scene.joints.iter().any(|other| other.kind == "revolute" && other.given.points().any(|of| of.body == body))
                };
                if self.scene.joints[number].kind == "screw" && is_turned(inner) && !is_turned(outer) {
                    Slide::Sleeve { at: p.at, outer, inner }
                } else {
                    Slide::Sleeve { at: p.at + axis * way, outer: inner, inner: outer }
                }
            }
        }
    }

    pub(super) fn sliding(&mut self, number: usize, p: Of, q: Of, axis: Vec3) {
        let joint = &self.scene.joints[number];
        let (title, name, kind) = (self.title(joint), joint.name.clone(), joint.kind.clone());
        let here = (q.at - p.at).dot(axis);
        let is_round = kind != "translational";
        match self.slide(number, p, q, axis) {
            Slide::Guide { mover, at } => {
                let (low, high) = self.customs.way(number);
                let (low, high) = if p.body.is_none() { (low - here, high - here) } else { (here - high, here - low) };
                let ends = [at + axis * (low - 34.0), at + axis * (high + 34.0)];
                self.rail(number, &title, ends, axis, kind == "screw", None);
                self.sleeve(&title, mover, at, axis, SIZE / 2.0, is_round);
                self.name(at, &name);
            }
            Slide::Telescope { outer, inner } => {
                let way = inner.at - outer.at;
                let (from, to) = (outer.at + way * 0.14, outer.at + way * 0.56);
                self.sleeve(&title, outer.body, (from + to) * 0.5, way.unit(), (to - from).norm() / 2.0, is_round);
                self.wish_beside(&name, from, to, Subject::Joint);
            }
            Slide::Sleeve { at, outer, inner } => {
                if kind == "screw" {
                    let ends = self.spindle(at, if inner == p.body { p.at } else { q.at }, axis);
                    self.rail(number, &title, ends, axis, true, inner);
                }
                self.sleeve(&title, outer, at, axis, SIZE / 2.0, kind == "cylindrical");
                self.name(at, &name);
            }
        }
    }

    /// Ends of a spindle, from its own point to beyond the nut.
    pub(super) fn spindle(&self, nut: Vec3, own: Vec3, axis: Vec3) -> [Vec3; 2] {
        let reach = (own - nut).dot(axis);
        [nut + axis * (reach.min(0.0) - 24.0), nut + axis * (reach.max(0.0) + 24.0)]
    }

    /// A box or a cylinder along an axis.
    fn sleeve(&mut self, title: &str, body: Option<usize>, at: Vec3, axis: Vec3, half: f64, is_round: bool) {
        let mut pen = self.pen(title);
        if is_round {
            pen.tube(Layer::Block, block(body), at - axis * half, at + axis * half, SLEEVE);
        } else {
            let (one, two) = axis.frame();
            pen.block(block(body), at, [axis * half, one * SLEEVE, two * SLEEVE]);
        }
        let depth = self.depth_on(at).max(self.depth_on(at + axis * half)).max(self.depth_on(at - axis * half));
        self.put(depth, pen);
        self.tops.push((at, depth));
    }

    /// A rod that guides a sliding body; posts on ground hold it at its ends.
    pub(super) fn rail(&mut self, number: usize, title: &str, [low, high]: [Vec3; 2], axis: Vec3, is_thread: bool, body: Option<usize>) {
        if is_thread {
            let middle = (low + high) * 0.5;
            for (from, to) in [(low, middle), (middle, high)] {
                let mut pen = self.pen(title);
                pen.tube(Layer::Rod, block(body), from, to, 4.0);
                let count = ((to - from).norm() / 5.0).floor().clamp(0.0, 60.0) as usize;
                let turn = |number: usize| pen.half_turn(from + axis * (2.5 + 5.0 * number as f64), axis, 4.0, 5.0);
                let turns: Vec<_> = (0..count).map(turn).collect();
                pen.lines(Layer::Rod, Ink::Thin, &turns);
                self.put(self.sight.depth((from + to) * 0.5) + 0.2, pen);
            }
        } else {
            self.bar(title, Layer::Rod, Ink::Rod, body, low, high);
        }
        if body.is_none() {
            let down = self.customs.down(number);
            if axis.z.abs() > 0.75 {
                let (end, along) = if axis.dot(down) > 0.0 { (high, axis) } else { (low, -axis) };
                self.foot(title, end, along, 4.0);
            } else {
                for end in [low, high] {
                    self.foot(title, end, down.across(axis).unit(), 12.0);
                }
            }
        }
    }
}
