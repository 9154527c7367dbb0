//! Newton's method from a prediction to the solution on the same branch.

use super::limits::{LARGEST_CONTRACTION, LONGEST_FIRST_CORRECTION};
use super::newton_step::{History, NewtonStep, Settled};
use super::position::{Position, accept};
use super::{Iterate, Problem};
use crate::linear::Linear;
use crate::names::Culprit;
use crate::number::{Float, Mask};

/// Largest number of corrections; with the largest contraction allowed, five reach rounding.
const FOLLOWING_ITERATIONS: usize = 12;

/// Why no solution on the same branch was found with certainty.
pub(crate) enum TrackError {
    /// The equations are not defined at an iterate.
    NotFinite(Culprit),
    /// Φ_q is singular there.
    Singular,
    /// The solution is too far from the prediction.
    Far,
}

/// Newton's method from a prediction, with full steps only. It gives up where the solution is far or convergence is slow.
///
/// * `sign`: given, the sign of the determinant at the previous state. Where two branches cross, the smooth continuation changes
///   the sign, and so does the prediction: a solution with the old sign would lie on the other branch.
pub(crate) fn track<T: Float, P: Problem<T, N>, const N: usize>(
    problem: &P,
    prediction: &Iterate<T, N>,
    sign: Option<T::Signs>,
) -> Result<Position<T, P::Factors, N>, TrackError> {
    let mut history = History::new();
    let mut iterate = *prediction;
    for iterations in 1..=FOLLOWING_ITERATIONS {
        let step = NewtonStep::at(problem, iterate)?;
        // Sums that a correction below their rounding leaves unchanged make corrections shrink by a constant factor.
        if step.has_settled(&history) || (iterations == FOLLOWING_ITERATIONS && step.is_rounding()) {
            return accept(problem, Settled { step, iterations }).map_err(|_| TrackError::Singular);
        }
        if iterations == 1 && sign.is_some_and(|sign| !T::same_signs(step.factors.det_sign(), sign).all()) {
            return Err(TrackError::Far);
        }
        let is_far = match history.contraction(step.length) {
            Some(theta) => theta > T::of(LARGEST_CONTRACTION) && !step.is_rounding(),
            None => step.length > T::of(LONGEST_FIRST_CORRECTION),
        };
        if is_far {
            return Err(TrackError::Far);
        }
        iterate = step.moved(T::of(1.0), problem);
        history = history.after(step.length, true);
    }
    Err(TrackError::Far)
}

impl From<Culprit> for TrackError {
    fn from(culprit: Culprit) -> Self {
        Self::NotFinite(culprit)
    }
}
