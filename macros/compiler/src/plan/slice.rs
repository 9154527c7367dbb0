//! A part of a mechanism that can be solved alone: the part upstream of an output, or the moving part.
//!
//! In: the stages of a mechanism. Out: [`Slice`]s: some of the stages, and the unknowns that a state of the slice holds so that the next
//! state can be predicted from it. Not done here: printing.

use super::jerk::Jerks;
use super::lines::PlanContext;
use super::solution::{Solution, Solving, solution};
use super::stage::{Origin, Stage};
use crate::expr::{Arena, Leaf};
use crate::system::OutputMotion;
use std::collections::BTreeSet;

/// A part of a mechanism.
#[derive(Clone, Debug)]
pub struct Slice {
    /// Unknowns of the mechanism with given values: they rest and are not part of the slice.
    pub given: Vec<usize>,
    /// Unknowns held by a state of the slice, by index in q; components of an output follow after these indices.
    pub held: Vec<usize>,
    /// Solution of the slice.
    pub solution: Solution,
}

/// The slice upstream of an output, with the output's components as unknowns after those of the mechanism, and after them their third
/// derivatives.
pub(super) fn upstream(frame: &PlanContext, stages: &[Stage], output: &OutputMotion, jerks: Option<&Jerks>, n: usize) -> Slice {
    let mut needed: BTreeSet<usize> = BTreeSet::new();
    let motions = output.components.iter().copied().chain(jerks.into_iter().flat_map(Jerks::as_accelerations));
    let outputs: Vec<Stage> =
        motions.enumerate().map(|(index, motion)| Stage::Explicit { unknown: n + index, origin: Origin::Output, motion }).collect();
    for stage in &outputs {
        needed.extend(leaves(frame.arena, stage));
    }
    let mut chosen: Vec<Stage> = Vec::new();
    for stage in stages.iter().rev() {
        if stage.unknowns().iter().any(|unknown| needed.contains(unknown)) {
            let stage = jerks.map_or_else(|| stage.clone(), |jerks| jerks.asked_of(stage));
            needed.extend(leaves(frame.arena, &stage));
            chosen.push(stage);
        }
    }
    chosen.reverse();
    // Of the checked equations, only those entirely upstream belong to the slice.
    let found: BTreeSet<usize> = chosen.iter().flat_map(Stage::unknowns).copied().collect();
    let is_upstream = |stage: &&Stage| matches!(stage, Stage::Check { .. }) && leaves(frame.arena, stage).is_subset(&found);
    chosen.extend(stages.iter().filter(is_upstream).cloned());
    chosen.extend(outputs);
    let solution = solution(frame, &chosen, false);
    let held = held(frame, &chosen, &solution.solving, n);
    Slice { given: Vec::new(), held, solution }
}

/// The moving slice; `None` unless some blocks rest, which then need not be solved at every time, and some stages move.
pub(super) fn moving(frame: &PlanContext, stages: &[Stage]) -> Option<Slice> {
    let mut timed = timed(frame.arena, stages);
    // The side of a binary link is tested with all entries of its rotation matrix.
    for link in frame.links {
        if timed.range(link.clone()).next().is_some() {
            timed.extend(link.clone());
        }
    }
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
        // Shared code reads all values from arrays.
        held.extend(&given);
    }
    Some(Slice { given, held: held.into_iter().collect(), solution })
}

/// Unknowns that depend on time, including those that only jump and have zero rate.
fn timed(arena: &Arena, stages: &[Stage]) -> BTreeSet<usize> {
    let mut timed = BTreeSet::new();
    for stage in stages {
        if stage.depends_on_time(arena) || leaves(arena, stage).iter().any(|unknown| timed.contains(unknown)) {
            timed.extend(stage.unknowns());
        }
    }
    timed
}

/// Unknowns in the expressions of a stage.
fn leaves(arena: &Arena, stage: &Stage) -> BTreeSet<usize> {
    let leaf = |leaf: &Leaf| match leaf {
        Leaf::Coordinate(index) | Leaf::Speed(index) | Leaf::Acceleration(index) | Leaf::Jerk(index) => Some(*index as usize),
        Leaf::Time | Leaf::Parameter(_) | Leaf::Input { .. } | Leaf::Datum(_) | Leaf::Turn(_) => None,
    };
    arena.leaves_of(&stage.results()).iter().filter_map(leaf).collect()
}

/// A slice's state holds iterated unknowns (for the predictor), varying computed angles (for the step test), outputs, and, with shared
/// code, every unknown that its kernels exchange. Mechanisms with slices have no binary links.
fn held(frame: &PlanContext, stages: &[Stage], solving: &Solving, n: usize) -> Vec<usize> {
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
