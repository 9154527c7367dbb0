//! From a system to the blocks it is solved in.
//!
//! In: a [`System`]. Out: a [`Structure`]: which unknowns are found from which equations, in which
//! order. Not done here: numbers. Today there is one block, of everything.

use crate::system::System;

/// The order of solution.
#[derive(Clone, Debug)]
pub struct Structure {
    /// Solved one after the other.
    pub blocks: Vec<Block>,
}

/// Unknowns that are found together.
#[derive(Clone, Debug)]
pub struct Block {
    /// Indices of the unknowns.
    pub unknowns: Vec<usize>,
    /// Indices of the equations.
    pub equations: Vec<usize>,
}

/// Decides which unknowns are found from which equations.
pub(crate) fn analyze(system: &System) -> Structure {
    let everything = Block { unknowns: (0..system.unknowns.len()).collect(), equations: (0..system.equations.len()).collect() };
    Structure { blocks: vec![everything] }
}
