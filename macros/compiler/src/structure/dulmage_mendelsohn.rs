//! Dulmage-Mendelsohn decomposition: the overdetermined and the underdetermined part of a system.
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

/// The overdetermined part: all equations that can be reached from an unmatched equation, and their unknowns.
pub(crate) fn overdetermined(pattern: &Pattern, matching: &Matching) -> DmPart {
    contending(pattern, matching, matching.free_equations())
}

/// The equations that compete with the given ones for unknowns. With a single unmatched equation this set is minimal: without any one
/// of them, all the others can be matched.
pub(crate) fn contending(pattern: &Pattern, matching: &Matching, mut open: Vec<usize>) -> DmPart {
    let mut part = DmPart::default();
    // An empty row competes for no unknown.
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

/// The underdetermined part: all unknowns that can be reached from an unmatched unknown, and their equations.
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
