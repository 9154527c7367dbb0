//! From one state to another along the branch. In: a state and a time. Out: the state then, reached by steps that are each short
//! enough to be sure of the branch.
//!
//! A step is accepted if in every block the prediction does not go far, the solution is near it, Newton's method contracts well,
//! and the determinant keeps its sign: two assemblies of one loop have different signs; and if computed angles came to where they
//! were expected. Otherwise it is halved; after a success it is doubled.

use nalgebra::SVector;

use crate::pass::{Pass, Stop};
use crate::stages::{Coordinates, Stages};
use crate::straight::Departure;
use crate::verdict;
use crate::{Cause, Culprit, Failure, Float, State, names};

/// Steps of one continuation, accepted or not.
const MOST_STEPS: usize = 1_000_000;

/// How far an angle may be from its prediction, in rad.
const LARGEST_SURPRISE: f64 = 0.6;

/// The shortest step, in roundings of the time it leads to.
const SHORTEST_STEP: f64 = 8.0;

/// Takes a state to time `t` on its branch. A state that cannot be taken there stays as it is.
///
/// * `state`: given, a solved state of the same mechanism with the same parameters; returned, the state at `t`.
/// * `t`: given, s, before or after `state.t`.
///
/// # Errors
/// Any [`Cause`], with the last valid state on the way.
#[inline]
pub(crate) fn advance<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    state: &mut State<T, N>,
    t: T,
) -> Result<(), Failure<T, N>> {
    // One step is the usual case.
    let h = t - state.t;
    if h.is_finite() && step(equations, state, t, h) { Ok(()) } else { advance_by_steps(equations, state, t) }
}

/// One step straight on; whether it was made.
#[inline(always)]
fn step<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(equations: &E, state: &mut State<T, N>, t: T, h: T) -> bool {
    let mut pass = Pass::straight(equations, Departure::new(state, &state.branch, h));
    let Ok(there) = equations.stages(t, &mut pass) else { return false };
    let (found, condition, iterations) = (pass.found(), pass.condition, pass.iterations);
    if !found || !is_surely_finite(&there) || !is_resolved(state, &there.q, h, E::COMPUTED_ANGLES) {
        return false;
    }
    // Every block has kept its sign: the branch's name stays.
    state.follow_on(t, h, there);
    (state.condition, state.iterations) = (condition, iterations);
    true
}

/// The same by as many steps as it takes.
#[cold]
#[inline(never)]
fn advance_by_steps<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    state: &mut State<T, N>,
    t: T,
) -> Result<(), Failure<T, N>> {
    let fail = |cause, time, last: &State<T, N>| Err(Failure { mechanism: E::NAME, cause, time, last: Some(last.clone()) });
    if !t.is_finite() || !state.t.is_finite() {
        return fail(Cause::NotFinite { of: Culprit::Time }, t, state);
    }
    let mut here = state.clone();
    let mut step = t - state.t;
    for _ in 0..MOST_STEPS {
        let next = if step.abs() >= (t - here.t).abs() { t } else { here.t + step };
        match self::state(equations, next, Pass::follow(equations, &here, next - here.t)) {
            Ok(reached) if !is_resolved(&here, &reached.q, next - here.t, E::COMPUTED_ANGLES) && halves(&mut step, next, &here) => {}
            Ok(reached) if next == t => {
                *state = reached;
                return Ok(());
            }
            Ok(reached) => {
                here = reached;
                step = step + step;
            }
            Err(refusal) => {
                if !halves(&mut step, next, &here) {
                    return fail(verdict::end_of_branch(equations, next, &here, refusal), next, &here);
                }
            }
        }
    }
    fail(Cause::TooManySteps { steps: MOST_STEPS }, t, &here)
}

/// Halves a step; false if it cannot be any shorter.
fn halves<T: Float, const N: usize>(step: &mut T, next: T, here: &State<T, N>) -> bool {
    *step = (next - here.t) * T::of(0.5);
    step.abs() > T::of(SHORTEST_STEP) * T::EPSILON * here.t.abs().max(next.abs())
}

/// Every computed angle came to where it was expected: a drive that goes on after a rest may turn anything in one long step.
#[inline(always)]
fn is_resolved<T: Float, const N: usize>(here: &State<T, N>, q: &SVector<T, N>, h: T, angles: &[usize]) -> bool {
    let mut farthest = T::of(0.0);
    for &i in angles {
        if i < N {
            let off = (q[i] - (here.q[i] + h * (here.qd[i] + h * T::of(0.5) * here.qdd[i]))).abs();
            farthest = if off > farthest { off } else { farthest };
        }
    }
    farthest <= T::of(LARGEST_SURPRISE)
}

/// The state at the end of a pass with care.
#[inline(never)]
pub(crate) fn state<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    mut pass: Pass<'_, T, N>,
) -> Result<State<T, N>, Stop<T>> {
    let there = equations.stages(t, &mut pass)?;
    let Coordinates { q, qd, qdd } = there;
    if !is_surely_finite(&there) {
        for vector in [&q, &qd, &qdd] {
            if let Some(index) = vector.iter().position(|entry| !entry.is_finite()) {
                return Err(Stop::NotFinite(Culprit::Coordinate(names::coordinate(E::COORDINATES, index))));
            }
        }
    }
    let Pass { branch, condition, iterations, .. } = pass;
    Ok(State { branch, condition, iterations, ..State::new(t, q, qd, qdd) })
}

/// A sum is not finite if a term is not. Four sums side by side, so that none has to wait for the one before.
#[inline(always)]
fn is_surely_finite<T: Float, const N: usize>(there: &Coordinates<T, N>) -> bool {
    let mut sums = [T::of(0.0); 4];
    for i in 0..N {
        sums[i % 4] = sums[i % 4] + (there.q[i] + (there.qd[i] + there.qdd[i]));
    }
    ((sums[0] + sums[1]) + (sums[2] + sums[3])).is_finite()
}
