//! Dense systems on the stack: A x = b with A an N × N matrix.
//!
//! In: a matrix. Out: its factors, from which many right-hand sides are solved, its rank, the sign of
//! its determinant, and an estimate of its condition. Not here: what to do about a singular matrix.
//!
//! ```text
//! P (R A C) Q = L U        R, C diagonal, powers of two (exact);  P, Q permutations, Q = 1 unless A is nearly singular
//! ```
//!
//! Golub, Van Loan: Matrix Computations, 4th ed., 3.4 (pivoting), 3.5.2 (scaling), 3.5.3 (iterative refinement).

mod condition;
mod factor;
mod rank;
mod solve;

pub(crate) use factor::Factors;
pub(crate) use rank::weakest;
