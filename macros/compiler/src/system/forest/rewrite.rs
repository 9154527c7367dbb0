//! Declared rows and outputs in the unknowns.

use super::super::FurtherAngle;
use super::super::rows::Row;
use super::{Forest, FreeSpeeds};
use crate::expr::{Binary, Expr, Leaf, Mark, Node, dot};
use crate::model::{DECLARED, JointQuantity, Place, Triad};
use crate::quantity::{Ambient, Dim, Role, SpeedRole};
use std::collections::BTreeMap;

impl Forest<'_> {
    /// The angle between two triads as a sum of known angles, if a chain of joints about one direction leads from one to the other; and the
    /// second triad, turned by half a turn about x if its axis points against that of the first.
    fn by_known_angles(&mut self, one: Triad, two: Triad) -> Option<(Expr, Triad)> {
        let zero = self.arena.integer(0);
        // Triads on the way, each with its angle against the first.
        let mut found = vec![(one, zero)];
        let mut next = 0;
        while next < found.len() {
            let (here, angle) = found[next];
            next += 1;
            if let Some(two) = self.along_axis_of(here, two) {
                let rest = self.direction_in(here, two);
                return Some((self.arena.add(angle, rest), two));
            }
            for (a, b, between) in self.angles.clone() {
                for (near, far, is_forward) in [(a, b, true), (b, a, false)] {
                    if found.iter().any(|(known, _)| known.body == far.body) {
                        continue;
                    }
                    let Some(turned) = self.along_axis_of(here, near) else { continue };
                    // About the opposite axis the same turn has the opposite sign.
                    let (far, is_forward) = if turned == near { (far, is_forward) } else { (far.half_turned(self.arena, 0), !is_forward) };
                    let own = self.direction_in(here, turned);
                    let sum = self.arena.add(angle, own);
                    let sum = if is_forward { self.arena.add(sum, between) } else { self.arena.sub(sum, between) };
                    found.push((far, sum));
                }
            }
        }
        None
    }

    /// A triad of the same body, half turned about its x axis if its z axis is the opposite of that of the first; `None` if it is another.
    fn along_axis_of(&mut self, one: Triad, other: Triad) -> Option<Triad> {
        let candidates = [other, other.half_turned(self.arena, 0)];
        candidates.into_iter().find(|triad| (triad.body, triad.axes[2]) == (one.body, one.axes[2]))
    }

    /// Angles of joints that keep their axes in one direction, by number of the quantity, each with its triads, whose z axes are equal.
    pub(super) fn aligned(&mut self) -> BTreeMap<u32, [Triad; 2]> {
        let mut aligned = BTreeMap::new();
        for (number, (quantity, _)) in (0..).zip(&self.model.space.quantities) {
            if let JointQuantity::Angle(one, two) = *quantity
                && let Some((_, two)) = self.by_known_angles(one, two)
            {
                aligned.insert(number, [one, two]);
            }
        }
        aligned
    }

    /// Angle of the x axis of a triad in another one with the same z axis.
    fn direction_in(&mut self, of: Triad, triad: Triad) -> Expr {
        let (s, c) = (dot(self.arena, triad.axes[0], of.axes[1]), dot(self.arena, triad.axes[0], of.axes[0]));
        self.arena.binary(Binary::Atan2, s, c)
    }

    pub(super) fn declared_rows(&mut self) {
        for row in Row::declared(self.model) {
            if !self.holding.contains(&(row.joint, row.row)) {
                let residual = if self.free_speeds == FreeSpeeds::Spin { self.by_spins(row.residual) } else { row.residual };
                let residual = self.rewrite(residual);
                self.rows.push(Row { residual, ..row });
            }
        }
    }

    /// Rows of the angles that joints name but that place no body.
    ///
    /// ```text
    /// s cos θ − c sin θ = 0        s, c: y · x', x · x' of the two triads
    /// s sin θ + c cos θ > 0        at θ + π the row holds too
    /// ```
    pub(super) fn rows_of_further_angles(&mut self) -> Vec<FurtherAngle> {
        let mut angles = Vec::new();
        for (number, unknown) in self.further_angles.clone() {
            let (JointQuantity::Angle(one, two), _) = self.model.space.quantities[number as usize] else { continue };
            let ([x, y, _], [other, _, _]) = (self.in_ground(one), self.in_ground(two));
            let (s, c) = (dot(self.arena, y, other), dot(self.arena, x, other));
            let (sine, cosine) = (self.arena.sin(unknown), self.arena.cos(unknown));
            let (left, right) = (self.arena.mul(s, cosine), self.arena.mul(c, sine));
            let phi = self.arena.sub(left, right);
            let (along, across) = (self.arena.mul(c, cosine), self.arena.mul(s, sine));
            angles.push(FurtherAngle { phi, cosine: self.arena.add(along, across) });
            let joint = two.body.or(one.body).map_or(0, |body| self.a_joint_of(body));
            self.rows.push(Row { joint, row: 0, dim: Dim::NUMBER, residual: phi, is_velocity: false, is_initial: false });
        }
        angles
    }

    /// A declared expression in the unknowns.
    pub(super) fn rewrite(&mut self, root: Expr) -> Expr {
        let whole = |node: &Node| matches!(node, Node::Marked { mark: Mark::Turned { .. } | Mark::OfJoint(_), .. });
        for expr in self.arena.reachable_above(&[root], whole) {
            if self.rewritten.contains_key(&expr) {
                continue;
            }
            let node = *self.arena.node(expr);
            let at = |this: &Self, child: Expr| this.rewritten.get(&child).copied().unwrap_or(child);
            let new = match node {
                Node::Leaf(Leaf::Coordinate(number)) if number >= DECLARED => {
                    let (body, role) = ((number - DECLARED) as usize / Role::SPACE.len(), (number - DECLARED) as usize % Role::SPACE.len());
                    self.arena.leaf(Leaf::Coordinate((Ambient::Space.first_coordinate(body) + role) as u32))
                }
                Node::Leaf(Leaf::Speed(number)) if number >= DECLARED => self.speed((number - DECLARED) as usize),
                Node::Leaf(Leaf::Acceleration(number)) if number >= DECLARED => self.acceleration((number - DECLARED) as usize),
                Node::Marked { mark: Mark::Turned { vector, axis }, .. } => {
                    let (body, local) = self.arena.vector(vector);
                    self.vector(Place { body: Some(body), local })[usize::from(axis)]
                }
                Node::Marked { mark: Mark::OfJoint(number), value } => self.quantity(number, value),
                _ => {
                    let children: Vec<Expr> = node.children().map(|child| at(self, child)).collect();
                    self.arena.with_children(expr, &children)
                }
            };
            self.rewritten.insert(expr, new);
        }
        self.rewritten[&root]
    }

    /// A declared speed in the rates of the unknowns.
    fn speed(&mut self, number: usize) -> Expr {
        let (body, at) = (number / SpeedRole::SPACE.len(), number % SpeedRole::SPACE.len());
        match (at.checked_sub(Ambient::Space.components()), self.frames[body]) {
            (None, _) => self.arena.leaf(Leaf::Speed((Ambient::Space.first_coordinate(body) + at) as u32)),
            (Some(axis), Some(frame)) => self.arena.frame(frame).velocity[axis],
            (Some(_), None) => self.arena.integer(0),
        }
    }

    /// A declared acceleration in those of the unknowns.
    fn acceleration(&mut self, number: usize) -> Expr {
        let (body, at) = (number / SpeedRole::SPACE.len(), number % SpeedRole::SPACE.len());
        match (at.checked_sub(Ambient::Space.components()), self.frames[body]) {
            (None, _) => self.arena.leaf(Leaf::Acceleration((Ambient::Space.first_coordinate(body) + at) as u32)),
            (Some(axis), Some(frame)) => self.arena.frame(frame).acceleration[axis],
            (Some(_), None) => self.arena.integer(0),
        }
    }

    /// An angle or a displacement of a joint in the unknowns.
    fn quantity(&mut self, number: u32, value: Expr) -> Expr {
        if let Some(known) = self.displacements.get(&number).or_else(|| self.further_angles.get(&number)) {
            return *known;
        }
        match self.model.space.quantities[number as usize].0 {
            JointQuantity::Displacement(..) => {
                let Node::Marked { value, .. } = *self.arena.node(value) else { return self.rewrite(value) };
                self.rewrite(value)
            }
            JointQuantity::Angle(one, two) => {
                if let Some((angle, _)) = self.by_known_angles(one, two) {
                    return angle;
                }
                let body = two.body.or(one.body).unwrap_or(0);
                let start = self.declared_angle(one, two).or_else(|| self.start_angle(one, two, true));
                let (_, unknown) = self.unknown(body, Role::Angle, start, Some((self.a_joint_of(body), "angle")));
                self.further_angles.insert(number, unknown);
                unknown
            }
        }
    }
}
