//! Suggests joints to type in, made of declared points.
//!
//! In: a model, and a body to be joined. Out: the text of the declaration. Not done here: deciding whether that joint was meant; the
//! bodies may have to be joined elsewhere, or by another kind of joint.

use super::Model;
use super::sketch::{JointArgument, LocalVector};
use crate::quantity::Ambient;

/// `joint name = revolute(ground.C, rocker.position);`, in space `spherical`: the joint that holds two points together.
pub(crate) fn joint(model: &Model, one: &str, two: &str) -> String {
    let kind = if model.ambient == Ambient::Space { "spherical" } else { "revolute" };
    format!("joint name = {kind}({one}, {two});")
}

/// Point at which to join a body: its origin or, if a joint is there already, its first declared point without a joint.
pub(crate) fn place_of(model: &Model, body: usize) -> String {
    let free = if is_joined(model, body) { free_point(model, Some(body)) } else { None };
    free.unwrap_or_else(|| called(model, Some(body), "position"))
}

/// True if a joint is at the origin of the body. Always false for a mechanism that is too large to be drawn.
pub(crate) fn is_joined(model: &Model, body: usize) -> bool {
    has_joint(model, &|at| at.body == Some(body) && is_origin(model, at))
}

/// Point of ground: the first declared one without a joint, else the origin.
pub(crate) fn place_of_ground(model: &Model) -> String {
    free_point(model, None).unwrap_or_else(|| called(model, None, "position"))
}

/// First declared point without a joint, of ground or of one of `bodies`; else the origin of the first body.
pub(crate) fn place_of_one(model: &Model, bodies: impl Iterator<Item = usize> + Clone) -> String {
    let frames = std::iter::once(None).chain(bodies.clone().map(Some));
    frames.into_iter().find_map(|frame| free_point(model, frame)).unwrap_or_else(|| called(model, bodies.into_iter().next(), "position"))
}

/// First declared point without a joint, of a body or of ground.
fn free_point(model: &Model, body: Option<usize>) -> Option<String> {
    let of_body = model.sketch.points.iter().filter(|point| point.at.body == body);
    let is_free = |at: &LocalVector| !has_joint(model, &|other| other.body == at.body && other.local == at.local);
    of_body.into_iter().find(|point| is_free(&point.at)).map(|point| called(model, body, &point.name))
}

/// True if such a point is an argument of a joint.
fn has_joint(model: &Model, is_meant: &dyn Fn(&LocalVector) -> bool) -> bool {
    let arguments = model.sketch.joints.iter().flat_map(|joint| &joint.arguments);
    arguments.into_iter().any(|(_, argument)| matches!(argument, JointArgument::Point(at) if is_meant(at)))
}

fn is_origin(model: &Model, at: &LocalVector) -> bool {
    at.local.iter().all(|part| model.sketch.arena.as_constant(*part).is_some_and(|value| value.is_zero()))
}

/// `crank.A`
fn called(model: &Model, body: Option<usize>, point: &str) -> String {
    match body {
        Some(body) => format!("{}.{point}", model.bodies[body].name),
        None => format!("ground.{point}"),
    }
}
