//! From a prediction to the solution that is surely on the same branch, or to none.

use super::limits::{LARGEST_CONTRACTION, LONGEST_FIRST_CORRECTION};
use super::newton_step::{History, NewtonStep};
use super::position::{Position, accept};
use super::{Iterate, Problem};
use crate::linear::Linear;
use crate::names::Culprit;
use crate::number::{Float, Mask};

/// Corrections of a predicted position; with that contraction, five reach rounding.
const FOLLOWING_ITERATIONS: usize = 12;

/// Why a predicted position does not lead to one that is surely on the same branch.
pub(crate) enum TrackError {
    /// The equations are not defined at an iterate.
    NotFinite(Culprit),
    /// Φ_q is singular there.
    Singular,
    /// The solution is too far from the prediction.
    Far,
}

/// Newton's method from a prediction: full steps only, and none if the solution is far or convergence slow.
///
/// * `sign`: given, the orientation before. Where two branches cross, the one that goes straight on changes it, and so does the
///   prediction: what is then found on the old side is another branch.
pub(crate) fn track<T: Float, P: Problem<T, N>, const N: usize>(
    problem: &P,
    prediction: &Iterate<T, N>,
    sign: Option<T::Signs>,
) -> Result<Position<T, P::Factors, N>, TrackError> {
    let mut history = History::new();
    let mut iterate = *prediction;
    for iterations in 1..=FOLLOWING_ITERATIONS {
        let step = NewtonStep::at(problem, iterate)?;
        if step.has_settled(&history) {
            return accept(problem, step, iterations).map_err(|_| TrackError::Singular);
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
