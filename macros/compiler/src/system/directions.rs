//! Angles between axes that joints keep apart.
//!
//! In: a model with the relations of its joints. Out: a refusal of each angle of one axis against another that is at a fixed angle to it, as the
//! axis of a hinge is to a second axis of the next body. Between two directions that are not parallel the angle about one of them is not that of
//! a joint, and where it is undefined the motion ends. Axes whose directions no joint relates are left alone.

use crate::diag::{Diag, SystemFact};
use crate::expr::{Expr, Triple, Values, evaluate};
use crate::model::{JointQuantity, Model, Relationship, Said, Triad};
use std::f64::consts::FRAC_PI_2;

/// Sine below which two axes are parallel: declared directions are rounded.
const PARALLEL: f64 = 1e-3;

/// A direction in a body, `None` for ground, at the defaults.
type Direction = (Option<usize>, [f64; 3]);

/// Refuses angles between axes that are at a fixed angle to each other.
pub(super) fn angles_are_of_one_direction(model: &Model, diag: &mut Diag) {
    let mut said = Said::default();
    let defaults = defaults(model);
    let (related, perpendicular) = (related(model, &defaults), perpendicular(model, &defaults));
    let are = |pair: &[Direction; 2], from, to| [[0, 1], [1, 0]].iter().any(|[a, b]| is_one(pair[*a], from) && is_one(pair[*b], to));
    for ((quantity, _), item) in model.space.quantities.iter().zip(&model.quantity_items) {
        let (JointQuantity::Angle(one, two), Some(name)) = (quantity, item) else { continue };
        let [from, to] = [one, two].map(|triad| direction(model, &defaults, triad.body, triad.axes[2]));
        // The angle of a joint about its own axes.
        if related.iter().any(|[near, far]| is_one(*near, from) && is_one(*far, to)) {
            continue;
        }
        let apart = parallels(&related, to).into_iter().find(|other| other.0 == from.0).map(|other| between(other.1, from.1));
        let apart = apart.or_else(|| perpendicular.iter().any(|pair| are(pair, from, to)).then_some(FRAC_PI_2));
        let apart =
            apart.or_else(|| parallels(&related, from).into_iter().find(|other| other.0 == to.0).map(|other| between(other.1, to.1)));
        if let Some(apart) = apart.filter(|apart| apart.sin() > PARALLEL)
            && said.is_new(name)
        {
            let bodies = [one, two].map(|triad| triad.body.map_or("ground".to_owned(), |body| model.bodies[body].name.to_string()));
            diag.refuse::<()>(name, SystemFact::AngleOfTwoDirections { name: name.to_string(), bodies, apart });
        }
    }
}

/// Pairs of axes that joints keep parallel.
fn related(model: &Model, defaults: &[f64]) -> Vec<[Direction; 2]> {
    let pairs = |(_, _, relation): &(usize, usize, Relationship)| match relation {
        Relationship::SameDirection(one, two) => vec![axes_of(model, defaults, [one, two], 2)],
        Relationship::SameOrientation(one, two) | Relationship::Equal(one, two) => {
            (0..3).map(|k| axes_of(model, defaults, [one, two], k)).collect()
        }
        Relationship::Coincident(..) | Relationship::Perpendicular(..) | Relationship::OnLine(..) => Vec::new(),
    };
    model.space.relations.iter().flat_map(pairs).collect()
}

/// Pairs of directions that joints keep perpendicular, as the arms of a cross.
fn perpendicular(model: &Model, defaults: &[f64]) -> Vec<[Direction; 2]> {
    let pair = |(_, _, relation): &(usize, usize, Relationship)| match relation {
        Relationship::Perpendicular(one, two) => Some([one, two].map(|place| direction(model, defaults, place.body, place.local))),
        _ => None,
    };
    model.space.relations.iter().filter_map(pair).collect()
}

fn axes_of(model: &Model, defaults: &[f64], triads: [&Triad; 2], axis: usize) -> [Direction; 2] {
    triads.map(|triad| direction(model, defaults, triad.body, triad.axes[axis]))
}

/// True for two directions of one body that are parallel.
fn is_one(one: Direction, other: Direction) -> bool {
    one.0 == other.0 && between(one.1, other.1).sin() < PARALLEL
}

/// The directions in all bodies that are parallel to one.
fn parallels(related: &[[Direction; 2]], to: Direction) -> Vec<Direction> {
    let mut found = vec![to];
    let mut next = 0;
    while let Some(direction) = found.get(next).copied() {
        next += 1;
        for [one, two] in related {
            for (near, far) in [(one, two), (two, one)] {
                if is_one(*near, direction) && !found.iter().any(|known| is_one(*known, *far)) {
                    found.push(*far);
                }
            }
        }
    }
    found
}

/// Angle between two directions, in rad; not a number if one of them depends on a Rust function.
fn between(one: [f64; 3], two: [f64; 3]) -> f64 {
    let cross = [0, 1, 2].map(|k| one[(k + 1) % 3] * two[(k + 2) % 3] - one[(k + 2) % 3] * two[(k + 1) % 3]);
    let sine = cross.iter().map(|part| part * part).sum::<f64>().sqrt();
    let cosine: f64 = one.iter().zip(two).map(|(one, two)| one * two).sum();
    libm::atan2(sine, cosine)
}

fn direction(model: &Model, defaults: &[f64], body: Option<usize>, local: Triple) -> Direction {
    let parts = values(model, defaults, &local);
    (body, [parts[0], parts[1], parts[2]])
}

/// The defaults of the parameters.
fn defaults(model: &Model) -> Vec<f64> {
    let all: Vec<Expr> = model.parameters.iter().map(|parameter| parameter.default).collect();
    values(model, &[], &all)
}

fn values(model: &Model, parameters: &[f64], exprs: &[Expr]) -> Vec<f64> {
    let functions = |_: u32, _: f64| [f64::NAN; 3];
    evaluate(
        &model.arena,
        exprs,
        &Values { time: 0.0, parameters, coordinates: &[], speeds: &[], accelerations: &[], functions: &functions },
    )
}
