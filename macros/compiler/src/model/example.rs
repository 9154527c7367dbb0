//! Joints to be typed in, made of points that there are.
//!
//! In: a model, and a body that is to be joined. Out: the line. Not done here: whether it is what was meant; the bodies may have to
//! be joined elsewhere, or by another kind of joint.

use super::Model;
use super::sketch::{Argument, Local};

/// `joint name = revolute(ground.C, rocker.position);`
pub(crate) fn revolute(one: &str, two: &str) -> String {
    format!("joint name = revolute({one}, {two});")
}

/// Where a body may be joined to others: where it is, unless a joint is there already, else at a point that no joint has.
pub(crate) fn place_of(model: &Model, body: usize) -> String {
    let free = if is_joined(model, body) { free_point(model, Some(body)) } else { None };
    free.unwrap_or_else(|| called(model, Some(body), "position"))
}

/// A joint is where the body is. So much is not known of a mechanism that is too large to be drawn.
pub(crate) fn is_joined(model: &Model, body: usize) -> bool {
    has_joint(model, &|at| at.body == Some(body) && is_origin(model, at))
}

/// A place of ground: the first declared one that no joint has, else its origin.
pub(crate) fn place_of_ground(model: &Model) -> String {
    free_point(model, None).unwrap_or_else(|| called(model, None, "position"))
}

/// A declared point that no joint has, of ground or of one of these bodies; else where the first of them is.
pub(crate) fn place_of_one(model: &Model, bodies: impl Iterator<Item = usize> + Clone) -> String {
    let frames = std::iter::once(None).chain(bodies.clone().map(Some));
    frames.into_iter().find_map(|frame| free_point(model, frame)).unwrap_or_else(|| called(model, bodies.into_iter().next(), "position"))
}

/// The first declared point of a body or of ground that no joint has.
fn free_point(model: &Model, body: Option<usize>) -> Option<String> {
    let of_body = model.sketch.points.iter().filter(|point| point.at.body == body);
    let is_free = |at: &Local| !has_joint(model, &|other| other.body == at.body && other.local == at.local);
    of_body.into_iter().find(|point| is_free(&point.at)).map(|point| called(model, body, &point.name))
}

/// A joint was made with such a point.
fn has_joint(model: &Model, is_meant: &dyn Fn(&Local) -> bool) -> bool {
    let arguments = model.sketch.joints.iter().flat_map(|joint| &joint.arguments);
    arguments.into_iter().any(|(_, argument)| matches!(argument, Argument::Point(at) if is_meant(at)))
}

fn is_origin(model: &Model, at: &Local) -> bool {
    at.local.iter().all(|part| model.sketch.arena.as_constant(*part).is_some_and(|value| value.is_zero()))
}

/// `crank.A`
fn called(model: &Model, body: Option<usize>, point: &str) -> String {
    match body {
        Some(body) => format!("{}.{point}", model.bodies[body].name),
        None => format!("ground.{point}"),
    }
}
