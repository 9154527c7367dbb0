//! What is looked at together where there are more equations than are needed.
//!
//! In: a [`System`]. Out: [`Piece`]s in order, which in contrast to blocks may have more equations than unknowns. Not done here:
//! numbers, which alone tell equations that follow from others from equations that contradict them.

use super::components;
use super::incidence::Incidence;
use super::matching::{self, Matching};
use crate::model::Model;
use crate::system::System;
use std::collections::BTreeSet;

/// Unknowns that are found together, and all equations that say something about them and about nothing that comes later.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Piece {
    pub(crate) unknowns: Vec<usize>,
    pub(crate) equations: Vec<usize>,
    /// There is more to it than there are unknowns.
    pub(crate) is_surplus: bool,
}

/// Up to this many coordinates everything is looked at together.
const LARGEST: usize = 60;

/// The pieces of a system of which some equations may follow from others; none if there is nothing to ask.
///
/// Where a joint is marked as redundant its equations are the first to be left over.
pub(crate) fn surplus(model: &Model, system: &System) -> Option<Vec<Piece>> {
    let is_marked = |equation: &usize| model.joints[system.equations[*equation].joint].is_redundant;
    if model.equations_only {
        return None;
    }
    let has_mark = model.joints.iter().any(|joint| joint.is_redundant);
    let incidence = Incidence::new(model, system);
    let matching = matching::maximum_in(&incidence, in_turn(model, system));
    if !has_mark && matching.free_equations().is_empty() {
        return None;
    }
    if system.unknowns.len() <= LARGEST {
        let unknowns = (0..system.unknowns.len()).collect();
        return Some(vec![Piece { unknowns, equations: (0..system.equations.len()).collect(), is_surplus: true }]);
    }
    // Where freedoms are left in a large system, drives are what is missing first.
    matching.free_unknowns().is_empty().then(|| in_order(&incidence, &matching, is_marked))
}

/// The equations that are left over by their pattern alone, those of redundant joints before others.
pub(crate) fn left_over(model: &Model, system: &System) -> BTreeSet<usize> {
    let is_marked = |equation: &usize| model.joints[system.equations[*equation].joint].is_redundant;
    let incidence = Incidence::new(model, system);
    matching::maximum_in(&incidence, in_turn(model, system)).free_equations().into_iter().filter(is_marked).collect()
}

/// What moves the mechanism first, so that what is left over are the joints that only follow; redundant ones last.
fn in_turn(model: &Model, system: &System) -> impl Iterator<Item = usize> {
    let rank = |equation: &usize| {
        let joint = &model.joints[system.equations[*equation].joint];
        (joint.is_redundant, !joint.is_drive)
    };
    let mut all: Vec<usize> = (0..system.equations.len()).collect();
    all.sort_by_key(rank);
    all.into_iter()
}

/// Blocks in order, each with the equations left over that belong to it.
fn in_order(incidence: &Incidence, matching: &Matching, is_marked: impl Fn(&usize) -> bool) -> Vec<Piece> {
    let groups = components::in_order(incidence, matching);
    let mut piece_of = vec![0; incidence.unknowns];
    let mut pieces: Vec<Piece> = Vec::new();
    for equations in groups {
        let unknowns: Vec<usize> = equations.iter().filter_map(|equation| matching.of_equation[*equation]).collect();
        unknowns.iter().for_each(|unknown| piece_of[*unknown] = pieces.len());
        let is_surplus = equations.iter().any(&is_marked);
        pieces.push(Piece { unknowns, equations, is_surplus });
    }
    for equation in matching.free_equations() {
        let last = incidence.rows[equation].iter().map(|entry| piece_of[entry.unknown]).max();
        if let Some(piece) = last.and_then(|last| pieces.get_mut(last)) {
            piece.equations.push(equation);
            piece.is_surplus = true;
        }
    }
    let wider: Vec<(usize, Piece)> = (0..pieces.len())
        .filter(|index| pieces[*index].is_surplus)
        .map(|index| (index, with_upstream(incidence, &pieces, &piece_of, index)))
        .collect();
    for (index, piece) in wider {
        pieces[index] = piece;
    }
    pieces
}

/// A piece together with what is next upstream of it: equations that are too many follow from equations there.
fn with_upstream(incidence: &Incidence, pieces: &[Piece], piece_of: &[usize], index: usize) -> Piece {
    let mut found = vec![index];
    let mut wide = pieces[index].clone();
    let mut next = 0;
    while let Some(piece) = found.get(next).map(|index| &pieces[*index]) {
        for entry in piece.equations.iter().flat_map(|equation| &incidence.rows[*equation]) {
            let upstream = piece_of[entry.unknown];
            if !found.contains(&upstream) && wide.unknowns.len() + pieces[upstream].unknowns.len() <= LARGEST {
                found.push(upstream);
                wide.unknowns.extend(&pieces[upstream].unknowns);
                wide.equations.extend(&pieces[upstream].equations);
            }
        }
        next += 1;
    }
    wide
}
