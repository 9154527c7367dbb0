//! More equations than unknowns: finds minimal groups of joints and drives that over-constrain.
//!
//! Joints come first, then drives, both in declaration order. An unmatched equation thus depends on equations before it, and
//! [`contending`] finds the smallest over-constrained group around it. So joints are blamed only for conflicts among joints, and a drive
//! only if the joints alone are consistent.

use super::freedoms::driven;
use crate::diag::{Diag, Fact, MotionFact, SystemFact};
use crate::model::{Model, Said};
use crate::redundancy::free_beside;
use crate::structure::{DmPart, Pattern, contending, maximum};
use crate::system::System;
use std::collections::{BTreeMap, BTreeSet};

/// An over-constrained group of equations, and its first unmatched equation.
struct Contention {
    part: DmPart,
    first: usize,
}

/// Refuses groups with more equations than unknowns. `under`: given, the underdetermined part.
pub(super) fn nothing_is_demanded_twice(model: &Model, system: &System, pattern: &Pattern, under: &DmPart, diag: &mut Diag) {
    let mut said = Said::default();
    for group in groups(model, system, pattern) {
        let joints: BTreeSet<usize> = group.part.equations.iter().map(|equation| system.equations[*equation].joint).collect();
        let (drives, joints): (Vec<usize>, Vec<usize>) = joints.into_iter().partition(|joint| model.joints[*joint].is_drive);
        let free: BTreeSet<usize> = under.unknowns.difference(&group.part.unknowns).copied().collect();
        let view = Contenders { model, system, group: &group, free: &free, missing: under.equations.len() };
        let (blamed, fact) = match drives.as_slice() {
            [] => joints_contend(&view, &joints),
            [freedom] if model.joints[*freedom].freedom.is_some() => (*freedom, freedom_is_held(&view, *freedom, &joints)),
            [drive] => (*drive, nothing_to_drive(&view, *drive, &joints).into()),
            _ => (drives[drives.len() - 1], drives_contend(&view, &drives, &joints).into()),
        };
        if said.is_new(&model.joints[blamed].name) {
            diag.refuse::<()>(&model.joints[blamed].name, fact);
        }
    }
}

/// A group and its surroundings.
struct Contenders<'a> {
    model: &'a Model,
    system: &'a System,
    group: &'a Contention,
    /// Underdetermined coordinates outside the group.
    free: &'a BTreeSet<usize>,
    /// Number of equations of the underdetermined part.
    missing: usize,
}

impl Contenders<'_> {
    fn joints(&self, joints: &[usize]) -> Vec<String> {
        joints.iter().map(|joint| self.model.joints[*joint].name.to_string()).collect()
    }

    fn coordinates(&self, unknowns: &BTreeSet<usize>) -> Vec<String> {
        let mut names: Vec<String> = unknowns.iter().map(|unknown| self.system.name(self.model, *unknown)).collect();
        names.dedup();
        names
    }

    /// The coordinates that are left free, as a drive could prescribe them.
    fn drivable(&self) -> Vec<String> {
        let free: Vec<usize> = self.free.iter().copied().collect();
        driven(self.model, self.system, &free)
    }

    /// Number of joint equations in the group.
    fn of_joints(&self) -> usize {
        let is_drive = |equation: &&usize| self.model.joints[self.system.equations[**equation].joint].is_drive;
        self.group.part.equations.iter().filter(|equation| !is_drive(equation)).count()
    }
}

/// Joints alone over-constrain: the mobility of the group is negative.
fn joints_contend(view: &Contenders, joints: &[usize]) -> (usize, Fact) {
    let blamed = view.system.equations[view.group.first].joint;
    let others: Vec<usize> = joints.iter().copied().filter(|joint| *joint != blamed).collect();
    let fact = SystemFact::TooManyEquations {
        joint: view.model.joints[blamed].name.to_string(),
        others: view.joints(&others),
        equations: view.group.part.equations.len(),
        coordinates: view.coordinates(&view.group.part.unknowns),
        free: view.drivable(),
        for_free: view.missing,
    };
    (blamed, fact.into())
}

/// The joints leave no motion for a freedom.
fn freedom_is_held(view: &Contenders, freedom: usize, joints: &[usize]) -> Fact {
    let declared = &view.model.joints[freedom];
    let (by, mut free) = (view.joints(joints), view.drivable());
    if free.is_empty() && declared.residuals.len() > 1 {
        free = free_beside(view.model, view.system, freedom);
    }
    MotionFact::FreedomIsHeld { freedom: declared.name.to_string(), of: declared.residuals.len(), by, free }.into()
}

/// The joints leave a drive no freedom.
fn nothing_to_drive(view: &Contenders, drive: usize, joints: &[usize]) -> SystemFact {
    let held_by = view.model.held_by(drive, joints.iter().copied());
    if held_by.is_none() && view.group.part.unknowns.len() > view.of_joints() {
        return drives_contend(view, &[drive], joints);
    }
    SystemFact::NothingToDrive {
        drive: view.model.joints[drive].name.to_string(),
        joints: view.joints(joints),
        equations: [view.of_joints(), joints.iter().map(|joint| view.model.joints[*joint].residuals.len()).sum()],
        coordinates: view.coordinates(&view.group.part.unknowns),
        free: view.drivable(),
        neglected: view.model.neglected(joints.iter().copied()),
        held_by,
    }
}

/// The joints leave fewer freedoms than there are drives for them.
fn drives_contend(view: &Contenders, drives: &[usize], joints: &[usize]) -> SystemFact {
    let free: Vec<usize> = drives.iter().copied().filter(|drive| view.model.joints[*drive].freedom.is_some()).collect();
    // In space, joints that hold by the choice of the unknowns leave freedoms too.
    let bodies = view.group.part.unknowns.iter().map(|unknown| view.system.coordinates[*unknown].body);
    let reached = bodies.filter_map(|body| view.system.space.reached.get(body).copied().flatten()).map(|(joint, _)| joint);
    let joints: BTreeSet<usize> = joints.iter().copied().chain(reached).collect();
    let joints: Vec<usize> = joints.into_iter().collect();
    SystemFact::DrivesContend {
        drives: view.joints(drives),
        declared_free: view.joints(&free),
        numbers: drives.iter().map(|drive| view.model.joints[*drive].residuals.len()).sum(),
        freedoms: view.group.part.unknowns.len() - view.of_joints(),
        joints: view.joints(&joints),
        coordinates: view.coordinates(&view.group.part.unknowns),
        free: view.drivable(),
        in_space: view.system.declared.is_some(),
    }
}

/// Over-constrained groups: drives with shared equations are merged; of joints with shared equations the first group is kept.
fn groups(model: &Model, system: &System, pattern: &Pattern) -> Vec<Contention> {
    let mut order: Vec<usize> = (0..system.equations.len()).collect();
    order.sort_by_key(|equation| model.joints[system.equations[*equation].joint].is_drive);
    let ordered = pattern.in_order(&order);
    let matching = maximum(&ordered);
    let mut groups: Vec<Option<Contention>> = Vec::new();
    let mut group_of: BTreeMap<usize, usize> = BTreeMap::new();
    for free in matching.free_equations() {
        if ordered.rows[free].is_empty() {
            // A redundant row, checked instead of solved.
            continue;
        }
        let DmPart { equations, unknowns } = contending(&ordered, &matching, vec![free]);
        let mut joined =
            Contention { part: DmPart { equations: equations.iter().map(|row| order[*row]).collect(), unknowns }, first: order[free] };
        let is_of_drive = |equation: usize| model.joints[system.equations[equation].joint].is_drive;
        let known: BTreeSet<usize> = joined.part.equations.iter().filter_map(|equation| group_of.get(equation).copied()).collect();
        // If joints alone over-constrain, a drive is not blamed as well.
        if is_of_drive(joined.first) && known.iter().any(|known| groups[*known].as_ref().is_some_and(|group| !is_of_drive(group.first))) {
            continue;
        }
        // Report one over-constrained group per joint; a further group of the same joints shows once this one is fixed.
        let joint = system.equations[joined.first].joint;
        let is_of_another = |group: &Contention| system.equations[group.first].joint != joint;
        if !is_of_drive(joined.first) && known.iter().any(|known| groups[*known].as_ref().is_some_and(is_of_another)) {
            continue;
        }
        for other in known.iter().rev().filter_map(|known| groups[*known].take()) {
            joined.part.equations.extend(&other.part.equations);
            joined.part.unknowns.extend(&other.part.unknowns);
            joined.first = other.first;
        }
        group_of.extend(joined.part.equations.iter().map(|equation| (*equation, groups.len())));
        groups.push(Some(joined));
    }
    groups.into_iter().flatten().collect()
}
