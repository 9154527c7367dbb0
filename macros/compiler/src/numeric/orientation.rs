//! Orientations of bodies in space, beside the declared ones.

use super::Numeric;
use super::search::Distance;
use crate::expr::{Expr, Values, evaluate};
use crate::quantity::Role;

/// Largest angle between two orientations that count as equal, in rad.
const ALIKE: f64 = 1e-4;

/// A unit quaternion, the real part first.
pub(crate) type Quaternion = [f64; 4];

impl Numeric<'_> {
    /// For each body whose declared orientation no start of an angle expresses, adds the squared angle between its orientation and the declared one.
    ///
    /// * `other`: given, another configuration; bodies with equal orientations in both are left out.
    pub(crate) fn add_orientations(&self, distance: &mut Distance, q: &[f64], other: Option<&[f64]>) {
        let differs = |body: &&usize| {
            let [one, other] = [Some(q), other].map(|q| q.and_then(|q| self.orientation(q, **body)));
            one.zip(other).is_none_or(|(one, other)| between(one, other) > ALIKE)
        };
        let away = self.system.space.turned.iter().filter(differs).filter_map(|body| self.turned_away(q, *body));
        distance[0] += away.map(|angle| angle * angle).sum::<f64>();
    }

    /// The angle between the orientation of a body at the start and the declared one; `None` if no orientation is declared.
    pub(crate) fn turned_away(&self, start: &[f64], body: usize) -> Option<f64> {
        let (declared, found) = (self.declared_orientation(body)?, self.orientation(start, body)?);
        Some(between(declared, found))
    }

    /// The declared orientation of a body.
    pub(crate) fn declared_orientation(&self, body: usize) -> Option<Quaternion> {
        let declared = self.model.bodies[body].coordinates.iter().filter(|one| matches!(one.role, Role::Quaternion(_)));
        let declared: Vec<Expr> = declared.map(|one| one.start).collect::<Option<_>>()?;
        evaluate(&self.system.arena, &declared, &self.known).try_into().ok()
    }

    /// The orientation of a body in a configuration.
    pub(crate) fn orientation(&self, q: &[f64], body: usize) -> Option<Quaternion> {
        quaternion(&evaluate(&self.system.arena, &self.system.cosines(body), &Values { coordinates: q, ..self.known }))
    }
}

/// The angle of the rotation that leads from one orientation to another.
pub(crate) fn between(one: Quaternion, other: Quaternion) -> f64 {
    let cosine: f64 = one.iter().zip(other).map(|(one, other)| one * other).sum();
    2.0 * libm::acos(cosine.abs().min(1.0))
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
