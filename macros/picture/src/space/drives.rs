//! Drive arrows in space: curved ones about axes of rotation, straight ones beside translating bodies.

use super::drawing::Drawing;
use super::pen::Pen;
use super::placed::Made;
use super::symbols::SIZE;
use super::vector::{UP, Vec3, vec3};
use crate::canvas::{Ink, Layer, Near, Subject};

/// The radius of a curved arrow.
const RADIUS: f64 = 15.0;

/// Half the angle of a curved arrow (rad).
const SWEEP: f64 = 2.25;

/// The length of a straight arrow.
const ARROW: f64 = 34.0;

/// Position of a joint, its axis, and the extent of its symbol along the axis.
pub(crate) type Seat = (Vec3, Vec3, f64);

impl Drawing<'_> {
    /// True if the drive is drawn as an arrow.
    pub(crate) fn is_arrow(&self, number: usize) -> bool {
        self.pushed(number).is_some() || self.turned(number).is_some()
    }

    /// Draws the arrow of a drive.
    pub(crate) fn drive(&mut self, number: usize) {
        if !self.scene.joints[number].is_drive {
            return;
        }
        if let Some((along, at)) = self.pushed(number) {
            self.push(number, along, at);
        } else if let Some((seat, holder)) = self.turned(number) {
            self.turn(number, seat, holder);
        }
    }

    /// Direction of a driven translation, and the centre of the arrow.
    fn pushed(&self, number: usize) -> Option<(Vec3, Vec3)> {
        let drive = &self.scene.joints[number];
        let free = |along: Vec3| {
            let ahead = if drive.rate < 0.0 { -along } else { along };
            Some((along, drive.given.point("P")?.at + ahead * (11.0 + ARROW / 2.0)))
        };
        match drive.kind.as_str() {
            "drive_x" => free(vec3(1.0, 0.0, 0.0)),
            "drive_y" => free(vec3(0.0, 1.0, 0.0)),
            "drive_z" => free(UP),
            _ => {
                let made = drive.given.joints().iter().find(|made| made.kind == "displacement")?;
                let (p, q, a) = (made.given.point("P")?, made.given.point("Q")?, made.given.axis("a")?);
                let own = self.joint_between([p.body, q.body], a.at).and_then(|joint| self.seat(joint));
                let (at, ..) = own.unwrap_or(((p.at + q.at) * 0.5, a.at, 0.0));
                let side = a.at.cross(self.sight.camera.toward).direction()?;
                // Above the guide, or to the right of a vertical guide.
                let height = side.dot(self.sight.camera.up);
                let side = if height < -0.05 || height.abs() <= 0.05 && side.dot(self.sight.camera.right) < 0.0 { -side } else { side };
                Some((a.at, at + side * 16.0))
            }
        }
    }

    /// Axis of a driven rotation, and the joint on it.
    fn turned(&self, number: usize) -> Option<(Seat, Option<usize>)> {
        let made = self.scene.joints[number].given.joints().iter().find(|made| made.kind == "angle")?;
        self.seat_of(made)
    }

    /// Axis of a joint angle, and the joint that has this angle.
    pub(crate) fn seat_of(&self, made: &Made) -> Option<(Seat, Option<usize>)> {
        let (a, b) = (made.given.axis("a")?, made.given.axis("b")?);
        let own =
            self.joint_between([a.body, b.body], a.at).or_else(|| self.joint_of(b.body, a.at)).or_else(|| self.joint_of(a.body, a.at));
        if let Some((at, _, reach)) = own.and_then(|joint| self.seat(joint)) {
            return Some(((at, a.at, reach), own));
        }
        let body = b.body.or(a.body)?;
        let at = self.shapes[body].ends.first().map_or(self.scene.bodies[body].origin, |(at, _)| *at);
        Some(((at, a.at, 0.0), None))
    }

    /// The joint between two bodies with this axis.
    fn joint_between(&self, bodies: [Option<usize>; 2], axis: Vec3) -> Option<usize> {
        self.scene.joint_on(axis, |p, q| [p, q] == bodies || [q, p] == bodies)
    }

    /// The first joint of a body with this axis.
    fn joint_of(&self, body: Option<usize>, axis: Vec3) -> Option<usize> {
        body.and_then(|_| self.scene.joint_on(axis, |p, q| p == body || q == body))
    }

    fn turn(&mut self, number: usize, (at, axis, reach): Seat, holder: Option<usize>) {
        let drive = &self.scene.joints[number];
        let (title, name, rate) = (self.title(drive), drive.name.clone(), drive.rate);
        let reach = self.wheels.reach(at, axis).max(reach);
        // In front of the joint, unless ground or another arrow is there.
        let down = holder.map_or(Vec3::default(), |joint| self.customs.down(joint));
        let side = [axis, -axis].into_iter().min_by(|one, two| self.against(at, *one, down).total_cmp(&self.against(at, *two, down)));
        let side = side.unwrap_or(axis);
        let count = self.arrows.iter().filter(|(known, along)| (*known - at).norm() < 1.0 && along.dot(side) > 0.9).count();
        self.arrows.push((at, side));
        let middle = at + side * (reach + 9.0 + 11.0 * count as f64);
        let (level, _) = axis.frame();
        // Along the line of sight only rounding errors are left, which have no direction.
        let x = Some(self.sight.camera.toward.across(axis)).filter(|x| x.norm() > 1e-9).and_then(Vec3::direction).unwrap_or(level);
        let circle = [x, axis.cross(x)];
        let mut pen = self.pen(&title);
        pen.line(Layer::Arrow, Ink::Line, &Pen::on_circle(middle, circle, RADIUS, -SWEEP, SWEEP));
        let tip = |angle: f64, ahead: f64| {
            let (sine, cosine) = libm::sincos(angle + 0.35 * ahead);
            let (chord_sine, chord_cosine) = libm::sincos(angle);
            let (tip, foot) = (
                middle + (circle[0] * cosine + circle[1] * sine) * RADIUS,
                middle + (circle[0] * chord_cosine + circle[1] * chord_sine) * RADIUS,
            );
            (tip, tip - foot)
        };
        if rate >= 0.0 {
            let (tip, along) = tip(SWEEP, 1.0);
            pen.head(tip, along);
        }
        if rate <= 0.0 {
            let (tip, along) = tip(-SWEEP, -1.0);
            pen.head(tip, along);
        }
        let depth = self.depth_on(at).max(self.sight.depth(middle)) + 1.0;
        self.put(depth, pen);
        let around = Pen::on_circle(middle, circle, RADIUS, -SWEEP, SWEEP);
        let seen: Vec<_> = around.iter().step_by(4).map(|at| self.sight.at(*at)).collect();
        let segments = seen.windows(2).map(|pair| (pair[0], pair[1])).collect();
        self.canvas.wish(Subject::Drive, &name, Near::Segments(segments));
    }

    /// Cost of an arrow on this side of a joint.
    fn against(&self, at: Vec3, side: Vec3, down: Vec3) -> f64 {
        let is_on_ground = down.dot(side) > 0.75;
        let arrows = self.arrows.iter().filter(|(known, along)| (*known - at).norm() < 1.0 && along.dot(side) > 0.9).count();
        let behind = if self.sight.depth(side) < -0.02 { 1.0 } else { 0.0 };
        let is_taken = self.is_taken(at + side * (SIZE / 2.0 + 9.0), side);
        f64::from(u8::from(is_on_ground)) * 3.0 + arrows as f64 * 0.8 + behind + f64::from(u8::from(is_taken)) * 1.5
    }

    fn push(&mut self, number: usize, along: Vec3, at: Vec3) {
        let drive = &self.scene.joints[number];
        let (title, name, rate) = (self.title(drive), drive.name.clone(), drive.rate);
        let (tail, tip) = (at - along * (ARROW / 2.0), at + along * (ARROW / 2.0));
        let mut pen = self.pen(&title);
        pen.line(Layer::Arrow, Ink::Line, &[tail + along * 3.0, tip - along * 3.0]);
        if rate >= 0.0 {
            pen.head(tip, along);
        }
        if rate <= 0.0 {
            pen.head(tail, -along);
        }
        let depth = self.depth_on(at) + 8.0;
        self.put(depth, pen);
        self.wish_beside(&name, tail, tip, Subject::Drive);
    }
}
