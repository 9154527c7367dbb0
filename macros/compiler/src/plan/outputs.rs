//! Outputs: one after the other, or where those of an array are alike, one for all.

use super::routine::Routine;
use super::schedule;
use super::shape::{Piece, Shape, Tracer};
use super::words::Words;
use crate::expr::{Arena, Expr};
use crate::model::{Method, Model};
use crate::system::System;

/// How the outputs of one method are computed.
#[derive(Clone, Debug)]
pub enum Outputs {
    /// They are whole bodies, and nothing is computed.
    Bodies(Vec<usize>),
    /// Value, rate and acceleration of each component, output by output.
    Each(Vec<Routine>),
    /// The same for all of them.
    Alike(Box<(Shape, Routine)>),
}

/// Decides how the outputs of each method are computed.
pub(super) fn outputs(arena: &Arena, tracer: &Tracer, model: &Model, system: &System, words: &Words) -> Vec<Outputs> {
    let results = |member: &usize| -> Vec<Expr> { system.outputs[*member].components.iter().flatten().copied().collect() };
    let outputs = |method: &Method| {
        let bodies: Option<Vec<usize>> = method.members.iter().map(|member| model.outputs[*member].body).collect();
        if let Some(bodies) = bodies {
            return Outputs::Bodies(bodies);
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
