//! Frames of bodies, by the relations that reach them.

use super::super::rows::Row;
use super::{Forest, FreeSpeeds};
use crate::expr::{Arena, Expr, Frame, Leaf, Spin, Triple, combination, cross};
use crate::geometry::rotation;
use crate::model::{Place, Relationship, Triad};
use crate::quantity::{Dim, Role};

impl Forest<'_> {
    pub(super) fn reach_by_angle(&mut self, joint: usize, one: Triad, two: Triad) {
        let (inner, outer) = self.inward(one, two);
        let Some(body) = outer.body else { return };
        if let Some(row) = self.twist(one, two) {
            self.holding.insert(row);
            let outer = self.facing_in_all(inner, outer);
            self.reach_without_angle(joint, inner, outer);
            return;
        }
        let declared = self.declared_angle(one, two);
        // The angle counts the second body against the first, wherever ground is.
        let is_forward = inner == one;
        // The angle is counted about the axis of the first triad: the second one is half turned.
        let (inner, outer) = if is_forward { (inner, self.facing(inner, outer)) } else { (self.facing_back(inner, outer), outer) };
        let (one, two) = if is_forward { (inner, outer) } else { (outer, inner) };
        let [x, y, z] = self.in_ground(inner);
        let against = |forest: &mut Self, angle: Expr| if is_forward { angle } else { forest.arena.neg(angle) };
        let by_place = match declared {
            Some(angle) => Some(angle),
            None => self.start_angle_by_place(inner, outer).map(|angle| against(self, angle)),
        };
        if by_place.is_some() {
            self.placed.insert(body);
        }
        let by_drive = if by_place.is_some() || self.has_orientation(body) { None } else { self.driven_angle(one, two) };
        if by_drive.is_some() {
            self.driven.insert(body);
        }
        let start = match by_place {
            None if self.says_angle(inner, body) => self.start_angle(one, two, self.has_orientation(body)),
            by_place => by_place,
        };
        let angle = by_drive.or(start).unwrap_or_else(|| self.arena.integer(0));
        let angle = against(self, angle);
        self.note_start(inner, outer, Some(angle));
        let (number, unknown) = self.unknown(body, Role::Angle, start, Some((joint, "angle")));
        let (angle, turn) = if is_forward { (unknown, z) } else { (self.arena.neg(unknown), z.map(|part| self.arena.neg(part))) };
        let axes = self.about(angle, [x, y, z]);
        self.attach(joint, inner.body, outer, axes, &[(number, turn)]);
        self.angles.push((one, two, unknown));
    }

    /// Reaches a body whose triad has the axes of another.
    pub(super) fn reach_without_angle(&mut self, joint: usize, inner: Triad, outer: Triad) {
        let axes = self.in_ground(inner);
        self.note_start(inner, outer, None);
        self.attach(joint, inner.body, outer, axes, &[]);
    }

    /// The row that keeps two bodies with one axis direction from turning about it.
    fn twist(&self, one: Triad, two: Triad) -> Option<(usize, usize)> {
        let is_twist = |a: &Place, b: &Place| {
            let matches = |a: &Place, b: &Place| {
                (a.body, b.body) == (one.body, two.body)
                    && ((a.local, b.local) == (one.axes[0], two.axes[1]) || (a.local, b.local) == (one.axes[1], two.axes[0]))
            };
            matches(a, b) || matches(b, a)
        };
        let found = self.model.space.relations.iter().find(|(_, _, relation)| match relation {
            Relationship::Perpendicular(a, b) => is_twist(a, b),
            _ => false,
        });
        found.map(|(joint, row, _)| (*joint, *row))
    }

    pub(super) fn reach_by_two_angles(&mut self, (joint, row): (usize, usize), one: Place, two: Place) {
        let is_in_order = self.depth(one.body).is_some();
        let (inner, outer) = if is_in_order { (one, two) } else { (two, one) };
        let words = if is_in_order { ["angle_a", "angle_b"] } else { ["angle_b", "angle_a"] };
        let Some(body) = outer.body else { return };
        let (inner, outer) = match self.model.space.arms.get(&(joint, row)).copied() {
            Some(arms) => {
                // angle_a is zero where the second axis lies along x of the first, angle_b where x of the second lies along the first.
                let [a, b] = if is_in_order { arms } else { [arms[1], arms[0]] };
                (a.quarter_turned(self.arena), b.quarter_turned(self.arena).half_turned(self.arena, 2))
            }
            None => (self.triad_along(inner), self.triad_along(outer)),
        };
        let axes = self.in_ground(inner);
        let is_told = self.says_angle(inner, body);
        let [first, second] = if is_told { self.start_cross(inner, outer) } else { [None, None] };
        // Both angles count the second body against the first, wherever ground is.
        let counted = |forest: &mut Self, angle: Expr| if is_in_order { angle } else { forest.arena.neg(angle) };
        let [first, second] = [first, second].map(|start| start.map(|angle| counted(self, angle)));
        let (alpha, one) = self.unknown(body, Role::Angle, first, Some((joint, words[0])));
        let (beta, two) = self.unknown(body, Role::Angle, second, Some((joint, words[1])));
        let [one, two] = [one, two].map(|angle| counted(self, angle));
        let [x, y, z] = self.about(one, axes);
        // After a quarter turn about x the second axis lies across the first.
        let across = [x, z, y.map(|part| self.arena.neg(part))];
        let turned = self.about(two, across);
        let turns = [axes[2], across[2]].map(|axis| axis.map(|part| counted(self, part)));
        self.attach(joint, inner.body, outer, turned, &[(alpha, turns[0]), (beta, turns[1])]);
    }

    /// A body about which nothing is known.
    pub(super) fn free(&mut self, body: usize) {
        let start = self.start_quaternion(body);
        let unknowns = [0, 1, 2, 3].map(|k| self.unknown(body, Role::Quaternion(k), Some(start[usize::from(k)]), None));
        let [w, x, y, z] = unknowns.map(|(_, leaf)| leaf);
        let (columns, factor) = rotation(self.arena, [w, x, y, z]);
        self.depths[body] = self.model.bodies.len();
        let own = unknowns.iter().map(|(number, _)| Leaf::Coordinate(*number)).collect();
        if self.free_speeds == FreeSpeeds::Spin {
            let spin = Spin { first: unknowns[0].0, axes: self.axes_of_spin(body) };
            self.frames[body] = Some(self.arena.add_spinning_frame(columns, spin, own));
            let zero = self.arena.integer(0);
            self.norm(body, zero);
            return;
        }
        let arena = &mut *self.arena;
        // ω = h vec(ė ē), with h = 2/(e · e)
        let turn = |arena: &mut Arena, k: usize| {
            let [nx, ny, nz] = [x, y, z].map(|part| arena.neg(part));
            let rows = [[nx, ny, nz], [w, z, ny], [nz, w, x], [y, nx, w]];
            rows[k].map(|part| arena.mul(factor, part))
        };
        let turns = [0, 1, 2, 3].map(|k| (unknowns[k].0, turn(arena, k)));
        let zero = arena.integer(0);
        let motion = |arena: &mut Arena, leaf: fn(u32) -> Leaf| {
            let mut sum = [zero; 3];
            for (number, turn) in &turns {
                let rate = arena.leaf(leaf(*number));
                for (sum, part) in sum.iter_mut().zip(turn) {
                    let term = arena.mul(*part, rate);
                    *sum = arena.add(*sum, term);
                }
            }
            sum
        };
        let velocity = motion(arena, Leaf::Speed);
        let along = motion(arena, Leaf::Acceleration);
        // ω̇ = h vec(ë ē) − h (e · ė) ω
        let mut growth = zero;
        for (leaf, (number, _)) in [w, x, y, z].into_iter().zip(&turns) {
            let rate = arena.leaf(Leaf::Speed(*number));
            let term = arena.mul(leaf, rate);
            growth = arena.add(growth, term);
        }
        let growth = arena.mul(factor, growth);
        let drift = velocity.map(|part| arena.mul(growth, part));
        let acceleration = [0, 1, 2].map(|k| arena.sub(along[k], drift[k]));
        let acceleration_at_constant_speeds = drift.map(|part| arena.neg(part));
        let mut turns: Vec<(Leaf, Triple)> = turns.iter().map(|(number, turn)| (Leaf::Coordinate(*number), *turn)).collect();
        turns.extend(arena.turns_about_ground(body));
        let frame = arena.add_frame(Frame { columns, velocity, acceleration, acceleration_at_constant_speeds, turns, against: None, own });
        self.frames[body] = Some(frame);
        let squares = [w, x, y, z].map(|part| self.arena.square(part));
        let sum = self.arena.sum(&squares);
        let one = self.arena.integer(1);
        let phi = self.arena.sub(sum, one);
        self.norm(body, phi);
    }

    /// The row of the norm of a quaternion.
    fn norm(&mut self, body: usize, phi: Expr) {
        self.rows.push(Row {
            joint: self.a_joint_of(body),
            row: 0,
            dim: Dim::NUMBER,
            residual: phi,
            is_velocity: false,
            is_initial: false,
        });
    }

    /// The frame of a body: its triad has these axes in ground, and it turns against the frame of another with these coordinates.
    pub(super) fn attach(&mut self, joint: usize, from: Option<usize>, triad: Triad, axes: [Triple; 3], by: &[(u32, Triple)]) {
        let Some(body) = triad.body else { return };
        self.reached[body] = Some((joint, from));
        let columns = self.columns(triad, axes);
        let zero = self.arena.integer(0);
        let (mut velocity, mut acceleration, mut steady, mut turns) = match from.and_then(|from| self.frames[from]) {
            Some(frame) => {
                let frame = self.arena.frame(frame);
                (frame.velocity, frame.acceleration, frame.acceleration_at_constant_speeds, frame.turns.clone())
            }
            None => ([zero; 3], [zero; 3], [zero; 3], Vec::new()),
        };
        for (number, axis) in by {
            let (speed, second) = (self.arena.leaf(Leaf::Speed(*number)), self.arena.leaf(Leaf::Acceleration(*number)));
            let rates = axis.map(|part| self.arena.mul(part, speed));
            // ω × z θ̇: the axis turns with the joints before it.
            let swing = cross(self.arena, velocity, rates);
            for k in 0..3 {
                let along = self.arena.mul(axis[k], second);
                let along = self.arena.add(along, swing[k]);
                acceleration[k] = self.arena.add(acceleration[k], along);
                steady[k] = self.arena.add(steady[k], swing[k]);
                velocity[k] = self.arena.add(velocity[k], rates[k]);
            }
            turns.push((Leaf::Coordinate(*number), *axis));
        }
        let against = from.and_then(|from| self.frames[from]);
        let own = by.iter().map(|(number, _)| Leaf::Coordinate(*number)).collect();
        let frame = Frame { columns, velocity, acceleration, acceleration_at_constant_speeds: steady, turns, against, own };
        self.frames[body] = Some(self.arena.add_frame(frame));
        self.depths[body] = from.map_or(0, |from| self.depths[from]) + 1;
    }

    /// A = (x y z) Tᵀ of a body whose triad has these axes in ground.
    pub(super) fn columns(&mut self, triad: Triad, axes: [Triple; 3]) -> [Triple; 3] {
        [0, 1, 2].map(|column| combination(self.arena, triad.axes.map(|axis| axis[column]), axes))
    }

    /// A triad turned about its z axis.
    pub(super) fn about(&mut self, angle: Expr, [x, y, z]: [Triple; 3]) -> [Triple; 3] {
        let arena = &mut *self.arena;
        let (sine, cosine) = (arena.sin(angle), arena.cos(angle));
        let mut turned = |a: Triple, b: Triple, is_plus: bool| {
            [0, 1, 2].map(|k| {
                let (one, two) = (arena.mul(a[k], cosine), arena.mul(b[k], sine));
                if is_plus { arena.add(one, two) } else { arena.sub(one, two) }
            })
        };
        [turned(x, y, true), turned(y, x, false), z]
    }

    /// A triad whose z axis is this vector.
    fn triad_along(&mut self, place: Place) -> Triad {
        let known = self.model.space.relations.iter().flat_map(|(_, _, relation)| match relation {
            Relationship::SameDirection(one, two) | Relationship::SameOrientation(one, two) => vec![*one, *two],
            Relationship::OnLine(one, ..) => vec![*one],
            _ => Vec::new(),
        });
        // An axis that other joints use has its directions already.
        let mut known = known.filter(|triad| triad.body == place.body);
        if let Some(triad) = known.find(|triad| triad.axes[2] == place.local) {
            return triad;
        }
        let value = |part: Expr| self.arena.as_constant(part).map_or(0.5, |value| value.to_f64().abs());
        let sizes = place.local.map(value);
        let least = (0..3).fold(0, |least, k| if sizes[k] < sizes[least] { k } else { least });
        let (zero, one) = (self.arena.integer(0), self.arena.integer(1));
        let toward = [0, 1, 2].map(|k| if k == least { one } else { zero });
        Triad::along(self.arena, place, toward)
    }
}
