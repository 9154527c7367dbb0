//! What the last step tells about the next one.

use nalgebra::SVector;

use super::{Coordinates, State};
use crate::number::{Real, SimdReal};

/// What the step to a state tells about the next, beyond the state itself: a help for predictions, and no part of what the state is,
/// so that all of them are equal.
///
/// ```text
/// e = 31 (q − q₀) − s (17 q̇ + 14 q̇₀) + s² (7 q̈ / 2 − 2 q̈₀)      s: length of the step, from q₀, q̇₀, q̈₀
/// ```
///
/// is what q + s q̇ + s² q̈ / 2 leaves out one such step further on, by the polynomial of fifth degree through both states, their
/// rates and their accelerations; it is wrong by s⁶ / 90 times the sixth derivative.
#[derive(Clone, Debug)]
pub(crate) struct Extrapolation<T, const N: usize> {
    /// s, in s; 0 if there was no step.
    pub(crate) span: T,
    /// e but for the term with q̈, in m and rad.
    pub(crate) rest: SVector<T, N>,
}

impl<T, const N: usize> PartialEq for Extrapolation<T, N> {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl<T: Real, const N: usize> Extrapolation<T, N> {
    /// Nothing is known.
    pub(crate) fn none() -> Self {
        Self { span: T::of(0.0), rest: SVector::from_element(T::of(0.0)) }
    }
}

impl<T: SimdReal, const N: usize> Extrapolation<T, N> {
    /// What q̇, q̈ and `rest` are multiplied by in a step of length `h`: e counts with the cube of the quotient of the lengths, and not
    /// at all where the step is more than twice as long, as far as one cannot see.
    #[inline(always)]
    pub(crate) fn weights(&self, h: T) -> [T; 3] {
        let quotient = h / self.span;
        let weight = T::pick(quotient.abs().at_most(T::of(2.0)), quotient * quotient * quotient, T::of(0.0));
        [h, T::of(0.5) * (h * h) + weight * (T::of(3.5) * (self.span * self.span)), weight]
    }
}

impl<T: SimdReal, const N: usize> State<T, N> {
    /// Takes note of what a step of `h` (s) tells about the next, in the lanes in which it was found; the sum of the accelerations of
    /// the `iterated` unknowns.
    #[inline(always)]
    pub(crate) fn extrapolate(&mut self, h: T, found: T::Mask, there: &Coordinates<T, N>, iterated: &[usize]) -> T {
        let twice = T::of(2.0) * (h * h);
        let mut sum = T::of(0.0);
        for &i in iterated {
            if i < N {
                let rates = T::of(17.0) * there.qd[i] + T::of(14.0) * self.qd[i];
                let rest = (T::of(31.0) * (there.q[i] - self.q[i]) - twice * self.qdd[i]) - h * rates;
                self.extrapolation.rest[i] = T::pick(found, rest, self.extrapolation.rest[i]);
                sum = sum + there.qdd[i];
            }
        }
        sum
    }

    /// Nothing is known any more in the lanes in which a step was not found.
    #[cold]
    pub(crate) fn forget_extrapolation(&mut self, found: T::Mask) {
        self.extrapolation.span = T::pick(found, self.extrapolation.span, T::of(0.0));
    }
}
