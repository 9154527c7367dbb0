//! Numbers that the solver runs on, and what each of them does where a warm step is not enough.

use crate::linear::{FactorReal, Linear};
use crate::names::Description;
use crate::newton::{Block, Evaluate, Solved, StepError, length_of};
use crate::number::SimdReal;

/// A [`SimdReal`] over which a mechanism can be followed in time: `f64` and `f32`, registers of several lanes, and numbers that carry
/// derivatives or error bounds.
pub trait SolverReal: FactorReal {
    /// How blocks are solved where a warm step is not enough.
    #[doc(hidden)]
    type Cold<'a, const N: usize>: ColdStart<Self, N>;
}

/// A solution of all blocks, one after the other, that does not begin with a warm step.
#[doc(hidden)]
pub trait ColdStart<T: SolverReal, const N: usize> {
    /// L in m, and 1/L.
    fn lengths(&self) -> (T, T);

    /// Solves a block.
    ///
    /// * `sizes`: given, by equation: the magnitude of its terms, of which rounding errors are a fraction.
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

    /// Records the residual of an equation that is verified and not solved.
    ///
    /// * `row`: given, its index in Φ.
    /// * `size`: given, the magnitude of its terms.
    fn check(&self, row: usize, residual: T, size: T);
}

/// For numbers that have no cold start: registers of several lanes leave it to the scalar code. There is no such value.
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

/// L in m, and 1/L.
#[inline(always)]
pub(crate) fn lengths_of<T: SimdReal, E: Description<T, N> + ?Sized, const N: usize>(equations: &E) -> (T, T) {
    let length = length_of(equations.characteristic_length());
    (length, T::of(1.0) / length)
}
