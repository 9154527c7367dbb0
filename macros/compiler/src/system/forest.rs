//! What is solved for in space: positions, angles and displacements of joints, and quaternions only where no joint says more.
//!
//! ```text
//! axes of one direction      A_j = A_i T_i R_z(θ) T_jᵀ                 one angle for two rows
//! equal triads               A_j = A_i T_i T_jᵀ                        no unknown for three rows
//! perpendicular vectors      A_j = A_i T_i R_z(α) R_x(90°) R_z(β) T_jᵀ  two angles for one row
//! no relation                A_j = A(e),  e · e = 1                    four components, one row more
//! point on a line            r_Q = r_P + s z                           one displacement, three rows for two
//! ```
//!
//! Bodies are reached from ground, each by one relation. Rows of relations that reached a body hold by construction and are not solved.

use super::rows::Row;
use super::{Choice, Coordinate};
use crate::expr::{Arena, Expr, Frame, Leaf, Mark, Node, Triple, combination, cross, dot};
use crate::geometry::rotation;
use crate::model::{DECLARED, JointQuantity, Model, Place, Relationship, Triad};
use crate::quantity::{Axis, Dim, Role};
use std::collections::{BTreeSet, HashMap};

/// Unknowns and rows of a mechanism in space.
pub(super) struct Forest<'a> {
    model: &'a Model,
    arena: &'a mut Arena,
    /// Frame of each body in the arena.
    frames: Vec<Option<usize>>,
    /// Number of relations between ground and the body.
    depths: Vec<usize>,
    coordinates: Vec<Coordinate>,
    /// The relation's joint by which each body was reached, and the body that it was reached from.
    reached: Vec<Option<(usize, Option<usize>)>>,
    /// Angles between triads.
    angles: Vec<(Triad, Triad, Expr)>,
    /// Unknown that a quantity stands for.
    unknowns: HashMap<u32, Expr>,
    /// Rows that hold by construction.
    holding: BTreeSet<(usize, usize)>,
    rows: Vec<Row>,
    rewritten: HashMap<Expr, Expr>,
}

/// Chooses the unknowns of a mechanism in space, and writes its rows and outputs in them.
pub(super) fn reduce(model: &Model, arena: &mut Arena) -> Choice {
    let bodies = model.bodies.len();
    let mut forest = Forest {
        model,
        arena,
        frames: vec![None; bodies],
        depths: vec![usize::MAX; bodies],
        coordinates: Vec::new(),
        reached: vec![None; bodies],
        angles: Vec::new(),
        unknowns: HashMap::new(),
        holding: BTreeSet::new(),
        rows: Vec::new(),
        rewritten: HashMap::new(),
    };
    forest.positions();
    forest.orientations();
    forest.lines();
    forest.declared_rows();
    forest.rows.sort_by_key(|row| row.joint);
    let outputs = model.outputs.iter().map(|output| output.components.iter().map(|part| forest.rewrite(*part)).collect()).collect();
    forest.remaining_quantities();
    forest.rows.sort_by_key(|row| row.joint);
    let frames = forest.frames.iter().map(|frame| frame.unwrap_or(0)).collect();
    Choice { coordinates: forest.coordinates, rows: forest.rows, outputs, frames, reached: forest.reached }
}

impl Forest<'_> {
    fn positions(&mut self) {
        for (body, declared) in self.model.bodies.iter().enumerate() {
            for (role, axis) in Role::SPACE.into_iter().zip([Axis::X, Axis::Y, Axis::Z]) {
                let start = declared.coordinates.iter().find(|coordinate| coordinate.role == role).and_then(|found| found.start);
                self.coordinates.push(Coordinate { body, role: Role::Position(axis), start, of_joint: None });
            }
        }
    }

    /// Position of a body.
    fn origin(&mut self, body: usize) -> Triple {
        [0, 1, 2].map(|axis| self.arena.leaf(Leaf::Coordinate((3 * body + axis) as u32)))
    }

    /// A new unknown.
    fn unknown(&mut self, body: usize, role: Role, start: Option<Expr>, of_joint: Option<(usize, &'static str)>) -> (u32, Expr) {
        let number = self.coordinates.len() as u32;
        self.coordinates.push(Coordinate { body, role, start, of_joint });
        (number, self.arena.leaf(Leaf::Coordinate(number)))
    }

    /// Depth of a body, or of ground; `None` if it has not been reached.
    fn depth(&self, body: Option<usize>) -> Option<usize> {
        match body {
            None => Some(0),
            Some(body) => self.frames[body].map(|_| self.depths[body]),
        }
    }

    /// Reaches every body.
    fn orientations(&mut self) {
        loop {
            if let Some((joint, row, relation)) = self.next_relation() {
                self.reach(joint, row, relation);
            } else if let Some(body) = self.frames.iter().position(Option::is_none) {
                self.free(body);
            } else {
                return;
            }
        }
    }

    /// The relation that reaches a new body by the fewest unknowns, and of these the nearest to ground.
    fn next_relation(&self) -> Option<(usize, usize, Relationship)> {
        let rank = |(joint, _, relation): &&(usize, usize, Relationship)| {
            let (unknowns, bodies) = match relation {
                Relationship::SameOrientation(one, two) => (0, [one.body, two.body]),
                Relationship::SameDirection(one, two) => (1, [one.body, two.body]),
                Relationship::Perpendicular(one, two) => (2, [one.body, two.body]),
                Relationship::Coincident(..) | Relationship::OnLine(..) => return None,
            };
            match bodies.map(|body| self.depth(body)) {
                [Some(depth), None] | [None, Some(depth)] => Some((self.model.joints[*joint].is_redundant, unknowns, depth)),
                _ => None,
            }
        };
        let relations = self.model.space.relations.iter();
        relations.filter_map(|relation| Some((rank(&relation)?, relation))).min_by_key(|(rank, _)| *rank).map(|(_, relation)| *relation)
    }

    fn reach(&mut self, joint: usize, row: usize, relation: Relationship) {
        self.holding.extend((0..relation.rows()).map(|offset| (joint, row + offset)));
        match relation {
            Relationship::SameOrientation(one, two) => {
                let (inner, outer) = self.inward(one, two);
                let axes = self.in_ground(inner);
                self.attach(joint, inner.body, outer, axes, &[]);
            }
            Relationship::SameDirection(one, two) => self.reach_by_angle(joint, one, two),
            Relationship::Perpendicular(one, two) => self.reach_by_two_angles(joint, one, two),
            Relationship::Coincident(..) | Relationship::OnLine(..) => {}
        }
    }

    /// The triad of the body that has been reached, and that of the other.
    fn inward(&self, one: Triad, two: Triad) -> (Triad, Triad) {
        if self.depth(one.body).is_some() { (one, two) } else { (two, one) }
    }

    fn reach_by_angle(&mut self, joint: usize, one: Triad, two: Triad) {
        let (inner, outer) = self.inward(one, two);
        let Some(body) = outer.body else { return };
        let [x, y, z] = self.in_ground(inner);
        if let Some(row) = self.twist(one, two) {
            self.holding.insert(row);
            self.attach(joint, inner.body, outer, [x, y, z], &[]);
            return;
        }
        let start = self.start_angle(one, two);
        let (number, unknown) = self.unknown(body, Role::Angle, start, Some((joint, "angle")));
        // The angle counts the second body against the first, wherever ground is.
        let is_forward = inner == one;
        let (angle, turn) = if is_forward { (unknown, z) } else { (self.arena.neg(unknown), z.map(|part| self.arena.neg(part))) };
        let axes = self.about(angle, [x, y, z]);
        self.attach(joint, inner.body, outer, axes, &[(number, turn)]);
        self.angles.push((one, two, unknown));
    }

    /// An angle of two triads by those that are known, if a chain of joints about one direction leads from one to the other.
    fn by_known_angles(&mut self, one: Triad, two: Triad) -> Option<Expr> {
        let zero = self.arena.integer(0);
        // Triads on the way, each with its angle against the first.
        let mut found = vec![(one, zero)];
        let mut next = 0;
        while next < found.len() {
            let (here, angle) = found[next];
            next += 1;
            if here.body == two.body && here.axes[2] == two.axes[2] {
                let rest = self.direction_in(here, two);
                return Some(self.arena.add(angle, rest));
            }
            for (a, b, between) in self.angles.clone() {
                for (near, far, is_forward) in [(a, b, true), (b, a, false)] {
                    let is_new = !found.iter().any(|(known, _)| known.body == far.body);
                    if near.body == here.body && near.axes[2] == here.axes[2] && is_new {
                        let own = self.direction_in(here, near);
                        let sum = self.arena.add(angle, own);
                        let sum = if is_forward { self.arena.add(sum, between) } else { self.arena.sub(sum, between) };
                        found.push((far, sum));
                    }
                }
            }
        }
        None
    }

    /// Angle of the x axis of a triad in another one with the same z axis.
    fn direction_in(&mut self, of: Triad, triad: Triad) -> Expr {
        let (s, c) = (dot(self.arena, triad.axes[0], of.axes[1]), dot(self.arena, triad.axes[0], of.axes[0]));
        self.arena.binary(crate::expr::Binary::Atan2, s, c)
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

    fn reach_by_two_angles(&mut self, joint: usize, one: Place, two: Place) {
        let (inner, outer) = if self.depth(one.body).is_some() { (one, two) } else { (two, one) };
        let Some(body) = outer.body else { return };
        let (inner, outer) = (self.triad_along(inner), self.triad_along(outer));
        let axes = self.in_ground(inner);
        let [first, second] = self.start_cross(inner, outer);
        let (alpha, one) = self.unknown(body, Role::Angle, first, Some((joint, "angle_1")));
        let (beta, two) = self.unknown(body, Role::Angle, second, Some((joint, "angle_2")));
        let [x, y, z] = self.about(one, axes);
        // After a quarter turn about x the second axis lies across the first.
        let across = [x, z, y.map(|part| self.arena.neg(part))];
        let turned = self.about(two, across);
        self.attach(joint, inner.body, outer, turned, &[(alpha, axes[2]), (beta, across[2])]);
    }

    /// A body about which nothing is known.
    fn free(&mut self, body: usize) {
        let start = self.start_quaternion(body);
        let unknowns = [0, 1, 2, 3].map(|k| self.unknown(body, Role::Quaternion(k), Some(start[usize::from(k)]), None));
        let [w, x, y, z] = unknowns.map(|(_, leaf)| leaf);
        let (columns, factor) = rotation(self.arena, [w, x, y, z]);
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
        let turns = turns.iter().map(|(number, turn)| (Leaf::Coordinate(*number), *turn)).collect();
        let own = unknowns.iter().map(|(number, _)| Leaf::Coordinate(*number)).collect();
        let frame = arena.add_frame(Frame { columns, velocity, acceleration, acceleration_at_constant_speeds, turns, against: None, own });
        self.frames[body] = Some(frame);
        self.depths[body] = self.model.bodies.len();
        let squares = [w, x, y, z].map(|part| self.arena.square(part));
        let sum = self.arena.sum(&squares);
        let one = self.arena.integer(1);
        let phi = self.arena.sub(sum, one);
        self.rows.push(Row { joint: self.a_joint_of(body), row: 0, dim: Dim::NUMBER, residual: phi, is_velocity: false });
    }

    /// A joint of a body.
    fn a_joint_of(&self, body: usize) -> usize {
        let first = DECLARED + (Role::SPACE.len() * body) as u32;
        let own = first..first + Role::SPACE.len() as u32;
        let is_of =
            |expr: Expr| self.model.arena.leaves(expr).iter().any(|leaf| matches!(leaf, Leaf::Coordinate(number) if own.contains(number)));
        self.model.joints.iter().position(|joint| joint.residuals.iter().any(|residual| is_of(residual.expr))).unwrap_or(0)
    }

    /// The frame of a body: its triad has these axes in ground, and it turns against the frame of another with these coordinates.
    fn attach(&mut self, joint: usize, from: Option<usize>, triad: Triad, axes: [Triple; 3], by: &[(u32, Triple)]) {
        let Some(body) = triad.body else { return };
        self.reached[body] = Some((joint, from));
        // A = (x y z) Tᵀ
        let columns = [0, 1, 2].map(|column| combination(self.arena, triad.axes.map(|axis| axis[column]), axes));
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
            // ω × z θ̇: the axis turns with what came before.
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

    /// A triad turned about its z axis.
    fn about(&mut self, angle: Expr, [x, y, z]: [Triple; 3]) -> [Triple; 3] {
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

    /// The axes of a triad in ground.
    fn in_ground(&mut self, triad: Triad) -> [Triple; 3] {
        triad.axes.map(|axis| self.vector(Place { body: triad.body, local: axis }))
    }

    /// A vector fixed in a body, in ground.
    fn vector(&mut self, place: Place) -> Triple {
        match place.body.and_then(|body| self.frames[body]) {
            Some(frame) => self.arena.turned(frame, place.local),
            None => place.local,
        }
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

    /// Declared orientation of a body at the start, as a quaternion.
    fn start_quaternion(&mut self, body: usize) -> [Expr; 4] {
        let declared = &self.model.bodies[body].coordinates;
        let given: Vec<Option<Expr>> = declared.iter().filter(|one| matches!(one.role, Role::Quaternion(_))).map(|one| one.start).collect();
        [0, 1, 2, 3].map(|k| given.get(k).copied().flatten().unwrap_or_else(|| self.arena.integer(i64::from(k == 0))))
    }

    /// A vector fixed in a body, in ground, at the declared start.
    fn at_start(&mut self, place: Place) -> Triple {
        let Some(body) = place.body else { return place.local };
        let quaternion = self.start_quaternion(body);
        let columns = rotation(self.arena, quaternion).0;
        combination(self.arena, place.local, columns)
    }

    /// Position of a point at the declared start.
    fn point_at_start(&mut self, place: Place) -> Triple {
        let turned = self.at_start(place);
        let Some(body) = place.body else { return turned };
        let zero = self.arena.integer(0);
        [0, 1, 2].map(|k| {
            let origin = self.coordinates[3 * body + k].start.unwrap_or(zero);
            self.arena.add(origin, turned[k])
        })
    }

    /// Angle of the second triad against the first at the declared start; `None` if it is zero.
    fn start_angle(&mut self, one: Triad, two: Triad) -> Option<Expr> {
        let [x, y] = [0, 1].map(|k| self.at_start(Place { body: one.body, local: one.axes[k] }));
        let other = self.at_start(Place { body: two.body, local: two.axes[0] });
        let (s, c) = (dot(self.arena, y, other), dot(self.arena, x, other));
        self.angle_of(s, c)
    }

    fn angle_of(&mut self, s: Expr, c: Expr) -> Option<Expr> {
        let angle = self.arena.binary(crate::expr::Binary::Atan2, s, c);
        let is_zero = self.arena.as_constant(s).is_some_and(|value| value.is_zero())
            && self.arena.as_constant(c).is_some_and(|value| value.signum() >= 0);
        (!is_zero).then_some(angle)
    }

    /// Angles about two perpendicular axes at the declared start.
    fn start_cross(&mut self, inner: Triad, outer: Triad) -> [Option<Expr>; 2] {
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

    /// Points on lines that place a body: three rows and a displacement instead of two rows.
    fn lines(&mut self) {
        let mut placed = vec![false; self.model.bodies.len()];
        let is_placed = |placed: &[bool], body: Option<usize>| body.is_none_or(|body| placed[body]);
        loop {
            let relations = self.model.space.relations.iter();
            let next = relations
                .filter_map(|found| {
                    let (rank, bodies) = match found.2 {
                        Relationship::Coincident(one, two) => (0, [one.body, two.body]),
                        Relationship::OnLine(_, one, two) => (1, [one.body, two.body]),
                        _ => return None,
                    };
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
        let start = {
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
            self.rows.push(Row { joint, row: row + k.min(1), dim: Dim::LENGTH, residual: phi, is_velocity: false });
        }
        let quantity = JointQuantity::Displacement(triad, from, to);
        if let Some(index) = self.model.space.quantities.iter().position(|(known, _)| *known == quantity) {
            self.unknowns.insert(index as u32, unknown);
        }
    }

    /// A point in ground.
    fn point(&mut self, place: Place) -> Triple {
        let turned = self.vector(place);
        match place.body {
            Some(body) => {
                let origin = self.origin(body);
                [0, 1, 2].map(|k| self.arena.add(origin[k], turned[k]))
            }
            None => turned,
        }
    }

    fn declared_rows(&mut self) {
        for row in Row::declared(self.model) {
            if !self.holding.contains(&(row.joint, row.row)) {
                let residual = self.rewrite(row.residual);
                self.rows.push(Row { residual, ..row });
            }
        }
    }

    /// Rows of the angles that joints name but that place no body.
    fn remaining_quantities(&mut self) {
        let mut pending: Vec<(u32, Expr)> =
            self.unknowns.iter().filter(|(number, _)| **number >= COUNTED).map(|(number, unknown)| (*number, *unknown)).collect();
        pending.sort_unstable();
        for (number, unknown) in pending {
            let (JointQuantity::Angle(one, two), _) = self.model.space.quantities[(number - COUNTED) as usize] else { continue };
            let ([x, y, _], [other, _, _]) = (self.in_ground(one), self.in_ground(two));
            let (s, c) = (dot(self.arena, y, other), dot(self.arena, x, other));
            let (sine, cosine) = (self.arena.sin(unknown), self.arena.cos(unknown));
            let (left, right) = (self.arena.mul(s, cosine), self.arena.mul(c, sine));
            let phi = self.arena.sub(left, right);
            let joint = two.body.or(one.body).map_or(0, |body| self.a_joint_of(body));
            self.rows.push(Row { joint, row: 0, dim: Dim::NUMBER, residual: phi, is_velocity: false });
        }
    }

    /// A declared expression in the unknowns.
    fn rewrite(&mut self, root: Expr) -> Expr {
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
                    self.arena.leaf(Leaf::Coordinate((3 * body + role) as u32))
                }
                Node::Leaf(Leaf::Speed(number)) if number >= DECLARED => self.speed((number - DECLARED) as usize),
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
        let (body, at) = (number / 6, number % 6);
        match (at.checked_sub(3), self.frames[body]) {
            (None, _) => self.arena.leaf(Leaf::Speed((3 * body + at) as u32)),
            (Some(axis), Some(frame)) => self.arena.frame(frame).velocity[axis],
            (Some(_), None) => self.arena.integer(0),
        }
    }

    /// An angle or a displacement of a joint in the unknowns.
    fn quantity(&mut self, number: u32, value: Expr) -> Expr {
        if let Some(known) = self.unknowns.get(&number).or_else(|| self.unknowns.get(&(COUNTED + number))) {
            return *known;
        }
        match self.model.space.quantities[number as usize].0 {
            JointQuantity::Displacement(..) => {
                let Node::Marked { value, .. } = *self.arena.node(value) else { return self.rewrite(value) };
                self.rewrite(value)
            }
            JointQuantity::Angle(one, two) => {
                if let Some(angle) = self.by_known_angles(one, two) {
                    return angle;
                }
                let body = two.body.or(one.body).unwrap_or(0);
                let start = self.start_angle(one, two);
                let (_, unknown) = self.unknown(body, Role::Angle, start, Some((self.a_joint_of(body), "angle")));
                self.unknowns.insert(COUNTED + number, unknown);
                unknown
            }
        }
    }
}

/// Angles that place no body are kept from here on.
const COUNTED: u32 = 1 << 30;
