//! A part of a mechanism that can be solved alone: what is upstream of an output, or what moves.
//!
//! In: the stages of a mechanism. Out: [`Slice`]s: some of the stages, and which unknowns a state of the slice must hold so that
//! the next can be found from it. Not done here: printing.

use super::lines::Frame;
use super::solution::{Solution, Solving, solution};
use super::stage::Stage;
use crate::expr::{Arena, Leaf};
use crate::system::OutputMotion;
use std::collections::BTreeSet;

/// A part of a mechanism.
#[derive(Clone, Debug)]
pub struct Slice {
    /// Unknowns of the mechanism whose values are given: they rest, and do not belong to the slice.
    pub given: Vec<usize>,
    /// The unknowns that a state of the slice holds, by their index in q; the components of an output count on from there.
    pub held: Vec<usize>,
    /// How they are found.
    pub solution: Solution,
}

/// What is upstream of an output, with the output as unknowns of their own after those of the mechanism.
pub(super) fn upstream(frame: &Frame, stages: &[Stage], output: &OutputMotion, n: usize) -> Slice {
    let mut needed: BTreeSet<usize> = BTreeSet::new();
    let outputs: Vec<Stage> = output
        .components
        .iter()
        .enumerate()
        .map(|(index, motion)| Stage::Explicit { unknown: n + index, equation: usize::MAX, motion: *motion })
        .collect();
    for stage in &outputs {
        needed.extend(leaves(frame.arena, stage));
    }
    let mut chosen: Vec<Stage> = Vec::new();
    for stage in stages.iter().rev() {
        if stage.unknowns().iter().any(|unknown| needed.contains(unknown)) {
            needed.extend(leaves(frame.arena, stage));
            chosen.push(stage.clone());
        }
    }
    chosen.reverse();
    // What is not upstream may hold or not.
    let found: BTreeSet<usize> = chosen.iter().flat_map(Stage::unknowns).copied().collect();
    let is_upstream = |stage: &&Stage| matches!(stage, Stage::Check { .. }) && leaves(frame.arena, stage).is_subset(&found);
    chosen.extend(stages.iter().filter(is_upstream).cloned());
    chosen.extend(outputs);
    let solution = solution(frame, &chosen, false);
    let held = held(frame, &chosen, &solution.solving, n);
    Slice { given: Vec::new(), held, solution }
}

/// What moves, if there are blocks that do not: these need not be solved for every moment.
pub(super) fn moving(frame: &Frame, stages: &[Stage]) -> Option<Slice> {
    let timed = timed(frame.arena, stages);
    let rests = |stage: &Stage| match stage {
        Stage::Check { .. } => timed.is_disjoint(&leaves(frame.arena, stage)),
        Stage::Explicit { .. } | Stage::Block(_) => !stage.unknowns().iter().any(|unknown| timed.contains(unknown)),
    };
    if !stages.iter().any(|stage| matches!(stage, Stage::Block(_)) && rests(stage)) || stages.iter().all(rests) {
        return None;
    }
    let chosen: Vec<Stage> = stages.iter().filter(|stage| !rests(stage)).cloned().collect();
    let found: BTreeSet<usize> = chosen.iter().flat_map(Stage::unknowns).copied().collect();
    let needed: BTreeSet<usize> = chosen.iter().flat_map(|stage| leaves(frame.arena, stage)).collect();
    let given: Vec<usize> = needed.difference(&found).copied().collect();
    let solution = solution(frame, &chosen, false);
    let mut held: BTreeSet<usize> = found;
    if matches!(solution.solving, Solving::Shared(_)) {
        // Shared code takes everything from arrays.
        held.extend(&given);
    }
    Some(Slice { given, held: held.into_iter().collect(), solution })
}

/// The unknowns that depend on time, be it in jumps only, which have no rate.
fn timed(arena: &Arena, stages: &[Stage]) -> BTreeSet<usize> {
    let mut timed = BTreeSet::new();
    for stage in stages {
        if stage.depends_on_time(arena) || leaves(arena, stage).iter().any(|unknown| timed.contains(unknown)) {
            timed.extend(stage.unknowns());
        }
    }
    timed
}

/// The unknowns in the expressions of a stage.
fn leaves(arena: &Arena, stage: &Stage) -> BTreeSet<usize> {
    let leaf = |leaf: &Leaf| match leaf {
        Leaf::Coordinate(index) | Leaf::Speed(index) | Leaf::Acceleration(index) => Some(*index as usize),
        Leaf::Time | Leaf::Parameter(_) | Leaf::Datum(_) => None,
    };
    stage.results().iter().flat_map(|result| arena.leaves(*result)).filter_map(|found| leaf(&found)).collect()
}

/// A prediction needs what is iterated, the test of a step angles that are computed; shared code hands everything on in arrays.
fn held(frame: &Frame, stages: &[Stage], solving: &Solving, n: usize) -> Vec<usize> {
    let timed = timed(frame.arena, stages);
    let is_held = |stage: &&Stage| match stage {
        Stage::Block(_) => true,
        Stage::Check { .. } => false,
        Stage::Explicit { unknown, motion, .. } => {
            let is_constant = motion.iter().all(|expr| frame.arena.as_constant(*expr).is_some());
            let is_shared = matches!(solving, Solving::Shared(_));
            *unknown >= n || !is_constant && (is_shared || frame.is_angle[*unknown] && timed.contains(unknown))
        }
    };
    let mut held: Vec<usize> = stages.iter().filter(is_held).flat_map(Stage::unknowns).copied().collect();
    held.sort_unstable();
    held
}
