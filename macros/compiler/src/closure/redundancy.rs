//! Equations that follow from others wherever the mechanism can be: redundant ones, in contrast to those that are so at a single
//! position only, which is then singular.
//!
//! In: a [`System`], of which it may not yet be known how it is solved. Out: the equations of redundant joints that are checked
//! instead of solved; a refusal for every other joint that adds nothing or contradicts the rest. The parameters are the declared
//! ones: the third crank of a parallelogram is redundant although with other lengths it would not close. Not done here: counting,
//! which is the work of `structure/verdict.rs`; so is what over-determines the drives.

use super::rank::{Basis, Matrix};
use super::tour::{Pose, Tour, with_room};
use super::{Closure, LARGEST, Room};
use crate::diag::{Diag, Fact};
use crate::expr::{Evaluator, Expr, Values, evaluate};
use crate::model::{Dim, Joint, Model};
use crate::structure::{self, Block, Piece, Structure};
use crate::system::{Equation, System};
use std::collections::{BTreeMap, BTreeSet};

/// Of so many joints, the last declared, it is tried whether the rest closes without them.
const MOST_TRIES: usize = 12;

/// The equations that are checked instead of solved.
///
/// Where there are too many equations, or joints are marked as redundant, it is found out by numbers which of them follow from
/// others. Of those that are marked as many are left out as can be, and as few taken as have to be: those that are farthest from
/// singular over the motion.
pub(crate) fn surplus(model: &Model, system: &System, diag: &mut Diag) -> Option<BTreeSet<usize>> {
    let Some(pieces) = structure::surplus(model, system) else { return Some(BTreeSet::new()) };
    with_room(model, system, |room| {
        let mut search = Search { room, pieces: &pieces, diag };
        let checked = search.surplus();
        search.diag.is_clean().then_some(checked)
    })
}

/// Refuses a mechanism that has as many equations as it needs, of which some say the same wherever it stands.
///
/// A mechanism that is singular at its start only, or that cannot be moved from there, is none of this: it stands at a dead point.
pub(crate) fn equations_are_independent(
    model: &Model,
    system: &System,
    structure: &Structure,
    closure: &Closure,
    diag: &mut Diag,
) -> Option<()> {
    if model.equations_only || !closure.is_closed {
        return Some(());
    }
    with_room(model, system, |room| {
        if room.has_singular_block(structure, &closure.start) {
            let pieces = pieces(system, structure);
            Search { room, pieces: &pieces, diag }.dependence(&closure.start);
        }
    });
    diag.is_clean().then_some(())
}

/// The equations that are solved: of a small system all together, of a large one block by block.
fn pieces(system: &System, structure: &Structure) -> Vec<Piece> {
    let piece = |block: &Block| Piece {
        unknowns: block.explicit.iter().map(|explicit| explicit.unknown).chain(block.iterated.iter().copied()).collect(),
        equations: block.explicit.iter().map(|explicit| explicit.equation).chain(block.residuals.iter().copied()).collect(),
        is_surplus: !block.iterated.is_empty(),
    };
    let pieces: Vec<Piece> = structure.blocks.iter().map(piece).collect();
    if system.unknowns.len() > LARGEST {
        return pieces;
    }
    let equations = (0..system.equations.len()).filter(|equation| !structure.checked.contains(equation)).collect();
    vec![Piece { unknowns: (0..system.unknowns.len()).collect(), equations, is_surplus: true }]
}

/// What is looked through.
struct Search<'a, 'b> {
    room: &'a Room<'b>,
    pieces: &'a [Piece],
    diag: &'a mut Diag,
}

impl Search<'_, '_> {
    fn surplus(&mut self) -> BTreeSet<usize> {
        let nothing = |_: usize| false;
        let (start, is_closed) = self.room.assembled(self.pieces, nothing);
        if !is_closed {
            self.contradiction(&self.room.least_open(self.pieces));
            return BTreeSet::new();
        }
        let tour = self.room.tour(self.pieces, &start, nothing);
        if !tour.holds {
            self.contradiction_on_the_way(&start);
            return BTreeSet::new();
        }
        let pieces: Vec<&Piece> = self.pieces.iter().filter(|piece| piece.is_surplus).collect();
        pieces.iter().flat_map(|piece| self.left_over(piece, &tour)).collect()
    }

    /// The equations of a piece that are left over; those that are not marked are refused.
    fn left_over(&mut self, piece: &Piece, tour: &Tour) -> Vec<usize> {
        let poses = self.room.matrices(piece, &tour.poses);
        let rows = self.room.rows(piece);
        let mut basis = Basis::new(&poses);
        let dependent: Vec<usize> = rows.plain.iter().copied().filter(|row| !basis.takes(*row)).collect();
        // A drive that adds nothing is a matter of mobility.
        let dependent: Vec<usize> = dependent.into_iter().filter(|row| !self.room.joint(piece, *row).is_drive).collect();
        let free = if rows.marked.is_empty() { self.room.names(piece, &basis.free(piece.unknowns.len())) } else { Vec::new() };
        self.refuse_dependent(&basis, piece, &dependent, &free, tour.moves);
        if !self.diag.is_clean() {
            return Vec::new();
        }
        let mut open = rows.marked.clone();
        // One after the other the best of those that still add something.
        loop {
            let candidates = open.iter().copied().filter(|row| basis.lacks(*row)).map(|row| (row, basis.fitness(row)));
            let Some((best, _)) = candidates.reduce(|best, next| if next.1 > best.1 + 1e-9 { next } else { best }) else { break };
            basis.take(best);
            open.retain(|row| *row != best);
        }
        self.marks_are_meant(&basis, piece, &rows, &open, &poses);
        open.into_iter().map(|row| piece.equations[row]).collect()
    }

    /// Every joint that is marked as redundant has an equation that follows from others.
    fn marks_are_meant(&mut self, basis: &Basis, piece: &Piece, rows: &Rows, left_over: &[usize], poses: &[Matrix]) {
        let joint = |row: &usize| self.room.system.equations[piece.equations[*row]].joint;
        let involved: BTreeSet<usize> =
            left_over.iter().flat_map(|row| basis.sources(*row).into_iter().chain([*row])).map(|row| joint(&row)).collect();
        let marked: BTreeSet<usize> = rows.marked.iter().map(joint).collect();
        for needed in marked.difference(&involved) {
            let mut without = Basis::new(poses);
            for row in rows.plain.iter().chain(&rows.marked).filter(|row| joint(row) != *needed) {
                without.takes(*row);
            }
            let free = self.room.names(piece, &without.free(piece.unknowns.len()));
            let name = &self.room.model.joints[*needed].name;
            self.diag.refuse::<()>(name, Fact::NotRedundant { joint: name.to_string(), free });
        }
    }

    /// As many equations as unknowns, and still some that add nothing.
    fn dependence(&mut self, start: &[f64]) {
        let tour = self.room.tour(self.pieces, start, |_| false);
        for piece in self.pieces.iter().filter(|piece| piece.is_surplus) {
            // What is singular where it starts must be so elsewhere, at more than one place.
            if tour.poses.len() < 3 || !self.diag.is_clean() {
                return;
            }
            let poses = self.room.matrices(piece, &tour.poses);
            let mut basis = Basis::new(&poses);
            let dependent: Vec<usize> = self.room.rows(piece).plain.into_iter().filter(|row| !basis.takes(*row)).collect();
            let free = self.room.names(piece, &basis.free(piece.unknowns.len()));
            self.refuse_dependent(&basis, piece, &dependent, &free, tour.moves);
        }
    }

    /// One refusal for each joint with equations that follow from others.
    fn refuse_dependent(&mut self, basis: &Basis, piece: &Piece, dependent: &[usize], free: &[String], moves: bool) {
        let joint = |row: &usize| self.room.system.equations[piece.equations[*row]].joint;
        for index in dependent.iter().map(joint).collect::<BTreeSet<usize>>() {
            let own: Vec<usize> = dependent.iter().copied().filter(|row| joint(row) == index).collect();
            let sources: BTreeSet<usize> = own.iter().flat_map(|row| basis.sources(*row)).map(|row| joint(&row)).collect();
            let model = self.room.model;
            let others = sources.iter().filter(|other| **other != index).map(|other| model.joints[*other].name.to_string()).collect();
            let name = &model.joints[index].name;
            let fact = Fact::FollowsFrom {
                joint: name.to_string(),
                is_drive: model.joints[index].is_drive,
                rows: own.len(),
                of: model.joints[index].residuals.len(),
                others,
                free: free.to_vec(),
                moves,
            };
            self.diag.refuse::<()>(name, fact);
        }
    }

    /// The equations hold nowhere near the start: the last joint without which they do contradicts the others.
    ///
    /// Where freedoms are left, a joint stands in the wrong place, and where the drives alone are too much, the joints make a
    /// structure, which cannot be driven: both is said elsewhere.
    fn contradiction(&mut self, start: &[f64]) {
        let joints = self.joints();
        if self.leaves_freedom(start) {
            return;
        }
        let is_drive = |joint: usize| self.room.model.joints[joint].is_drive;
        let has_drives = joints.iter().any(|joint| is_drive(*joint));
        if has_drives && self.closes_without(start, &is_drive).is_some() {
            return;
        }
        let candidates = joints.iter().rev().copied().filter(|joint| !is_drive(*joint)).take(MOST_TRIES);
        let found = candidates.filter_map(|joint| Some((joint, self.closes_without(start, &|other| other == joint)?))).next();
        if let Some((joint, q)) = found {
            self.refuse_contradiction(joint, &Pose { time: 0.0, q });
        }
    }

    /// There are coordinates of which no equation says anything new.
    fn leaves_freedom(&self, q: &[f64]) -> bool {
        let pose = [Pose { time: 0.0, q: q.to_vec() }];
        self.pieces.iter().filter(|piece| piece.is_surplus).any(|piece| {
            let poses = self.room.matrices(piece, &pose);
            let mut basis = Basis::new(&poses);
            (0..piece.equations.len()).for_each(|row| basis.take(row));
            !basis.free(piece.unknowns.len()).is_empty()
        })
    }

    /// The equations hold at the start, but not when the drives move: a joint that is marked as redundant may be why.
    fn contradiction_on_the_way(&mut self, start: &[f64]) {
        let marked = self.joints().into_iter().rev().filter(|joint| self.room.model.joints[*joint].is_redundant).take(MOST_TRIES);
        for joint in marked {
            let tour = self.room.tour(self.pieces, start, |equation| self.room.system.equations[equation].joint == joint);
            if let (true, Some(pose)) = (tour.holds, tour.poses.get(1)) {
                return self.refuse_contradiction(joint, pose);
            }
        }
    }

    /// An assembly without some joints, near the start.
    fn closes_without(&self, start: &[f64], left_out: &dyn Fn(usize) -> bool) -> Option<Vec<f64>> {
        let leaves_out = |equation: usize| left_out(self.room.system.equations[equation].joint);
        self.room.settled(self.pieces, 0.0, start.to_vec(), leaves_out).or_else(|| {
            let (q, is_closed) = self.room.assembled(self.pieces, leaves_out);
            is_closed.then_some(q)
        })
    }

    /// The joints of all pieces that have too many equations.
    fn joints(&self) -> BTreeSet<usize> {
        let pieces = self.pieces.iter().filter(|piece| piece.is_surplus);
        pieces.flat_map(|piece| &piece.equations).map(|equation| self.room.system.equations[*equation].joint).collect()
    }

    fn refuse_contradiction(&mut self, joint: usize, pose: &Pose) {
        let room = self.room;
        let name = &room.model.joints[joint].name;
        let (length, angle) = room.gap(joint, pose);
        let (bodies, is_redundant) = (room.touched(joint), room.model.joints[joint].is_redundant);
        let fact = Fact::Contradicts { joint: name.to_string(), bodies, length, angle, time: pose.time, is_redundant };
        self.diag.refuse::<()>(name, fact);
    }
}

/// The rows of a piece, in the order in which they are taken.
struct Rows {
    /// Of joints in the order declared, then of drives.
    plain: Vec<usize>,
    /// Of redundant joints.
    marked: Vec<usize>,
}

impl Room<'_> {
    fn joint(&self, piece: &Piece, row: usize) -> &Joint {
        &self.model.joints[self.system.equations[piece.equations[row]].joint]
    }

    fn rows(&self, piece: &Piece) -> Rows {
        let mut all: Vec<usize> = (0..piece.equations.len()).collect();
        all.sort_by_key(|row| (self.joint(piece, *row).is_drive, piece.equations[*row]));
        let (marked, plain) = all.into_iter().partition(|row| self.joint(piece, *row).is_redundant);
        Rows { plain, marked }
    }

    /// The rows of Φ_q that belong to a piece, at each pose, in scaled unknowns and of unit length.
    fn matrices(&self, piece: &Piece, poses: &[Pose]) -> Vec<Matrix> {
        let place: BTreeMap<usize, usize> = piece.unknowns.iter().enumerate().map(|(column, unknown)| (*unknown, column)).collect();
        let equations: Vec<&Equation> = piece.equations.iter().map(|equation| &self.system.equations[*equation]).collect();
        let roots: Vec<Expr> = equations.iter().flat_map(|equation| equation.jacobian.iter().map(|(_, entry)| *entry)).collect();
        let mut evaluator = Evaluator::new(&self.system.arena, &roots);
        let mut values = vec![f64::NAN; roots.len()];
        let matrix = |pose: &Pose| {
            evaluator.run(&Values { time: pose.time, coordinates: &pose.q, ..self.known }, &mut values);
            let mut entries = values.iter();
            let row = |(number, equation): (usize, &&Equation)| {
                let mut row = vec![0.0; piece.unknowns.len()];
                for ((unknown, _), value) in equation.jacobian.iter().zip(&mut entries) {
                    // A function in Rust is not known here: its row is taken for one that has nothing to do with any other.
                    let value = if value.is_finite() { *value } else { 0.1 + (number as f64 * 0.754_877 + *unknown as f64 * 0.569_84).fract() };
                    if let Some(column) = place.get(unknown) {
                        row[*column] = value * self.scale(*unknown);
                    }
                }
                unit(row)
            };
            equations.iter().enumerate().map(row).collect()
        };
        poses.iter().map(matrix).collect()
    }

    /// In one of the blocks the Jacobian of what is iterated, everything explicit put in, is singular.
    fn has_singular_block(&self, structure: &Structure, q: &[f64]) -> bool {
        let roots: Vec<Expr> = self.system.equations.iter().flat_map(|equation| equation.jacobian.iter().map(|(_, entry)| *entry)).collect();
        let values = evaluate(&self.system.arena, &roots, &Values { coordinates: q, ..self.known });
        let mut entries = values.into_iter();
        let rows: Vec<Vec<(usize, f64)>> = self
            .system
            .equations
            .iter()
            .map(|equation| equation.jacobian.iter().zip(&mut entries).map(|((unknown, _), value)| (*unknown, value * self.scale(*unknown))).collect())
            .collect();
        structure.blocks.iter().filter(|block| !block.iterated.is_empty()).any(|block| is_singular(block, &rows))
    }

    /// How far the equations of a joint are from holding: in m, and in rad.
    fn gap(&self, joint: usize, pose: &Pose) -> (Option<f64>, Option<f64>) {
        let known = Values { time: pose.time, coordinates: &pose.q, ..self.known };
        let (mut length, mut angle): (Option<f64>, Option<f64>) = (None, None);
        for equation in self.system.equations.iter().filter(|equation| equation.joint == joint) {
            let roots: Vec<Expr> = equation.phi.into_iter().chain(equation.jacobian.iter().map(|(_, entry)| *entry)).collect();
            let values = evaluate(&self.system.arena, &roots, &known);
            let Some((phi, slopes)) = values.split_first() else { continue };
            if equation.dim == Dim::ANGLE {
                angle = Some(angle.unwrap_or(0.0).hypot(*phi));
            } else {
                // Other quantities count by the way that it takes to make them vanish.
                let along = |index: &usize| self.system.unknowns[equation.jacobian[*index].0].dim == Dim::LENGTH;
                let slope = (0..slopes.len()).filter(along).map(|index| slopes[index].abs()).fold(0.0, f64::max);
                let way = if equation.dim == Dim::LENGTH || slope == 0.0 { *phi } else { phi / slope };
                length = Some(length.unwrap_or(0.0).hypot(way));
            }
        }
        let is_open = |size: f64| move |gap: &f64| *gap > 1e-9 * size;
        (length.filter(is_open(self.size)), angle.filter(is_open(1.0)))
    }

    /// The bodies in the equations of a joint.
    fn touched(&self, joint: usize) -> Vec<String> {
        let equations = self.system.equations.iter().filter(|equation| equation.joint == joint);
        let bodies: BTreeSet<usize> =
            equations.flat_map(|equation| &equation.jacobian).map(|(unknown, _)| self.system.unknowns[*unknown].body).collect();
        bodies.into_iter().map(|body| self.model.bodies[body].name.to_string()).collect()
    }

    /// The coordinates in these columns of a piece.
    fn names(&self, piece: &Piece, columns: &[usize]) -> Vec<String> {
        let name = |column: &usize| {
            let unknown = &self.system.unknowns[piece.unknowns[*column]];
            format!("{}.{}", self.model.bodies[unknown.body].name, unknown.name)
        };
        // Where an angle is free, places mostly follow it.
        let is_angle = |column: &&usize| self.system.unknowns[piece.unknowns[**column]].dim == Dim::ANGLE;
        let angles: Vec<String> = columns.iter().filter(is_angle).map(name).collect();
        if angles.is_empty() { columns.iter().map(name).collect() } else { angles }
    }
}

/// The derivative of a block's residuals by what it iterates is singular, everything explicit put in.
fn is_singular(block: &Block, rows: &[Vec<(usize, f64)>]) -> bool {
    let column = |iterated: &usize| {
        let mut moved: BTreeMap<usize, f64> = BTreeMap::from([(*iterated, 1.0)]);
        let along = |row: &[(usize, f64)], moved: &BTreeMap<usize, f64>| -> f64 {
            row.iter().filter_map(|(unknown, value)| Some(value * moved.get(unknown)?)).sum()
        };
        for explicit in &block.explicit {
            let row = &rows[explicit.equation];
            let pivot = row.iter().find(|(unknown, _)| *unknown == explicit.unknown).map_or(f64::NAN, |(_, value)| *value);
            let way = -along(row, &moved) / pivot;
            moved.insert(explicit.unknown, way);
        }
        block.residuals.iter().map(|equation| along(&rows[*equation], &moved)).collect()
    };
    let columns: Vec<Vec<f64>> = block.iterated.iter().map(column).map(unit).collect();
    if columns.iter().flatten().any(|value| !value.is_finite()) {
        // A function in Rust, of which nothing is known.
        return false;
    }
    let poses = [columns];
    let mut basis = Basis::new(&poses);
    !(0..block.iterated.len()).all(|column| basis.takes(column))
}

/// A row of unit length; one that is zero stays so.
fn unit(mut row: Vec<f64>) -> Vec<f64> {
    let length = row.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
    if length > 0.0 {
        row.iter_mut().for_each(|entry| *entry /= length);
    }
    row
}
