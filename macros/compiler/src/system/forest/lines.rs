//! Points on lines, and their displacements.

use super::super::rows::Row;
use super::Forest;
use crate::expr::dot;
use crate::model::{JointQuantity, Place, Relationship, Triad};
use crate::quantity::{Dim, Role};

impl Forest<'_> {
    /// Points on lines that place a body: three rows and a displacement instead of two rows.
    pub(super) fn lines(&mut self) {
        let mut placed: Vec<bool> = (0..self.model.bodies.len()).map(|body| self.linked.contains(&body)).collect();
        let is_placed = |placed: &[bool], body: Option<usize>| body.is_none_or(|body| placed[body]);
        loop {
            let relations = self.model.space.relations.iter();
            let next = relations
                .filter_map(|found| {
                    let rank = match found.2 {
                        Relationship::Coincident(..) if !self.has_link(&found.2) => 0,
                        Relationship::OnLine(..) => 1,
                        _ => return None,
                    };
                    let bodies = found.2.bodies();
                    let rank = (self.model.joints[found.0].is_redundant, rank);
                    (is_placed(&placed, bodies[0]) != is_placed(&placed, bodies[1])).then_some((rank, bodies, *found))
                })
                .min_by_key(|(rank, _, _)| *rank);
            match next {
                Some((_, bodies, (joint, row, relation))) => {
                    bodies.into_iter().flatten().for_each(|body| placed[body] = true);
                    if let Relationship::OnLine(triad, from, to) = relation {
                        self.on_line((joint, row), triad, from, to);
                    }
                }
                None => match placed.iter().position(|placed| !placed) {
                    Some(body) => placed[body] = true,
                    None => return,
                },
            }
        }
    }

    fn on_line(&mut self, (joint, row): (usize, usize), triad: Triad, from: Place, to: Place) {
        self.holding.extend([(joint, row), (joint, row + 1)]);
        let body = to.body.or(from.body).unwrap_or(0);
        let quantity = JointQuantity::Displacement(triad, from, to);
        let start = if let Some(start) = self.declared_start(quantity) {
            self.start_along(triad, start, from, to);
            start
        } else {
            let (z, p, q) =
                (self.at_start(Place { body: triad.body, local: triad.axes[2] }), self.point_at_start(from), self.point_at_start(to));
            let d = [0, 1, 2].map(|k| self.arena.sub(q[k], p[k]));
            dot(self.arena, z, d)
        };
        let start = (!self.arena.as_constant(start).is_some_and(|value| value.is_zero())).then_some(start);
        let (_, unknown) = self.unknown(body, Role::Displacement, start, Some((joint, "displacement")));
        let z = self.vector(Place { body: triad.body, local: triad.axes[2] });
        let (p, q) = (self.point(from), self.point(to));
        for k in 0..3 {
            let d = self.arena.sub(q[k], p[k]);
            let part = self.arena.mul(unknown, z[k]);
            let phi = self.arena.sub(d, part);
            self.rows.push(Row { joint, row: row + k.min(1), dim: Dim::LENGTH, residual: phi, is_velocity: false, is_initial: false });
        }
        if let Some(index) = self.model.space.quantities.iter().position(|(known, _)| *known == quantity) {
            self.displacements.insert(index as u32, unknown);
        }
    }
}
