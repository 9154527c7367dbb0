//! From one state to another along the branch. In: a state and a time. Out: the state then, reached by steps that are each short
//! enough to be sure of the branch.
//!
//! A step is accepted if in every block the predicted position is near the solution, Newton's method contracts well from it,
//! and the determinant keeps its sign: two assemblies of one loop have different signs. Otherwise it is halved; after a success it is doubled.

use nalgebra::SVector;

use crate::pass::{Pass, Stop};
use crate::stages::{Coordinates, Stages};
use crate::verdict;
use crate::{Cause, Coordinate, Culprit, Failure, Float, State, names};

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
pub(crate) fn reach<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
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
#[inline]
fn advance<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(equations: &E, next: T, here: &State<T, N>) -> Result<State<T, N>, Stop<T>> {
    state(equations, next, Pass::follow(equations, here, next - here.t))
}

/// The state at the end of a pass.
#[inline]
pub(crate) fn state<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    mut pass: Pass<'_, T, N>,
) -> Result<State<T, N>, Stop<T>> {
    let Coordinates { q, qd, qdd } = equations.stages(t, &mut pass)?;
    for vector in [&q, &qd, &qdd] {
        if let Some(coordinate) = not_finite(vector, E::COORDINATES) {
            return Err(Stop::NotFinite(Culprit::Coordinate(coordinate)));
        }
    }
    let Pass { branch, condition, iterations, .. } = pass;
    Ok(State { t, q, qd, qdd, branch, condition, iterations })
}

/// The first coordinate in which a vector is not finite. A sum is not finite if a term is not: it is looked at first.
#[inline]
fn not_finite<T: Float, const N: usize>(vector: &SVector<T, N>, coordinates: &[Coordinate]) -> Option<Coordinate> {
    // Zero times anything finite is zero; this keeps the sum from overflowing by itself.
    let sum = vector.iter().fold(T::of(0.0), |sum, &entry| sum + entry * T::of(0.0));
    if sum == T::of(0.0) {
        return None;
    }
    let index = vector.iter().position(|entry| !entry.is_finite())?;
    Some(names::coordinate(coordinates, index))
}
