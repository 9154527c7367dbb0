//! Redundancy by the pattern of Φ_q.

use crate::model::Model;
use crate::numeric::at_defaults;
use crate::structure::{SMALL, Subsystem, maximum_in, subsystems};
use crate::system::System;
use std::collections::BTreeSet;

/// Subsystems in which some equations may depend on others; `None` if there is nothing to test.
///
/// Equations of joints declared as redundant are the first to be left over.
pub(super) fn overdetermined(model: &Model, system: &System) -> Option<Vec<Subsystem>> {
    let is_marked = |equation: &usize| model.joints[system.equations[*equation].joint].is_redundant;
    if !model.task.is_determined() {
        return None;
    }
    let has_mark = model.joints.iter().any(|joint| joint.is_redundant);
    let matching = maximum_in(&system.pattern, in_turn(model, system));
    let has_resting = system.declared.is_some() && !at_defaults(model, system, |numeric| numeric.resting().is_empty());
    if !has_mark && !has_resting && matching.free_equations().is_empty() {
        return None;
    }
    if system.coordinates.len() <= SMALL {
        let unknowns = (0..system.coordinates.len()).collect();
        return Some(vec![Subsystem { unknowns, equations: (0..system.equations.len()).collect(), is_overdetermined: true }]);
    }
    // If a large system has freedoms left, missing drives are reported first.
    matching.free_unknowns().is_empty().then(|| subsystems(&system.pattern, &matching, is_marked))
}

/// Equations of redundant joints that are left over by their pattern alone.
pub(super) fn left_over(model: &Model, system: &System) -> BTreeSet<usize> {
    let is_marked = |equation: &usize| model.joints[system.equations[*equation].joint].is_redundant;
    maximum_in(&system.pattern, in_turn(model, system)).free_equations().into_iter().filter(is_marked).collect()
}

/// Equations in the order of the matching: drives, then joints, then joints declared as redundant, so that the last are left over.
fn in_turn(model: &Model, system: &System) -> impl Iterator<Item = usize> {
    let rank = |equation: &usize| {
        let joint = &model.joints[system.equations[*equation].joint];
        (joint.is_redundant, !joint.is_drive)
    };
    let mut all: Vec<usize> = (0..system.equations.len()).collect();
    all.sort_by_key(rank);
    all.into_iter()
}
