//! The orientation of a body at the start, beside the declared one.
//!
//! In: the assembly of a mechanism in space. Out: how far a body is turned away from its declared orientation, and its orientation as a
//! line to type. Not done here: deciding what is far.

use crate::diag::significant;
use crate::numeric::Numeric;
use crate::numeric::orientation::{Quaternion, between};
use crate::quantity::Ambient;

/// A rotation below this has no axis, in rad.
const NONE: f64 = 1e-9;

impl Numeric<'_> {
    /// The angle between the orientation of a body at the start and the declared one, both against the body on the other side of its joint
    /// unless nothing says how that one is turned; `None` if an orientation is not declared.
    pub(super) fn turned_against(&self, start: &[f64], body: usize) -> Option<f64> {
        let Some(from) = self.joined_to(body).filter(|_| !self.system.space.turned.contains(&body)) else {
            return self.turned_away(start, body);
        };
        let relative = |[[real, x, y, z], body]: [Quaternion; 2]| product([real, -x, -y, -z], body);
        let declared = relative([self.declared_orientation(from)?, self.declared_orientation(body)?]);
        let found = relative([self.orientation(start, from)?, self.orientation(start, body)?]);
        Some(between(declared, found))
    }

    /// The orientation to declare for a body in space, as a `turn`, so that the angle of its joint is that of a configuration; `None`
    /// in the plane.
    ///
    /// The start values of angles follow from declared orientations. Where the body on the other side of the joint is declared
    /// elsewhere, this is not the orientation in the configuration.
    pub(super) fn as_turn(&self, q: &[f64], body: usize) -> Option<String> {
        if self.model.ambient == Ambient::Plane {
            return None;
        }
        let found = self.orientation(q, body)?;
        let Some(from) = self.joined_to(body) else { return Some(turn(found)) };
        let Some(declared) = self.declared_orientation(from) else { return Some(turn(found)) };
        let [real, x, y, z] = self.orientation(q, from)?;
        Some(turn(product(declared, product([real, -x, -y, -z], found))))
    }

    /// The body on the other side of the joint that leads to a body; `None` for ground, or if no joint does.
    fn joined_to(&self, body: usize) -> Option<usize> {
        self.system.space.reached.get(body).copied().flatten().and_then(|(_, from)| from)
    }
}

/// The product of two rotations: the second comes first.
fn product([a, b, c, d]: Quaternion, [e, f, g, h]: Quaternion) -> Quaternion {
    [a * e - b * f - c * g - d * h, a * f + b * e + c * h - d * g, a * g - b * h + c * e + d * f, a * h + b * g - c * f + d * e]
}

/// `turn((0, 0, 1), 87deg)`: the largest component of the axis is 1.
fn turn([real, x, y, z]: Quaternion) -> String {
    let half = libm::atan2((x * x + y * y + z * z).sqrt(), real);
    let axis = if half.abs() < NONE { [0.0, 0.0, 1.0] } else { [x, y, z] };
    let largest = axis.into_iter().fold(0.0, |largest: f64, part| if part.abs() > largest.abs() + NONE { part } else { largest });
    let angle = if half > core::f64::consts::FRAC_PI_2 { 2.0 * half - core::f64::consts::TAU } else { 2.0 * half };
    let angle = (angle * largest.signum()).to_degrees().round();
    let [x, y, z] = axis.map(|part| significant((part / largest * 1e4).round() / 1e4));
    format!("turn(({x}, {y}, {z}), {}deg)", significant(angle))
}
