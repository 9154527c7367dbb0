//! From a system to the blocks it is solved in.
//!
//! In: a [`System`]. Out: a [`Structure`]: which unknowns are found from which equations, in which
//! order. Only the pattern of Φ_q is looked at, and which of its entries are constants. Not done
//! here: numbers.
//!
//! 1. `incidence`: which equation contains which unknown.
//! 2. `matching`: every unknown gets an equation of its own, as many as can.
//! 3. `components`: unknowns that can only be found together make a block; blocks are put in order.
//! 4. `verdict`: where there are too many equations, or too few, the mechanism is refused: `grounding`, `agreement`, `mobility` and
//!    `surplus` say what is wrong, `dependence` finds rows that follow from others.
//! 5. `tearing`: inside a block, what follows explicitly from the rest is not iterated.
//!
//! Reference: Duff, Erisman, Reid, Direct Methods for Sparse Matrices, chapter 6.

mod agreement;
mod components;
mod dependence;
mod grounding;
mod incidence;
mod lines;
mod matching;
mod mobility;
mod parts;
mod pieces;
mod surplus;
mod tearing;
#[cfg(test)]
mod tests;
mod verdict;

use crate::diag::Diag;
use crate::model::Model;
use crate::system::System;
use incidence::Incidence;
pub(crate) use pieces::{Piece, left_over, surplus};
use std::collections::BTreeSet;

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

/// Refuses bodies that nothing holds, and equations that say what others say by exact arithmetic.
pub(crate) fn rows_agree(model: &Model, system: &System, diag: &mut Diag) -> Option<()> {
    if !model.equations_only {
        verdict::rows_agree(model, system, &Incidence::new(model, system), diag);
    }
    diag.is_clean().then_some(())
}

/// Decides which unknowns are found from which equations, and in which order.
///
/// Where only equations are wanted they need not fit the unknowns, and what does not fit is in no block. Neither is what is `checked`.
pub(crate) fn analyze(model: &Model, system: &System, checked: &BTreeSet<usize>, diag: &mut Diag) -> Option<Structure> {
    let incidence = Incidence::new(model, system).without(checked);
    let matching = matching::maximum(&incidence);
    if !model.equations_only {
        verdict::equations_fit(model, system, &incidence, &matching, diag);
    }
    let groups = components::in_order(&incidence, &matching);
    let blocks = groups.iter().map(|group| tearing::tear(&incidence, &matching, group)).collect();
    diag.is_clean().then(|| Structure { blocks, checked: checked.iter().copied().collect() })
}
