//! From one state to another along the branch. In: a state and a time. Out: the state then, reached by steps that are each short
//! enough to be sure of the branch.
//!
//! A step is accepted if the predicted position is near the solution, Newton's method contracts well from it, and det Φ_q keeps
//! its sign: two assemblies of one loop have different signs. Otherwise it is halved; after a success it is doubled.

use crate::acceleration::acceleration;
use crate::position::{self, Position, Refusal};
use crate::scale::Scale;
use crate::velocity::velocity;
use crate::verdict;
use crate::{Cause, Culprit, Equations, Failure, Float, State};

/// Steps of one continuation, accepted or not.
const MOST_STEPS: usize = 1_000_000;

/// The shortest step, in roundings of the time it leads to.
const SHORTEST_STEP: f64 = 8.0;

/// The state at `t` on the branch of `from`.
///
/// * `t`: given, s, before or after `from.t`.
/// * `from`: given, a solved state of the same mechanism with the same parameters.
///
/// # Errors
/// Any [`Cause`], with the last valid state on the way.
pub(crate) fn reach<T: Float, E: Equations<T, N, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    from: &State<T, N>,
) -> Result<State<T, N>, Failure<T, N>> {
    let fail = |cause, time, last: &State<T, N>| Err(Failure { mechanism: E::NAME, cause, time, last: Some(last.clone()) });
    if !t.is_finite() || !from.t.is_finite() {
        return fail(Cause::NotFinite { of: Culprit::Time }, t, from);
    }
    let scale = Scale::of(equations);
    let mut here = from.clone();
    let mut step = t - from.t;
    for _ in 0..MOST_STEPS {
        let next = if step.abs() >= (t - here.t).abs() { t } else { here.t + step };
        match advance(equations, next, &here, &scale) {
            Ok(state) if next == t => return Ok(state),
            Ok(state) => {
                here = state;
                step = step + step;
            }
            Err(refusal) => {
                step = (next - here.t) * T::of(0.5);
                if step.abs() <= T::of(SHORTEST_STEP) * T::EPSILON * here.t.abs().max(next.abs()) {
                    return fail(verdict::end_of_branch(equations, next, &here, refusal, &scale), next, &here);
                }
            }
        }
    }
    fail(Cause::TooManySteps { steps: MOST_STEPS }, t, &here)
}

/// One step from `here` to time `next`.
fn advance<T: Float, E: Equations<T, N, N> + ?Sized, const N: usize>(
    equations: &E,
    next: T,
    here: &State<T, N>,
    scale: &Scale<T, N>,
) -> Result<State<T, N>, Refusal> {
    let position = position::follow(equations, next, &here.predict(next), scale)?;
    if position.factors.orientation != here.orientation {
        return Err(Refusal::OtherBranch);
    }
    Ok(state(equations, next, &position)?)
}

/// Completes a position with velocities and accelerations.
pub(crate) fn state<T: Float, E: Equations<T, N, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    position: &Position<T, N>,
) -> Result<State<T, N>, Culprit> {
    let qd = velocity(equations, t, position)?;
    let qdd = acceleration(equations, t, position, &qd)?;
    let &Position { q, ref factors, condition, iterations } = position;
    Ok(State { t, q, qd, qdd, orientation: factors.orientation, condition, iterations })
}
