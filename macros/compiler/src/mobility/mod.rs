//! Whether equations fit the freedoms: drives that are missing, joints and drives that demand too much.
//!
//! In: a [`System`], and the equations that are checked instead of solved. Out: at most one refusal for a mistake: each check looks at
//! what the ones before it have left. An item of a component or a loop stands many times; the first is refused.

mod freedoms;
mod overdetermined;

use crate::diag::Diag;
use crate::model::Model;
use crate::redundancy::ExactDependence;
use crate::structure::{maximum, overdetermined, underdetermined};
use crate::system::System;
use std::collections::BTreeSet;

/// Every unknown has an equation of its own, and every equation an unknown.
pub(crate) fn check(model: &Model, system: &System, redundant: &BTreeSet<usize>, diag: &mut Diag) -> Option<()> {
    if model.equations_only {
        return Some(());
    }
    let exact = ExactDependence::new(model, system);
    // What numbers have not found to follow as a whole may follow in part.
    exact.no_row_follows_from_others(false, diag);
    if !diag.is_clean() {
        return None;
    }
    let pattern = system.pattern.without(redundant);
    let matching = maximum(&pattern);
    let over = overdetermined(&pattern, &matching);
    let under = underdetermined(&pattern, &matching);
    match (over.equations.is_empty(), under.unknowns.is_empty()) {
        (true, true) => exact.no_rows_collide(diag),
        (true, false) => freedoms::nothing_is_free(model, system, &pattern, &matching, &under, diag),
        (false, _) => overdetermined::nothing_is_demanded_twice(model, system, &pattern, &under, diag),
    }
    diag.is_clean().then_some(())
}
