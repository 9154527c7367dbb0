//! From one state to another along the branch. In: a state and a time. Out: the state then, reached by steps that are each short
//! enough to be sure of the branch.
//!
//! A step is accepted if in every block the predicted position is near the solution, Newton's method contracts well from it,
//! and the determinant keeps its sign: two assemblies of one loop have different signs. Otherwise it is halved; after a success it is doubled.

use nalgebra::SVector;

use crate::pass::{Pass, Stop};
use crate::stages::{Coordinates, Stages};
use crate::verdict;
use crate::{Cause, Culprit, Failure, Float, State, names};

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
#[inline]
pub(crate) fn reach<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    from: &State<T, N>,
) -> Result<State<T, N>, Failure<T, N>> {
    // One step is the usual case.
    let h = t - from.t;
    let one_step = if h.is_finite() { advance(equations, t, from) } else { Err(Stop::NotFinite(Culprit::Time)) };
    one_step.or_else(|_| reach_by_steps(equations, t, from))
}

/// The same by as many steps as it takes.
#[cold]
#[inline(never)]
fn reach_by_steps<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    from: &State<T, N>,
) -> Result<State<T, N>, Failure<T, N>> {
    let fail = |cause, time, last: &State<T, N>| Err(Failure { mechanism: E::NAME, cause, time, last: Some(last.clone()) });
    if !t.is_finite() || !from.t.is_finite() {
        return fail(Cause::NotFinite { of: Culprit::Time }, t, from);
    }
    let mut here = from.clone();
    let mut step = t - from.t;
    for _ in 0..MOST_STEPS {
        let next = if step.abs() >= (t - here.t).abs() { t } else { here.t + step };
        match advance(equations, next, &here) {
            Ok(state) if next == t => return Ok(state),
            Ok(state) => {
                here = state;
                step = step + step;
            }
            Err(refusal) => {
                step = (next - here.t) * T::of(0.5);
                if step.abs() <= T::of(SHORTEST_STEP) * T::EPSILON * here.t.abs().max(next.abs()) {
                    return fail(verdict::end_of_branch(equations, next, &here, refusal), next, &here);
                }
            }
        }
    }
    fail(Cause::TooManySteps { steps: MOST_STEPS }, t, &here)
}

/// One step from `here` to time `next`.
#[inline(always)]
fn advance<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(equations: &E, next: T, here: &State<T, N>) -> Result<State<T, N>, Stop<T>> {
    state(equations, next, Pass::follow(equations, here, next - here.t))
}

/// The state at the end of a pass.
#[inline(always)]
pub(crate) fn state<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    mut pass: Pass<'_, T, N>,
) -> Result<State<T, N>, Stop<T>> {
    let Coordinates { q, qd, qdd } = equations.stages(t, &mut pass)?;
    if !is_surely_finite(&q, &qd, &qdd) {
        for vector in [&q, &qd, &qdd] {
            if let Some(index) = vector.iter().position(|entry| !entry.is_finite()) {
                return Err(Stop::NotFinite(Culprit::Coordinate(names::coordinate(E::COORDINATES, index))));
            }
        }
    }
    let Pass { branch, condition, iterations, .. } = pass;
    Ok(State { t, q, qd, qdd, branch, condition, iterations })
}

/// A sum is not finite if a term is not. Four sums side by side, so that none has to wait for the one before.
#[inline(always)]
fn is_surely_finite<T: Float, const N: usize>(q: &SVector<T, N>, qd: &SVector<T, N>, qdd: &SVector<T, N>) -> bool {
    let mut sums = [T::of(0.0); 4];
    for i in 0..N {
        sums[i % 4] = sums[i % 4] + (q[i] + (qd[i] + qdd[i]));
    }
    ((sums[0] + sums[1]) + (sums[2] + sums[3])).is_finite()
}
