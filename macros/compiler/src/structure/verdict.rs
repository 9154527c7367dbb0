//! What does not fit: bodies that nothing holds, freedoms without a drive, joints that demand too much.

use super::incidence::Incidence;
use super::matching::Matching;
use super::parts::{Part, overdetermined, underdetermined};
use crate::diag::{Diag, Fact};
use crate::model::{Dim, Model};
use crate::system::System;
use std::collections::BTreeSet;

/// Every unknown has an equation of its own, and every equation an unknown.
pub(super) fn equations_fit(model: &Model, system: &System, incidence: &Incidence, matching: &Matching, diag: &mut Diag) {
    every_body_is_held(model, system, incidence, diag);
    if !diag.is_clean() {
        return;
    }
    let over = overdetermined(incidence, matching);
    let under = underdetermined(incidence, matching);
    match (over.equations.is_empty(), under.unknowns.is_empty()) {
        (true, true) => {}
        (true, false) => too_few(model, system, incidence, matching, &under, diag),
        (false, _) => too_many(model, system, &over, &under, diag),
    }
}

/// A body whose coordinates occur in no equation is connected to nothing.
fn every_body_is_held(model: &Model, system: &System, incidence: &Incidence, diag: &mut Diag) {
    let held: BTreeSet<usize> = incidence.rows.iter().flatten().map(|entry| system.unknowns[entry.unknown].body).collect();
    for (index, body) in model.bodies.iter().enumerate() {
        if !held.contains(&index) {
            diag.refuse::<()>(&body.name, Fact::BodyIsFree { body: body.name.to_string() });
        }
    }
}

/// Freedoms are left: which coordinates a drive could take.
fn too_few(model: &Model, system: &System, incidence: &Incidence, matching: &Matching, under: &Part, diag: &mut Diag) {
    let angles: BTreeSet<usize> = under.unknowns.iter().copied().filter(|unknown| system.unknowns[*unknown].dim == Dim::ANGLE).collect();
    let candidates = if angles.is_empty() { &under.unknowns } else { &angles };
    let fact = Fact::TooFewEquations {
        name: model.name.to_string(),
        coordinates: system.unknowns.len(),
        equations: incidence.rows.iter().filter(|row| !row.is_empty()).count(),
        missing: matching.free_unknowns().len(),
        drives: drives(model),
        candidates: names(model, system, candidates),
    };
    diag.refuse::<()>(&model.name, fact);
}

/// Joints contend for the same coordinates; elsewhere there may be too few of them.
fn too_many(model: &Model, system: &System, over: &Part, under: &Part, diag: &mut Diag) {
    let joints: BTreeSet<usize> = over.equations.iter().map(|equation| system.equations[*equation].joint).collect();
    let drives: Vec<usize> = joints.iter().copied().filter(|joint| model.joints[*joint].is_drive).collect();
    // Of two drives on one freedom the later one is to blame, else the joint that was added last to what stood before.
    let last_joint = joints.iter().copied().rfind(|joint| !model.joints[*joint].is_drive);
    let blamed = if drives.len() > 1 { drives.last().copied() } else { last_joint.or(drives.last().copied()) };
    let Some(blamed) = blamed else { return };
    let fact = Fact::TooManyEquations {
        joint: model.joints[blamed].name.to_string(),
        others: joints.iter().filter(|joint| **joint != blamed).map(|joint| model.joints[*joint].name.to_string()).collect(),
        equations: over.equations.len(),
        coordinates: names(model, system, &over.unknowns),
        free: names(model, system, &under.unknowns),
        for_free: under.equations.len(),
    };
    diag.refuse::<()>(&model.joints[blamed].name, fact);
}

/// The number of equations that come from drives.
fn drives(model: &Model) -> usize {
    model.joints.iter().filter(|joint| joint.is_drive).map(|joint| joint.residuals.len()).sum()
}

fn names(model: &Model, system: &System, unknowns: &BTreeSet<usize>) -> Vec<String> {
    let name = |unknown: &usize| {
        let unknown = &system.unknowns[*unknown];
        format!("{}.{}", model.bodies[unknown.body].name, unknown.name)
    };
    unknowns.iter().map(name).collect()
}
