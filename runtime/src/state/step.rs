//! Accepted steps.

use super::{Coordinates, State, Values};
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
        self.accept(t, step);
        let (here, Coordinates { q, qd, qdd }) = (&mut self.values, there);
        if step.found.all() {
            (here.q, here.qd, here.qdd) = (*q, *qd, *qdd);
        } else {
            let pick = |then, otherwise| T::pick(step.found, then, otherwise);
            (here.q, here.qd, here.qdd) = (q.zip_map(&here.q, pick), qd.zip_map(&here.qd, pick), qdd.zip_map(&here.qdd, pick));
        }
    }

    /// The same where the coordinates are there already.
    #[inline(always)]
    pub(crate) fn accept(&mut self, t: T, &Step { h, found, condition, iterations }: &Step<T>) {
        let here = &mut self.values;
        here.iterations = iterations;
        if found.all() {
            (self.extrapolation.span, here.condition, here.t) = (h, condition, t);
        } else {
            let pick = |then, otherwise| T::pick(found, then, otherwise);
            (self.extrapolation.span, here.condition) = (pick(h, self.extrapolation.span), pick(condition, here.condition));
            here.t = pick(t, here.t);
        }
    }
}

impl<T: SimdReal, const N: usize> Values<T, N> {
    /// Puts the coordinates back in the lanes in which a step failed.
    #[cold]
    #[inline(never)]
    pub(crate) fn put_back(&mut self, found: T::Mask, before: &Coordinates<T, N>) {
        let pick = |then, otherwise| T::pick(found, then, otherwise);
        self.q.zip_apply(&before.q, |then, otherwise| *then = pick(*then, otherwise));
        self.qd.zip_apply(&before.qd, |then, otherwise| *then = pick(*then, otherwise));
        self.qdd.zip_apply(&before.qdd, |then, otherwise| *then = pick(*then, otherwise));
    }
}
