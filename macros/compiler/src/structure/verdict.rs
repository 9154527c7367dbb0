//! What does not fit: bodies that nothing holds, rows that say nothing new, freedoms without a drive, joints that demand too much.
//!
//! Each check looks at what the ones before it have left, so that one mistake gives one error. An item of a component or a loop
//! stands many times; what is wrong with it is said of the first.

use super::incidence::Incidence;
use super::matching::Matching;
use super::parts::{overdetermined, underdetermined};
use super::{agreement, grounding, lines, mobility, surplus};
use crate::diag::{Diag, Fact};
use crate::model::{Model, Said};
use crate::system::System;
use std::collections::BTreeSet;

/// Every body is held by ground, and no row says what others say, but those of redundant joints.
pub(super) fn rows_agree(model: &Model, system: &System, incidence: &Incidence, diag: &mut Diag) {
    every_body_is_held(model, system, incidence, diag);
    grounding::every_group_is_on_ground(model, system, incidence, diag);
    if diag.is_clean() {
        agreement::no_row_follows_from_others(model, system, &agreement::dependent(model, system), true, diag);
    }
}

/// Every unknown has an equation of its own, and every equation an unknown.
pub(super) fn equations_fit(model: &Model, system: &System, incidence: &Incidence, matching: &Matching, diag: &mut Diag) {
    let dependent = agreement::dependent(model, system);
    // What numbers have not found to follow as a whole may follow in part.
    agreement::no_row_follows_from_others(model, system, &dependent, false, diag);
    if !diag.is_clean() {
        return;
    }
    let over = overdetermined(incidence, matching);
    let under = underdetermined(incidence, matching);
    match (over.equations.is_empty(), under.unknowns.is_empty()) {
        (true, true) => agreement::no_rows_collide(model, system, &dependent, diag),
        (true, false) => mobility::nothing_is_free(model, system, incidence, matching, &under, diag),
        (false, _) => surplus::nothing_is_demanded_twice(model, system, incidence, &under, diag),
    }
}

/// A body whose coordinates occur in no equation is connected to nothing.
fn every_body_is_held(model: &Model, system: &System, incidence: &Incidence, diag: &mut Diag) {
    let held: BTreeSet<usize> = incidence.rows.iter().flatten().map(|entry| system.unknowns[entry.unknown].body).collect();
    let mut said = Said::default();
    let on_ground = grounding::bodies_on_ground(model, system, incidence);
    for (index, body) in model.bodies.iter().enumerate() {
        if !held.contains(&index) && said.is_new(&body.name) {
            let example = lines::revolute(&lines::place_of_one(model, on_ground.iter().copied()), &lines::place_of(model, index));
            diag.refuse::<()>(&body.name, Fact::BodyIsFree { body: body.name.to_string(), example });
        }
    }
}

/// `crank.angle`
pub(super) fn coordinate(model: &Model, system: &System, unknown: usize) -> String {
    let unknown = &system.unknowns[unknown];
    format!("{}.{}", model.bodies[unknown.body].name, unknown.name)
}
