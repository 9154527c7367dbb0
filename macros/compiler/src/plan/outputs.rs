//! Outputs: computed one by one, or by one routine if the outputs of an array have the same shape.

use super::jerk::Jerks;
use super::routine::Routine;
use super::schedule;
use super::shape::{Piece, Shape, Tracer};
use super::words::Words;
use crate::expr::{Arena, Expr};
use crate::model::{Method, Model};
use crate::system::OutputMotion;

/// Computation of the outputs of one method.
#[derive(Clone, Debug)]
pub enum Outputs {
    /// Whole bodies; nothing is computed.
    Bodies(Vec<usize>),
    /// Value and derivatives of each component, output by output.
    Each(Vec<OutputCode>),
    /// One routine for all outputs.
    Alike(Box<(Shape, Routine)>),
}

/// Code of one output in a state.
#[derive(Clone, Debug)]
pub struct OutputCode {
    /// With jerk, for each block upstream: names of the third derivatives of its unknowns, and its Jacobian by rows followed by the
    /// right-hand side.
    pub systems: Vec<(Vec<String>, Routine)>,
    /// Value and derivatives of each component.
    pub lines: Routine,
}

/// Plans the outputs of each method.
pub(super) fn outputs(
    arena: &Arena,
    tracer: &Tracer,
    model: &Model,
    motions: &[OutputMotion],
    jerks: &[Option<Jerks>],
    words: &Words,
) -> Vec<Outputs> {
    let results = |member: &usize| -> Vec<Expr> {
        let orders = 1 + model.outputs[*member].derivatives;
        motions[*member].components.iter().flat_map(|motion| &motion[..orders]).copied().collect()
    };
    let outputs = |method: &Method| {
        let bodies: Option<Vec<usize>> = method.members.iter().map(|member| model.outputs[*member].body).collect();
        if let Some(bodies) = bodies {
            return Outputs::Bodies(bodies);
        }
        let jerks = |member: &usize| jerks.get(*member)?.as_ref();
        let is_alike = method.members.len() > 1 && !method.members.iter().any(|member| jerks(member).is_some());
        if is_alike {
            let piece = |member: &usize| Piece { tag: Vec::new(), first: Vec::new(), results: results(member) };
            let pieces: Vec<Piece> = method.members.iter().map(piece).collect();
            let (mut shapes, _) = tracer.shapes(&pieces);
            if let (Some(shape), true) = (shapes.pop(), shapes.is_empty()) {
                let routine = schedule::routine(&shape.arena, shape.results.clone(), &words.of_shape(&shape));
                return Outputs::Alike(Box::new((shape, routine)));
            }
        }
        let code = |member: &usize| match jerks(member) {
            Some(jerks) => jerks.code(arena, &motions[*member], words),
            None => OutputCode { systems: Vec::new(), lines: schedule::routine(arena, results(member), words) },
        };
        Outputs::Each(method.members.iter().map(code).collect())
    };
    model.methods.iter().map(outputs).collect()
}
