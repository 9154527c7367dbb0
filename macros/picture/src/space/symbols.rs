//! Symbols of spatial joints (ISO 3952).

use super::drawing::{Drawing, NEAR};
use super::pen::Pen;
use super::placed::{Of, Sign};
use super::slides::Slide;
use super::vector::{UP, Vec3, vec3};
use crate::canvas::{Ink, Layer, Near, Subject};
use crate::springs::KINDS;
use core::f64::consts::PI;

/// The length of a hinge.
pub(crate) const SIZE: f64 = 28.0;

/// The radius of a hinge.
const RADIUS: f64 = 6.5;

/// Radius of the forks of a universal joint.
const FORK: f64 = 14.0;

/// Half the side of a plate.
pub(super) const PLATE: f64 = 24.0;

/// Height of a hinge above its support on ground.
const HEIGHT: f64 = 22.0;

/// Fill of a block in the colour of its body; ground is grey.
pub(super) fn block(body: Option<usize>) -> Ink {
    Ink::Block(body.unwrap_or(usize::MAX))
}

pub(super) fn fork(body: Option<usize>) -> Ink {
    Ink::Fork(body.unwrap_or(usize::MAX))
}

impl Drawing<'_> {
    /// Symbols that a joint adds to its bodies.
    pub(crate) fn prepare(&mut self, number: usize) {
        let joint = &self.scene.joints[number];
        let points: Vec<Of> = joint.given.points().collect();
        let has_symbol = joint.hinge().is_some()
            || joint.kind == "spherical"
            || joint.kind.ends_with("distance")
            || KINDS.contains(&joint.kind.as_str());
        for body in points.iter().filter_map(|of| of.body).filter(|_| has_symbol) {
            self.shapes[body].is_shown = true;
        }
        match joint.kind.as_str() {
            "universal" => {
                let Some((p, q, a)) = joint.hinge() else { return };
                let Some(b) = joint.given.axis("b") else { return };
                for (of, axis, other) in [(p, a.at, b.at), (q, b.at, a.at)] {
                    let way = self.fork_way(number, of, axis, other);
                    if let Some(body) = of.body {
                        self.shapes[body].end_at(of.at, of.at + way * FORK);
                    }
                }
            }
            "translational" | "cylindrical" | "screw" => {
                let Some((p, q, a)) = joint.hinge() else { return };
                match self.slide(number, p, q, a.at) {
                    Slide::Guide { .. } => {}
                    Slide::Telescope { outer, inner } => {
                        let way = inner.at - outer.at;
                        for (of, to) in [(outer, outer.at + way * 0.2), (inner, outer.at + way * 0.5)] {
                            if let Some(body) = of.body {
                                self.shapes[body].bars.push((of.at, to));
                            }
                        }
                    }
                    Slide::Sleeve { at, inner, .. } => {
                        if let Some(body) = inner.filter(|_| joint.kind == "screw") {
                            let [low, high] = self.spindle(at, if inner == p.body { p.at } else { q.at }, a.at);
                            self.shapes[body].bars.push((low, high));
                        } else if let Some(body) = inner {
                            let (low, high) = self.customs.way(number);
                            let here = (q.at - p.at).dot(a.at);
                            // A bar of the first body stands still while the sleeve of the second moves along it.
                            let (low, high) = if inner == p.body { (low - here, high - here) } else { (here - high, here - low) };
                            self.shapes[body].bars.push((at + a.at * (low - 30.0), at + a.at * (high + 30.0)));
                        }
                    }
                }
            }
            _ => {}
        }
    }

    /// Direction in which the shaft leaves its fork, perpendicular to the arm of the cross in that fork.
    fn fork_way(&self, number: usize, of: Of, axis: Vec3, other: Vec3) -> Vec3 {
        let own = of.body.and_then(|body| self.shapes[body].away(of.at, axis));
        let ground = || {
            let down = self.customs.down(number).across(axis);
            if down.norm() > 0.3 { down.unit() } else { other.across(axis).unit() }
        };
        own.unwrap_or_else(|| if of.body.is_none() { ground() } else { axis.cross(other).unit() })
    }

    /// Draws a joint. Arrows of drives are drawn after all other shapes.
    pub(crate) fn joint(&mut self, number: usize) {
        let scene = self.scene;
        let joint = &scene.joints[number];
        let (p, q) = (joint.given.point("P"), joint.given.point("Q"));
        match (joint.kind.as_str(), joint.hinge(), p, q) {
            ("revolute", Some((p, q, a)), ..) => self.revolute(number, p, q, a.at),
            ("translational" | "cylindrical" | "screw", Some((p, q, a)), ..) => self.sliding(number, p, q, a.at),
            ("universal", Some((p, q, a)), ..) if joint.given.axis("b").is_some() => {
                self.universal(number, p, q, [a.at, joint.given.axis("b").map_or(UP, |of| of.at)]);
            }
            ("planar", Some((p, q, a)), ..) => self.planar(number, p, q, a.at),
            ("point_on_plane", Some((p, q, a)), ..) => self.on_plane(number, p.body, q, a.at),
            ("point_on_line", Some((p, q, a)), ..) => self.on_line(number, p, q, a.at),
            ("weld", Some((p, ..)), ..) => self.weld(number, p),
            ("spherical" | "constant_velocity", _, Some(p), Some(q)) => self.spherical(number, p, q),
            ("distance", _, Some(p), Some(q)) => self.rod(number, p, q),
            (kind, _, Some(p), Some(q)) if KINDS.contains(&kind) => self.force(number, p, q),
            ("drive_distance", _, Some(p), Some(q)) => self.actuator(number, p, q),
            ("absolute_x", _, Some(p), _) => self.on_plane(number, None, p, vec3(1.0, 0.0, 0.0)),
            ("absolute_y", _, Some(p), _) => self.on_plane(number, None, p, vec3(0.0, 1.0, 0.0)),
            ("absolute_z", _, Some(p), _) => self.on_plane(number, None, p, UP),
            _ if self.wheels.shows(number) || joint.is_drive && self.is_arrow(number) => {}
            _ => self.condition(joint),
        }
    }

    fn revolute(&mut self, number: usize, p: Of, q: Of, axis: Vec3) {
        let joint = &self.scene.joints[number];
        let (title, half) = (self.title(joint), axis * (SIZE / 2.0));
        let at = self.hinge_at(p.at, axis);
        if (at - p.at).norm() > NEAR {
            // A shaft leads to the wheel.
            let (body, name) = (q.body.or(p.body), self.title(joint));
            self.bar(&name, Layer::DrawnBody, Ink::Bar(body.unwrap_or(usize::MAX)), body, at, p.at);
        }
        if p.body.is_none() || q.body.is_none() {
            self.bearing(number, &title, at, axis);
        }
        self.centre_line(&title, at - axis * (SIZE / 2.0 + 13.0), at + axis * (SIZE / 2.0 + 13.0));
        let mut pen = self.pen(&title);
        // A barrel of the second body between two of the first, from back to front.
        let mut parts =
            vec![(at - half, at - half * 0.5, p.body), (at - half * 0.5, at + half * 0.5, q.body), (at + half * 0.5, at + half, p.body)];
        if self.sight.depth(axis) < 0.0 {
            parts.reverse();
        }
        let last = parts.len() - 1;
        for (index, (from, to, body)) in parts.into_iter().enumerate() {
            if index == last {
                pen.tube(Layer::Pin, block(body), from, to, RADIUS);
            } else {
                pen.mantle(Layer::Pin, block(body), from, to, RADIUS);
            }
        }
        self.put_on(at, pen);
        self.name(at, &joint.name);
    }

    /// Position of a hinge, moved aside if a wheel would hide it.
    fn hinge_at(&self, at: Vec3, axis: Vec3) -> Vec3 {
        let reach = self.wheels.reach(at, axis);
        if reach > SIZE / 2.0 { at - axis * (reach + SIZE / 2.0 + 5.0) } else { at }
    }

    /// A dash-dotted line along an axis.
    pub(crate) fn centre_line(&mut self, title: &str, from: Vec3, to: Vec3) {
        let mut pen = self.pen(title);
        pen.line(Layer::Ground, Ink::Axis, &[from, to]);
        let depth = self.depth_on((from + to) * 0.5) - 0.3;
        self.put(depth, pen);
    }

    /// The support of a cylinder on ground: a pedestal below it, or a post at its end.
    fn bearing(&mut self, number: usize, title: &str, at: Vec3, axis: Vec3) {
        let down = self.customs.down(number);
        if axis.z.abs() > 0.75 {
            let along = if axis.dot(down) > 0.0 { axis } else { -axis };
            self.foot(title, at + along * (SIZE / 2.0), along, 9.0);
            return;
        }
        let below = down.across(axis).unit();
        let foot = at + below * HEIGHT;
        self.patch(title, foot, below, axis);
        let mut pen = self.pen(title);
        pen.area(Layer::Ground, Ink::Paper, &[at - axis * 7.0, at + axis * 7.0, foot + axis * 12.0, foot - axis * 12.0]);
        self.put(self.sight.depth(at + below * 8.0).min(self.depth_on(at) - 0.2), pen);
    }

    /// A short post to ground.
    pub(super) fn foot(&mut self, title: &str, from: Vec3, along: Vec3, length: f64) {
        let foot = from + along * length;
        self.patch(title, foot, along, along.frame().0);
        let mut pen = self.pen(title);
        pen.mantle(Layer::Ground, Ink::Paper, from, foot, 3.0);
        self.put(self.sight.depth((from + foot) * 0.5), pen);
    }

    /// A hatched patch of ground, facing away from the direction `into`.
    fn patch(&mut self, title: &str, at: Vec3, into: Vec3, along: Vec3) {
        // The patch is horizontal unless the direction is nearly horizontal.
        let into = if into.z.abs() > 0.5 { UP * into.z.signum() } else { into };
        let one = along.across(into).direction().unwrap_or_else(|| into.frame().0);
        let two = into.cross(one);
        let corner = |a: f64, b: f64| at + one * (a * 17.0) + two * (b * 11.0);
        let mut pen = self.pen(title);
        let corners = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
        pen.area(Layer::Ground, Ink::Paper, &corners);
        let stroke = |part: i32| {
            let b = f64::from(part) / 2.0;
            // Slanting strokes, clipped at the edges.
            let (from, to) = ((b - 1.0).max(-1.0), (b + 1.0).min(1.0));
            vec![corner(from, (from - b).clamp(-1.0, 1.0)), corner(to, (to - b).clamp(-1.0, 1.0))]
        };
        pen.lines(Layer::Ground, Ink::Thin, &(-3..=3).map(stroke).collect::<Vec<_>>());
        self.put(self.sight.depth(at) - if self.sight.depth(into) < 0.0 { 6.0 } else { 0.0 }, pen);
    }

    fn universal(&mut self, number: usize, p: Of, q: Of, [a, b]: [Vec3; 2]) {
        let joint = &self.scene.joints[number];
        let (title, at) = (self.title(joint), p.at);
        let ways = [self.fork_way(number, p, a, b), self.fork_way(number, q, b, a)];
        if let Some((_, way)) = [(p, ways[0]), (q, ways[1])].into_iter().find(|(of, _)| of.body.is_none()) {
            self.foot(&title, at + way * FORK, way, 7.0);
        }
        let on = self.depth_on(at);
        let mut forks = [(p.body, a, ways[0]), (q.body, b, ways[1])];
        forks.sort_by(|one, two| self.sight.depth(one.2).total_cmp(&self.sight.depth(two.2)));
        for (rank, (body, arm, way)) in forks.into_iter().enumerate() {
            let mut pen = self.pen(&title);
            let arc = Pen::on_circle(at, [arm, way], FORK, 0.0, PI);
            pen.line(Layer::Pin, fork(body), &arc);
            self.put(on + 0.4 * rank as f64, pen);
        }
        let mut pen = self.pen(&title);
        let arms = [a, b].map(|arm| vec![at - arm * FORK, at + arm * FORK]);
        pen.lines(Layer::Pin, Ink::Rod, &arms);
        arms.iter().flatten().for_each(|end| pen.ball(Ink::Paper, *end, 2.8));
        self.put(on + 0.2, pen);
        self.name(at, &joint.name);
    }

    fn planar(&mut self, number: usize, p: Of, q: Of, axis: Vec3) {
        let joint = &self.scene.joints[number];
        let (title, name) = (self.title(joint), joint.name.clone());
        let (one, two) = axis.frame();
        // The plate of the second body lies on that of the first.
        let at = q.at;
        for (body, offset, half) in [(p.body, -2.5, PLATE), (q.body, 2.5, PLATE * 0.6)] {
            self.plate(&title, body, at + axis * offset, [one * half, two * half]);
        }
        if p.body.is_none() || q.body.is_none() {
            let into = if p.body.is_none() { -axis } else { axis };
            self.foot(&title, at + into * 3.0, into, 12.0);
        }
        self.name(at, &name);
    }

    pub(super) fn plate(&mut self, title: &str, body: Option<usize>, at: Vec3, [one, two]: [Vec3; 2]) {
        let mut pen = self.pen(title);
        let corners = [at + one + two, at + one - two, at - one - two, at - one + two];
        pen.area(Layer::DrawnBody, Ink::Paper, &corners);
        pen.area(Layer::DrawnBody, Ink::Wheel(body.unwrap_or(usize::MAX)), &corners);
        let depth = self.depth_on(at) - 0.4 + self.sight.depth((one.cross(two)).unit()).signum() * 0.01;
        self.put(depth, pen);
    }

    fn weld(&mut self, number: usize, p: Of) {
        let joint = &self.scene.joints[number];
        let title = self.title(joint);
        if joint.bodies.contains(&None) {
            self.foot(&title, p.at, -UP, HEIGHT - 8.0);
        }
        let mut pen = self.pen(&title);
        pen.block(Ink::Solid, p.at, [vec3(5.5, 0.0, 0.0), vec3(0.0, 5.5, 0.0), vec3(0.0, 0.0, 5.5)]);
        self.put_on(p.at, pen);
        self.name(p.at, &joint.name);
    }

    /// A condition without a symbol: a dashed line between its points.
    fn condition(&mut self, joint: &Sign) {
        let title = self.title(joint);
        let points: Vec<Vec3> = joint.given.points().map(|of| of.at).collect();
        let role = if joint.is_drive { Subject::Drive } else { Subject::Joint };
        match points.as_slice() {
            [] => self.canvas.captions.push(title),
            [at] => self.canvas.wish(role, &joint.name, Near::Point(self.sight.at(*at), 9.0)),
            several => {
                let mut pen = self.pen(&title);
                pen.line(Layer::Rod, Ink::Dashed, several);
                self.put(self.sight.depth(Vec3::middle(several)), pen);
                let is_long = several.windows(2).any(|pair| (pair[1] - pair[0]).norm() > NEAR);
                let seen: Vec<_> = several.windows(2).map(|pair| (self.sight.at(pair[0]), self.sight.at(pair[1]))).collect();
                let near = if is_long { Near::Segments(seen) } else { Near::Point(self.sight.at(several[0]), 9.0) };
                self.canvas.wish(role, &joint.name, near);
            }
        }
    }

    pub(crate) fn wish_beside(&mut self, name: &str, from: Vec3, to: Vec3, role: Subject) {
        self.canvas.wish(role, name, Near::Segments(vec![(self.sight.at(from), self.sight.at(to))]));
    }

    /// Position of a joint's symbol, its axis, and the extent of the symbol along the axis.
    pub(crate) fn seat(&self, number: usize) -> Option<(Vec3, Vec3, f64)> {
        let joint = &self.scene.joints[number];
        let (p, q, a) = joint.hinge()?;
        match joint.kind.as_str() {
            "translational" | "cylindrical" | "screw" => Some(match self.slide(number, p, q, a.at) {
                Slide::Guide { at, .. } | Slide::Sleeve { at, .. } => (at, a.at, SIZE / 2.0),
                Slide::Telescope { outer, inner } => (outer.at + (inner.at - outer.at) * 0.35, a.at, (inner.at - outer.at).norm() * 0.21),
            }),
            "universal" => Some((p.at, a.at, FORK)),
            _ => Some((self.hinge_at(p.at, a.at), a.at, SIZE / 2.0)),
        }
    }
}
