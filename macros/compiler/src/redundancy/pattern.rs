//! What the pattern of Φ_q says of redundancy.

use crate::model::Model;
use crate::structure::{SMALL, Subsystem, maximum_in, subsystems};
use crate::system::System;
use std::collections::BTreeSet;

/// The subsystems of a system of which some equations may follow from others; none if there is nothing to ask.
///
/// Where a joint is marked as redundant its equations are the first to be left over.
pub(super) fn overdetermined(model: &Model, system: &System) -> Option<Vec<Subsystem>> {
    let is_marked = |equation: &usize| model.joints[system.equations[*equation].joint].is_redundant;
    if model.equations_only {
        return None;
    }
    let has_mark = model.joints.iter().any(|joint| joint.is_redundant);
    let matching = maximum_in(&system.pattern, in_turn(model, system));
    if !has_mark && matching.free_equations().is_empty() {
        return None;
    }
    if system.coordinates.len() <= SMALL {
        let unknowns = (0..system.coordinates.len()).collect();
        return Some(vec![Subsystem { unknowns, equations: (0..system.equations.len()).collect(), is_overdetermined: true }]);
    }
    // Where freedoms are left in a large system, drives are what is missing first.
    matching.free_unknowns().is_empty().then(|| subsystems(&system.pattern, &matching, is_marked))
}

/// The equations that are left over by their pattern alone, those of redundant joints before others.
pub(super) fn left_over(model: &Model, system: &System) -> BTreeSet<usize> {
    let is_marked = |equation: &usize| model.joints[system.equations[*equation].joint].is_redundant;
    maximum_in(&system.pattern, in_turn(model, system)).free_equations().into_iter().filter(is_marked).collect()
}

/// What moves the mechanism first, so that what is left over are the joints that only follow; redundant ones last.
fn in_turn(model: &Model, system: &System) -> impl Iterator<Item = usize> {
    let rank = |equation: &usize| {
        let joint = &model.joints[system.equations[*equation].joint];
        (joint.is_redundant, !joint.is_drive)
    };
    let mut all: Vec<usize> = (0..system.equations.len()).collect();
    all.sort_by_key(rank);
    all.into_iter()
}
