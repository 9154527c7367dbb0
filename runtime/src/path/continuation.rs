//! From one state to another along the branch. In: a state and a time. Out: the state then, reached by steps that are each short
//! enough to be sure of the branch.
//!
//! A step is accepted if in every block the prediction does not go far, the solution is near it, Newton's method contracts well,
//! and the determinant keeps its sign: assemblies that meet somewhere have different signs; if the new state, seen backwards, came from
//! the old one: two assemblies of the same sign, one of which ended on the way, do not; and if computed angles came to where they were
//! expected. Otherwise it is halved; after a success it is doubled.

use super::branch::is_same_branch;
use super::cold::cold_state;
use super::crossing;
use crate::names::{self, Cause, CoordinateKind, Culprit};
use crate::newton::{StepError, length_of};
use crate::number::Float;
use crate::number::order::greater;
use crate::solve::{ColdSolver, Stages};
use crate::state::State;

/// Steps of one continuation, accepted or not, by a mechanism of a few coordinates; more coordinates take fewer, in about the same time.
const MOST_STEPS: usize = 1_000_000;

/// The coordinates that take a tenth of them.
const MANY: usize = 90;

/// Up to this share of ε^(−1/4) a condition says that a change point is not too near to look across.
const CLEAR: f64 = 0.0625;

/// The same where there are few digits.
const LEAST_CLEAR: f64 = 16.0;

/// From this share of 1 / √ε on a condition may be that of the end of a branch.
const NEARLY_SINGULAR: f64 = 1.0 / 64.0;

/// A step that goes less far than this share of 1 / condition there, and fails, was the last.
const LEAST_WAY: f64 = 0.01;

/// The shortest step, in roundings of the time it leads to.
const SHORTEST_STEP: f64 = 8.0;

/// Why a continuation ended before it was there.
pub(crate) enum Ended<T, const N: usize> {
    /// There is no state at this time with these parameters.
    Refused(Cause<T>),
    /// No step from `here` towards `next`, however short, stays on the branch.
    Lost { error: StepError<T>, here: State<T, N>, next: T },
    /// So many steps were made, and the last one came to `here`.
    TooManySteps { steps: usize, here: State<T, N> },
}

/// Takes a state to time `t` (s) on its branch, by as many steps as it takes. A state that cannot be taken there stays as it is.
///
/// * `state`: given, a solved state of the same mechanism with the same parameters; returned, the state at `t`.
///
/// # Errors
/// Where and why the branch could not be followed.
#[cold]
#[inline(never)]
pub(crate) fn advance_by_steps<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    state: &mut State<T, N>,
    t: T,
) -> Result<(), Ended<T, N>> {
    if !t.is_finite() || !state.t.is_finite() {
        return Err(Ended::Refused(Cause::NotFinite { of: Culprit::Time }));
    }
    if let Err(parameter) = equations.validate() {
        return Err(Ended::Refused(Cause::ParameterOutOfRange(parameter)));
    }
    // A state of slightly other parameters is first put in order where it is; one of these parameters stays as it is.
    let seated = cold_state(equations, state.t, ColdSolver::from_prediction(equations, state, T::of(0.0)));
    let mut here = seated.map_or_else(|_| state.clone(), |(seated, _)| seated);
    let mut waypoint = here.clone();
    let mut step = t - state.t;
    let most = const { MOST_STEPS / (1 + 10 * N / MANY) };
    for _ in 0..most {
        let next = if step.abs() >= (t - here.t).abs() { t } else { here.t + step };
        match cold_state(equations, next, ColdSolver::from_prediction(equations, &here, next - here.t)) {
            Ok((there, _)) if !is_same_branch(equations, &here, &there) && halves(equations, &mut step, next, &here, t - state.t) => {}
            Ok((there, off)) if next == t => match off {
                Some(cause) => return Err(Ended::Refused(cause)),
                None => {
                    *state = there;
                    return Ok(());
                }
            },
            Ok((there, _)) => {
                here = there;
                step = step + step;
                if here.condition <= greater(largest_condition(CLEAR), T::of(LEAST_CLEAR)) {
                    waypoint = here.clone();
                }
            }
            Err(error) => {
                if !halves(equations, &mut step, next, &here, t - state.t) {
                    if let Some(beyond) = crossing::cross(equations, &waypoint, &here, t) {
                        if beyond.t == t {
                            *state = beyond;
                            return Ok(());
                        }
                        step = t - beyond.t;
                        (here, waypoint) = (beyond.clone(), beyond);
                        continue;
                    }
                    return Err(Ended::Lost { error, here, next });
                }
            }
        }
    }
    Err(Ended::TooManySteps { steps: most, here })
}

/// This share of ε^(−1/4).
fn largest_condition<T: Float>(share: f64) -> T {
    T::of(share) / T::ROOT_EPSILON.sqrt()
}

/// Halves a step; false if it cannot be any shorter: time, or what moves, would not change by a rounding of it.
///
/// * `whole`: given, s, how long the way takes of which it is a step.
fn halves<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(equations: &E, step: &mut T, next: T, here: &State<T, N>, whole: T) -> bool {
    *step = (next - here.t) * T::of(0.5);
    let (h, zero) = (*step, T::of(0.0));
    let time = here.t.abs().max(next.abs()).max(T::EPSILON * whole.abs());
    let length = length_of(equations.characteristic_length());
    let ways = || E::ITERATED.iter().filter(|i| **i < N).map(|&i| (i, (h * here.qd[i]).abs() + (h * h * here.qdd[i]).abs()));
    let size = |i: usize| if names::coordinate(E::COORDINATES, i).kind == CoordinateKind::Length { length } else { T::of(1.0) };
    // Where a fold is so near, rounding errors make the least steps fail and succeed in turn.
    let is_at_end = here.condition * T::ROOT_EPSILON > T::of(NEARLY_SINGULAR);
    let least = |i: usize| if is_at_end { T::of(LEAST_WAY) * size(i) / here.condition } else { T::EPSILON * (here.q[i].abs() + size(i)) };
    let moves = || ways().any(|(i, way)| way > least(i));
    let rests = || ways().all(|(_, way)| way == zero);
    h.abs() > T::of(SHORTEST_STEP) * T::EPSILON * time && (rests() || moves())
}
