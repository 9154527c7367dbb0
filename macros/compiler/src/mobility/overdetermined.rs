//! More equations than unknowns: which joints and drives contend, as few of them as there are.
//!
//! Joints come first, then drives, both as declared; an equation that finds no unknown then depends on those before it, and what
//! [`contending`] reaches from it is the smallest group that is too much. So joints are blamed only for what they do to each other,
//! and a drive for what it adds to them.

use crate::diag::{Diag, SystemFact};
use crate::model::{Model, Said};
use crate::structure::{DmPart, Pattern, contending, maximum};
use crate::system::System;
use std::collections::{BTreeMap, BTreeSet};

/// Equations that contend for unknowns, and the first of them that found none.
struct Contention {
    part: DmPart,
    first: usize,
}

/// No group of equations is larger than the number of unknowns that it has. `under`: given, where equations are missing.
pub(super) fn nothing_is_demanded_twice(model: &Model, system: &System, pattern: &Pattern, under: &DmPart, diag: &mut Diag) {
    let mut said = Said::default();
    for group in groups(model, system, pattern) {
        let joints: BTreeSet<usize> = group.part.equations.iter().map(|equation| system.equations[*equation].joint).collect();
        let (drives, joints): (Vec<usize>, Vec<usize>) = joints.into_iter().partition(|joint| model.joints[*joint].is_drive);
        let free: BTreeSet<usize> = under.unknowns.difference(&group.part.unknowns).copied().collect();
        let view = Contenders { model, system, group: &group, free: &free, missing: under.equations.len() };
        let (blamed, fact) = match drives.as_slice() {
            [] => joints_contend(&view, &joints),
            [drive] => (*drive, nothing_to_drive(&view, *drive, &joints)),
            _ => (drives[drives.len() - 1], drives_contend(&view, &drives, &joints)),
        };
        if said.is_new(&model.joints[blamed].name) {
            diag.refuse::<()>(&model.joints[blamed].name, fact);
        }
    }
}

/// A group and what is around it.
struct Contenders<'a> {
    model: &'a Model,
    system: &'a System,
    group: &'a Contention,
    /// Coordinates elsewhere that have too few equations.
    free: &'a BTreeSet<usize>,
    /// How many equations these have.
    missing: usize,
}

impl Contenders<'_> {
    fn joints(&self, joints: &[usize]) -> Vec<String> {
        joints.iter().map(|joint| self.model.joints[*joint].name.to_string()).collect()
    }

    fn coordinates(&self, unknowns: &BTreeSet<usize>) -> Vec<String> {
        unknowns.iter().map(|unknown| self.system.name(self.model, *unknown)).collect()
    }

    /// The equations of joints in the group.
    fn of_joints(&self) -> usize {
        let is_drive = |equation: &&usize| self.model.joints[self.system.equations[**equation].joint].is_drive;
        self.group.part.equations.iter().filter(|equation| !is_drive(equation)).count()
    }
}

/// Joints alone demand more than there is to demand: the mobility of the group is below zero.
fn joints_contend(view: &Contenders, joints: &[usize]) -> (usize, SystemFact) {
    let blamed = view.system.equations[view.group.first].joint;
    let others: Vec<usize> = joints.iter().copied().filter(|joint| *joint != blamed).collect();
    let fact = SystemFact::TooManyEquations {
        joint: view.model.joints[blamed].name.to_string(),
        others: view.joints(&others),
        equations: view.group.part.equations.len(),
        coordinates: view.coordinates(&view.group.part.unknowns),
        free: view.coordinates(view.free),
        for_free: view.missing,
    };
    (blamed, fact)
}

/// Joints leave a drive no freedom.
fn nothing_to_drive(view: &Contenders, drive: usize, joints: &[usize]) -> SystemFact {
    SystemFact::NothingToDrive {
        drive: view.model.joints[drive].name.to_string(),
        joints: view.joints(joints),
        equations: [view.of_joints(), joints.iter().map(|joint| view.model.joints[*joint].residuals.len()).sum()],
        coordinates: view.coordinates(&view.group.part.unknowns),
        free: view.coordinates(view.free),
    }
}

/// Joints leave fewer freedoms than there are drives for them.
fn drives_contend(view: &Contenders, drives: &[usize], joints: &[usize]) -> SystemFact {
    SystemFact::DrivesContend {
        drives: view.joints(drives),
        freedoms: view.group.part.unknowns.len() - view.of_joints(),
        joints: view.joints(joints),
        coordinates: view.coordinates(&view.group.part.unknowns),
        free: view.coordinates(view.free),
    }
}

/// What contends: drives together that share equations, of joints the first group.
fn groups(model: &Model, system: &System, pattern: &Pattern) -> Vec<Contention> {
    let mut order: Vec<usize> = (0..system.equations.len()).collect();
    order.sort_by_key(|equation| model.joints[system.equations[*equation].joint].is_drive);
    let ordered = pattern.in_order(&order);
    let matching = maximum(&ordered);
    let mut groups: Vec<Option<Contention>> = Vec::new();
    let mut group_of: BTreeMap<usize, usize> = BTreeMap::new();
    for free in matching.free_equations() {
        if ordered.rows[free].is_empty() {
            // It is checked, not solved.
            continue;
        }
        let DmPart { equations, unknowns } = contending(&ordered, &matching, vec![free]);
        let mut joined =
            Contention { part: DmPart { equations: equations.iter().map(|row| order[*row]).collect(), unknowns }, first: order[free] };
        let is_of_drive = |equation: usize| model.joints[system.equations[equation].joint].is_drive;
        let known: BTreeSet<usize> = joined.part.equations.iter().filter_map(|equation| group_of.get(equation).copied()).collect();
        // Where joints alone are too many, a drive is not to blame as well.
        if is_of_drive(joined.first) && known.iter().any(|known| groups[*known].as_ref().is_some_and(|group| !is_of_drive(group.first))) {
            continue;
        }
        // What else is too much of the same joints shows when the first is mended; of one joint it is one mistake.
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
