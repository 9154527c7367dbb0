//! Space: orientations as results of the solution, and expressions without marks.

use super::stage::{Iteration, Origin, Stage};
use crate::assembly::Assembly;
use crate::expr::{Arena, Expr, Lookup, Values, evaluate};
use crate::model::Model;
use crate::numeric;
use crate::system::{OutputMotion, System};

/// Stages that compute the orientations of the bodies, after all unknowns.
pub(super) fn orientations(arena: &mut Arena, system: &System) -> Vec<Stage> {
    let mut stages = Vec::new();
    for body in 0..system.frames.len() {
        let origin = Origin::Orientation(root(system, body));
        for motion in system.orientation(arena, body) {
            stages.push(Stage::Explicit { unknown: system.coordinates.len() + stages.len(), origin, motion });
        }
    }
    stages
}

/// The body nearest to the ground in the tree of hinges to which a body belongs.
fn root(system: &System, mut body: usize) -> usize {
    while let Some((_, Some(before))) = system.space.reached.get(body).copied().flatten() {
        body = before;
    }
    body
}

/// Replaces marked expressions by their values: from here on nothing is differentiated.
pub(super) fn without_marks(arena: &mut Arena, stages: &mut [Stage], outputs: &mut [OutputMotion]) {
    if !arena.is_spatial() {
        return;
    }
    let mut known = Lookup::default();
    for stage in stages {
        match stage {
            Stage::Explicit { motion, .. } => each(arena, &mut known, motion),
            Stage::Check { residual, sizes, .. } => {
                each(arena, &mut known, std::slice::from_mut(residual));
                each(arena, &mut known, sizes);
            }
            Stage::Block(Iteration { residuals, jacobian, sizes, rates, accelerations, .. }) => {
                for list in [residuals, sizes, rates, accelerations].into_iter().chain(jacobian) {
                    each(arena, &mut known, list);
                }
            }
        }
    }
    for motion in outputs.iter_mut().flat_map(|output| &mut output.components) {
        each(arena, &mut known, motion);
    }
}

/// The motions of the outputs without marks.
pub(super) fn plain_outputs(arena: &mut Arena, system: &System) -> Vec<OutputMotion> {
    let mut outputs = system.outputs.clone();
    without_marks(arena, &mut [], &mut outputs);
    outputs
}

fn each(arena: &mut Arena, known: &mut Lookup<Expr, Expr>, list: &mut [Expr]) {
    list.iter_mut().for_each(|expr| *expr = arena.plain(*expr, known));
}

/// The rotation matrices of the bodies where the mechanism is assembled.
pub(super) fn orientations_at_start(model: &Model, system: &System, assembly: &Assembly) -> Vec<f64> {
    if system.frames.is_empty() {
        return Vec::new();
    }
    let mut arena = system.arena.clone();
    let bodies = 0..system.frames.len();
    let roots: Vec<Expr> = bodies.flat_map(|body| system.orientation(&mut arena, body)).map(|[value, _, _]| value).collect();
    numeric::at_defaults(model, system, |numeric| evaluate(&arena, &roots, &Values { coordinates: &assembly.start, ..numeric.known }))
}
