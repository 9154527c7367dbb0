//! Diagnosis of a continuation that ended early. In: how it ended. Out: a [`Failure`].

use crate::names::{self, Cause, CoordinateKind};
use crate::newton::{StepError, length_of};
use crate::number::Float;
use crate::path::{self, Ended};
use crate::solve::{ColdSolver, Followed};
use crate::state::State;

use super::Failure;

/// Whether a branch that ends here ends at a dead point: the condition is above ε^(−1/4). Approaching a dead point to the rounding
/// of t gives about ε^(−1/2).
fn is_dead_point<T: Float, const N: usize>(state: &State<T, N>) -> bool {
    state.condition * T::ROOT_EPSILON.sqrt() > T::of(1.0)
}

/// A motion that ends with a growing length of more than this many L diverges.
const FAR: f64 = 100.0;

/// The least x ẍ / ẋ² of a length that diverges; a pole of any order has more.
const STEEP: f64 = 1.01;

/// The failure of a continuation to time `t` (s), which left `state` unchanged.
#[cold]
pub(crate) fn of_continuation<T: Float, const N: usize>(
    mechanism: &Followed<'_, T, N>,
    state: &State<T, N>,
    t: T,
    ended: Ended<T, N>,
) -> Failure<T, N> {
    let (cause, time, last) = match ended {
        Ended::Refused(cause) => (cause, t, state.clone()),
        Ended::Lost { error, here, next, is_solved } => {
            let ended = || (end_of_branch(mechanism, next, (&here, is_solved), error), next);
            let (cause, time) = diverging(mechanism, &here, next).unwrap_or_else(ended);
            (cause, if let Cause::StateTooFar { .. } = cause { t } else { time }, here)
        }
        Ended::TooManySteps { steps, here } => {
            let (cause, time) = diverging(mechanism, &here, t).unwrap_or((Cause::TooManySteps { steps }, t));
            (cause, time, here)
        }
    };
    let last = if let Cause::StateTooFar { .. } = cause { None } else { Some(last) };
    Failure { mechanism: mechanism.name, cause, time, end: None, last }
}

/// Why the branch could not be followed from `here`, which may be no solution, to `next`.
fn end_of_branch<T: Float, const N: usize>(
    mechanism: &Followed<'_, T, N>,
    next: T,
    (here, is_solved): (&State<T, N>, bool),
    error: StepError<T>,
) -> Cause<T> {
    if let StepError::NotFinite(of) = error {
        return Cause::NotFinite { of };
    }
    if is_dead_point(here)
        && let Some(cause) = path::inspect(mechanism, here.t, &here.q)
    {
        return cause;
    }
    match path::cold_state(mechanism, next, ColdSolver::from_guess(mechanism, &here.predict(next))) {
        Ok((other, _)) => match path::jump(mechanism, &here.q, &other.q) {
            Cause::BranchLost { coordinate, jump } if !is_solved => Cause::StateTooFar { coordinate, jump },
            lost => lost,
        },
        Err(error) => error.into(),
    }
}

/// The coordinate that grows beyond all bounds, and the approximate time; None if the motion does not diverge.
///
/// ```text
/// x = c / (t∞ − t)      t∞ = t + x / ẋ      x ẍ = 2 ẋ²
/// ```
///
/// A power of time has x ẍ < ẋ² and an exponential x ẍ = ẋ²: they grow for ever, and reach every time.
///
/// * `next`: given, s, a moment after `here`.
fn diverging<T: Float, const N: usize>(mechanism: &Followed<'_, T, N>, here: &State<T, N>, next: T) -> Option<(Cause<T>, T)> {
    let mut longest: Option<(usize, T)> = None;
    for (i, place) in here.q.iter().enumerate() {
        let is_length = names::coordinate(mechanism.coordinates, i).kind == CoordinateKind::Length;
        if is_length && longest.is_none_or(|(_, most)| place.abs() > most) {
            longest = Some((i, place.abs()));
        }
    }
    let (index, size) = longest?;
    let (&value, &rate, &acceleration) = (here.q.get(index)?, here.qd.get(index)?, here.qdd.get(index)?);
    let grows = value * rate * (next - here.t) > T::of(0.0) && value * acceleration > T::of(STEEP) * rate * rate;
    let is_far = size / length_of(mechanism.length) > T::of(FAR);
    let coordinate = names::coordinate(mechanism.coordinates, index);
    (is_far && grows).then(|| (Cause::Diverges { coordinate, value }, here.t + value / rate))
}
