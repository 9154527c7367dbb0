//! One function for all stages of the same shape.
//!
//! In: the stages of a mechanism, in runs. Out: [`Kernels`]: for each shape, its lines over local unknowns; for each run, its shape and, in
//! columns, its unknowns. Stages exchange values in arrays: q, q̇, q̈, and the sine and cosine of angles used by more than one stage. Not
//! done here: printing.

use super::lines::{PlanContext, StageCode, StraightLine, lines};
use super::routine::Cost;
use super::runs::{Run, Runs};
use super::shape::{Column, Shape};
use super::stage::Stage;
use super::words::Words;
use crate::expr::{Leaf, Node, Unary};
use std::collections::BTreeSet;

/// The stages of a mechanism, grouped by shape.
#[derive(Clone, Debug)]
pub struct Kernels {
    /// One kernel per shape.
    pub kernels: Vec<Kernel>,
    /// Kernel of each stage or run of stages, in order; the n-th occurrence of a kernel is its n-th piece.
    pub order: Vec<usize>,
    /// Unknowns that are constant, with their values; no kernel computes them.
    pub constants: Vec<(usize, f64)>,
    /// True if more than one drive moves something, so that one may rest while others move.
    pub can_rest: bool,
    /// For each block, the number of its shape among blocks, and the operations of one Newton step.
    pub(super) blocks: Vec<(usize, Cost)>,
}

/// The function of one shape.
#[derive(Clone, Debug)]
pub struct Kernel {
    /// Shape of the stages that it computes.
    pub shape: Shape,
    /// Its code.
    pub lines: StraightLine,
    /// Local unknowns that it computes.
    pub found: Vec<usize>,
    /// Equations of its block, or the equation that it checks.
    pub equations: Vec<Column<u32>>,
    /// Local unknowns whose sine and cosine it stores for other kernels.
    pub kept: Vec<usize>,
}

/// Shapes that are called in alternation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Round {
    /// Indices of their kernels.
    pub shapes: Vec<usize>,
    /// Total number of calls.
    pub calls: usize,
}

impl Round {
    /// Number of pieces of the shape at this place.
    #[must_use]
    pub fn pieces(&self, place: usize) -> usize {
        (self.calls + self.shapes.len() - 1 - place) / self.shapes.len()
    }
}

impl Kernels {
    pub(super) fn new(frame: &PlanContext, stages: &[Stage], runs: Runs) -> Kernels {
        let words = frame.words;
        let Runs { runs, shapes, order, constants, blocks } = runs;
        let turned: Vec<BTreeSet<usize>> = shapes.iter().map(turned).collect();
        let member = |number: usize| runs.iter().zip(&order).filter(move |(_, of)| **of == number).map(|(run, _)| run);
        let mut kernels: Vec<Kernel> =
            shapes.into_iter().enumerate().map(|(number, shape)| kernel(shape, member(number).collect(), &turned[number], words)).collect();
        keep_turns(&mut kernels, &turned);
        let of_blocks = runs.iter().zip(&order).filter(|(run, _)| run.has_block()).map(|(_, kernel)| kernels[*kernel].step());
        let blocks = blocks.into_iter().zip(of_blocks).collect();
        Kernels { kernels, order, constants, can_rest: can_rest(frame, stages), blocks }
    }

    /// The order as rounds, if each shape occurs in only one of them: then rustc knows the next function in each loop.
    pub fn rounds(&self) -> Option<Vec<Round>> {
        rounds(&self.order)
    }

    /// Operations outside of loops, of all stages.
    pub(super) fn cost(&self) -> Cost {
        self.kernels.iter().fold(Cost::default(), |sum, kernel| sum + kernel.lines.cost * kernel.shape.count)
    }
}

impl Kernel {
    /// Operations of one Newton step.
    fn step(&self) -> Cost {
        let of_part = |part: &StageCode| if let StageCode::Block(block) = part { Some(block.cost) } else { None };
        self.lines.parts.iter().find_map(of_part).unwrap_or_default()
    }
}

/// The order as rounds, if each number occurs in only one of them.
fn rounds(order: &[usize]) -> Option<Vec<Round>> {
    let mut rounds: Vec<Round> = Vec::new();
    let mut rest = order;
    while let [first, others @ ..] = rest {
        let period = others.iter().position(|shape| shape == first).map_or(1, |position| position + 1);
        let shapes = rest[..period].to_vec();
        let calls = rest.iter().zip(shapes.iter().cycle()).take_while(|(shape, expected)| shape == expected).count();
        rounds.push(Round { shapes, calls });
        rest = &rest[calls..];
    }
    let mut seen = BTreeSet::new();
    rounds.iter().flat_map(|round| &round.shapes).all(|shape| seen.insert(shape)).then_some(rounds)
}

/// True if more than one drive moves something.
pub(super) fn can_rest(frame: &PlanContext, stages: &[Stage]) -> bool {
    let is_driven = |stage: &&Stage| matches!(stage, Stage::Explicit { .. }) && stage.depends_on_time(frame.arena);
    stages.iter().filter(is_driven).count() > 1
}

/// Local unknowns whose sine or cosine occurs.
fn turned(shape: &Shape) -> BTreeSet<usize> {
    let angle = |expr| {
        let Node::Unary(Unary::Sin | Unary::Cos, angle) = shape.arena.node(expr) else { return None };
        let Node::Leaf(Leaf::Coordinate(slot)) = shape.arena.node(*angle) else { return None };
        Some(*slot as usize)
    };
    shape.arena.all().filter_map(angle).collect()
}

fn kernel(shape: Shape, runs: Vec<&Run>, turned: &BTreeSet<usize>, words: &Words) -> Kernel {
    let mut results = shape.results.as_slice();
    let mut found = Vec::new();
    let mut stages = Vec::new();
    let mut equations = Vec::new();
    for stage in &runs[0].stages {
        let count = stage.results().len();
        let (own, rest) = results.split_at(count);
        results = rest;
        let first = found.len();
        match stage {
            Stage::Explicit { origin, .. } => {
                found.push(first);
                stages.push(Stage::Explicit { unknown: first, origin: *origin, motion: [own[0], own[1], own[2]] });
            }
            Stage::Block(system) => {
                let k = system.unknowns.len();
                found.extend(first..first + k);
                stages.push(Stage::Block(system.with((first..first + k).collect(), (0..k).collect(), own)));
                equations = (0..k).map(|row| Column::of(runs.iter().map(|run| run.equation(row)).collect())).collect();
            }
            Stage::Check { .. } => {
                stages.push(Stage::Check { equation: 0, residual: own[0], sizes: [own[1], own[2], own[3]] });
                equations = vec![Column::of(runs.iter().map(|run| run.equation(0)).collect())];
            }
        }
    }
    let elsewhere: BTreeSet<usize> = turned.iter().copied().filter(|slot| !found.contains(slot)).collect();
    let lines = lines(&shape.arena, &stages, shape.unknowns.len(), &elsewhere, false, &words.of_shape(&shape));
    Kernel { shape, lines, found, equations, kept: Vec::new() }
}

/// The kernel that computes an angle stores its sine and cosine if another kernel uses them.
fn keep_turns(kernels: &mut [Kernel], turned: &[BTreeSet<usize>]) {
    let mut wanted = BTreeSet::new();
    for (kernel, turned) in kernels.iter().zip(turned) {
        for slot in turned.iter().filter(|slot| !kernel.found.contains(slot)) {
            wanted.extend((0..kernel.shape.count).map(|piece| kernel.shape.unknowns[*slot].at(piece)));
        }
    }
    for kernel in kernels {
        let is_wanted = |slot: &usize| (0..kernel.shape.count).any(|piece| wanted.contains(&kernel.shape.unknowns[*slot].at(piece)));
        kernel.kept = kernel.found.iter().copied().filter(is_wanted).collect();
    }
}

#[cfg(test)]
mod tests {
    use super::{Round, rounds};

    /// True if the loops call the shapes in the given order.
    fn is_kept(order: &[usize]) -> bool {
        let Some(rounds) = rounds(order) else { return false };
        let called = rounds.iter().flat_map(|round| {
            let pieces = (0..round.pieces(0)).flat_map(|piece| (0..round.shapes.len()).map(move |place| (piece, place)));
            pieces.filter(|(piece, place)| *piece < round.pieces(*place)).map(|(_, place)| round.shapes[place])
        });
        called.eq(order.iter().copied())
    }

    #[test]
    fn turns_are_found_and_kept() {
        assert_eq!(rounds(&[0, 1, 2, 3, 2, 3, 2]).map(|rounds| rounds.len()), Some(3));
        for order in [&[][..], &[0], &[0, 0, 0], &[0, 1], &[0, 1, 0, 1, 0], &[0, 1, 2, 3, 2, 3, 2], &[0, 1, 2, 0, 1, 2, 3, 3, 4]] {
            assert!(is_kept(order), "{order:?}");
        }
    }

    #[test]
    fn a_shape_that_comes_back_later_needs_the_table() {
        for order in [&[0, 1, 1, 0][..], &[0, 0, 1, 0, 0, 1], &[0, 1, 0, 2, 1]] {
            assert_eq!(rounds(order), None::<Vec<Round>>, "{order:?}");
        }
    }
}
