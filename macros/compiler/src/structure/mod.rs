//! Decomposes a pattern into the blocks in which a system is solved.
//!
//! In: a [`Pattern`]: which equation contains which unknown, and which entries are never zero. Out: a [`Structure`]: blocks of unknowns
//! and equations in the order of solution. Graphs only: names of unknowns and contents of equations are not used here.
//!
//! 1. `matching`: as many unknowns as possible get an equation of their own.
//! 2. `components`: unknowns that can only be found together make a block; blocks are put in order.
//! 3. `tearing`: unknowns of a block that follow explicitly from the others are not iterated.
//! 4. `dulmage_mendelsohn`: the overdetermined and the underdetermined part.
//! 5. `subsystems`: blocks with the unmatched equations that belong to them.
//!
//! Reference: Duff, Erisman, Reid, Direct Methods for Sparse Matrices, chapter 6.

mod components;
mod dulmage_mendelsohn;
mod matching;
mod pattern;
mod subsystems;
mod tearing;
#[cfg(test)]
mod tests;

pub(crate) use components::in_order as components_in_order;
pub(crate) use dulmage_mendelsohn::{DmPart, contending, overdetermined, underdetermined};
pub(crate) use matching::{Matching, maximum, maximum_in};
pub use pattern::{Entry, Pattern};
use std::collections::BTreeSet;
pub(crate) use subsystems::{SMALL, Subsystem, subsystems};

/// Blocks in the order of solution.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Structure {
    /// Blocks, solved one after the other.
    pub blocks: Vec<Block>,
    /// Redundant equations, which follow from the others in every position: they are checked, not solved.
    pub checked: Vec<usize>,
    /// The pattern, with the rows of redundant equations left empty.
    pub(crate) pattern: Pattern,
    /// As many pairs of an equation and an unknown as there can be.
    pub(crate) matching: Matching,
}

/// A block: unknowns that are found together.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Block {
    /// Unknowns computed in order, from the other unknowns of the block and from earlier blocks.
    pub explicit: Vec<Explicit>,
    /// Unknowns found by Newton iteration.
    pub iterated: Vec<usize>,
    /// Equations of the Newton iteration, as many as there are iterated unknowns.
    pub residuals: Vec<usize>,
}

/// An equation solved for an unknown: linear in it, with a coefficient that is never zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Explicit {
    /// The unknown.
    pub unknown: usize,
    /// The equation.
    pub equation: usize,
}

impl Block {
    /// Unknowns and equations of the block, iterated unknowns and residuals first.
    pub(crate) fn parts(&self) -> (Vec<usize>, Vec<usize>) {
        let unknowns = self.iterated.iter().copied().chain(self.explicit.iter().map(|explicit| explicit.unknown)).collect();
        let equations = self.residuals.iter().copied().chain(self.explicit.iter().map(|explicit| explicit.equation)).collect();
        (unknowns, equations)
    }
}

/// Assigns the unknowns to equations and puts the blocks in order.
///
/// The `checked` rows are in no block. If the equations do not fit the unknowns, unmatched ones are in no block either.
pub(crate) fn analyze(pattern: &Pattern, checked: &BTreeSet<usize>) -> Structure {
    let pattern = pattern.without(checked);
    let matching = maximum(&pattern);
    let groups = components::in_order(&pattern, &matching);
    let blocks = groups.iter().map(|group| tearing::tear(&pattern, &matching, group)).collect();
    Structure { blocks, checked: checked.iter().copied().collect(), pattern, matching }
}
