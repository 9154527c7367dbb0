//! A block straight on: from a prediction that is nearly right to the solution next to it, the usual case in a sweep.
//!
//! In: what the last states tell. Out: the unknowns and the factors of the Jacobian there, or nothing, and then the step is done
//! again from a cold start, which also knows why. There are no names and no failures here, and every comparison has
//! an answer for each lane.
//!
//! ```text
//! x₀ = q + h q̇ + h² q̈ / 2 + e      e: what this leaves out, from the step before (Extrapolation)
//! A₀ δ = Φ(x₀)                      A₀ = Φ_q(x₀)
//! x  = x₀ − δ                       the solution if |δ| ≤ √ε, for then |δ|² is below rounding
//! A  η = Φ(x)                       and if |η|, which nothing waits for, is a rounding
//! ```
//!
//! A longer δ is made as well, and the next one is looked at.

use nalgebra::SVector;

use super::limits::{LARGEST_CONTRACTION, LONGEST_FIRST_CORRECTION, LONGEST_PREDICTION, WELL_CONDITIONED};
use super::{Iterate, Linearized};
use crate::linear::Linear;
use crate::number::{Mask, SimdReal};
use crate::state::{Coordinates, State};

/// A correction after the last may be this many times the first-order effect of one rounding of each term.
const ROUNDINGS: f64 = 2.0;

/// From this condition on the last correction has to be shorter than √ε: what its square leaves out would be felt otherwise, where the
/// condition tells more than rounding does.
const ILL: f64 = 256.0;

/// Corrections, each of which squares the error: from 0.2 the fourth is below √ε, and more are a case for care.
const MOST_CORRECTIONS: usize = 4;

/// Of so few unknowns a step is a chain of results that each wait for the one before, and it is shorter by a tenth if sines and cosines of
/// the predicted angles are turned on from those before; more unknowns keep a processor busy all the time, and the turns cost more.
const SMALL: usize = 3;

/// Where a pass sets out from, and how far it goes.
pub(crate) struct Predictor<'a, T: SimdReal, const N: usize> {
    here: &'a State<T, N>,
    signs: &'a [T::Signs; N],
    /// The lanes that set out.
    moving: T::Mask,
    /// What q̇, q̈ and the rest of the trend are multiplied by.
    weights: [T; 3],
    /// There are so few unknowns that each result is waited for.
    is_small: bool,
}

/// What solving a block straight on needs to know of it.
pub(crate) struct BlockData<'a, T, const K: usize> {
    /// Indices of the unknowns in q.
    pub(crate) unknowns: &'a [usize; K],
    /// Which unknowns turn.
    pub(crate) needs_sin_cos: &'a [bool; K],
    /// One over what counts as 1 in each unknown.
    pub(crate) reciprocal: &'a SVector<T, K>,
    /// What rounding errors of Φ are a share of.
    pub(crate) sizes: &'a SVector<T, K>,
}

/// A solution.
pub(crate) struct BlockSolution<T: SimdReal, L, const K: usize> {
    pub(crate) iterate: Iterate<T, K>,
    pub(crate) factors: L,
    pub(crate) condition: T,
    /// Number of factorisations.
    pub(crate) iterations: usize,
    /// The lanes in which it is one.
    pub(crate) found: T::Mask,
}

impl<'a, T: SimdReal, const N: usize> Predictor<'a, T, N> {
    /// From a state, whose signs of determinants are `signs`, to a moment h later, in the lanes that are `moving`, with this many
    /// unknowns that are iterated.
    #[inline(always)]
    pub(crate) fn new(here: &'a State<T, N>, signs: &'a [T::Signs; N], h: T, moving: T::Mask, iterated: usize) -> Self {
        Self { here, signs, moving, weights: here.extrapolation.weights(h), is_small: iterated <= SMALL }
    }

    /// Where the unknowns `own` were, if they rested and the `inputs` rest where they did.
    #[inline]
    pub(crate) fn resting<const K: usize>(&self, found: &Coordinates<T, N>, inputs: &[usize], own: [usize; K]) -> Option<[T; K]> {
        let (here, zero) = (self.here, T::of(0.0));
        let rested = |i: usize| here.qd[i] == zero && here.qdd[i] == zero;
        let rests = |&i: &usize| rested(i) && found.q[i] == here.q[i] && found.qd[i] == zero && found.qdd[i] == zero;
        (inputs.iter().all(rests) && own.iter().all(|&i| rested(i))).then(|| own.map(|i| here.q[i]))
    }

    /// Predictions of these unknowns, and the scaled length of the way there.
    #[inline(always)]
    fn predict<const K: usize>(&self, data: &BlockData<'_, T, K>) -> (SVector<T, K>, T) {
        let [first, second, rest] = self.weights;
        let mut x = SVector::from_element(T::of(0.0));
        let mut way = T::of(0.0);
        for k in 0..K {
            let i = data.unknowns[k];
            let of = |vector: &SVector<T, N>| of(vector, i);
            let terms = [first * of(&self.here.qd), second * of(&self.here.qdd), rest * of(&self.here.extrapolation.rest)];
            // q̈ comes last.
            x[k] = ((of(&self.here.q) + terms[2]) + terms[0]) + terms[1];
            way = way + (terms[0].abs() + terms[1].abs() + terms[2].abs()) * data.reciprocal[k];
        }
        (x, way)
    }

    /// Solves a block whose orientation is kept at index `name`; None where no lane arrives.
    #[inline(always)]
    pub(crate) fn solve<L: Linear<T, K>, const K: usize>(
        &self,
        data: &BlockData<'_, T, K>,
        name: usize,
        evaluate: impl Fn(&Iterate<T, K>) -> Linearized<T, L, K>,
    ) -> Option<BlockSolution<T, L, K>> {
        let (x, way) = self.predict(data);
        let sign = *self.signs.get(name)?;
        let mut follows = self.moving.and(way.at_most(T::of(LONGEST_PREDICTION)));
        let mut iterate = if self.is_small {
            Iterate::after(SVector::from_fn(|k, _| of(&self.here.q, data.unknowns[k])), x, data.needs_sin_cos)
        } else {
            Iterate::at(x, data.needs_sin_cos)
        };
        let mut longest = T::of(LONGEST_FIRST_CORRECTION);
        let mut iterations = 0;
        loop {
            iterations += 2;
            let (phi, jacobian) = evaluate(&iterate);
            let factors = L::factor(&jacobian).ok()?;
            // Where two branches cross, the one that goes straight on changes its sign: the other is not followed instead.
            follows = follows.and(T::same_signs(factors.det_sign(), sign));
            let correction = factors.solve_regular(&phi);
            let there = iterate.nudged_back(&correction, data.needs_sin_cos);

            let (phi, jacobian) = evaluate(&there);
            let factors = L::factor(&jacobian).ok()?;
            let next = norm(&factors.solve_regular(&phi), data.reciprocal);
            let amplification = factors.error_amplification(data.sizes, data.reciprocal);
            let condition = amplification.max(T::of(1.0));

            let length = norm(&correction, data.reciprocal);
            let is_short = length.at_most(T::ROOT_EPSILON);
            let is_last = next.at_most(T::of(ROUNDINGS) * T::EPSILON * amplification);
            let is_alike = factors.is_regular().and(follows).and(T::same_signs(factors.det_sign(), sign));
            let mut found = is_short.and(is_last).and(amplification.at_most(T::of(ILL))).and(is_alike);
            if !found.all() {
                found = is_found(length, next, condition, amplification + norm(&there.x, data.reciprocal)).and(is_alike);
            }
            if found.all() || found.or(follows.not()).all() || iterations >= 2 * MOST_CORRECTIONS {
                let solution = BlockSolution { iterate: there, factors, condition, iterations, found };
                return (!found.not().all()).then_some(solution);
            }
            // Lanes that have arrived stand still: they come to the same again.
            follows = follows.and(found.or(length.at_most(longest)));
            iterate = further(iterate, correction, *data.needs_sin_cos).replaced(found, &iterate);
            longest = length * T::of(LARGEST_CONTRACTION);
        }
    }
}

/// Whether a correction of this length was the last, with `next` after it, where that shows not at once: the condition is large, or rounding
/// errors of the unknowns themselves are felt.
#[cold]
#[inline(never)]
fn is_found<T: SimdReal>(length: T, next: T, condition: T, effect: T) -> T::Mask {
    let is_short = (length * length * (T::of(1.0 / ILL) * condition).max(T::of(1.0))).at_most(T::EPSILON);
    let is_last = next.at_most(T::of(ROUNDINGS) * T::EPSILON * effect);
    is_short.and(is_last).and((condition * T::ROOT_EPSILON).at_most(T::of(WELL_CONDITIONED)))
}

/// The entry of an unknown, whose index is in range.
#[inline(always)]
fn of<T: SimdReal, const N: usize>(vector: &SVector<T, N>, unknown: usize) -> T {
    vector.data.0[0].get(unknown).copied().unwrap_or(T::of(f64::NAN))
}

/// After a correction that was not the last.
#[cold]
#[inline(never)]
fn further<T: SimdReal, const K: usize>(iterate: Iterate<T, K>, correction: SVector<T, K>, needs_sin_cos: [bool; K]) -> Iterate<T, K> {
    iterate.moved(T::of(-1.0), &correction, &needs_sin_cos)
}

/// The sum of scaled magnitudes; NaN if one is.
#[inline(always)]
fn norm<T: SimdReal, const K: usize>(vector: &SVector<T, K>, reciprocal: &SVector<T, K>) -> T {
    (0..K).fold(T::of(0.0), |sum, k| sum + vector[k].abs() * reciprocal[k])
}
