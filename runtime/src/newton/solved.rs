//! A block that is solved, or why it is not.

use nalgebra::SVector;

use crate::linear::Linear;
use crate::names::{Cause, Culprit};
use crate::number::{Float, SimdReal};

/// Why a pass ended early.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StepError<T> {
    /// A shorter step may do.
    Far,
    /// A number is not finite.
    NotFinite(Culprit),
    /// The equations do not hold anywhere near, or their Jacobian is singular.
    Open(Cause<T>),
}

/// A block with its unknowns found.
pub struct Solved<T, L, const K: usize> {
    /// The unknowns, in m and rad.
    pub x: [T; K],
    /// (sine, cosine) of those that turn.
    pub sin_cos: [(T, T); K],
    pub(crate) factors: L,
}

impl<T: SimdReal, L: Linear<T, K>, const K: usize> Solved<T, L, K> {
    /// The rates that the block's Jacobian maps to `b`, refined where that makes them better.
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
