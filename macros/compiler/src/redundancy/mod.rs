//! Equations that depend on others along the whole motion. They are redundant; equations that depend on others at a single configuration
//! only make it singular.
//!
//! In: a [`System`]. Out: the equations of redundant joints, which are checked instead of solved, and a refusal of every other joint that
//! adds nothing or contradicts the rest. Parameters have their declared values: the third crank of a parallelogram is redundant, although
//! with other lengths the linkage would not close. Not done here: counting equations and over-determined drives, both in `mobility`.

mod askew;
mod contradiction;
mod directions;
mod elimination;
mod exact;
mod identity;
mod pattern;
mod rows;

use crate::diag::{Diag, MotionFact, SystemFact};
use crate::model::{Model, Said};
use crate::numeric::basis::{Basis, Matrix};
use crate::numeric::samples::Samples;
use crate::numeric::{Numeric, at_defaults};
use crate::structure::{Block, SMALL, Structure, Subsystem};
use crate::syntax::ast::Closing;
use crate::system::System;
pub(crate) use exact::{ExactDependence, free_beside};
use rows::Rows;
use std::collections::{BTreeMap, BTreeSet};

/// Redundant rows of a system.
pub(crate) struct Redundancy<'a> {
    /// The equations that are checked instead of solved.
    pub(crate) rows: BTreeSet<usize>,
    /// Rows that depend on others by exact elimination; `None` if only equations are wanted.
    pub(crate) exact: Option<ExactDependence<'a>>,
}

/// Finds the equations that are checked instead of solved. A mechanism of which only equations are wanted has none.
pub(crate) fn find<'a>(model: &'a Model, system: &'a System, diag: &mut Diag) -> Option<Redundancy<'a>> {
    identity::rows_depend_on_positions(model, system, diag)?;
    directions::axes_agree(model, system, diag)?;
    askew::hinges_are_parallel(model, system, diag)?;
    let exact = model.task.is_determined().then(|| ExactDependence::new(model, system));
    exact.iter().for_each(|exact| exact.no_row_follows_from_others(true, diag));
    if !diag.is_clean() {
        return None;
    }
    Some(Redundancy { rows: left_over(model, system, diag)?, exact })
}

/// Finds the redundant equations; by their pattern alone if `#[closure(…)]` accepts placeholder defaults.
///
/// If there are too many equations, or joints are declared as redundant, a numerical test tells which equations depend on others. As many
/// equations of joints declared as redundant are left out as possible; the remaining ones are chosen to be farthest from singular over the
/// motion.
fn left_over(model: &Model, system: &System, diag: &mut Diag) -> Option<BTreeSet<usize>> {
    if model.closing != Closing::Deny {
        return Some(pattern::left_over(model, system));
    }
    let Some(subsystems) = pattern::overdetermined(model, system) else { return Some(BTreeSet::new()) };
    at_defaults(model, system, |numeric| {
        let mut search = Search { numeric, subsystems: &subsystems, said: Said::default(), diag };
        let checked = search.surplus();
        search.diag.is_clean().then_some(checked)
    })
}

/// Refuses a mechanism with as many equations as unknowns whose equations are dependent along the whole motion.
///
/// A mechanism that is singular at its start only, or cannot move from there, is not refused: it is at a dead point.
pub(crate) fn equations_are_independent(numeric: &Numeric, structure: &Structure, start: &[f64], diag: &mut Diag) -> Option<()> {
    if numeric.model.closing == Closing::Deny && numeric.has_singular_block(structure, start) {
        let subsystems = subsystems(numeric.system, structure);
        Search { numeric, subsystems: &subsystems, said: Said::default(), diag }.dependence(start);
    }
    diag.is_clean().then_some(())
}

/// Refuses a drive of a freedom that joints have already removed, such as a drive between two sides of a triangle: without the drive
/// everything closes, and at every perturbed assembly the drive's row depends on rows of joints. The pattern does not show this.
pub(crate) fn drives_have_something_to_drive(
    numeric: &Numeric,
    structure: &Structure,
    start: &[f64],
    is_open: bool,
    diag: &mut Diag,
) -> Option<()> {
    let is_suspicious = is_open || numeric.has_singular_block(structure, start);
    if numeric.system.coordinates.len() > SMALL || !is_suspicious {
        return Some(());
    }
    let subsystems = subsystems(numeric.system, structure);
    let subsystem = subsystems.first()?;
    let names = |joints: BTreeSet<usize>| joints.iter().map(|joint| numeric.model.joints[*joint].name.to_string()).collect();
    for (drive, declared) in numeric.model.joints.iter().enumerate().filter(|(_, joint)| joint.is_drive) {
        let is_of_it = |equation: usize| numeric.system.equations[equation].joint == drive;
        let there = || (start.to_vec(), true);
        let (q, is_closed) = if !is_open { there() } else { numeric.assembled_in_order(&subsystems, is_of_it) };
        if !is_closed {
            continue;
        }
        let poses = numeric.matrices(subsystem, &numeric.pushed(&subsystems, q, is_of_it));
        let mut basis = Basis::new(&poses);
        let (own, others): (Vec<usize>, Vec<usize>) =
            numeric.rows(subsystem).plain.into_iter().partition(|row| is_of_it(subsystem.equations[*row]));
        others.into_iter().for_each(|row| basis.take(row));
        let joints: BTreeSet<usize> = own
            .into_iter()
            .filter(|row| poses.len() > 2 && !basis.lacks(*row))
            .flat_map(|row| basis.sources(row))
            .map(|row| numeric.system.equations[subsystem.equations[row]].joint)
            .collect();
        if !joints.is_empty() && joints.iter().all(|joint| !numeric.model.joints[*joint].is_drive) {
            let free = numeric.names(subsystem, &basis.free(subsystem.unknowns.len()));
            let neglected = numeric.model.neglected(joints.iter().copied());
            let held_by = numeric.model.held_by(drive, joints.iter().copied());
            let (name, by) = (declared.name.to_string(), names(joints));
            if declared.freedom.is_some() {
                let of = declared.residuals.len();
                return diag.refuse(&declared.name, MotionFact::FreedomIsHeld { freedom: name, of, by, free });
            }
            let (equations, coordinates) = ([0; 2], Vec::new());
            let fact = SystemFact::NothingToDrive { drive: name, joints: by, equations, coordinates, free, neglected, held_by };
            return diag.refuse(&declared.name, fact);
        }
    }
    Some(())
}

/// The solved equations: of a small system all together, of a large one block by block.
pub(crate) fn subsystems(system: &System, structure: &Structure) -> Vec<Subsystem> {
    let subsystem = |block: &Block| Subsystem {
        unknowns: block.explicit.iter().map(|explicit| explicit.unknown).chain(block.iterated.iter().copied()).collect(),
        equations: block.explicit.iter().map(|explicit| explicit.equation).chain(block.residuals.iter().copied()).collect(),
        is_overdetermined: !block.iterated.is_empty(),
    };
    let subsystems: Vec<Subsystem> = structure.blocks.iter().map(subsystem).collect();
    if system.coordinates.len() > SMALL {
        return subsystems;
    }
    let checked: BTreeSet<usize> = structure.checked.iter().copied().collect();
    let equations = (0..system.equations.len()).filter(|equation| !checked.contains(equation)).collect();
    vec![Subsystem { unknowns: (0..system.coordinates.len()).collect(), equations, is_overdetermined: true }]
}

/// Search for redundant and contradictory equations.
pub(super) struct Search<'a, 'b> {
    pub(super) numeric: &'a Numeric<'b>,
    pub(super) subsystems: &'a [Subsystem],
    /// Names already reported: an item in a loop has many instances, and a mistake is reported for the first only.
    said: Said,
    pub(super) diag: &'a mut Diag,
}

impl Search<'_, '_> {
    fn surplus(&mut self) -> BTreeSet<usize> {
        let nothing = |_: usize| false;
        let (mut start, mut is_closed) = self.numeric.assembled_in_order(self.subsystems, nothing);
        let is_marked = self.joints().into_iter().any(|joint| self.numeric.model.joints[joint].is_redundant);
        if !is_closed && is_marked {
            // No joint is said to contradict the others before other beginnings than the declared start have been tried.
            (start, is_closed) = self.numeric.assembled_widely(self.subsystems, start);
        }
        if !is_closed {
            self.contradiction(&self.numeric.least_open(self.subsystems, start));
            return BTreeSet::new();
        }
        let samples = self.numeric.samples(self.subsystems, &start, nothing);
        if !samples.holds {
            self.contradiction_on_the_way(&start);
            return BTreeSet::new();
        }
        let subsystems: Vec<&Subsystem> = self.subsystems.iter().filter(|subsystem| subsystem.is_overdetermined).collect();
        let checked = subsystems.iter().flat_map(|subsystem| self.left_over(subsystem, &samples)).collect();
        if self.diag.is_clean() {
            self.contradiction_of_checks(&start, &checked);
        }
        checked
    }

    /// The redundant equations of a subsystem; dependent rows of joints not declared as redundant are refused.
    fn left_over(&mut self, subsystem: &Subsystem, samples: &Samples) -> Vec<usize> {
        let poses = self.numeric.matrices(subsystem, &samples.poses);
        let rows = self.numeric.rows(subsystem);
        let mut basis = Basis::new(&poses);
        let dependent: Vec<usize> = rows.plain.iter().copied().filter(|row| !basis.takes(*row)).collect();
        // `mobility` reports drives that add nothing.
        let dependent: Vec<usize> = dependent.into_iter().filter(|row| !self.numeric.joint(subsystem, *row).is_drive).collect();
        let free = if rows.marked.is_empty() { self.numeric.names(subsystem, &basis.free(subsystem.unknowns.len())) } else { Vec::new() };
        self.refuse_dependent(&basis, subsystem, &dependent, &free, samples.moves);
        if !self.diag.is_clean() {
            return Vec::new();
        }
        let mut open = rows.marked.clone();
        // Add the best independent row, one at a time.
        loop {
            let candidates = open.iter().copied().filter(|row| basis.lacks(*row)).map(|row| (row, basis.fitness(row)));
            let Some((best, _)) = candidates.reduce(|best, next| if next.1 > best.1 + 1e-9 { next } else { best }) else { break };
            basis.take(best);
            open.retain(|row| *row != best);
        }
        self.marks_are_meant(&basis, subsystem, &rows, &open, &poses);
        open.into_iter().map(|row| subsystem.equations[row]).collect()
    }

    /// Refuses joints declared as redundant that have no equation dependent on others.
    fn marks_are_meant(&mut self, basis: &Basis, subsystem: &Subsystem, rows: &Rows, left_over: &[usize], poses: &[Matrix]) {
        let joint = |row: &usize| self.numeric.system.equations[subsystem.equations[*row]].joint;
        let involved: BTreeSet<usize> =
            left_over.iter().flat_map(|row| basis.sources(*row).into_iter().chain([*row])).map(|row| joint(&row)).collect();
        let marked: BTreeSet<usize> = rows.marked.iter().map(joint).collect();
        for needed in marked.difference(&involved) {
            let mut without = Basis::new(poses);
            for row in rows.plain.iter().chain(&rows.marked).filter(|row| joint(row) != *needed) {
                without.takes(*row);
            }
            let free = self.numeric.names(subsystem, &without.free(subsystem.unknowns.len()));
            let name = &self.numeric.model.joints[*needed].name;
            if !self.said.is_new(name) {
                continue;
            }
            self.diag.refuse::<()>(name, SystemFact::NotRedundant { joint: name.to_string(), free });
        }
    }

    /// As many equations as unknowns: refuses those that are dependent.
    fn dependence(&mut self, start: &[f64]) {
        let samples = self.numeric.samples(self.subsystems, start, |_| false);
        for subsystem in self.subsystems.iter().filter(|subsystem| subsystem.is_overdetermined) {
            // A singular start proves nothing: the rows must be dependent at several other poses.
            if samples.poses.len() < 3 || !self.diag.is_clean() {
                return;
            }
            let poses = self.numeric.matrices(subsystem, &samples.poses);
            let mut basis = Basis::new(&poses);
            let dependent: Vec<usize> = self.numeric.rows(subsystem).plain.into_iter().filter(|row| !basis.takes(*row)).collect();
            let free = self.numeric.names(subsystem, &basis.free(subsystem.unknowns.len()));
            self.refuse_dependent(&basis, subsystem, &dependent, &free, samples.moves);
        }
    }

    /// Reports one refusal per joint with dependent equations.
    fn refuse_dependent(&mut self, basis: &Basis, subsystem: &Subsystem, dependent: &[usize], free: &[String], moves: bool) {
        let joint = |row: &usize| self.numeric.system.equations[subsystem.equations[*row]].joint;
        let mut of_joint: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        dependent.iter().for_each(|row| of_joint.entry(joint(row)).or_default().push(*row));
        for (index, own) in of_joint {
            let mut sources: BTreeSet<usize> = own.iter().flat_map(|row| basis.sources(*row)).map(|row| joint(&row)).collect();
            sources.extend(self.numeric.system.loop_of(index));
            if sources.is_empty() {
                // A row with zero gradient (a square at its root) is neither solvable nor dependent on others; it is reported elsewhere.
                continue;
            }
            let model = self.numeric.model;
            let others = sources.iter().filter(|other| **other != index).map(|other| model.joints[*other].name.to_string()).collect();
            let name = &model.joints[index].name;
            if !self.said.is_new(name) {
                continue;
            }
            let is_in_space = self.numeric.system.declared.is_some();
            let kinds = sources.iter().chain([&index]).filter(|_| is_in_space).map(|joint| model.joints[*joint].kind.clone()).collect();
            let fact = SystemFact::FollowsFrom {
                joint: name.to_string(),
                is_drive: model.joints[index].is_drive,
                rows: own.len(),
                of: model.joints[index].residuals.len(),
                others,
                free: free.to_vec(),
                moves,
                kinds,
            };
            self.diag.refuse::<()>(name, fact);
        }
    }
}
