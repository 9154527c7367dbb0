//! Symbols with balls: spherical joints, rods, actuators, points on planes and lines.

use super::drawing::Drawing;
use super::placed::{Of, Sign};
use super::symbols::{PLATE, block, fork};
use super::vector::Vec3;
use crate::canvas::{Ink, Layer, Subject};
use crate::springs::{drawn, symbol};
use core::f64::consts::{FRAC_PI_2, PI};

/// The radius of a ball.
const BALL: f64 = 5.6;

impl Drawing<'_> {
    pub(super) fn on_plane(&mut self, number: usize, body: Option<usize>, q: Of, axis: Vec3) {
        let joint = &self.scene.joints[number];
        let (title, name) = (self.title(joint), joint.name.clone());
        let (one, two) = axis.frame();
        self.plate(&title, body, q.at - axis * BALL, [one * PLATE, two * PLATE]);
        if body.is_none() {
            self.foot(&title, q.at - axis * BALL, -axis, 12.0);
        }
        let mut pen = self.pen(&title);
        pen.ball(block(q.body), q.at, BALL);
        self.put_on(q.at, pen);
        self.name(q.at, &name);
    }

    pub(super) fn on_line(&mut self, number: usize, p: Of, q: Of, axis: Vec3) {
        let joint = &self.scene.joints[number];
        let (title, name) = (self.title(joint), joint.name.clone());
        let here = (q.at - p.at).dot(axis);
        let (low, high) = self.customs.way(number);
        let (low, high) = (low.min(0.0) - here, high.max(0.0) - here);
        self.rail(number, &title, [q.at + axis * (low - 24.0), q.at + axis * (high + 24.0)], axis, false, p.body);
        let mut pen = self.pen(&title);
        pen.ball(block(q.body), q.at, BALL + 1.0);
        self.put_on(q.at, pen);
        self.name(q.at, &name);
    }

    /// A ball of the second body in a socket of the first.
    pub(super) fn spherical(&mut self, number: usize, p: Of, q: Of) {
        let joint = &self.scene.joints[number];
        let (title, at) = (self.title(joint), p.at);
        if p.body.is_none() || q.body.is_none() {
            self.foot(&title, at + self.customs.down(number) * (BALL + 2.0), self.customs.down(number), 12.0);
        }
        let (socket, ball) = if p.body.is_none() || q.body.is_some() { (p.body, q.body) } else { (q.body, p.body) };
        let open = self.open_side(at, ball, socket);
        let mut pen = self.pen(&title);
        pen.ball(block(ball), at, BALL);
        pen.arc(fork(socket), at, BALL + 3.4, open + 1.0, open + 2.0 * PI - 1.0);
        self.put_on(at, pen);
        self.name(at, &joint.name);
    }

    /// Direction (rad) in which a link leaves the socket of a joint.
    fn open_side(&self, at: Vec3, ball: Option<usize>, socket: Option<usize>) -> f64 {
        let away = |body: Option<usize>| body.and_then(|body| self.shapes[body].away(at, Vec3::default()));
        let way = away(ball).or_else(|| away(socket).map(|way| -way)).map(|way| self.sight.at(way));
        way.filter(|way| way.norm() > 1e-3).map_or(-FRAC_PI_2, |way| (way.angle() * 1e4).round() / 1e4)
    }

    /// A thin rod with a ball at either end.
    pub(super) fn rod(&mut self, number: usize, p: Of, q: Of) {
        let joint = &self.scene.joints[number];
        let (title, name) = (self.title(joint), joint.name.clone());
        self.bar(&title, Layer::Rod, Ink::Rod, None, p.at, q.at);
        self.balls(number, &title, p, q);
        self.wish_beside(&name, p.at, q.at, Subject::Joint);
    }

    /// A spring, a damper, or both, with a ball at either end.
    pub(super) fn force(&mut self, number: usize, p: Of, q: Of) {
        let joint = &self.scene.joints[number];
        let (title, name) = (self.title(joint), joint.name.clone());
        let (way, camera) = (q.at - p.at, &self.sight.camera);
        let side = self.sight.at(way).unit().perp();
        let side = camera.right * side.x + camera.up * side.y;
        let mut pen = self.pen(&title);
        let ends = |other: &Sign| Some([other.given.point("P")?, other.given.point("Q")?]);
        let joints: Vec<_> = self.scene.joints.iter().map(|other| (other.kind.as_str(), ends(other))).collect();
        if let Some(kind) = drawn(number, &joints, |one, two| one.body == two.body && (one.at - two.at).norm() < 1.0) {
            pen.lines(Layer::Rod, Ink::Line, &symbol(kind, |part, across| p.at + way * part + side * across));
        }
        self.put(self.sight.depth(p.at + way * 0.5), pen);
        self.balls(number, &title, p, q);
        self.wish_beside(&name, p.at, q.at, Subject::Joint);
    }

    /// A cylinder with its rod, and a ball at either end.
    pub(super) fn actuator(&mut self, number: usize, p: Of, q: Of) {
        let joint = &self.scene.joints[number];
        let (title, name) = (self.title(joint), joint.name.clone());
        let way = q.at - p.at;
        self.bar(&title, Layer::Rod, Ink::Rod, None, p.at, q.at);
        let mut pen = self.pen(&title);
        let (from, to) = (p.at + way * 0.14, p.at + way * 0.56);
        pen.tube(Layer::Block, Ink::Paper, from, to, 5.5);
        let quarters = [0.25, 0.75].map(|part| self.sight.depth(p.at + way * part));
        let depth = quarters[0].max(quarters[1]) + 0.5;
        self.put(depth, pen);
        self.balls(number, &title, p, q);
        self.wish_beside(&name, from, to, Subject::Drive);
    }

    fn balls(&mut self, number: usize, title: &str, p: Of, q: Of) {
        for of in [p, q] {
            if of.body.is_none() {
                self.foot(title, of.at, self.customs.down(number), 12.0);
            }
            let mut pen = self.pen(title);
            pen.ball(Ink::Paper, of.at, 4.2);
            self.put_on(of.at, pen);
        }
    }
}
