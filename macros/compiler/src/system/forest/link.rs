//! Binary links: bodies held by a ball and a universal joint alone.
//!
//! ```text
//! d = r_Q − r_P                        from the ball P to the cross Q, points of the neighbours
//! Φ = d · d − l²                       one row for the three of the second joint
//! x = d/l,  z = ± x × v/|x × v|        v: the arm of the cross in the neighbour, z: the one in the link
//! ω = x × ẋ + σ x                      n · (ω − ω_v) = 0 with n = z × v gives σ
//! ```
//!
//! The orientation of a link is computed after its neighbours have been placed. The sign is that of the declared start; where x lies along v,
//! the cross folds, and there is no orientation.

use super::super::rows::Row;
use super::Forest;
use crate::expr::{Exact, Expr, Frame, Jets, Leaf, Seed, Triple, cross, derivative, dot};
use crate::model::{DECLARED, Place, Relationship, Triad};
use crate::quantity::{Ambient, Dim, Role};
use crate::syntax::ast::Task;
use std::collections::BTreeSet;

/// The cross counts as folded where sin² of the angle between the link and the arm in its neighbour is below 1/2⁵².
const FOLDED: i128 = 1 << 52;

/// A body held by a ball and a universal joint alone.
#[derive(Clone, Copy)]
pub(super) struct BinaryLink {
    body: usize,
    /// Joint of the ball.
    ball: usize,
    /// Joint and first row of the second pair of points.
    second: (usize, usize),
    /// Joint and row of the perpendicular arms.
    arms: (usize, usize),
    /// Ends of d, in the neighbours.
    ends: [Place; 2],
    /// Arm of the cross in the neighbour, and in the link.
    arm: [Place; 2],
    /// From the ball to the cross, in the link.
    along: Triple,
}

/// Directions from which the rotation of a link follows: its own, and that of the arm in its neighbour.
struct LinkDirections {
    x: Triple,
    z: Triple,
    v: Triple,
    /// ± 1/|x × v|
    reach: Expr,
    /// n = z × v
    normal: Triple,
}

impl Forest<'_> {
    /// The binary links of a mechanism; the rows of the second joint, and that of the arms, need not be solved.
    pub(super) fn links(&mut self) -> Vec<BinaryLink> {
        // Where the cross folds, the formula leads to the other side of the link. A step detects that by the previous orientation, which
        // neither states of slices nor integrated states hold.
        if self.model.task == Task::Motion || self.model.methods.iter().any(|method| method.is_slice) {
            return Vec::new();
        }
        let rows = self.rows_of_bodies();
        let links: Vec<BinaryLink> = rows.iter().enumerate().filter_map(|(body, rows)| self.link(body, rows)).collect();
        for link in &links {
            let (joint, first) = link.second;
            self.holding.extend((first..first + 3).map(|row| (joint, row)));
            self.holding.insert(link.arms);
            self.linked.insert(link.body);
        }
        links
    }

    /// The body as a binary link, if it is one.
    ///
    /// * `rows`: given, those in which the body occurs.
    fn link(&mut self, body: usize, rows: &[(usize, usize)]) -> Option<BinaryLink> {
        let relations = &self.model.space.relations;
        let own: Vec<_> = relations.iter().filter(|(_, _, relation)| relation.bodies().contains(&Some(body))).copied().collect();
        let outward = |one: Place, two: Place| if one.body == Some(body) { [two, one] } else { [one, two] };
        let (mut points, mut arms) = (Vec::new(), Vec::new());
        for (joint, row, relation) in &own {
            match *relation {
                Relationship::Coincident(one, two) => points.push((*joint, *row, outward(one, two))),
                Relationship::Perpendicular(one, two) => arms.push((*joint, *row, outward(one, two))),
                _ => return None,
            }
        }
        let ([_, _], [(joint, row, arm)]) = (points.as_slice(), arms.as_slice()) else { return None };
        // The row of the link is that of the joint with the cross.
        points.sort_by_key(|(of, ..)| of == joint);
        let [(ball, _, [p, own_p]), (other, first, [q, own_q])] = [points[0], points[1]];
        let is_held_elsewhere = p.body == q.body || has_other_rows(rows, &own);
        if is_held_elsewhere || own.iter().any(|(joint, ..)| self.model.joints[*joint].is_redundant) {
            return None;
        }
        let along = [0, 1, 2].map(|k| self.arena.sub(own_q.local[k], own_p.local[k]));
        let across = dot(self.arena, along, arm[1].local);
        let [across, square] = [across, dot(self.arena, along, along)].map(|part| self.arena.snapped(part));
        let is_zero = |expr: Expr| self.arena.as_constant(expr).is_some_and(|value| value.is_zero());
        let is_link = is_zero(across) && !is_zero(square);
        is_link.then_some(BinaryLink { body, ball, second: (other, first), arms: (*joint, *row), ends: [p, q], arm: *arm, along })
    }

    /// By body, the joint and number of each row that depends on it.
    fn rows_of_bodies(&self) -> Vec<Vec<(usize, usize)>> {
        let mut rows = vec![Vec::new(); self.model.bodies.len()];
        let body = |leaf: Leaf| match leaf {
            Leaf::Coordinate(number) => Some(number.checked_sub(DECLARED)? as usize / Role::SPACE.len()),
            Leaf::Speed(number) => Some(Ambient::Space.body_of(number.checked_sub(DECLARED)? as usize)),
            _ => None,
        };
        for (joint, declared) in self.model.joints.iter().enumerate() {
            for (row, residual) in declared.residuals.iter().enumerate() {
                let bodies: BTreeSet<usize> = self.model.arena.leaves(residual.expr).into_iter().filter_map(body).collect();
                // Angles and displacements of joints have the numbers after those of the bodies.
                for body in bodies {
                    if let Some(rows) = rows.get_mut(body) {
                        rows.push((joint, row));
                    }
                }
            }
        }
        rows
    }

    /// The row of a link and its frame, once its neighbours have theirs.
    pub(super) fn hang(&mut self, link: &BinaryLink) {
        let [p, q] = link.ends.map(|end| self.point(end));
        let d = [0, 1, 2].map(|k| self.arena.sub(q[k], p[k]));
        let [reach, length] = [d, link.along].map(|vector| dot(self.arena, vector, vector));
        let phi = self.arena.sub(reach, length);
        let (joint, row) = link.second;
        let dim = Dim::LENGTH.times(Dim::LENGTH);
        self.rows.push(Row { joint, row, dim, residual: phi, is_velocity: false, is_initial: false });
        let length = self.arena.sqrt(length);
        let one = self.arena.integer(1);
        let short = self.arena.div(one, length);
        let x = d.map(|part| self.arena.mul(part, short));
        self.hang_along(link, x);
    }

    /// A vector along the line between the joints of a binary link, in ground: it does not turn with the arms.
    pub(super) fn along_link(&mut self, place: Place) -> Option<Triple> {
        let (triad, x) = *self.lines_of_links.get(&place.body?)?;
        let [along, y, z] = triad.axes.map(|axis| {
            let part = dot(self.arena, place.local, axis);
            self.arena.snapped(part)
        });
        let is_zero = |part: Expr| self.arena.as_constant(part).is_some_and(|value| value.is_zero());
        (is_zero(y) && is_zero(z)).then(|| x.map(|part| self.arena.mul(along, part)))
    }

    fn hang_along(&mut self, link: &BinaryLink, x: Triple) {
        let v = self.vector(link.arm[0]);
        let across = cross(self.arena, x, v);
        let square = dot(self.arena, across, across);
        // Where the cross folds, the turning about the line is not determined: no number is better than any.
        let (least, zero) = (self.arena.constant(Exact::ratio(1, FOLDED).unwrap_or(Exact::ZERO)), self.arena.integer(0));
        let square = self.arena.select(square, least, zero, square);
        let height = self.arena.sqrt(square);
        let sign = if self.is_start_inverted(link) { -1 } else { 1 };
        let one = self.arena.integer(sign);
        let reach = self.arena.div(one, height);
        let z = across.map(|part| self.arena.mul(part, reach));
        let normal = cross(self.arena, z, v);
        let y = cross(self.arena, z, x);
        let triad = Triad::along(self.arena, link.arm[1], link.along);
        let columns = self.columns(triad, [x, y, z]);
        self.lines_of_links.insert(link.body, (triad, x));
        let directions = LinkDirections { x, z, v, reach, normal };
        let neighbour = link.arm[0].body.and_then(|body| self.frames[body]);
        let mut own = self.arena.leaves_of(&x);
        own.extend(neighbour.iter().flat_map(|frame| self.arena.frame(*frame).turns.iter().map(|(leaf, _)| *leaf)));
        own.retain(|leaf| matches!(leaf, Leaf::Coordinate(_)));
        let turns = own.iter().map(|leaf| (*leaf, self.turn_of(&directions, neighbour, *leaf))).collect();
        let rates: Vec<Option<u32>> = (0..self.coordinates.len() as u32).map(Some).collect();
        let [velocity, acceleration] = self.motion_of(&directions, neighbour, Seed::motion(rates.clone()));
        let [_, steady] = self.motion_of(&directions, neighbour, Seed::constant_speeds(rates));
        let own = own.into_iter().collect();
        let frame = Frame { columns, velocity, acceleration, acceleration_at_constant_speeds: steady, turns, against: None, own };
        self.frames[link.body] = Some(self.arena.add_frame(frame));
        self.reached[link.body] = Some((link.ball, link.ends[0].body));
    }

    /// The turn with a coordinate.
    fn turn_of(&mut self, directions: &LinkDirections, neighbour: Option<usize>, by: Leaf) -> Triple {
        let zero = self.arena.integer(0);
        let rate = directions.x.map(|part| derivative(self.arena, part, by));
        let turns = neighbour.map(|frame| &self.arena.frame(frame).turns);
        let of_arm = turns.and_then(|turns| turns.iter().find(|(leaf, _)| *leaf == by)).map_or([zero; 3], |(_, turn)| *turn);
        self.turned_with(directions, rate, of_arm)
    }

    /// x × ẋ + σ x
    fn turned_with(&mut self, directions: &LinkDirections, rate: Triple, of_arm: Triple) -> Triple {
        let across = cross(self.arena, directions.x, rate);
        let spin = self.spin(directions, of_arm, across);
        self.plus(across, directions.x, spin)
    }

    /// The σ for which n · (a + σ x) = n · b.
    fn spin(&mut self, directions: &LinkDirections, b: Triple, a: Triple) -> Expr {
        let rest = [0, 1, 2].map(|k| self.arena.sub(a[k], b[k]));
        let along = dot(self.arena, rest, directions.normal);
        // n · x = −1/reach
        self.arena.mul(directions.reach, along)
    }

    /// ω and ω̇.
    fn motion_of(&mut self, directions: &LinkDirections, neighbour: Option<usize>, seed: Seed) -> [Triple; 2] {
        let zero = self.arena.integer(0);
        let is_steady = !seed.speeds_change();
        let [of_arm, growth] = neighbour.map_or([[zero; 3]; 2], |frame| {
            let frame = self.arena.frame(frame);
            [frame.velocity, if is_steady { frame.acceleration_at_constant_speeds } else { frame.acceleration }]
        });
        let mut jets = Jets::along(seed);
        let jets = directions.x.map(|part| jets.of(self.arena, part));
        let [rate, second] = [1, 2].map(|order| jets.map(|jet| jet[order]));
        let across = cross(self.arena, directions.x, rate);
        let sigma = self.spin(directions, of_arm, across);
        let velocity = self.plus(across, directions.x, sigma);
        // ω̇ = x × ẍ + σ ẋ + σ̇ x, and n · (ω̇ − ω̇_v) = −ṅ · (ω − ω_v)
        let bent = cross(self.arena, directions.x, second);
        let bent = self.plus(bent, rate, sigma);
        let against = [0, 1, 2].map(|k| self.arena.sub(velocity[k], of_arm[k]));
        let (of_z, of_v) = (cross(self.arena, velocity, directions.z), cross(self.arena, of_arm, directions.v));
        let (one, two) = (cross(self.arena, of_z, directions.v), cross(self.arena, directions.z, of_v));
        let normal = [0, 1, 2].map(|k| self.arena.add(one[k], two[k]));
        let swing = dot(self.arena, normal, against);
        let swing = self.arena.mul(directions.reach, swing);
        let sigma = self.spin(directions, growth, bent);
        let sigma = self.arena.add(sigma, swing);
        [velocity, self.plus(bent, directions.x, sigma)]
    }

    /// a + s b
    fn plus(&mut self, a: Triple, b: Triple, s: Expr) -> Triple {
        [0, 1, 2].map(|k| {
            let part = self.arena.mul(s, b[k]);
            self.arena.add(a[k], part)
        })
    }

    /// True if the arm in the link lies against x × v at the declared start.
    fn is_start_inverted(&mut self, link: &BinaryLink) -> bool {
        let [v, z] = link.arm.map(|arm| self.at_start(arm));
        let d = if self.has_orientation(link.body) {
            self.at_start(Place { body: Some(link.body), local: link.along })
        } else {
            let [p, q] = link.ends.map(|end| self.point_at_start(end));
            [0, 1, 2].map(|k| self.arena.sub(q[k], p[k]))
        };
        let across = cross(self.arena, d, v);
        let side = dot(self.arena, across, z);
        self.at_defaults(side).is_some_and(|value| value < 0.0)
    }
}

/// True if there are other rows than those of relations.
fn has_other_rows(rows: &[(usize, usize)], relations: &[(usize, usize, Relationship)]) -> bool {
    let stated: BTreeSet<(usize, usize)> =
        relations.iter().flat_map(|(joint, row, relation)| (0..relation.rows()).map(move |k| (*joint, row + k))).collect();
    rows.iter().any(|row| !stated.contains(row))
}
