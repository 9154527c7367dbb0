//! Gears that cannot mesh at the declared parameters.

use crate::diag::{Doubt, Warning, quantity};
use crate::expr::{Values, evaluate};
use crate::model::sketch::{Instantiation, JointArgument, LocalVector};
use crate::model::{Joint, Model, Said};
use crate::numeric::at_defaults;
use crate::quantity::Dim;
use crate::system::System;

/// Gears with shifted profiles are not as far apart as their radii say, but by less than this part of the distance.
const SHIFTED: f64 = 0.05;

/// Warnings about pairs of gears that are too far apart or too close to each other.
pub(super) fn apart(model: &Model, system: &System) -> Vec<Warning> {
    let mut said = Said::default();
    let of_joint = |(joint, made): (&Joint, &Instantiation)| {
        if made.kind != "gear_pair" {
            return None;
        }
        let (distance, [a, b]) = at_defaults(model, system, |numeric| centers_and_radii(model, made, &numeric.known))?;
        let needed = (a + b).abs();
        // One warning for all pairs of a loop.
        if !((distance - needed).abs() > SHIFTED * distance.max(needed) && said.is_new(&joint.name)) {
            return None;
        }
        let rounded = |length: f64| quantity((length * 1e6).round() * 1e-6, Dim::LENGTH);
        let (joint_name, distance, needed, is_internal) = (joint.name.to_string(), rounded(distance), rounded(needed), a * b < 0.0);
        Some(Warning { doubt: Doubt::GearsApart { joint: joint_name, distance, needed, is_internal }, range: (&joint.name).into() })
    };
    model.joints.iter().zip(&model.sketch.joints).filter_map(of_joint).collect()
}

/// Warnings about planetary trains whose ring gear is not larger than the sun gear inside it.
pub(super) fn inside_out(model: &Model, system: &System) -> Vec<Warning> {
    let mut said = Said::default();
    let of_joint = |(joint, made): (&Joint, &Instantiation)| {
        if made.kind != "planetary" {
            return None;
        }
        let [Some(JointArgument::Number(sun, dim)), Some(JointArgument::Number(ring, _)), Some(JointArgument::Number(offset, _))] =
            ["z_sun", "z_ring", "c"].map(|name| made.argument(name))
        else {
            return None;
        };
        let values = at_defaults(model, system, |numeric| evaluate(&model.sketch.arena, &[*sun, *ring, *offset], &numeric.known));
        let &[sun, ring, offset] = values.as_slice() else { return None };
        // Of three numbers of teeth the last one is taken as the offset.
        let is_inside = ring < sun || ring == sun && offset.abs() > ring;
        // With a negative one it is a train with two sun gears.
        if !(ring > 0.0 && is_inside && said.is_new(&joint.name)) {
            return None;
        }
        let doubt = Doubt::RingInsideSun { joint: joint.name.to_string(), ring: quantity(ring, *dim), sun: quantity(sun, *dim) };
        Some(Warning { doubt, range: (&joint.name).into() })
    };
    model.joints.iter().zip(&model.sketch.joints).filter_map(of_joint).collect()
}

/// The distance between the hinges of two gears on their carrier, and the radii; `None` for teeth, and for gears that turn otherwise.
fn centers_and_radii(model: &Model, made: &Instantiation, known: &Values) -> Option<(f64, [f64; 2])> {
    let body = |name: &str| match made.argument(name) {
        Some(JointArgument::Body(body)) => *body,
        _ => None,
    };
    let [a, b] = ["a", "b"].map(|name| match made.argument(name) {
        Some(JointArgument::Number(radius, Dim::LENGTH)) => Some(*radius),
        _ => None,
    });
    let carrier = body("carrier");
    let [one, two] = [body("i")?, body("j")?].map(|gear| hinge(model, gear, carrier));
    let exprs: Vec<_> = [a?, b?].into_iter().chain(one?.local.iter().copied()).chain(two?.local.iter().copied()).collect();
    let values = evaluate(&model.sketch.arena, &exprs, known);
    let &[a, b, x1, y1, x2, y2] = values.as_slice() else { return None };
    Some(((x2 - x1).hypot(y2 - y1), [a, b]))
}

/// Where a gear is hinged to its carrier, in the frame of the carrier.
fn hinge(model: &Model, gear: usize, carrier: Option<usize>) -> Option<&LocalVector> {
    model.sketch.joints.iter().filter(|made| made.kind == "revolute").find_map(|made| {
        let (Some(JointArgument::Point(one)), Some(JointArgument::Point(two))) = (made.argument("P"), made.argument("Q")) else {
            return None;
        };
        [(one, two), (two, one)].into_iter().find(|(on, of)| of.body == Some(gear) && on.body == carrier).map(|(on, _)| on)
    })
}
