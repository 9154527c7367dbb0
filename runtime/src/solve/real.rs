//! Number types of the solver, each with its fallback if a warm step fails.

use crate::linear::{FactorReal, Linear};
use crate::newton::{Block, Evaluate, Solved, StepError, length_of};
use crate::number::SimdReal;

/// A [`SimdReal`] over which a mechanism can be followed in time: `f64` and `f32`, registers of several lanes, and numbers that carry
/// derivatives or error bounds.
pub trait SolverReal: FactorReal {
    /// Method for blocks that a warm step does not solve.
    #[doc(hidden)]
    type Cold<'a, const N: usize>: ColdStart<Self, N>;
}

/// A solution of all blocks in order, without a warm step.
#[doc(hidden)]
pub trait ColdStart<T: SolverReal, const N: usize> {
    /// L in m, and 1/L.
    fn lengths(&self) -> (T, T);

    /// Solves a block.
    ///
    /// * `sizes`: given, by equation: the magnitude of its terms, to which rounding errors are proportional.
    /// * `evaluate`: given, residuals and their Jacobian at an iterate.
    ///
    /// # Errors
    /// Why no solution was found.
    fn solve_block<L: Linear<T, K>, const K: usize>(
        &self,
        block: &Block<K>,
        sizes: [T; K],
        evaluate: &Evaluate<'_, T, L, K>,
    ) -> Result<Solved<T, L, K>, StepError<T>>;

    /// Records the residual of an equation that is checked, not solved.
    ///
    /// * `row`: given, its index in Φ.
    /// * `size`: given, the magnitude of its terms.
    fn check(&self, row: usize, residual: T, size: T);
}

/// Cold start of numbers without one: registers of several lanes leave it to the scalar code. The type has no values.
#[doc(hidden)]
pub enum NoColdStart {}

impl<T: SolverReal, const N: usize> ColdStart<T, N> for NoColdStart {
    fn lengths(&self) -> (T, T) {
        match *self {}
    }

    fn solve_block<L: Linear<T, K>, const K: usize>(
        &self,
        _: &Block<K>,
        _: [T; K],
        _: &Evaluate<'_, T, L, K>,
    ) -> Result<Solved<T, L, K>, StepError<T>> {
        match *self {}
    }

    fn check(&self, _: usize, _: T, _: T) {
        match *self {}
    }
}

/// L in m, and 1/L, of a mechanism with this characteristic length (m).
#[inline(always)]
pub(crate) fn lengths_of<T: SimdReal>(characteristic: T) -> (T, T) {
    let length = length_of(characteristic);
    (length, T::of(1.0) / length)
}
