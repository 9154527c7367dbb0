//! Start values of the unknowns, by the declared start of the bodies.

use super::Forest;
use crate::expr::{Binary, Expr, Triple, combination, dot};
use crate::geometry::rotation;
use crate::model::{Place, Triad};
use crate::quantity::Role;

impl Forest<'_> {
    /// Declared orientation of a body at the start, as a quaternion.
    pub(super) fn start_quaternion(&mut self, body: usize) -> [Expr; 4] {
        let declared = &self.model.bodies[body].coordinates;
        let given: Vec<Option<Expr>> = declared.iter().filter(|one| matches!(one.role, Role::Quaternion(_))).map(|one| one.start).collect();
        [0, 1, 2, 3].map(|k| given.get(k).copied().flatten().unwrap_or_else(|| self.arena.integer(i64::from(k == 0))))
    }

    /// A vector fixed in a body, in ground, at the declared start.
    pub(super) fn at_start(&mut self, place: Place) -> Triple {
        let Some(body) = place.body else { return place.local };
        let quaternion = self.start_quaternion(body);
        let columns = rotation(self.arena, quaternion).0;
        combination(self.arena, place.local, columns)
    }

    /// Position of a point at the declared start.
    pub(super) fn point_at_start(&mut self, place: Place) -> Triple {
        let turned = self.at_start(place);
        let Some(body) = place.body else { return turned };
        let zero = self.arena.integer(0);
        [0, 1, 2].map(|k| {
            let origin = self.coordinates[3 * body + k].start.unwrap_or(zero);
            self.arena.add(origin, turned[k])
        })
    }

    /// Angle of the second triad against the first at the declared start; `None` if it is zero.
    pub(super) fn start_angle(&mut self, one: Triad, two: Triad) -> Option<Expr> {
        let [x, y] = [0, 1].map(|k| self.at_start(Place { body: one.body, local: one.axes[k] }));
        let other = self.at_start(Place { body: two.body, local: two.axes[0] });
        let (s, c) = (dot(self.arena, y, other), dot(self.arena, x, other));
        self.angle_of(s, c)
    }

    fn angle_of(&mut self, s: Expr, c: Expr) -> Option<Expr> {
        let angle = self.arena.binary(Binary::Atan2, s, c);
        let is_zero = self.arena.as_constant(s).is_some_and(|value| value.is_zero())
            && self.arena.as_constant(c).is_some_and(|value| value.signum() >= 0);
        (!is_zero).then_some(angle)
    }

    /// Angles about two perpendicular axes at the declared start.
    pub(super) fn start_cross(&mut self, inner: Triad, outer: Triad) -> [Option<Expr>; 2] {
        let [x, y, z] = [0, 1, 2].map(|k| self.at_start(Place { body: inner.body, local: inner.axes[k] }));
        let [xo, _, zo] = [0, 1, 2].map(|k| self.at_start(Place { body: outer.body, local: outer.axes[k] }));
        // The second axis is −y turned by the first angle: its components are sin α and −cos α.
        let (s, c) = (dot(self.arena, x, zo), dot(self.arena, y, zo));
        let c = self.arena.neg(c);
        let first = self.angle_of(s, c);
        let alpha = first.unwrap_or_else(|| self.arena.integer(0));
        let [xa, _, _] = self.about(alpha, [x, y, z]);
        let (s, c) = (dot(self.arena, z, xo), dot(self.arena, xa, xo));
        [first, self.angle_of(s, c)]
    }
}
