//! The solution as a whole: its stages, their cost, and whether they share code.

use super::finite::{Unsure, unsure};
use super::kernels::{Kernels, can_rest};
use super::lines::{PlanContext, StraightLine, lines};
use super::rolled::STRAIGHT;
use super::routine::Cost;
use super::runs::Runs;
use super::stage::{Elimination, Iteration, Stage};
use crate::expr::{Arena, Expr, Leaf};
use crate::system::deciding;
use std::collections::BTreeSet;

/// Solution for q, q̇ and q̈.
#[derive(Clone, Debug)]
pub struct Solution {
    /// Stages in order.
    pub stages: Vec<Summary>,
    /// Unknowns whose values or derivatives may not be finite.
    pub unsure: Vec<Unsure>,
    /// Operations outside of loops, once per state.
    pub cost: Cost,
    /// Code of the solution.
    pub solving: Solving,
}

/// Summary of a stage.
#[derive(Clone, Debug)]
pub enum Summary {
    /// A computed unknown.
    Explicit {
        /// Index in q.
        unknown: usize,
        /// True unless it is constant.
        moves: bool,
    },
    /// Unknowns that are solved together.
    Block {
        /// Indices in q.
        unknowns: Vec<usize>,
        /// Indices in Φ.
        equations: Vec<usize>,
        /// Operations of one Newton step, without the solution of its linear system.
        cost: Cost,
        /// Elimination of its Jacobian, if not in closed form.
        elimination: Option<Box<Elimination>>,
        /// Number of its shape: blocks with the same number do the same operations.
        shape: usize,
        /// True if the unknowns occur linearly: there is one solution at most.
        is_linear: bool,
    },
    /// An equation that is checked, by index in Φ.
    Check(usize),
}

/// Code of the stages.
#[derive(Clone, Debug)]
pub enum Solving {
    /// Straight-line code, stage by stage.
    Straight(StraightLine),
    /// One function per shape of stage.
    Shared(Kernels),
}

/// Schedules stages.
///
/// If `is_apart`, steps that depend on parameters only are separated.
pub(super) fn solution(frame: &PlanContext, stages: &[Stage], is_apart: bool) -> Solution {
    let PlanContext { arena, words, .. } = *frame;
    let runs = Runs::new(frame, stages);
    let all = size(arena, stages);
    // Shared functions do not exchange third derivatives.
    let has_jerks = stages.iter().any(|stage| matches!(stage, Stage::Block(system) if !system.jerks.is_empty()));
    let is_straight = has_jerks || all <= STRAIGHT || 2 * runs.size() > all && all <= LONGEST;
    // A block that may rest is left out alone.
    let runs = if is_straight || can_rest(frame, stages) { runs } else { runs.joined(frame) };
    let kernels = Kernels::new(frame, stages, runs);
    let mut blocks = kernels.blocks.iter().copied();
    let summaries = stages.iter().map(|stage| summary(arena, stage, &mut blocks)).collect();
    let (cost, solving) = if is_straight {
        let lines = lines(arena, stages, frame.is_angle.len(), &BTreeSet::new(), is_apart, words);
        (lines.cost, Solving::Straight(lines))
    } else {
        (kernels.cost(), Solving::Shared(kernels))
    };
    Solution { stages: summaries, unsure: unsure(arena, stages), cost, solving }
}

/// Largest number of operations in one function; beyond it the compile time of rustc grows more than in proportion.
const LONGEST: usize = 16_000;

/// Number of operations of all stages.
fn size(arena: &Arena, stages: &[Stage]) -> usize {
    let roots: Vec<Expr> = stages.iter().flat_map(Stage::results).collect();
    arena.reachable_to_values(&roots).len()
}

/// Summary of a stage; `blocks` yields shape and cost of the next block.
fn summary(arena: &Arena, stage: &Stage, blocks: &mut impl Iterator<Item = (usize, Cost)>) -> Summary {
    match stage {
        Stage::Explicit { unknown, motion, .. } => {
            Summary::Explicit { unknown: *unknown, moves: motion.iter().any(|expr| arena.as_constant(*expr).is_none()) }
        }
        Stage::Block(Iteration { unknowns, equations, elimination, jacobian, residuals, quaternions, .. }) => {
            let (shape, cost) = blocks.next().unwrap_or_default();
            let is_solved_for = |leaf: Leaf| matches!(leaf, Leaf::Coordinate(unknown) if unknowns.contains(&(unknown as usize)));
            let is_steady =
                quaternions.is_empty() && jacobian.iter().flatten().all(|entry| !arena.leaves(*entry).into_iter().any(is_solved_for));
            let is_chosen = |residual: &Expr| deciding(arena, *residual).iter().any(|unknown| unknowns.contains(unknown));
            let is_linear = is_steady && !residuals.iter().any(is_chosen);
            let (unknowns, equations, elimination) = (unknowns.clone(), equations.clone(), elimination.clone());
            Summary::Block { unknowns, equations, cost, elimination, shape, is_linear }
        }
        Stage::Check { equation, .. } => Summary::Check(*equation),
    }
}
