//! Elimination of matrices of numbers.
//!
//! In: numbers. Out: factors, independent rows, orders of pivots. Not done here: anything that knows of mechanisms.
//!
//! 1. `dense`: factors of small square matrices.
//! 2. `echelon`: independent rows and null space of a rectangular matrix, row by row.
//! 3. `order`: pivots of a sparse matrix, for elimination as straight-line code.

pub(crate) mod dense;
mod echelon;
pub(crate) mod order;

pub(crate) use echelon::Echelon;
pub(crate) use order::{PivotCandidate, in_order};
