//! Iterates of Newton's method: the unknowns, with sine and cosine of those that are angles.

use nalgebra::SVector;

use crate::number::{Mask, SimdReal};

/// Up to this angle, in rad, a correction rotates sine and cosine with the shorter series instead of recomputing them.
const TINY_ROTATION: f64 = 1.0 / 256.0;

/// Up to this angle, in rad, the change from one state to the next rotates them with the longer series.
const SMALL_ROTATION: f64 = 1.0 / 32.0;

/// Unknowns with the sines and cosines that occur in the equations.
#[derive(Clone, Copy, Debug)]
pub struct Iterate<T, const K: usize> {
    /// The unknowns, in m and rad.
    pub x: SVector<T, K>,
    /// (sine, cosine) of the unknowns that need them; unspecified for the others.
    pub sin_cos: [(T, T); K],
}

impl<T: SimdReal, const K: usize> Iterate<T, K> {
    /// At x, with sine and cosine of the unknowns marked in `needs_sin_cos`.
    #[inline(always)]
    pub(crate) fn at(x: SVector<T, K>, needs_sin_cos: &[bool; K]) -> Self {
        let mut sin_cos = [(T::of(0.0), T::of(1.0)); K];
        // In pairs: two take as long as one.
        for k in (0..K).step_by(2) {
            if k + 1 < K && needs_sin_cos[k] && needs_sin_cos[k + 1] {
                [sin_cos[k], sin_cos[k + 1]] = T::fast_sin_cos_of_each([x[k], x[k + 1]]);
            } else {
                if needs_sin_cos[k] {
                    sin_cos[k] = x[k].fast_sin_cos();
                }
                if k + 1 < K && needs_sin_cos[k + 1] {
                    sin_cos[k + 1] = x[k + 1].fast_sin_cos();
                }
            }
        }
        Self { x, sin_cos }
    }

    /// At x, which is usually close to `before`: sines and cosines are computed at `before`, which is known early, and rotated by
    /// the difference.
    #[inline(always)]
    pub(crate) fn after(before: SVector<T, K>, x: SVector<T, K>, needs_sin_cos: &[bool; K]) -> Self {
        let mut there = Self::at(before, needs_sin_cos);
        let mut is_near = T::Mask::of(true);
        for k in 0..K {
            if needs_sin_cos[k] {
                let by = x[k] - before[k];
                is_near = is_near.and(by.abs().at_most(T::of(SMALL_ROTATION)));
                there.sin_cos[k] = rotated_small(there.sin_cos[k], by);
            }
        }
        there.x = x;
        if is_near.all() { there } else { Self::anew(x, *needs_sin_cos) }
    }

    /// At x.
    #[cold]
    #[inline(never)]
    fn anew(x: SVector<T, K>, needs_sin_cos: [bool; K]) -> Self {
        Self::at(x, &needs_sin_cos)
    }

    /// At x + λ δ.
    #[inline(always)]
    pub(crate) fn moved(&self, lambda: T, correction: &SVector<T, K>, needs_sin_cos: &[bool; K]) -> Self {
        let mut there = *self;
        for k in 0..K {
            let by = lambda * correction[k];
            there.x[k] = self.x[k] + by;
            if needs_sin_cos[k] {
                let is_small = by.abs().at_most(T::of(TINY_ROTATION)).all();
                there.sin_cos[k] = if is_small { rotated_tiny(self.sin_cos[k], by) } else { there.x[k].fast_sin_cos() };
            }
        }
        there
    }

    /// At x + δ, with |δ| at most about √ε, so that δ² is below rounding in sine and cosine.
    pub(crate) fn nudged(&self, correction: &SVector<T, K>, needs_sin_cos: &[bool; K]) -> Self {
        self.nudged_back(&correction.map(|entry| -entry), needs_sin_cos)
    }

    /// At x − δ, with |δ| at most about √ε.
    #[inline(always)]
    pub(crate) fn nudged_back(&self, correction: &SVector<T, K>, needs_sin_cos: &[bool; K]) -> Self {
        let mut there = *self;
        for k in 0..K {
            there.x[k] = self.x[k] - correction[k];
            if needs_sin_cos[k] {
                let (sine, cosine) = self.sin_cos[k];
                there.sin_cos[k] = (sine - cosine * correction[k], cosine + sine * correction[k]);
            }
        }
        there
    }

    /// `then` in the lanes where `mask` is true, `self` in the others.
    #[inline(always)]
    pub(crate) fn replaced(&self, mask: T::Mask, then: &Self) -> Self {
        let pick = |then, otherwise| T::pick(mask, then, otherwise);
        Self {
            x: SVector::from_fn(|k, _| pick(then.x[k], self.x[k])),
            sin_cos: core::array::from_fn(|k| (pick(then.sin_cos[k].0, self.sin_cos[k].0), pick(then.sin_cos[k].1, self.sin_cos[k].1))),
        }
    }
}

/// Sine and cosine of an angle increased by δ, |δ| ≤ 1/32.
///
/// The truncation errors are below 8e-20 and 3e-22.
#[inline(always)]
fn rotated_small<T: SimdReal>((sine, cosine): (T, T), by: T) -> (T, T) {
    let z = by * by;
    let zz = z * z;
    let small = by - (by * z) * ((T::of(1.0 / 6.0) - z * T::of(1.0 / 120.0)) + zz * T::of(1.0 / 5040.0));
    let less = T::of(0.5) * z - zz * ((T::of(1.0 / 24.0) - z * T::of(1.0 / 720.0)) + zz * T::of(1.0 / 40320.0));
    (sine + (cosine * small - sine * less), cosine - (sine * small + cosine * less))
}

/// Sine and cosine of an angle increased by δ, |δ| ≤ 1/256.
///
/// sin δ = δ − δ³/6 + δ⁵/120 and cos δ − 1 = −δ²/2 + δ⁴/24 − δ⁶/720 have truncation errors below 3e-21 and 1e-24; the sum and the
/// products round once or twice each, as a recomputed sine does.
#[inline(always)]
fn rotated_tiny<T: SimdReal>((sine, cosine): (T, T), by: T) -> (T, T) {
    let square = by * by;
    let less = square * (T::of(0.5) - square * (T::of(1.0 / 24.0) - square * T::of(1.0 / 720.0)));
    let small = by - by * square * (T::of(1.0 / 6.0) - square * T::of(1.0 / 120.0));
    (sine + (cosine * small - sine * less), cosine - (sine * small + cosine * less))
}

#[cfg(test)]
mod tests {
    use super::{Iterate, SMALL_ROTATION};
    use nalgebra::SVector;

    /// Rotated sines and cosines are as accurate as recomputed ones, over several turns and up to the largest rotation.
    #[test]
    fn turned_angles_are_within_two_roundings() {
        for step in -400..=400 {
            let from = f64::from(step) * 0.0937;
            for share in [1.0, 0.999, 0.5, -0.73, 1e-3, -1e-9, 0.0] {
                let right = |iterate: &Iterate<f64, 1>| {
                    let (sine, cosine) = libm::sincos(iterate.x[0]);
                    let (found, error) = (iterate.sin_cos[0], |found: f64, exact: f64| (found - exact).abs() / f64::EPSILON);
                    assert!(error(found.0, sine) <= 2.0 && error(found.1, cosine) <= 2.0, "{from} and {share}: {found:?}");
                };
                let (before, needs_sin_cos) = (SVector::from([from]), [true]);
                right(&Iterate::after(before, SVector::from([from + share * SMALL_ROTATION]), &needs_sin_cos));
                right(&Iterate::after(before, SVector::from([from + 40.0 * share * SMALL_ROTATION]), &needs_sin_cos));
            }
        }
    }
}
