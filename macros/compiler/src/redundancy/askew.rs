//! Loops of hinges that are parallel but for one.
//!
//! In: a model with the relations of its joints. Out: a refusal if in a loop of four hinges some body carries two axes that are a little
//! askew while those of the other bodies are parallel: such hinges lock, and were meant to be parallel. Loops of more hinges can still move.

use super::directions::{angle, is_hinge};
use crate::diag::{Diag, SystemFact};
use crate::expr::Expr;
use crate::model::{Model, Relationship};
use crate::syntax::ast::Closing;
use crate::system::System;
use std::collections::BTreeSet;

/// Axes closer than this, in rad, are parallel.
const PARALLEL: f64 = 1e-7;

/// Axes that were meant to be parallel are closer than this, in rad.
const MEANT: f64 = 0.25;

/// Hinges of a loop that moves in a plane in one way.
const HINGES: usize = 4;

/// A hinge: its joint, and the body (`None` is ground) and the axis on either side.
#[derive(Clone)]
struct Hinge {
    joint: usize,
    bodies: [Option<usize>; 2],
    axes: [[Expr; 3]; 2],
}

/// A body of a loop with the hinges before and after it, and the angle between their axes on it.
struct Corner {
    body: Option<usize>,
    joints: [usize; 2],
    angle: f64,
}

/// Refuses the last hinge of a loop of four in which one axis is askew.
pub(super) fn hinges_are_parallel(model: &Model, system: &System, diag: &mut Diag) -> Option<()> {
    if model.closing != Closing::Deny || !model.task.is_determined() {
        return Some(());
    }
    let hinges = hinges(model);
    for (index, last) in hinges.iter().enumerate() {
        let Some(way) = way_round(&hinges[..index], last).filter(|way| way.len() == HINGES) else { continue };
        let corners = corners(&way, |one, two| angle(model, system, one, two));
        let askew: Vec<&Corner> = corners.iter().filter(|corner| corner.angle > PARALLEL).collect();
        let Some(joints) = shared(&askew).filter(|_| askew.iter().all(|corner| corner.angle < MEANT)) else { continue };
        let name = |joint: &usize| model.joints[*joint].name.to_string();
        let body = |body: Option<usize>| body.map_or("ground".to_owned(), |body| model.bodies[body].name.to_string());
        let others: BTreeSet<usize> = way.iter().map(|hinge| hinge.joint).filter(|joint| !joints.contains(joint)).collect();
        let fact = SystemFact::Askew {
            joints: joints.iter().map(name).collect(),
            bodies: askew.iter().map(|corner| body(corner.body)).collect(),
            angle: askew.iter().map(|corner| corner.angle).fold(0.0, f64::max),
            others: others.iter().map(name).collect(),
        };
        let blamed = joints.iter().max().copied().unwrap_or(last.joint);
        return diag.refuse(&model.joints[blamed].name, fact);
    }
    Some(())
}

/// All joints that keep a point and an axis of one body on those of another, in the order of their declaration.
fn hinges(model: &Model) -> Vec<Hinge> {
    let hinge = |(joint, _, relation): &(usize, usize, Relationship)| {
        let Relationship::SameDirection(one, two) = relation else { return None };
        let is_meant = one.body != two.body && model.joints[*joint].freedom.is_none() && is_hinge(model, *joint);
        is_meant.then_some(Hinge { joint: *joint, bodies: [one.body, two.body], axes: [one.axes[2], two.axes[2]] })
    };
    let mut hinges: Vec<Hinge> = model.space.relations.iter().filter_map(hinge).collect();
    hinges.sort_by_key(|hinge| hinge.joint);
    hinges
}

/// A shortest loop of hinges that ends with `last`; each hinge is turned so that its second body is the first one of the next.
fn way_round(hinges: &[Hinge], last: &Hinge) -> Option<Vec<Hinge>> {
    let [end, begin] = last.bodies;
    let mut ways: Vec<Vec<Hinge>> = vec![Vec::new()];
    let mut seen = BTreeSet::from([begin]);
    let mut next = 0;
    while let Some(way) = ways.get(next).cloned() {
        next += 1;
        if way.len() + 1 >= HINGES {
            continue;
        }
        let here = way.last().map_or(begin, |hinge| hinge.bodies[1]);
        for hinge in hinges {
            let turned = match hinge.bodies {
                [one, _] if one == here => hinge.clone(),
                [one, two] if two == here => Hinge { joint: hinge.joint, bodies: [two, one], axes: [hinge.axes[1], hinge.axes[0]] },
                _ => continue,
            };
            let reached = turned.bodies[1];
            let longer: Vec<Hinge> = way.iter().cloned().chain([turned]).collect();
            if reached == end {
                return Some(longer.into_iter().chain([last.clone()]).collect());
            }
            if seen.insert(reached) {
                ways.push(longer);
            }
        }
    }
    None
}

fn corners(way: &[Hinge], angle: impl Fn([Expr; 3], [Expr; 3]) -> f64) -> Vec<Corner> {
    let pairs = way.iter().zip(way.iter().cycle().skip(1));
    let corner = |(one, two): (&Hinge, &Hinge)| Corner {
        body: one.bodies[1],
        joints: [one.joint, two.joint],
        angle: angle(one.axes[1], two.axes[0]),
    };
    pairs.map(corner).collect()
}

/// The joints whose axis is askew: both of a single body, the one that two neighbouring bodies share.
fn shared(askew: &[&Corner]) -> Option<Vec<usize>> {
    match askew {
        [only] => Some(only.joints.to_vec()),
        [one, two] => one.joints.iter().find(|joint| two.joints.contains(joint)).map(|joint| vec![*joint]),
        _ => None,
    }
}
