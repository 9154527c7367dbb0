//! Warm start of a block: a predictor-corrector step from the previous state, the usual case in a sweep.
//!
//! In: the previous state and its extrapolation. Out: the unknowns and the factors of the Jacobian there, or nothing; the step is
//! then repeated from a cold start, which also finds the cause. Nothing here reports a cause, and every comparison has one answer
//! per lane.
//!
//! ```text
//! x₀ = q + h q̇ + h² q̈ / 2 + e        e: estimate of the remainder, from the previous step (Extrapolation)
//! A₀ δ = Φ(x₀)                      A₀ = Φ_q(x₀)
//! x  = x₀ − δ                       the solution if |δ| ≤ √ε, for then |δ|² is below rounding
//! A η = Φ(x) and if |η| is a rounding error (no later result depends on η), as it is if Φ(x) is one
//! ```
//!
//! If δ is longer, it is applied as well and the next correction is judged.
//!
//! A₀ may be factored without a test of its accuracy, since A is tested and judges δ. Where no solution is found in this way, all
//! factors are tested.

use nalgebra::SVector;

use super::limits::{BLURRED, LARGEST_CONTRACTION, LONGEST_FIRST_CORRECTION, LONGEST_PREDICTION, WELL_CONDITIONED};
use super::{Iterate, Linearized};
use crate::linear::Linear;
use crate::number::{Mask, SimdReal};
use crate::state::{Extrapolation, Moment, Values};

/// The correction after the last one, η, may be this many times the first-order effect of one rounding in each term.
const ROUNDINGS: f64 = 2.0;

/// From this condition on the last correction has to be shorter than √ε: its square, times the condition, would otherwise exceed
/// rounding.
const ILL: f64 = 256.0;

/// A condition is large throughout if the place where it would be infinite is farther away than this multiple of its inverse.
const STEADY: f64 = 100.0;

/// Largest number of corrections. Each squares the error: from 0.2 the fourth is below √ε. A step that needs more is left to a cold
/// start.
const MOST_CORRECTIONS: usize = 4;

/// Up to this number of iterated unknowns a step is bound by latency, and rotating sines and cosines from those of the previous
/// state makes it 10 % faster. With more unknowns it is bound by throughput, and recomputing them is faster.
const SMALL: usize = 3;

/// The previous state and the step from it.
pub(crate) struct Predictor<'a, T: SimdReal, const N: usize> {
    here: Moment<'a, T, N>,
    /// The condition there.
    condition: T,
    extrapolation: &'a Extrapolation<T, N>,
    signs: &'a [T::Signs; N],
    /// The lanes that take part in the step.
    moving: T::Mask,
    /// Weights of q̇, q̈ and the stored remainder.
    weights: [T; 3],
    /// Whether there are so few unknowns that the step is bound by latency.
    is_small: bool,
}

/// The data of a block that a warm start needs.
pub(crate) struct BlockData<'a, T, const K: usize> {
    /// Indices of the unknowns in q.
    pub(crate) unknowns: &'a [usize; K],
    /// Which unknowns occur in sines or cosines.
    pub(crate) needs_sin_cos: &'a [bool; K],
    /// By unknown: 1/L for lengths, 1 for angles.
    pub(crate) reciprocal: &'a SVector<T, K>,
    /// The magnitudes of the terms of Φ, to which rounding errors are proportional.
    pub(crate) sizes: &'a SVector<T, K>,
}

/// A solution. Its factors lie where the caller keeps them.
pub(crate) struct BlockSolution<T: SimdReal, const K: usize> {
    pub(crate) iterate: Iterate<T, K>,
    pub(crate) condition: T,
    /// Number of factorisations.
    pub(crate) iterations: usize,
    /// The lanes in which the block was solved.
    pub(crate) found: T::Mask,
}

impl<'a, T: SimdReal, const N: usize> Predictor<'a, T, N> {
    /// From a state to a time `h` (s) later, in the lanes `moving`.
    #[inline(always)]
    pub(crate) fn new(
        (here, condition): (Moment<'a, T, N>, T),
        extrapolation: &'a Extrapolation<T, N>,
        signs: &'a [T::Signs; N],
        h: T,
        moving: T::Mask,
        iterated: usize,
    ) -> Self {
        Self { here, condition, extrapolation, signs, moving, weights: extrapolation.weights(h), is_small: iterated <= SMALL }
    }

    /// The previous values of the unknowns `own`, if they were at rest and the `inputs` are at rest and unchanged.
    #[inline]
    pub(crate) fn resting<const K: usize>(&self, found: &Values<T, N>, inputs: &[usize], own: [usize; K]) -> Option<[T; K]> {
        let (here, zero) = (&self.here, T::of(0.0));
        let rested = |i: usize| here.qd[i] == zero && here.qdd[i] == zero;
        let rests = |&i: &usize| rested(i) && found.q[i] == here.q[i] && found.qd[i] == zero && found.qdd[i] == zero;
        (inputs.iter().all(rests) && own.iter().all(|&i| rested(i))).then(|| own.map(|i| here.q[i]))
    }

    /// The predicted unknowns, and the scaled length of the predicted change.
    #[inline(always)]
    fn predict<const K: usize>(&self, data: &BlockData<'_, T, K>) -> (SVector<T, K>, T) {
        let [first, second, rest] = self.weights;
        let mut x = SVector::from_element(T::of(0.0));
        let mut way = T::of(0.0);
        for k in 0..K {
            let i = data.unknowns[k];
            let of = |vector: &SVector<T, N>| of(vector, i);
            let terms = [first * of(self.here.qd), second * of(self.here.qdd), rest * of(&self.extrapolation.rest)];
            // The term with q̈ is added last: it is available last.
            x[k] = ((of(self.here.q) + terms[2]) + terms[0]) + terms[1];
            way = way + (terms[0].abs() + terms[1].abs() + terms[2].abs()) * data.reciprocal[k];
        }
        (x, way)
    }

    /// Solves a block whose sign is stored at index `first`; None if no lane was solved.
    ///
    /// * `factors_at`: returned, the factors at the solution.
    #[inline(always)]
    pub(crate) fn solve<L: Linear<T, K>, const K: usize>(
        &self,
        data: &BlockData<'_, T, K>,
        first: usize,
        factors_at: &mut Option<L>,
        evaluate: impl Fn(&Iterate<T, K>) -> Linearized<T, L, K>,
    ) -> Option<BlockSolution<T, K>> {
        let (x, way) = self.predict(data);
        let sign = *self.signs.get(first)?;
        let is_near = self.moving.and(way.at_most(T::of(LONGEST_PREDICTION)));
        let mut follows = is_near;
        let mut iterate = if self.is_small {
            Iterate::after(picked(self.here.q, data.unknowns), x, data.needs_sin_cos)
        } else {
            Iterate::at(x, data.needs_sin_cos)
        };
        let mut longest = T::of(LONGEST_FIRST_CORRECTION);
        let mut iterations = 0;
        let mut is_tested = !L::HAS_UNTESTED_CORRECTION;
        let again = || (true, 0, predicted(x, *data.needs_sin_cos), is_near, T::of(LONGEST_FIRST_CORRECTION));
        loop {
            iterations += 2;
            // Results of `evaluate` are used where they lie, since moving a large matrix would copy it.
            let here = evaluate(&iterate);
            let (correction, sign_here) =
                if is_tested { tested::<T, L, K>(&here.1, &here.0)? } else { L::correction(&here.1, &here.0).ok()? };
            // Where two branches cross, the smooth continuation changes the sign. A warm step does not switch to the other branch.
            follows = follows.and(T::same_signs(sign_here, sign));
            let there = iterate.nudged_back(&correction, data.needs_sin_cos);
            let length = norm(&correction, data.reciprocal);

            let closer = evaluate(&there);
            let phi = &closer.0;
            let factors = match L::factor_at(factors_at, &closer.1) {
                Ok(factors) => factors,
                Err(_) if is_tested => return None,
                Err(_) => {
                    (is_tested, iterations, iterate, follows, longest) = again();
                    continue;
                }
            };
            let is_rounding = factors.is_rounding(phi, data.sizes, T::of(ROUNDINGS));
            let next = if is_rounding.all() {
                T::of(0.0)
            } else {
                T::pick(is_rounding, T::of(0.0), norm(&factors.solve_regular(phi), data.reciprocal))
            };
            let amplification = factors.error_amplification(data.sizes, data.reciprocal);
            let condition = amplification.max(T::of(1.0));

            let is_short = length.at_most(T::ROOT_EPSILON);
            let is_last = next.at_most(T::of(ROUNDINGS) * T::EPSILON * amplification);
            let is_alike = factors.is_regular().and(follows).and(T::same_signs(factors.det_sign(), sign));
            let mut found = is_short.and(is_last).and(amplification.at_most(T::of(ILL))).and(is_alike);
            if !found.all() {
                found = is_found(length, next, condition, amplification + norm(&there.x, data.reciprocal)).and(is_alike);
                found = found.and(is_sharp([self.condition, condition], way));
            }
            let is_over = found.all() || found.or(follows.not()).all() || iterations >= 2 * MOST_CORRECTIONS;
            if is_over && !is_tested && !found.or(is_near.not()).all() {
                (is_tested, iterations, iterate, follows, longest) = again();
                continue;
            }
            if is_over {
                let solution = BlockSolution { iterate: there, condition, iterations, found };
                return (!found.not().all()).then_some(solution);
            }
            // Lanes that are solved keep their iterate, so that the next pass repeats the same result.
            follows = follows.and(found.or(length.at_most(longest)));
            iterate = further(iterate, correction, *data.needs_sin_cos).replaced(found, &iterate);
            longest = length * T::of(LARGEST_CONTRACTION);
        }
    }
}

/// A⁻¹ Φ and the sign of det A, with all tests.
#[inline(always)]
fn tested<T: SimdReal, L: Linear<T, K>, const K: usize>(jacobian: &L::Matrix, phi: &SVector<T, K>) -> Option<(SVector<T, K>, T::Signs)> {
    let factors = L::factor(jacobian).ok()?;
    Some((factors.solve_regular(phi), factors.det_sign()))
}

/// Whether a correction of this length was the last, followed by one of length `next`: the precise test, for a large condition or
/// where rounding errors of the unknowns themselves matter.
#[cold]
#[inline(never)]
fn is_found<T: SimdReal>(length: T, next: T, condition: T, effect: T) -> T::Mask {
    let is_short = (length * length * (T::of(1.0 / ILL) * condition).max(T::of(1.0))).at_most(T::EPSILON);
    let is_last = next.at_most(T::of(ROUNDINGS) * T::EPSILON * effect);
    is_short.and(is_last).and((condition * T::ROOT_EPSILON).at_most(T::of(WELL_CONDITIONED)))
}

/// Whether accelerations keep digits: near a change point, which is left to a cold start, the condition is the inverse of the distance from it. Where the
/// condition is large throughout, no change point is near.
///
/// * `before`, `condition`: given, that of the state before the step, and that of the block after it.
/// * `way`: given, scaled length of the step.
#[cold]
#[inline(never)]
fn is_sharp<T: SimdReal>([before, condition]: [T; 2], way: T) -> T::Mask {
    let is_steady = (T::of(STEADY) * (condition - before).abs()).at_most(condition * before * way);
    condition.at_most(T::of(BLURRED)).or(is_steady)
}

/// The entry of an unknown, whose index is in range.
#[inline(always)]
fn of<T: SimdReal, const N: usize>(vector: &SVector<T, N>, unknown: usize) -> T {
    vector.data.0[0].get(unknown).copied().unwrap_or(T::of(f64::NAN))
}

/// The entries of the unknowns.
#[inline(always)]
fn picked<T: SimdReal, const N: usize, const K: usize>(vector: &SVector<T, N>, unknowns: &[usize; K]) -> SVector<T, K> {
    SVector::from_fn(|k, _| of(vector, unknowns[k]))
}

/// Begins again at the prediction.
#[cold]
#[inline(never)]
fn predicted<T: SimdReal, const K: usize>(x: SVector<T, K>, needs_sin_cos: [bool; K]) -> Iterate<T, K> {
    Iterate::at(x, &needs_sin_cos)
}

/// Applies a correction that is not the last.
#[cold]
#[inline(never)]
fn further<T: SimdReal, const K: usize>(iterate: Iterate<T, K>, correction: SVector<T, K>, needs_sin_cos: [bool; K]) -> Iterate<T, K> {
    iterate.moved(T::of(-1.0), &correction, &needs_sin_cos)
}

/// The sum of scaled magnitudes; NaN if one is.
#[inline(always)]
fn norm<T: SimdReal, const K: usize>(vector: &SVector<T, K>, reciprocal: &SVector<T, K>) -> T {
    // From the first term on, since rustc keeps a sum with zero.
    let term = |k: usize| vector[k].abs() * reciprocal[k];
    (1..K).fold(term(0), |sum, k| sum + term(k))
}
