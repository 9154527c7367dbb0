//! The solution as a whole: what its stages are, what they cost, and whether they share code.

use super::kernels::Kernels;
use super::lines::{Frame, Lines, lines};
use super::rolled::STRAIGHT;
use super::routine::Cost;
use super::stage::{Elimination, Iteration, Stage};
use crate::expr::{Arena, Binary, Expr, Leaf, Node, Unary};
use std::collections::BTreeSet;

/// How q, q̇ and q̈ are found.
#[derive(Clone, Debug)]
pub struct Solution {
    /// What is found, in order.
    pub stages: Vec<Summary>,
    /// Indices in q of unknowns that may be found to be no finite numbers, or to have no finite rates.
    pub unsure: Vec<usize>,
    /// Operations outside of loops, once for each state.
    pub cost: Cost,
    /// The code that does it.
    pub solving: Solving,
}

/// A stage in short.
#[derive(Clone, Debug)]
pub enum Summary {
    /// An unknown that is computed.
    Explicit {
        /// Its index in q.
        unknown: usize,
        /// It is no constant.
        moves: bool,
    },
    /// Unknowns that are found together.
    Block {
        /// Indices in q.
        unknowns: Vec<usize>,
        /// Indices in Φ.
        equations: Vec<usize>,
        /// Operations of one Newton step, without the solution of its system.
        cost: Cost,
        /// How its system is eliminated, if not in closed form.
        elimination: Option<Box<Elimination>>,
        /// The number of its shape: blocks with the same number do the same operations.
        shape: usize,
    },
    /// An equation that is checked, by its index in Φ.
    Check(usize),
}

/// How the stages are written.
#[derive(Clone, Debug)]
pub enum Solving {
    /// One after the other.
    Straight(Lines),
    /// As one function for each shape of stage.
    Shared(Kernels),
}

/// Schedules stages.
///
/// What depends on parameters only is set apart where that `is_apart`.
pub(super) fn solution(frame: &Frame, stages: &[Stage], is_apart: bool) -> Solution {
    let Frame { arena, words, .. } = *frame;
    let kernels = Kernels::new(frame, stages);
    let (of_kernels, all) = (kernels.size(), size(arena, stages));
    let mut blocks = kernels.blocks.iter().copied();
    let summaries = stages.iter().map(|stage| summary(arena, stage, &mut blocks)).collect();
    let (cost, solving) = if all <= STRAIGHT || 2 * of_kernels > all && all <= LONGEST {
        let lines = lines(arena, stages, frame.is_angle.len(), &BTreeSet::new(), is_apart, words);
        (lines.cost, Solving::Straight(lines))
    } else {
        (kernels.cost(), Solving::Shared(kernels))
    };
    Solution { stages: summaries, unsure: unsure(arena, stages), cost, solving }
}

/// Beyond this many operations in one function rustc takes more than its time.
const LONGEST: usize = 16_000;

/// The number of operations of all stages.
fn size(arena: &Arena, stages: &[Stage]) -> usize {
    let roots: Vec<Expr> = stages.iter().flat_map(Stage::results).collect();
    arena.reachable(&roots).len()
}

/// The unknowns that may be found to be no finite numbers, or to have no finite rates.
///
/// What Newton's method finds is finite, and so are its rates if their right sides are. What is computed from finite unknowns by sums,
/// products and sines is finite as well. All else has to be looked at: parameters, which anyone may set, time, and functions that
/// have poles or end somewhere.
fn unsure(arena: &Arena, stages: &[Stage]) -> Vec<usize> {
    let is_given = |node: &Node| matches!(node, Node::Leaf(Leaf::Time | Leaf::Parameter(_) | Leaf::Datum(_)));
    let has = |roots: &[Expr], is_risk: &dyn Fn(&Node) -> bool| arena.reachable(roots).iter().any(|expr| is_risk(arena.node(*expr)));
    let is_unsure = |stage: &&Stage| match stage {
        Stage::Explicit { motion, .. } => has(motion, &|node| is_given(node) || has_poles(arena, node)),
        Stage::Block(_) => has(&stage.results(), &|node| has_poles(arena, node)),
        Stage::Check { .. } => false,
    };
    stages.iter().filter(is_unsure).flat_map(Stage::unknowns).copied().collect()
}

/// An operation that does not give a finite number for every finite operand.
fn has_poles(arena: &Arena, node: &Node) -> bool {
    match *node {
        Node::Binary(Binary::Div, _, divisor) => arena.as_constant(divisor).is_none(),
        Node::Unary(function, _) => matches!(function, Unary::Sqrt | Unary::Tan | Unary::Asin | Unary::Acos | Unary::Exp | Unary::Ln),
        Node::Call { .. } => true,
        Node::Constant(_) | Node::Leaf(_) | Node::Binary(..) | Node::Select { .. } => false,
    }
}

/// A stage in short; the next block has this shape and costs this.
fn summary(arena: &Arena, stage: &Stage, blocks: &mut impl Iterator<Item = (usize, Cost)>) -> Summary {
    match stage {
        Stage::Explicit { unknown, motion, .. } => {
            Summary::Explicit { unknown: *unknown, moves: motion.iter().any(|expr| arena.as_constant(*expr).is_none()) }
        }
        Stage::Block(Iteration { unknowns, equations, elimination, .. }) => {
            let (shape, cost) = blocks.next().unwrap_or_default();
            Summary::Block { unknowns: unknowns.clone(), equations: equations.clone(), cost, elimination: elimination.clone(), shape }
        }
        Stage::Check { equation, .. } => Summary::Check(*equation),
    }
}
