//! Mobility: the number of equations must match the freedoms. Reports missing drives, and joints and drives that over-constrain.
//!
//! In: a [`System`] and the redundant equations, which are checked instead of solved. Out: at most one refusal per mistake, since each
//! check sees only what earlier checks have accepted. Of an item of a component or a loop, which has many instances, the first is refused.

mod freedoms;
mod overdetermined;

use crate::diag::Diag;
use crate::model::Model;
use crate::redundancy::Redundancy;
use crate::structure::{Structure, overdetermined, underdetermined};
use crate::system::System;

/// Matches every unknown to an equation of its own and every equation to an unknown; refuses the mechanism if this fails.
pub(crate) fn check(model: &Model, system: &System, redundancy: &Redundancy, structure: &Structure, diag: &mut Diag) -> Option<()> {
    let Some(exact) = &redundancy.exact else { return Some(()) };
    // A joint that is not redundant as a whole may have redundant rows.
    exact.no_row_follows_from_others(false, diag);
    if !diag.is_clean() {
        return None;
    }
    let Structure { pattern, matching, .. } = structure;
    let over = overdetermined(pattern, matching);
    let under = underdetermined(pattern, matching);
    match (over.equations.is_empty(), under.unknowns.is_empty()) {
        (true, true) => exact.no_rows_collide(diag),
        (true, false) => freedoms::nothing_is_free(model, system, pattern, matching, &under, diag),
        (false, _) => overdetermined::nothing_is_demanded_twice(model, system, pattern, &under, diag),
    }
    diag.is_clean().then_some(())
}
