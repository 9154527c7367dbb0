//! Stages that one function computes.
//!
//! In: the stages of a mechanism. Out: [`Runs`]: a block alone or with the unknowns that follow from it, or the unknowns that one joint, one
//! tree of bodies or one output determines; and the shape of each. Not done here: code.

use super::lines::PlanContext;
use super::shape::{Piece, Shape};
use super::stage::{Iteration, Origin, Stage};
use crate::expr::Lookup;

/// Runs in order, and their shapes.
pub(super) struct Runs<'a> {
    /// The runs.
    pub(super) runs: Vec<Run<'a>>,
    /// Their shapes.
    pub(super) shapes: Vec<Shape>,
    /// The shape of each run.
    pub(super) order: Vec<usize>,
    /// Unknowns that are constant, with their values; in no run.
    pub(super) constants: Vec<(usize, f64)>,
    /// For each block, the number of its shape among blocks.
    pub(super) blocks: Vec<usize>,
}

/// Stages computed by one call.
pub(super) struct Run<'a> {
    /// The stages, of which at most one is a block.
    pub(super) stages: Vec<&'a Stage>,
    owner: Option<RunOwner>,
}

/// Computed unknowns that belong together.
#[derive(PartialEq)]
enum RunOwner {
    /// Those that one joint determines.
    Joint(usize),
    /// Direction cosines of the bodies that hang from this one.
    Tree(usize),
    /// Components of an output.
    Output,
}

/// Joining is considered only if the joined shapes, before they share operations, have at most this many times those of the separate ones.
const LARGER: usize = 2;

impl<'a> Runs<'a> {
    /// Each block alone, and consecutive unknowns of one owner together.
    pub(super) fn new(frame: &PlanContext, stages: &'a [Stage]) -> Runs<'a> {
        let (runs, constants) = runs(frame, stages);
        let (shapes, order) = shapes_of(frame, &runs);
        let mut numbers: Vec<usize> = Vec::new();
        let mut number = |shape: usize| {
            let known = numbers.iter().position(|other| *other == shape);
            known.unwrap_or_else(|| {
                numbers.push(shape);
                numbers.len() - 1
            })
        };
        let blocks = runs.iter().zip(&order).filter(|(run, _)| run.has_block()).map(|(_, shape)| number(*shape)).collect();
        Runs { runs, shapes, order, constants, blocks }
    }

    /// Number of operations of all shapes.
    pub(super) fn size(&self) -> usize {
        size(&self.shapes)
    }

    /// Each block with the unknowns that follow from it, so that they share operations: a loop of a chain is one call. They stay
    /// separate where joining would add more operations to the code than it saves in a step.
    pub(super) fn joined(self, frame: &PlanContext) -> Runs<'a> {
        let groups = self.followers();
        let own = |run: &usize| self.shapes[self.order[*run]].arena.len();
        let shapes: Lookup<Vec<usize>, usize> =
            groups.iter().map(|group| (group.iter().map(|run| self.order[*run]).collect(), group.iter().map(own).sum())).collect();
        if groups.len() == self.runs.len() || shapes.values().sum::<usize>() > LARGER * self.size() {
            return self;
        }
        let join = |group: &Vec<usize>| Run { stages: group.iter().flat_map(|run| self.runs[*run].stages.clone()).collect(), owner: None };
        let runs: Vec<Run> = groups.iter().map(join).collect();
        let (shapes, order) = shapes_of(frame, &runs);
        // Operations of the code and operations of a step.
        let costs = |shapes: &[Shape], order: &[usize]| size(shapes) + order.iter().map(|shape| shapes[*shape].arena.len()).sum::<usize>();
        if costs(&shapes, &order) > costs(&self.shapes, &self.order) { self } else { Runs { runs, shapes, order, ..self } }
    }

    /// Runs to join, in order: each with the last block that it depends on; those that depend on no block come first, each alone.
    fn followers(&self) -> Vec<Vec<usize>> {
        let mut pieces = vec![0; self.shapes.len()];
        let (mut first, mut groups): (Vec<Vec<usize>>, Vec<Vec<usize>>) = (Vec::new(), Vec::new());
        // The group that computes an unknown, counted from 1.
        let mut sources: Lookup<u32, usize> = Lookup::default();
        for (number, (run, shape)) in self.runs.iter().zip(&self.order).enumerate() {
            let piece = pieces[*shape];
            pieces[*shape] += 1;
            let unknowns = self.shapes[*shape].unknowns.iter().map(|column| column.at(piece));
            let group = if run.is_computed() {
                unknowns.filter_map(|unknown| sources.get(&unknown).copied()).max().unwrap_or(0)
            } else {
                groups.push(Vec::new());
                groups.len()
            };
            match group.checked_sub(1) {
                Some(group) => groups[group].push(number),
                None => first.push(vec![number]),
            }
            sources.extend(run.stages.iter().flat_map(|stage| stage.unknowns()).map(|unknown| (*unknown as u32, group)));
        }
        first.append(&mut groups);
        first
    }
}

impl Run<'_> {
    fn piece(&self, frame: &PlanContext) -> Piece {
        let mut tag = vec![self.stages.len() as u32];
        let mut first = Vec::new();
        for stage in &self.stages {
            match stage {
                Stage::Explicit { unknown, .. } => first.push(*unknown as u32),
                Stage::Block(system) => {
                    tag.extend([system.unknowns.len() as u32, system.quaternions.len() as u32]);
                    tag.extend(system.quaternions.iter().flatten().map(|column| *column as u32));
                    tag.extend(system.elimination.iter().flat_map(|elimination| elimination.features(frame.arena, &system.jacobian)));
                    first.extend(system.unknowns.iter().map(|unknown| *unknown as u32));
                }
                Stage::Check { .. } => tag.push(u32::MAX),
            }
        }
        tag.extend(first.iter().map(|unknown| u32::from(frame.is_angle[*unknown as usize])));
        Piece { tag, first, results: self.stages.iter().flat_map(|stage| stage.results()).collect() }
    }

    /// True if all its stages are computed.
    fn is_computed(&self) -> bool {
        self.stages.iter().all(|stage| matches!(stage, Stage::Explicit { .. }))
    }

    /// True if it has a block.
    pub(super) fn has_block(&self) -> bool {
        self.stages.iter().any(|stage| matches!(stage, Stage::Block(_)))
    }

    /// Index in Φ of an equation of its block, or of the equation that it checks.
    pub(super) fn equation(&self, row: usize) -> u32 {
        let of_stage = |stage: &&Stage| match stage {
            Stage::Block(Iteration { equations, .. }) => equations.get(row).copied(),
            Stage::Check { equation, .. } => Some(*equation),
            Stage::Explicit { .. } => None,
        };
        self.stages.iter().find_map(of_stage).unwrap_or(0) as u32
    }
}

/// Shapes of some runs, and the shape of each.
fn shapes_of(frame: &PlanContext, runs: &[Run]) -> (Vec<Shape>, Vec<usize>) {
    let pieces: Vec<Piece> = runs.iter().map(|run| run.piece(frame)).collect();
    frame.tracer.shapes(&pieces)
}

/// Number of operations of some shapes.
fn size(shapes: &[Shape]) -> usize {
    shapes.iter().map(|shape| shape.arena.len()).sum()
}

/// Groups stages into runs: each block alone, consecutive computed unknowns of one owner together. Constants are returned separately.
fn runs<'a>(frame: &PlanContext, stages: &'a [Stage]) -> (Vec<Run<'a>>, Vec<(usize, f64)>) {
    let (mut runs, mut constants): (Vec<Run>, Vec<(usize, f64)>) = (Vec::new(), Vec::new());
    let mut stages: Vec<&Stage> = stages.iter().collect();
    // Orientations depend on no other orientation: those of a tree, which share operations, come together.
    stages.chunk_by_mut(|one, other| tree(one).is_some() && tree(other).is_some()).for_each(|chunk| chunk.sort_by_key(|stage| tree(stage)));
    for stage in stages {
        let Stage::Explicit { unknown, origin, motion } = stage else {
            runs.push(Run { stages: vec![stage], owner: None });
            continue;
        };
        if let [Some(value), Some(_), Some(_)] = motion.map(|expr| frame.arena.as_constant(expr)) {
            constants.push((*unknown, value.to_f64()));
            continue;
        }
        let owner = Some(match origin {
            Origin::Equation(row) => RunOwner::Joint(frame.joints[*row]),
            Origin::Orientation(root) => RunOwner::Tree(*root),
            Origin::Output => RunOwner::Output,
        });
        match runs.last_mut() {
            Some(run) if run.owner == owner => run.stages.push(stage),
            _ => runs.push(Run { stages: vec![stage], owner }),
        }
    }
    (runs, constants)
}

/// The body from which all bodies hang whose orientations a stage computes.
fn tree(stage: &Stage) -> Option<usize> {
    match stage {
        Stage::Explicit { origin: Origin::Orientation(root), .. } => Some(*root),
        _ => None,
    }
}
