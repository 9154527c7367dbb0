//! From a prediction to the solution that is surely on the same branch, or to none.

use super::iterate::{History, Iterate};
use super::limits::{LARGEST_CONTRACTION, LONGEST_FIRST_CORRECTION};
use super::position::{Position, accept};
use super::{Place, Problem};
use crate::linear::Linear;
use crate::names::Culprit;
use crate::number::{Float, Mask};

/// Corrections of a predicted position; with that contraction, five reach rounding.
const FOLLOWING_ITERATIONS: usize = 12;

/// Why a predicted position does not lead to one that is surely on the same branch.
pub(crate) enum Refusal {
    /// The equations are not defined at an iterate.
    NotFinite(Culprit),
    /// Φ_q is singular there.
    Singular,
    /// The solution is too far from the prediction.
    Far,
}

/// Newton's method from a prediction: full steps only, and none if the solution is far or convergence slow.
///
/// * `side`: given, the orientation before. Where two branches cross, the one that goes straight on changes it, and so does the
///   prediction: what is then found on the old side is another branch.
pub(crate) fn follow<T: Float, P: Problem<T, N>, const N: usize>(
    problem: &P,
    prediction: &Place<T, N>,
    side: Option<T::Sides>,
) -> Result<Position<T, P::Factors, N>, Refusal> {
    let mut history = History::new();
    let mut place = *prediction;
    for iterations in 1..=FOLLOWING_ITERATIONS {
        let iterate = Iterate::at(problem, place)?;
        if iterate.has_settled(&history) {
            return accept(problem, iterate, iterations).map_err(|_| Refusal::Singular);
        }
        if iterations == 1 && side.is_some_and(|side| !T::same(iterate.factors.sides(), side).all()) {
            return Err(Refusal::Far);
        }
        let is_far = match history.contraction(iterate.length) {
            Some(theta) => theta > T::of(LARGEST_CONTRACTION) && !iterate.is_rounding(),
            None => iterate.length > T::of(LONGEST_FIRST_CORRECTION),
        };
        if is_far {
            return Err(Refusal::Far);
        }
        place = iterate.moved(T::of(1.0), problem);
        history = history.after(iterate.length, true);
    }
    Err(Refusal::Far)
}

impl From<Culprit> for Refusal {
    fn from(culprit: Culprit) -> Self {
        Self::NotFinite(culprit)
    }
}
