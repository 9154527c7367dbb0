//! Outputs: computed one by one, or by one routine if the outputs of an array have the same shape.

use super::jerk::{JerkCode, Jerks};
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
    Each(Vec<Routine>),
    /// Value and three derivatives of each component, output by output.
    WithJerk(Vec<JerkCode>),
    /// One routine for all outputs.
    Alike(Box<(Shape, Routine)>),
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
        let with_jerk = |member: &usize| Some(jerks.get(*member)?.as_ref()?.code(arena, &motions[*member], words));
        if let Some(all @ [_, ..]) = method.members.iter().map(with_jerk).collect::<Option<Vec<JerkCode>>>().as_deref() {
            return Outputs::WithJerk(all.to_vec());
        }
        if method.members.len() > 1 {
            let piece = |member: &usize| Piece { tag: Vec::new(), first: Vec::new(), results: results(member) };
            let pieces: Vec<Piece> = method.members.iter().map(piece).collect();
            let (mut shapes, _) = tracer.shapes(&pieces);
            if let (Some(shape), true) = (shapes.pop(), shapes.is_empty()) {
                let routine = schedule::routine(&shape.arena, shape.results.clone(), &words.of_shape(&shape));
                return Outputs::Alike(Box::new((shape, routine)));
            }
        }
        Outputs::Each(method.members.iter().map(|member| schedule::routine(arena, results(member), words)).collect())
    };
    model.methods.iter().map(outputs).collect()
}
