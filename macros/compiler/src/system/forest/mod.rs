//! Unknowns in space: positions, angles and displacements of joints, and quaternions only of bodies whose joints define no angle.
//!
//! ```text
//! parallel axes              A_j = A_i T_i R_z(θ) T_jᵀ                 one angle for two rows
//! equal triads               A_j = A_i T_i T_jᵀ                        no unknown for three rows
//! perpendicular vectors      A_j = A_i T_i R_z(α) R_x(90°) R_z(β) T_jᵀ  two angles for one row
//! no relation                A_j = A(e),  e · e = 1                    four components, one row more
//! point on a line            r_Q = r_P + s z                           one displacement, three rows for two
//! ```
//!
//! Where axes point against each other at the declared start, T_j is half turned about its x axis; equal triads may be half turned about any axis.
//!
//! Bodies are reached from ground, each by one relation. Rows of relations that reached a body hold by construction and are not solved.

mod balls;
mod directions;
mod lines;
mod link;
mod orientation;
mod rewrite;
mod start;

use super::rows::Row;
use super::{Balance, Choice, Coordinate, InSpace, LoadEquations};
use crate::expr::{Arena, Expr, Leaf, Lookup, Triple};
use crate::model::{DECLARED, Model, Place, Relationship, Triad};
use crate::quantity::{Ambient, Axis, Role};
use crate::syntax::ast::Task;
use std::collections::{BTreeMap, BTreeSet};

/// Unknowns and rows of a mechanism in space.
pub(super) struct Forest<'a> {
    model: &'a Model,
    arena: &'a mut Arena,
    free_speeds: FreeSpeeds,
    /// Frame of each body in the arena.
    frames: Vec<Option<usize>>,
    /// Number of relations between ground and the body.
    depths: Vec<usize>,
    coordinates: Vec<Coordinate>,
    /// For each body the joint whose relation reached it, and the body from which.
    reached: Vec<Option<(usize, Option<usize>)>>,
    /// For bodies without a declared orientation, the axes at the start, as their joints turn them.
    started: BTreeMap<usize, Started>,
    /// For bodies without a declared position, the position at the start, as their joints place them.
    origins: BTreeMap<usize, Triple>,
    /// Bodies that turn to their declared place at the start, and those that keep the orientation of such a body.
    placed: BTreeSet<usize>,
    /// Bodies without a declared start that a drive turns, and those that keep the orientation of such a body.
    driven: BTreeSet<usize>,
    /// Bodies with a declared orientation that no start of an angle expresses, since the orientation of the body that they are reached from is not
    /// known.
    turned: BTreeSet<usize>,
    /// Angles between triads.
    angles: Vec<(Triad, Triad, Expr)>,
    /// Displacements along lines that place a body, by number of the quantity.
    displacements: Lookup<u32, Expr>,
    /// Angles that joints name but that place no body, by number of the quantity.
    further_angles: BTreeMap<u32, Expr>,
    /// True if a triad was half turned towards its declared start.
    has_opposed: bool,
    /// Binary links, which are placed last.
    linked: BTreeSet<usize>,
    /// The triad of each placed binary link, and its x axis in ground.
    lines_of_links: BTreeMap<usize, (Triad, Triple)>,
    /// Rows that hold by construction.
    holding: BTreeSet<(usize, usize)>,
    rows: Vec<Row>,
    rewritten: Lookup<Expr, Expr>,
}

/// A body at the start whose orientation is not declared.
#[derive(Clone, Copy, Debug)]
struct Started {
    /// Columns of its rotation matrix.
    columns: [Triple; 3],
    /// The triad that it was reached from.
    inner: Triad,
    /// Its own triad.
    outer: Triad,
    /// True if it turns against the triad that it was reached from, about the z axis.
    is_hinged: bool,
}

/// Speeds of bodies that are free to turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FreeSpeeds {
    /// The rates of the quaternion.
    OfQuaternion,
    /// Components of ω, with the numbers of the first three components of the quaternion. The row of the norm is empty.
    Spin,
}

/// Chooses the unknowns of a mechanism in space, and writes its rows and outputs in them.
pub(super) fn reduce(model: &Model, arena: &mut Arena, free_speeds: FreeSpeeds) -> Choice {
    let bodies = model.bodies.len();
    let mut forest = Forest {
        model,
        arena,
        free_speeds,
        frames: vec![None; bodies],
        depths: vec![usize::MAX; bodies],
        coordinates: Vec::new(),
        reached: vec![None; bodies],
        started: BTreeMap::new(),
        origins: BTreeMap::new(),
        placed: BTreeSet::new(),
        driven: BTreeSet::new(),
        turned: BTreeSet::new(),
        angles: Vec::new(),
        displacements: Lookup::default(),
        further_angles: BTreeMap::new(),
        has_opposed: false,
        linked: BTreeSet::new(),
        lines_of_links: BTreeMap::new(),
        holding: BTreeSet::new(),
        rows: Vec::new(),
        rewritten: Lookup::default(),
    };
    forest.positions();
    let links = forest.links();
    forest.orientations();
    forest.lines();
    links.iter().for_each(|link| forest.hang(link));
    forest.declared_rows();
    forest.rows.sort_by_key(|row| row.joint);
    let outputs = model.outputs.iter().map(|output| output.components.iter().map(|part| forest.rewrite(*part)).collect()).collect();
    let spins = forest.spins();
    let balance = (model.task == Task::Motion).then(|| Balance::declared(model, forest.arena, &spins).map(|expr| forest.rewrite(expr)));
    let is_loaded = model.task.is_determined();
    let aligned = if is_loaded { forest.aligned() } else { BTreeMap::new() };
    let loads = is_loaded.then(|| LoadEquations::declared(model, forest.arena, &aligned)).flatten();
    let loads = loads.map(|loads| loads.map(|expr| forest.rewrite(expr)));
    let further_angles = forest.rows_of_further_angles();
    forest.rows.sort_by_key(|row| row.joint);
    let frames: Vec<usize> = forest.frames.iter().map(|frame| frame.unwrap_or(0)).collect();
    let balance = balance.map(|balance| balance.by_unknowns(forest.arena, &frames, forest.coordinates.len()));
    let loads = loads.map(|loads| loads.by_state(forest.arena, &frames, forest.coordinates.len()));
    let off_starts = forest.off_starts();
    let links = forest.linked.into_iter().collect();
    Choice {
        coordinates: forest.coordinates,
        rows: forest.rows,
        outputs,
        frames,
        space: InSpace {
            reached: forest.reached,
            links,
            off_starts,
            further_angles,
            has_opposed: forest.has_opposed,
            turned: forest.turned,
        },
        balance,
        loads,
    }
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
        [0, 1, 2].map(|axis| self.arena.leaf(Leaf::Coordinate((Ambient::Space.first_coordinate(body) + axis) as u32)))
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
            } else if let Some(body) = (0..self.frames.len()).find(|body| self.frames[*body].is_none() && !self.linked.contains(body)) {
                self.free(body);
            } else {
                return;
            }
        }
    }

    /// The relation that reaches a new body by the fewest unknowns, of these one with a declared start, and of these the nearest to ground.
    fn next_relation(&self) -> Option<(usize, usize, Relationship)> {
        let rank = |(joint, _, relation): &&(usize, usize, Relationship)| {
            let unknowns = match relation {
                Relationship::SameOrientation(..) | Relationship::Equal(..) => 0,
                Relationship::SameDirection(..) => 1,
                Relationship::Perpendicular(..) => 2,
                Relationship::Coincident(..) | Relationship::OnLine(..) => return None,
            };
            if self.has_link(relation) {
                return None;
            }
            match relation.bodies().map(|body| self.depth(body)) {
                [Some(depth), None] | [None, Some(depth)] => {
                    let has_start = matches!(relation, Relationship::SameDirection(one, two) if self.starts_between(*one, *two));
                    Some((self.model.joints[*joint].is_redundant, unknowns, !has_start, depth))
                }
                _ => None,
            }
        };
        let relations = self.model.space.relations.iter();
        relations.filter_map(|relation| Some((rank(&relation)?, relation))).min_by_key(|(rank, _)| *rank).map(|(_, relation)| *relation)
    }

    /// True if one of the bodies is a binary link.
    fn has_link(&self, relation: &Relationship) -> bool {
        relation.bodies().into_iter().flatten().any(|body| self.linked.contains(&body))
    }

    fn reach(&mut self, joint: usize, row: usize, relation: Relationship) {
        self.holding.extend((0..relation.rows()).map(|offset| (joint, row + offset)));
        match relation {
            Relationship::SameOrientation(one, two) => {
                let (inner, outer) = self.inward(one, two);
                let outer = self.facing_in_all(inner, outer);
                self.reach_without_angle(joint, inner, outer);
            }
            Relationship::Equal(one, two) => {
                let (inner, outer) = self.inward(one, two);
                self.reach_without_angle(joint, inner, outer);
            }
            Relationship::SameDirection(one, two) => self.reach_by_angle(joint, one, two),
            Relationship::Perpendicular(one, two) => self.reach_by_two_angles((joint, row), one, two),
            Relationship::Coincident(..) | Relationship::OnLine(..) => {}
        }
    }

    /// The triad of the body that has been reached, and that of the other.
    fn inward(&self, one: Triad, two: Triad) -> (Triad, Triad) {
        if self.depth(one.body).is_some() { (one, two) } else { (two, one) }
    }

    /// A joint of a body.
    fn a_joint_of(&self, body: usize) -> usize {
        let first = DECLARED + (Role::SPACE.len() * body) as u32;
        let own = first..first + Role::SPACE.len() as u32;
        let is_of =
            |expr: Expr| self.model.arena.leaves(expr).iter().any(|leaf| matches!(leaf, Leaf::Coordinate(number) if own.contains(number)));
        self.model.joints.iter().position(|joint| joint.residuals.iter().any(|residual| is_of(residual.expr))).unwrap_or(0)
    }

    /// The axes of a triad in ground.
    fn in_ground(&mut self, triad: Triad) -> [Triple; 3] {
        triad.axes.map(|axis| self.vector(Place { body: triad.body, local: axis }))
    }

    /// A vector fixed in a body, in ground.
    fn vector(&mut self, place: Place) -> Triple {
        if let Some(along) = self.along_link(place) {
            return along;
        }
        match place.body.and_then(|body| self.frames[body]) {
            Some(frame) => self.arena.turned(frame, place.local),
            None => place.local,
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
}
