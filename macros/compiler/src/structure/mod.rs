//! From a pattern to the blocks in which a system is solved.
//!
//! In: a [`Pattern`]: which equation contains which unknown, and which entries are never zero. Out: a [`Structure`]: which unknowns are
//! found from which equations, in which order. Graphs only: nothing here knows what an unknown is called or what an equation says.
//!
//! 1. `matching`: every unknown gets an equation of its own, as many as can.
//! 2. `components`: unknowns that can only be found together make a block; blocks are put in order.
//! 3. `tearing`: inside a block, what follows explicitly from the rest is not iterated.
//! 4. `dulmage_mendelsohn`: the equations that are too many, and the unknowns that have too few.
//! 5. `subsystems`: blocks with the equations that are too many.
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

pub(crate) use dulmage_mendelsohn::{DmPart, contending, overdetermined, underdetermined};
pub(crate) use matching::{Matching, maximum, maximum_in};
pub use pattern::{Entry, Pattern};
use std::collections::BTreeSet;
pub(crate) use subsystems::{SMALL, Subsystem, subsystems};

/// The order of solution.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Structure {
    /// Solved one after the other.
    pub blocks: Vec<Block>,
    /// Equations that follow from the others in every position: they are checked, not solved.
    pub checked: Vec<usize>,
}

/// Unknowns that are found together.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Block {
    /// Unknowns that are computed from the others of the block and from blocks before it, in order.
    pub explicit: Vec<Explicit>,
    /// Unknowns that Newton's method finds.
    pub iterated: Vec<usize>,
    /// Equations that must vanish for them, as many as there are iterated unknowns.
    pub residuals: Vec<usize>,
}

/// An equation that is linear in an unknown with a coefficient that is never zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Explicit {
    /// The unknown that is computed.
    pub unknown: usize,
    /// The equation that gives it.
    pub equation: usize,
}

impl Block {
    /// Its unknowns and equations, iterated unknowns and residuals first.
    pub(crate) fn parts(&self) -> (Vec<usize>, Vec<usize>) {
        let unknowns = self.iterated.iter().copied().chain(self.explicit.iter().map(|explicit| explicit.unknown)).collect();
        let equations = self.residuals.iter().copied().chain(self.explicit.iter().map(|explicit| explicit.equation)).collect();
        (unknowns, equations)
    }
}

/// Decides which unknowns are found from which equations, and in which order.
///
/// Rows that are `checked` are in no block. Where equations do not fit the unknowns, those without a partner are in no block either.
pub(crate) fn analyze(pattern: &Pattern, checked: &BTreeSet<usize>) -> Structure {
    let pattern = pattern.without(checked);
    let matching = maximum(&pattern);
    let groups = components::in_order(&pattern, &matching);
    let blocks = groups.iter().map(|group| tearing::tear(&pattern, &matching, group)).collect();
    Structure { blocks, checked: checked.iter().copied().collect() }
}
