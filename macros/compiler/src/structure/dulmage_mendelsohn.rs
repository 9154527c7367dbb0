//! Where a system has too many equations and where too few.
//!
//! Reference: Dulmage, Mendelsohn (1958), Coverings of bipartite graphs; Pothen, Fan (1990), Computing the block triangular form
//! of a sparse matrix.

use super::matching::Matching;
use super::pattern::Pattern;
use std::collections::BTreeSet;

/// A part of the decomposition: equations, and the unknowns in them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct DmPart {
    pub(crate) equations: BTreeSet<usize>,
    pub(crate) unknowns: BTreeSet<usize>,
}

/// The equations that contend for too few unknowns: all that can be reached from an equation without an unknown.
pub(crate) fn overdetermined(pattern: &Pattern, matching: &Matching) -> DmPart {
    contending(pattern, matching, matching.free_equations())
}

/// The equations that contend with some that have no unknown. With a single one these are as few as there can be: take any of them
/// away, and every one that remains has an unknown of its own.
pub(crate) fn contending(pattern: &Pattern, matching: &Matching, mut open: Vec<usize>) -> DmPart {
    let mut part = DmPart::default();
    // What is set aside contends for nothing.
    open.retain(|equation| !pattern.rows[*equation].is_empty());
    while let Some(equation) = open.pop() {
        if !part.equations.insert(equation) {
            continue;
        }
        for entry in &pattern.rows[equation] {
            part.unknowns.insert(entry.unknown);
            open.extend(matching.of_unknown[entry.unknown]);
        }
    }
    part
}

/// The unknowns that share too few equations: all that can be reached from an unknown without an equation.
pub(crate) fn underdetermined(pattern: &Pattern, matching: &Matching) -> DmPart {
    let mut holders: Vec<Vec<usize>> = vec![Vec::new(); pattern.unknowns];
    for (equation, row) in pattern.rows.iter().enumerate() {
        for entry in row {
            holders[entry.unknown].push(equation);
        }
    }
    let mut part = DmPart::default();
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
