//! Diagnosis of a continuation that ended early. In: how it ended. Out: a [`Failure`].

use crate::names::{self, Cause, CoordinateKind};
use crate::newton::{Scale, StepError};
use crate::number::Float;
use crate::path::{self, Ended};
use crate::solve::{ColdSolver, Stages};
use crate::state::State;

use super::Failure;

/// Whether a branch that ends here ends at a dead point: the condition is above ε^(−1/4). Approaching a dead point to the rounding
/// of t gives about ε^(−1/2).
fn is_dead_point<T: Float, const N: usize>(state: &State<T, N>) -> bool {
    state.condition * T::ROOT_EPSILON.sqrt() > T::of(1.0)
}

/// A motion that ends with a growing length of more than this many L diverges.
const FAR: f64 = 100.0;

/// The failure of a continuation to time `t` (s), which left `state` unchanged.
#[cold]
pub(crate) fn of_continuation<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    state: &State<T, N>,
    t: T,
    ended: Ended<T, N>,
) -> Failure<T, N> {
    let (cause, time, last) = match ended {
        Ended::Refused(cause) => (cause, t, state.clone()),
        Ended::Lost { error, here, next } => {
            let ended = || (end_of_branch(equations, next, &here, error), next);
            let (cause, time) = diverging(equations, &here, next).unwrap_or_else(ended);
            (cause, time, here)
        }
        Ended::TooManySteps { steps, here } => {
            let (cause, time) = diverging(equations, &here, t).unwrap_or((Cause::TooManySteps { steps }, t));
            (cause, time, here)
        }
    };
    Failure { mechanism: E::NAME, cause, time, end: None, last: Some(last) }
}

/// Why the branch could not be followed from `here` to `next`.
fn end_of_branch<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    next: T,
    here: &State<T, N>,
    error: StepError<T>,
) -> Cause<T> {
    if let StepError::NotFinite(of) = error {
        return Cause::NotFinite { of };
    }
    if is_dead_point(here)
        && let Some(cause) = path::inspect(equations, here.t, &here.q)
    {
        return cause;
    }
    match path::cold_state(equations, next, ColdSolver::from_guess(equations, &here.predict(next))) {
        Ok((other, _)) => path::jump(equations, &here.q, &other.q),
        Err(error) => error.into(),
    }
}

/// The coordinate that grows beyond all bounds, and the approximate time; None if the motion does not diverge.
///
/// ```text
/// x = c / (t∞ − t)      t∞ = t + x / ẋ
/// ```
///
/// * `next`: given, s, a moment after `here`.
fn diverging<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(equations: &E, here: &State<T, N>, next: T) -> Option<(Cause<T>, T)> {
    let scale = Scale::of(equations);
    let named = |i: usize| names::coordinate(E::COORDINATES, i);
    let all = here.q.iter().zip(here.qd.iter()).enumerate().map(|(i, (&place, &rate))| (named(i), place, rate));
    let lengths = all.filter(|(coordinate, ..)| coordinate.kind == CoordinateKind::Length);
    let (coordinate, value, rate) = lengths.reduce(|best, next| if next.1.abs() > best.1.abs() { next } else { best })?;
    let grows = value * rate * (next - here.t) > T::of(0.0);
    let is_far = value.abs() / scale.length > T::of(FAR);
    (is_far && grows).then(|| (Cause::Diverges { coordinate, value }, here.t + value / rate))
}
