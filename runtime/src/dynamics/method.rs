//! How steps are made.

use nalgebra::SVector;

use super::equations::Dynamics;
use super::stopped::Stopped;
use super::tableau::Rates;
use crate::number::Scalar;
use crate::state::State;

/// How a step is made.
pub trait Method: Copy {
    /// Times the square root is taken of an error for the change of the step size.
    #[doc(hidden)]
    const ROOTS: usize;

    /// True if steps know the rates in their stages.
    #[doc(hidden)]
    const IS_DENSE: bool;

    /// How often a step computes accelerations of so many coordinates.
    #[doc(hidden)]
    fn evaluations(coordinates: usize) -> usize;

    /// Tries a step.
    #[doc(hidden)]
    fn trial<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
        mechanism: &S,
        state: &State<T, N>,
        h: T,
    ) -> Result<Trial<T, N, I>, Stopped<T>>
    where
        T: Scalar,
        S: Dynamics<T, N, I, M, R>;
}

/// A step before the equations are fulfilled.
pub struct Trial<T, const N: usize, const I: usize> {
    /// Positions and speeds at its end.
    pub(super) end: [SVector<T, N>; 2],
    /// Two estimates of the error of each, of which the second damps the first.
    pub(super) errors: [[[T; 2]; I]; 2],
    /// Rates in the stages, of an explicit step.
    pub(super) rates: Option<Rates<T, I>>,
}
