//! Pairs of spatial joints between the same two bodies, each with a common axis direction.
//!
//! In: a model with the relations of its joints. Out: a refusal if the two axis directions differ. If they enclose the same angle on both
//! bodies, the bodies cannot rotate relative to each other; if not, the joints contradict each other. Parallel axes, joints that let
//! bodies slide, and redundant joints are left to the other tests.

use crate::diag::{Diag, SystemFact};
use crate::expr::{Expr, evaluate};
use crate::model::{Model, Relationship, Said};
use crate::numeric::at_defaults;
use crate::syntax::ast::Closing;
use crate::system::System;

/// Axes with a smaller angle between them than this, in rad, are parallel.
const APART: f64 = 1e-7;

/// A joint that keeps an axis of one body parallel to an axis of another; `None` is ground.
struct Kept {
    joint: usize,
    bodies: [Option<usize>; 2],
    axes: [[Expr; 3]; 2],
}

impl Kept {
    /// Such joints, except redundant ones; the body with the lower number comes first.
    fn of(model: &Model) -> Vec<Kept> {
        let kept = |(joint, _, relation): &(usize, usize, Relationship)| {
            let Relationship::SameDirection(one, two) = relation else { return None };
            let mut ends = [(one.body, one.axes[2]), (two.body, two.axes[2])];
            ends.sort_by_key(|(body, _)| *body);
            let [(one, a), (two, b)] = ends;
            let is_meant = one != two && !model.joints[*joint].is_redundant && model.joints[*joint].freedom.is_none();
            is_meant.then_some(Kept { joint: *joint, bodies: [one, two], axes: [a, b] })
        };
        model.space.relations.iter().filter_map(kept).collect()
    }
}

/// Refuses the later joint of each pair with different axis directions.
pub(super) fn axes_agree(model: &Model, system: &System, diag: &mut Diag) -> Option<()> {
    if model.closing != Closing::Deny || !model.task.is_determined() {
        return Some(());
    }
    let kept = Kept::of(model);
    let mut said = Said::default();
    for (index, later) in kept.iter().enumerate() {
        let Some(earlier) = kept[..index].iter().find(|other| other.bodies == later.bodies && other.joint != later.joint) else { continue };
        let angles = [0, 1].map(|end| angle(model, system, earlier.axes[end], later.axes[end]));
        let name = &model.joints[later.joint].name;
        if !angles.iter().any(|angle| *angle > APART) || !said.is_new(name) {
            continue;
        }
        let bodies = later.bodies.map(|body| body.map_or("ground".to_owned(), |body| model.bodies[body].name.to_string()));
        let (joint, other) = (name.to_string(), model.joints[earlier.joint].name.to_string());
        if (angles[0] - angles[1]).abs() > APART {
            diag.refuse::<()>(name, SystemFact::AxesContradict { joint, other, bodies, angles });
        } else if [earlier, later].iter().all(|kept| is_hinge(model, kept.joint)) {
            diag.refuse::<()>(name, SystemFact::TwoAxes { joint, other, bodies, angle: angles[0] });
        }
    }
    diag.is_clean().then_some(())
}

/// True if the joint also keeps two points coincident.
pub(super) fn is_hinge(model: &Model, joint: usize) -> bool {
    model.space.relations.iter().any(|(other, _, relation)| *other == joint && matches!(relation, Relationship::Coincident(..)))
}

/// Angle between two lines of one body at the declared defaults, at most π/2, in rad.
pub(super) fn angle(model: &Model, system: &System, one: [Expr; 3], two: [Expr; 3]) -> f64 {
    let values = at_defaults(model, system, |numeric| evaluate(&model.arena, &[one, two].concat(), &numeric.known));
    let (one, two) = values.split_at(3);
    let dot: f64 = one.iter().zip(two).map(|(one, two)| one * two).sum();
    let cross = [1, 2, 0].map(|k| one[k] * two[(k + 1) % 3] - one[(k + 1) % 3] * two[k]);
    let angle = cross.iter().map(|part| part * part).sum::<f64>().sqrt().atan2(dot.abs());
    if angle.is_finite() { angle } else { 0.0 }
}
