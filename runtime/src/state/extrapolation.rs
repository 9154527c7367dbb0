//! Extrapolation from the last step to the next.

use nalgebra::SVector;

use super::Moment;
use crate::number::{Real, SimdReal};

/// The remainder of a quadratic prediction, estimated from the last step. It only improves predictions and is not part of the
/// state's value, so that all extrapolations compare equal.
///
/// ```text
/// e = 31 (q − q₀) − s (17 q̇ + 14 q̇₀) + s² (7 q̈ / 2 − 2 q̈₀) s: length of the last step, which began at q₀, q̇₀, q̈₀
/// ```
///
/// is the remainder of q + s q̇ + s² q̈ / 2 after another step of the same length, by the polynomial of fifth degree through both
/// states with their rates and accelerations. Its error is s⁶ / 90 times the sixth derivative.
#[derive(Clone, Debug)]
pub(crate) struct Extrapolation<T, const N: usize> {
    /// s, in seconds; 0 if there was no step.
    pub(crate) span: T,
    /// e without the term in q̈, in m and rad.
    pub(crate) rest: SVector<T, N>,
}

impl<T, const N: usize> PartialEq for Extrapolation<T, N> {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl<T: Real, const N: usize> Extrapolation<T, N> {
    /// No previous step.
    pub(crate) fn none() -> Self {
        Self { span: T::of(0.0), rest: SVector::from_element(T::of(0.0)) }
    }
}

impl<T: SimdReal, const N: usize> Extrapolation<T, N> {
    /// The weights of q̇, q̈ and `rest` in a prediction over `h` (s). e is scaled by (h/s)³, and dropped when the step more than
    /// doubles.
    #[inline(always)]
    pub(crate) fn weights(&self, h: T) -> [T; 3] {
        let quotient = h / self.span;
        let weight = T::pick(quotient.abs().at_most(T::of(2.0)), quotient * quotient * quotient, T::of(0.0));
        [h, T::of(0.5) * (h * h) + weight * (T::of(3.5) * (self.span * self.span)), weight]
    }

    /// Takes over a step of `h` (s) from `here`, in the lanes `found`; returns the sum of the accelerations of the `iterated` unknowns.
    #[inline(always)]
    pub(crate) fn follow(&mut self, h: T, found: T::Mask, here: Moment<'_, T, N>, there: Moment<'_, T, N>, iterated: &[usize]) -> T {
        let twice = T::of(2.0) * (h * h);
        let mut sum = T::of(0.0);
        for &i in iterated {
            if i < N {
                let rates = T::of(17.0) * there.qd[i] + T::of(14.0) * here.qd[i];
                let rest = (T::of(31.0) * (there.q[i] - here.q[i]) - twice * here.qdd[i]) - h * rates;
                self.rest[i] = T::pick(found, rest, self.rest[i]);
                sum = sum + there.qdd[i];
            }
        }
        sum
    }

    /// Discards the extrapolation in the lanes in which the step failed.
    #[cold]
    pub(crate) fn forget(&mut self, found: T::Mask) {
        self.span = T::pick(found, self.span, T::of(0.0));
    }
}
