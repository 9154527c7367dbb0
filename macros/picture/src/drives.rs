//! Drive arrows: curved ones about rotating bodies, straight ones beside translating bodies.

use crate::canvas::{Ink, Layer, Near, Stroke, Subject};
use crate::drawing::{Drawing, directions};
use crate::gears::RIM;
use crate::plane::{Place, place, polar};
use core::f64::consts::{FRAC_PI_2, PI, TAU};

/// The radius of a curved arrow about a hinge.
const RADIUS: f64 = 23.0;

/// Angle of a curved arrow (rad).
const SWEEP: f64 = 1.9;

/// The length of a straight arrow.
const ARROW: f64 = 34.0;

impl Drawing<'_> {
    /// True if the drive is drawn as an arrow.
    pub(crate) fn is_arrow(&self, joint: usize) -> bool {
        self.pushed(joint).is_some() || self.turned(joint).is_some()
    }

    /// Draws all arrows; `wheel` returns the radius of a body's wheel and whether it is an internal gear.
    pub(crate) fn drives(&mut self, wheel: impl Fn(Option<usize>) -> Option<(f64, bool)>) {
        for joint in (0..self.scene.joints.len()).filter(|joint| self.scene.joints[*joint].is_drive) {
            if self.scene.joints[joint].kind == "drive_distance" {
                continue;
            }
            if let Some((along, at)) = self.pushed(joint) {
                self.push(joint, along, at);
            } else if let Some((body, at)) = self.turned(joint) {
                self.turn(joint, at, wheel(body));
            }
        }
    }

    /// Direction of a driven translation and its point of action.
    fn pushed(&self, joint: usize) -> Option<(Place, Place)> {
        let drive = &self.scene.joints[joint];
        let at = drive.point("P").map(|(_, at)| self.view.at(at));
        match drive.kind.as_str() {
            "drive_x" => Some((place(1.0, 0.0), at?)),
            "drive_y" => Some((place(0.0, -1.0), at?)),
            "drive_along" => self.driven_slide(joint),
            _ => None,
        }
    }

    /// The driven body and its centre of rotation.
    fn turned(&self, joint: usize) -> Option<(Option<usize>, Place)> {
        let drive = &self.scene.joints[joint];
        if drive.points().next().is_some() {
            return None;
        }
        let (body, carrier) = match drive.kind.as_str() {
            "drive_relative_angle" => match (drive.body("i")?, drive.body("j")?) {
                (i, None) => (i, None),
                (i, j) => (j, i),
            },
            _ => (drive.arguments.iter().find_map(|(name, _)| drive.body(name))?, None),
        };
        Some((body, self.view.at(self.scene.centre(body, carrier))))
    }

    fn turn(&mut self, joint: usize, at: Place, wheel: Option<(f64, bool)>) {
        let (title, name, rate) = (self.title(joint), self.scene.joints[joint].name.clone(), self.scene.joints[joint].rate);
        // On a large wheel the arrow lies inside the rim; on a small wheel and on an internal gear it lies outside.
        let radius = match wheel {
            Some((radius, true)) => radius + RIM + 8.0,
            Some((radius, false)) if radius < RADIUS + 7.0 => radius + 7.0,
            _ => RADIUS,
        };
        let mut taken = directions(&self.links, self.known, at);
        let arcs = self
            .canvas
            .items
            .iter()
            .filter(|item| matches!(&item.shape, Stroke::Arc(middle, own, ..) if (*middle - at).norm() < 1.0 && *own > radius - 6.0));
        let radius = radius + 9.0 * arcs.count() as f64;
        if let Some(ground) = self.pins.ground_of(at, &taken) {
            taken.extend([ground - 0.5, ground, ground + 0.5]);
        }
        let (from, to) = (freest(&taken), SWEEP / 2.0 * (RADIUS / radius).min(1.0));
        let (first, last) = (from - to, from + to);
        self.canvas.draw(Layer::Arrow, Ink::Line, &title, Stroke::Arc(at, radius, first, last));
        // The arrow head is straight, so its tip lies slightly beyond the end of the arc.
        let lag = 4.0 / radius;
        if rate <= 0.0 {
            self.canvas.head(&title, at + polar(radius, last + lag), polar(1.0, last + FRAC_PI_2));
        }
        if rate >= 0.0 {
            self.canvas.head(&title, at + polar(radius, first - lag), polar(1.0, first - FRAC_PI_2));
        }
        let beside = [-0.6, 0.0, 0.6].map(|part| from + part * to).map(|angle| at + polar(radius, angle));
        self.canvas.wish(Subject::Drive, &name, Near::Segments(vec![(beside[0], beside[1]), (beside[1], beside[2])]));
    }

    fn push(&mut self, joint: usize, along: Place, at: Place) {
        let (title, name, rate) = (self.title(joint), self.scene.joints[joint].name.clone(), self.scene.joints[joint].rate);
        let track = self.tracks.iter().find(|track| (track.held - at).norm() < 1.0 && track.along.cross(along).abs() < 0.1);
        let ahead = if rate < 0.0 { -along } else { along };
        let beside = track.map_or(at + ahead * (9.0 + ARROW / 2.0), |track| track.at - track.side * 19.0);
        let (tail, tip) = (beside - along * (ARROW / 2.0), beside + along * (ARROW / 2.0));
        self.canvas.line(Layer::Arrow, Ink::Line, &title, &[tail + along * 3.0, tip - along * 3.0]);
        if rate >= 0.0 {
            self.canvas.head(&title, tip, along);
        }
        if rate <= 0.0 {
            self.canvas.head(&title, tail, -along);
        }
        self.canvas.wish(Subject::Drive, &name, Near::Segments(vec![(tail, tip)]));
    }
}

/// Middle of the widest gap between directions (rad); upwards and slightly to the right if there are none.
fn freest(taken: &[f64]) -> f64 {
    let candidates = (0..24).map(|step| -PI / 4.0 + TAU * f64::from(step) / 24.0);
    let room = |angle: f64| {
        let distance = |other: &f64| libm::acos(libm::cos(angle - other));
        taken.iter().map(distance).fold(PI, f64::min).min(SWEEP * 0.75)
    };
    candidates.fold((-PI / 4.0, 0.0), |best, angle| if room(angle) > best.1 + 1e-6 { (angle, room(angle)) } else { best }).0
}
