//! q, q̇ and q̈ of one evaluation, before they become a state.

use nalgebra::SVector;

use super::{State, Values};
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

    /// The same, where they lie.
    #[inline(always)]
    pub(crate) fn moment(&self) -> Moment<'_, T, N> {
        Moment { q: &self.q, qd: &self.qd, qdd: &self.qdd }
    }
}

impl<T, const N: usize> From<Values<T, N>> for Coordinates<T, N> {
    fn from(values: Values<T, N>) -> Self {
        Self { q: values.q, qd: values.qd, qdd: values.qdd }
    }
}

/// Position, velocity and acceleration of all coordinates, where they lie.
#[derive(Clone, Copy)]
pub(crate) struct Moment<'a, T, const N: usize> {
    pub(crate) q: &'a SVector<T, N>,
    pub(crate) qd: &'a SVector<T, N>,
    pub(crate) qdd: &'a SVector<T, N>,
}

impl<T: Real, const N: usize> Values<T, N> {
    /// All zero.
    #[doc(hidden)]
    #[must_use]
    pub fn zero() -> Self {
        let Coordinates { q, qd, qdd } = Coordinates::zero();
        State::new(T::of(0.0), q, qd, qdd).values
    }

    /// Takes over these coordinates.
    #[inline(always)]
    pub(crate) fn put(&mut self, Coordinates { q, qd, qdd }: Coordinates<T, N>) {
        (self.q, self.qd, self.qdd) = (q, qd, qdd);
    }

    /// The coordinates, where they lie.
    #[inline(always)]
    pub(crate) fn moment(&self) -> Moment<'_, T, N> {
        Moment { q: &self.q, qd: &self.qd, qdd: &self.qdd }
    }
}
