//! Accepted steps.

use super::{Coordinates, State};
use crate::number::{Mask, SimdReal};

/// An accepted warm step.
pub(crate) struct Step<T: SimdReal> {
    /// Its length in s.
    pub(crate) h: T,
    /// The lanes in which it was accepted, at least one.
    pub(crate) found: T::Mask,
    pub(crate) condition: T,
    pub(crate) iterations: usize,
}

impl<T: SimdReal, const N: usize> State<T, N> {
    /// Becomes the state at `t` (s), on the same branch, in the lanes in which the step was accepted.
    #[inline(always)]
    pub(crate) fn follow_on(&mut self, t: T, step: &Step<T>, there: &Coordinates<T, N>) {
        let (&Step { h, found, condition, iterations }, Coordinates { q, qd, qdd }) = (step, there);
        let here = &mut self.values;
        here.iterations = iterations;
        if found.all() {
            (self.extrapolation.span, here.condition) = (h, condition);
            (here.t, here.q, here.qd, here.qdd) = (t, *q, *qd, *qdd);
        } else {
            let pick = |then, otherwise| T::pick(found, then, otherwise);
            (self.extrapolation.span, here.condition) = (pick(h, self.extrapolation.span), pick(condition, here.condition));
            here.t = pick(t, here.t);
            (here.q, here.qd, here.qdd) = (q.zip_map(&here.q, pick), qd.zip_map(&here.qd, pick), qdd.zip_map(&here.qdd, pick));
        }
    }
}
