//! Elimination of matrices of numbers.
//!
//! In: matrices of numbers. Out: factors, independent rows, null spaces. Not done here: anything specific to mechanisms.
//!
//! 1. `dense`: factors of small square matrices.
//! 2. `echelon`: independent rows and null space of a rectangular matrix, row by row.

pub(crate) mod dense;
mod echelon;

pub(crate) use echelon::Echelon;
