//! Where a system has too many equations and where too few.
//!
//! Reference: Dulmage, Mendelsohn (1958), Coverings of bipartite graphs; Pothen, Fan (1990), Computing the block triangular form
//! of a sparse matrix.

use super::incidence::Incidence;
use super::matching::Matching;
use std::collections::BTreeSet;

/// A part of a system: equations and the unknowns they have.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Part {
    pub(super) equations: BTreeSet<usize>,
    pub(super) unknowns: BTreeSet<usize>,
}

/// The equations that contend for too few unknowns: all that can be reached from an equation without an unknown.
pub(super) fn overdetermined(incidence: &Incidence, matching: &Matching) -> Part {
    contending(incidence, matching, matching.free_equations())
}

/// The equations that contend with some that have no unknown. With a single one these are as few as there can be: take any of them
/// away, and every one that remains has an unknown of its own.
pub(super) fn contending(incidence: &Incidence, matching: &Matching, mut open: Vec<usize>) -> Part {
    let mut part = Part::default();
    // What is set aside contends for nothing.
    open.retain(|equation| !incidence.rows[*equation].is_empty());
    while let Some(equation) = open.pop() {
        if !part.equations.insert(equation) {
            continue;
        }
        for entry in &incidence.rows[equation] {
            part.unknowns.insert(entry.unknown);
            open.extend(matching.of_unknown[entry.unknown]);
        }
    }
    part
}

/// The unknowns that share too few equations: all that can be reached from an unknown without an equation.
pub(super) fn underdetermined(incidence: &Incidence, matching: &Matching) -> Part {
    let mut holders: Vec<Vec<usize>> = vec![Vec::new(); incidence.unknowns];
    for (equation, row) in incidence.rows.iter().enumerate() {
        for entry in row {
            holders[entry.unknown].push(equation);
        }
    }
    let mut part = Part::default();
    let mut open = matching.free_unknowns();
    while let Some(unknown) = open.pop() {
        if !part.unknowns.insert(unknown) {
            continue;
        }
        for equation in &holders[unknown] {
            part.equations.insert(*equation);
            open.extend(matching.of_equation[*equation]);
        }
    }
    part
}
