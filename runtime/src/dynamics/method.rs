//! Integration methods: each tries a step.

use nalgebra::SVector;

use super::equations::Dynamics;
use super::stopped::Stopped;
use super::tableau::Rates;
use crate::number::Scalar;
use crate::state::State;

/// An integration method.
pub trait Method: Copy {
    /// Number of square roots that turn an error into a factor of the step size: three make an eighth root.
    #[doc(hidden)]
    const ROOTS: usize;

    /// True if a step returns the rates in its stages, from which states between its ends are computed.
    #[doc(hidden)]
    const IS_DENSE: bool;

    /// Number of times that a step computes the accelerations of a mechanism with this many coordinates.
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

/// A step before its end is projected onto the equations.
pub struct Trial<T, const N: usize, const I: usize> {
    /// Positions and speeds at its end.
    pub(super) end: [SVector<T, N>; 2],
    /// Two estimates of the error of each; the second damps the first.
    pub(super) errors: [[[T; 2]; I]; 2],
    /// Rates in the stages, of an explicit step.
    pub(super) rates: Option<Rates<T, I>>,
}
