//! Teeth of gears with known numbers of teeth: which wheels have them, at which angle, and their outlines.

use crate::placed::PlacedScene;
use crate::plane::{Place, polar};
use crate::wheels::Wheels;
use core::f64::consts::{PI, TAU};

/// Teeth of a wheel; those of an internal gear are counted by their spaces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Teeth {
    pub(crate) count: f64,
    /// Angle of a tooth in the frame of the body (rad).
    pub(crate) angle: f64,
}

/// Least and largest number of teeth that are drawn.
const DRAWN: core::ops::RangeInclusive<f64> = 5.0..=400.0;

/// Least module (picture units) at which teeth can be distinguished.
pub(crate) const FINEST: f64 = 1.5;

/// Pressure angle of the usual tooth (rad).
const PRESSURE: f64 = PI / 9.0;

impl Wheels {
    /// Gives two meshing wheels their teeth: the space of one where the other has a tooth. Only whole numbers are numbers of teeth.
    pub(crate) fn mesh(&mut self, scene: &PlacedScene, [one, two]: [usize; 2], [a, b]: [f64; 2]) {
        let is_whole = |count: f64| (count - count.round()).abs() < 1e-9 && DRAWN.contains(&count);
        if !(is_whole(a) && is_whole(b)) {
            return;
        }
        let is_known = |wheel: usize| self.wheels[wheel].teeth.is_some();
        let (from, to, counts) = if is_known(two) && !is_known(one) { (two, one, [b, a]) } else { (one, two, [a, b]) };
        let turned = |body: Option<usize>| body.and_then(|body| scene.bodies.get(body)).map_or(0.0, |body| body.angle);
        let first = *self.wheels[from].teeth.get_or_insert(Teeth { count: counts[0], angle: 0.0 });
        let (known, next) = (&self.wheels[from], &self.wheels[to]);
        if next.teeth.is_some() || (first.count - counts[0]).abs() > 0.5 {
            return;
        }
        let (tooth, ratio, pitch) = (turned(known.body) + first.angle, counts[0] / counts[1], TAU / counts[1]);
        let angle = if known.is_ring || next.is_ring {
            // Both centres lie on one side of the contact.
            let side = if known.is_ring { next.middle - known.middle } else { known.middle - next.middle }.angle();
            side + (tooth - side) * ratio
        } else {
            let side = (next.middle - known.middle).angle();
            side + PI - (tooth - side) * ratio - pitch / 2.0
        } - turned(next.body);
        // The next tooth from 0 on; rounding does not decide between two.
        let angle = angle - (angle / pitch + 1e-6).floor() * pitch;
        self.wheels[to].teeth = Some(Teeth { count: counts[1], angle });
    }

    /// A wheel with teeth that touches this internal gear from inside.
    pub(crate) fn inside(&self, ring: usize) -> Option<usize> {
        let ring = &self.wheels[ring];
        self.wheels.iter().position(|wheel| {
            let reach = (wheel.middle - ring.middle).norm() + wheel.radius;
            !wheel.is_ring && wheel.teeth.is_some() && (reach - ring.radius).abs() < 1e-6 * ring.radius
        })
    }
}

/// Outline of a gear about the origin with a tooth in the direction of x; for an internal gear that of its hole, with a space there.
pub(crate) fn outline(count: f64, radius: f64, is_ring: bool) -> Vec<Place> {
    let module = 2.0 * radius / count;
    let (above, below) = if is_ring { (1.2, 1.0) } else { (1.0, 1.2) };
    let (base, tip, root) = (radius * libm::cos(PRESSURE), radius + above * module, radius - below * module);
    let involute = |angle: f64| libm::tan(angle) - angle;
    // Half the angle of a tooth at this radius; the involute begins on the base circle.
    let half = |at: f64| PI / (2.0 * count) + involute(PRESSURE) - involute(libm::acos(base / at.max(base)));
    let flank = [root, tip].map(|at| (at, half(at).max(0.0)));
    let tooth = |number: usize| {
        let axis = TAU * number as f64 / count;
        let (rising, falling) = (flank.into_iter(), flank.into_iter().rev());
        rising.map(move |(at, half)| polar(at, axis - half)).chain(falling.map(move |(at, half)| polar(at, axis + half)))
    };
    (0..count as usize).flat_map(tooth).collect()
}

/// Corners of a circle about the origin, clockwise, so that an outline inside it is a hole.
pub(crate) fn rim(radius: f64) -> Vec<Place> {
    (0..60).map(|step| polar(radius, -TAU * f64::from(step) / 60.0)).collect()
}
