//! q, q̇ and q̈ of one evaluation, before they become a state.

use nalgebra::SVector;

use super::State;
use crate::number::Real;

/// Position, velocity and acceleration of all coordinates.
pub struct Coordinates<T, const N: usize> {
    /// q in m and rad.
    pub q: SVector<T, N>,
    /// q̇ in m/s and rad/s.
    pub qd: SVector<T, N>,
    /// q̈ in m/s² and rad/s².
    pub qdd: SVector<T, N>,
}

impl<T: Real, const N: usize> Coordinates<T, N> {
    /// All zero.
    #[must_use]
    pub fn zero() -> Self {
        let zero = SVector::from_element(T::of(0.0));
        Self { q: zero, qd: zero, qdd: zero }
    }

    /// The coordinates of a state.
    #[inline(always)]
    pub(crate) fn of(state: &State<T, N>) -> Self {
        Self { q: state.q, qd: state.qd, qdd: state.qdd }
    }
}
