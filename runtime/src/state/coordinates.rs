//! q, q̇ and q̈ of one evaluation, before they become a state.

use nalgebra::SVector;

use super::{State, Values};
use crate::number::{DetSign, Real};

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
        // Each field is written where it stays: without optimisation a copy takes as much of the stack once more.
        Self {
            t: T::of(0.0),
            q: SVector::from_element(T::of(0.0)),
            qd: SVector::from_element(T::of(0.0)),
            qdd: SVector::from_element(T::of(0.0)),
            branch: [DetSign::Positive; N],
            condition: T::of(1.0),
            iterations: 0,
        }
    }

    /// q, q̇ and q̈ of a result.
    #[doc(hidden)]
    #[must_use]
    pub fn coordinates(&self) -> Coordinates<T, N> {
        Coordinates { q: self.q, qd: self.qd, qdd: self.qdd }
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
