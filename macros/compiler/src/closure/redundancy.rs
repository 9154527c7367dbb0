//! Equations that follow from others wherever the mechanism can be: redundant ones, in contrast to those that are so at a single
//! position only, which is then singular.
//!
//! In: a [`System`], of which it may not yet be known how it is solved. Out: the equations of redundant joints that are checked
//! instead of solved; a refusal for every other joint that adds nothing or contradicts the rest. The parameters are the declared
//! ones: the third crank of a parallelogram is redundant although with other lengths it would not close. Not done here: counting,
//! which is the work of `structure/verdict.rs`; so is what over-determines the drives.

use super::order::Assembled;
use super::rank::{Basis, Matrix};
use super::rows::Rows;
use super::tour::Tour;
use super::{LARGEST, Room, with_room};
use crate::diag::{Diag, Fact};
use crate::model::{Model, Said};
use crate::structure::{self, Block, Piece, Structure};
use crate::syntax::ast::Closing;
use crate::system::System;
use std::collections::{BTreeMap, BTreeSet};

/// The equations that are checked instead of solved. Where `#[closure(…)]` accepts defaults that are placeholders their pattern decides.
///
/// Where there are too many equations, or joints are marked as redundant, it is found out by numbers which of them follow from
/// others. Of those that are marked as many are left out as can be, and as few taken as have to be: those that are farthest from
/// singular over the motion.
pub(crate) fn surplus(model: &Model, system: &System, diag: &mut Diag) -> Option<BTreeSet<usize>> {
    if model.closing != Closing::Deny {
        // Numbers that are placeholders tell nothing.
        return Some(structure::left_over(model, system));
    }
    let Some(pieces) = structure::surplus(model, system) else { return Some(BTreeSet::new()) };
    with_room(model, system, |room| {
        let mut search = Search { room, pieces: &pieces, said: Said::default(), diag };
        let checked = search.surplus();
        search.diag.is_clean().then_some(checked)
    })
}

/// Refuses a mechanism that has as many equations as it needs, of which some say the same wherever it stands.
///
/// A mechanism that is singular at its start only, or that cannot be moved from there, is none of this: it stands at a dead point.
pub(super) fn equations_are_independent(room: &Room, structure: &Structure, start: &[f64], diag: &mut Diag) -> Option<()> {
    if room.model.closing == Closing::Deny && room.has_singular_block(structure, start) {
        let pieces = pieces(room.system, structure);
        Search { room, pieces: &pieces, said: Said::default(), diag }.dependence(start);
    }
    diag.is_clean().then_some(())
}

/// Refuses a drive of what joints hold already, such as one between two sides of a triangle: without it everything closes, and wherever
/// the mechanism is then pushed, the equation of the drive follows from those of joints. Its pattern does not show that.
pub(super) fn drives_have_something_to_drive(room: &Room, structure: &Structure, assembled: &Assembled, diag: &mut Diag) -> Option<()> {
    let is_suspicious = assembled.open.is_some() || room.has_singular_block(structure, &assembled.start);
    if room.system.unknowns.len() > LARGEST || !is_suspicious {
        return Some(());
    }
    let pieces = pieces(room.system, structure);
    let piece = pieces.first()?;
    let names = |joints: BTreeSet<usize>| joints.iter().map(|joint| room.model.joints[*joint].name.to_string()).collect();
    for (drive, declared) in room.model.joints.iter().enumerate().filter(|(_, joint)| joint.is_drive) {
        let is_of_it = |equation: usize| room.system.equations[equation].joint == drive;
        let there = || (assembled.start.clone(), true);
        let (q, is_closed) = if assembled.open.is_none() { there() } else { room.assembled_in_pieces(&pieces, is_of_it) };
        if !is_closed {
            continue;
        }
        let poses = room.matrices(piece, &room.pushed(&pieces, q, is_of_it));
        let mut basis = Basis::new(&poses);
        let (own, others): (Vec<usize>, Vec<usize>) = room.rows(piece).plain.into_iter().partition(|row| is_of_it(piece.equations[*row]));
        others.into_iter().for_each(|row| basis.take(row));
        let joints: BTreeSet<usize> = own
            .into_iter()
            .filter(|row| poses.len() > 2 && !basis.lacks(*row))
            .flat_map(|row| basis.sources(row))
            .map(|row| room.system.equations[piece.equations[row]].joint)
            .collect();
        if !joints.is_empty() && joints.iter().all(|joint| !room.model.joints[*joint].is_drive) {
            let free = room.names(piece, &basis.free(piece.unknowns.len()));
            let fact = Fact::NothingToDrive {
                drive: declared.name.to_string(),
                joints: names(joints),
                equations: [0; 2],
                coordinates: Vec::new(),
                free,
            };
            return diag.refuse(&declared.name, fact);
        }
    }
    Some(())
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
    let checked: BTreeSet<usize> = structure.checked.iter().copied().collect();
    let equations = (0..system.equations.len()).filter(|equation| !checked.contains(equation)).collect();
    vec![Piece { unknowns: (0..system.unknowns.len()).collect(), equations, is_surplus: true }]
}

/// What is looked through.
pub(super) struct Search<'a, 'b> {
    pub(super) room: &'a Room<'b>,
    pub(super) pieces: &'a [Piece],
    /// An item of a loop stands many times; what is wrong with it is said of the first.
    said: Said,
    pub(super) diag: &'a mut Diag,
}

impl Search<'_, '_> {
    fn surplus(&mut self) -> BTreeSet<usize> {
        let nothing = |_: usize| false;
        let (start, is_closed) = self.room.assembled_in_pieces(self.pieces, nothing);
        if !is_closed {
            self.contradiction(&self.room.least_open(self.pieces, start));
            return BTreeSet::new();
        }
        let tour = self.room.tour(self.pieces, &start, nothing);
        if !tour.holds {
            self.contradiction_on_the_way(&start);
            return BTreeSet::new();
        }
        let pieces: Vec<&Piece> = self.pieces.iter().filter(|piece| piece.is_surplus).collect();
        let checked = pieces.iter().flat_map(|piece| self.left_over(piece, &tour)).collect();
        if self.diag.is_clean() {
            self.contradiction_of_checks(&start, &checked);
        }
        checked
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
            if !self.said.is_new(name) {
                continue;
            }
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
        let mut of_joint: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        dependent.iter().for_each(|row| of_joint.entry(joint(row)).or_default().push(*row));
        for (index, own) in of_joint {
            let sources: BTreeSet<usize> = own.iter().flat_map(|row| basis.sources(*row)).map(|row| joint(&row)).collect();
            if sources.is_empty() {
                // It has no slope, as the square of what vanishes: nothing can be solved for by it, and it follows from nothing.
                continue;
            }
            let model = self.room.model;
            let others = sources.iter().filter(|other| **other != index).map(|other| model.joints[*other].name.to_string()).collect();
            let name = &model.joints[index].name;
            if !self.said.is_new(name) {
                continue;
            }
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
}
