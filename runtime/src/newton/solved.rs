//! The result for one block: the unknowns and the factors of the Jacobian, or the reason why there is none.

use nalgebra::SVector;

use crate::linear::Linear;
use crate::names::{Cause, Culprit};
use crate::number::{Float, SimdReal};

/// Why a block was not solved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StepError<T> {
    /// No solution was found close to the prediction; a shorter step may succeed.
    Far,
    /// A number is not finite.
    NotFinite(Culprit),
    /// No solution was found from the guess, or the Jacobian is singular there.
    Open(Cause<T>),
}

/// A solved block.
pub struct Solved<T, L, const K: usize> {
    /// The unknowns, in m and rad.
    pub x: [T; K],
    /// (sine, cosine) of the unknowns that need them.
    pub sin_cos: [(T, T); K],
    pub(crate) factors: L,
}

impl<T: SimdReal, L: Linear<T, K>, const K: usize> Solved<T, L, K> {
    /// x with Φ_q x = `b`, with a step of iterative refinement where that improves it.
    #[inline(always)]
    pub fn solve(&self, b: [T; K]) -> [T; K] {
        self.factors.solve_refined(&SVector::from(b)).data.0[0]
    }
}

/// A solved block whose factors lie with the caller.
pub struct SolvedInPlace<'a, T, L, const K: usize> {
    /// The unknowns, in m and rad.
    pub x: [T; K],
    /// (sine, cosine) of the unknowns that need them.
    pub sin_cos: [(T, T); K],
    pub(crate) factors: &'a L,
}

impl<T: SimdReal, L: Linear<T, K>, const K: usize> SolvedInPlace<'_, T, L, K> {
    /// x with Φ_q x = `b`, with a step of iterative refinement where that improves it.
    #[inline(always)]
    pub fn solve(&self, b: [T; K]) -> [T; K] {
        self.factors.solve_refined(&SVector::from(b)).data.0[0]
    }
}

impl<T: Float> From<StepError<T>> for Cause<T> {
    fn from(error: StepError<T>) -> Self {
        match error {
            StepError::NotFinite(of) => Cause::NotFinite { of },
            StepError::Open(cause) => cause,
            StepError::Far => Cause::NoConvergence { correction: T::of(f64::NAN), iterations: 0 },
        }
    }
}
