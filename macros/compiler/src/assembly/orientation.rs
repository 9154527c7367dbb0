//! The orientation of a body at the start, beside the declared one.
//!
//! In: the assembly of a mechanism in space. Out: how far a body is turned away from its declared orientation, and its orientation as a
//! line to type. Not done here: deciding what is far.

use crate::diag::significant;
use crate::expr::{Expr, Values, evaluate};
use crate::numeric::Numeric;
use crate::quantity::{Ambient, Role};

/// A unit quaternion, the real part first.
type Quaternion = [f64; 4];

/// A rotation below this has no axis, in rad.
const NONE: f64 = 1e-9;

impl Numeric<'_> {
    /// The angle between the orientation of a body at the start and the declared one; `None` if no orientation is declared.
    pub(super) fn turned_away(&self, start: &[f64], body: usize) -> Option<f64> {
        let (declared, found) = (self.declared_orientation(body)?, self.orientation(start, body)?);
        Some(between(declared, found))
    }

    /// The same, against the body on the other side of its joint, or ground; `None` if one of the two orientations is not declared.
    pub(super) fn turned_against(&self, start: &[f64], body: usize) -> Option<f64> {
        let Some(from) = self.joined_to(body) else { return self.turned_away(start, body) };
        let relative = |[[real, x, y, z], body]: [Quaternion; 2]| product([real, -x, -y, -z], body);
        let declared = relative([self.declared_orientation(from)?, self.declared_orientation(body)?]);
        let found = relative([self.orientation(start, from)?, self.orientation(start, body)?]);
        Some(between(declared, found))
    }

    /// The orientation to declare for a body in space, as a `turn`, so that the angle of its joint is that of a configuration; `None`
    /// in the plane.
    ///
    /// The start values of angles follow from declared orientations. Where the body on the other side of the joint is declared
    /// elsewhere, or not at all, this is not the orientation in the configuration.
    pub(super) fn as_turn(&self, q: &[f64], body: usize) -> Option<String> {
        if self.model.ambient == Ambient::Plane {
            return None;
        }
        let found = self.orientation(q, body)?;
        let Some(from) = self.joined_to(body) else { return Some(turn(found)) };
        if self.system.driven.contains(&from) {
            return Some(turn(found));
        }
        let [real, x, y, z] = self.orientation(q, from)?;
        let relative = product([real, -x, -y, -z], found);
        Some(turn(product(self.declared_orientation(from).unwrap_or([1.0, 0.0, 0.0, 0.0]), relative)))
    }

    /// The body on the other side of the joint that leads to a body; `None` for ground, or if no joint does.
    fn joined_to(&self, body: usize) -> Option<usize> {
        self.system.reached.get(body).copied().flatten().and_then(|(_, from)| from)
    }

    fn declared_orientation(&self, body: usize) -> Option<Quaternion> {
        let declared = self.model.bodies[body].coordinates.iter().filter(|one| matches!(one.role, Role::Quaternion(_)));
        let declared: Vec<Expr> = declared.map(|one| one.start).collect::<Option<_>>()?;
        evaluate(&self.system.arena, &declared, &self.known).try_into().ok()
    }

    fn orientation(&self, q: &[f64], body: usize) -> Option<Quaternion> {
        quaternion(&evaluate(&self.system.arena, &self.system.cosines(body), &Values { coordinates: q, ..self.known }))
    }
}

/// The angle of the rotation that leads from one orientation to another.
fn between(one: Quaternion, other: Quaternion) -> f64 {
    let cosine: f64 = one.iter().zip(other).map(|(one, other)| one * other).sum();
    2.0 * libm::acos(cosine.abs().min(1.0))
}

/// The product of two rotations: the second comes first.
fn product([a, b, c, d]: Quaternion, [e, f, g, h]: Quaternion) -> Quaternion {
    [a * e - b * f - c * g - d * h, a * f + b * e + c * h - d * g, a * g - b * h + c * e + d * f, a * h + b * g - c * f + d * e]
}

/// The quaternion of a rotation matrix, given by its rows: the largest of the four components is found first.
///
/// Reference: Shepperd (1978), Quaternion from rotation matrix.
fn quaternion(rows: &[f64]) -> Option<Quaternion> {
    let r = |row: usize, column: usize| rows[3 * (row % 3) + column % 3];
    let trace = r(0, 0) + r(1, 1) + r(2, 2);
    let largest = (0..3).max_by(|one, two| r(*one, *one).total_cmp(&r(*two, *two)))?;
    let mut found = [0.0; 4];
    if trace >= r(largest, largest) {
        found[0] = 1.0 + trace;
        (0..3).for_each(|k| found[k + 1] = r(k + 2, k + 1) - r(k + 1, k + 2));
    } else {
        let i = largest;
        found[0] = r(i + 2, i + 1) - r(i + 1, i + 2);
        found[i + 1] = 1.0 + 2.0 * r(i, i) - trace;
        [i + 1, i + 2].into_iter().for_each(|k| found[k % 3 + 1] = r(k, i) + r(i, k));
    }
    let norm = found.iter().map(|part| part * part).sum::<f64>().sqrt();
    norm.is_finite().then(|| found.map(|part| part / norm))
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
