//! Continuation in time along a branch. In: a state and a time. Out: the state at that time, reached by steps short enough to stay
//! on the branch with certainty.
//!
//! A step is accepted if in every block the predicted change is small, the solution is close to the prediction, Newton's method
//! contracts well and the determinant keeps its sign (two assemblies that meet at a fold have opposite signs); if the prediction
//! backwards from the new state meets the old one (this excludes another assembly of the same sign after the branch has ended); if
//! redundant equations hold; if computed angles are close to their predictions; and if binary links keep their sides. A rejected step
//! is halved; after a success the step is doubled.

use super::branch::{is_same_branch, keeps_sides, turns_on};
use super::cold::cold_state;
use super::crossing;
use crate::names::{self, Cause, CoordinateKind, Culprit};
use crate::newton::{BLURRED, StepError, length_of};
use crate::number::Float;
use crate::solve::{ColdSolver, Followed, Stages, largest_alone};
use crate::state::State;

/// Largest number of steps of one continuation, accepted or not, for a mechanism of a few coordinates. It decreases with the number
/// of coordinates, so that the time stays about the same.
const MOST_STEPS: usize = 1_000_000;

/// With this many coordinates the limit is about a tenth.
const MANY: usize = 90;

/// From this condition on, as a fraction of 1 / √ε, a state may be at the end of a branch.
const NEARLY_SINGULAR: f64 = 1.0 / 64.0;

/// Up to this condition, as a fraction of 1 / √ε, an ordinary step may pass the place where the condition is largest.
const LARGEST_PASSED: f64 = 0.75;

/// The condition there must be larger than at the waypoint by this factor: where it is as large everywhere, no branches cross.
const RISEN: f64 = 4.0;

/// At the end of a branch: a step that fails and changes q by less than this fraction of 1 / condition is not halved again.
const LEAST_WAY: f64 = 0.01;

/// A mechanism rests where the rates at hand would change no coordinate by more roundings than this in the whole time.
const MOST_AT_REST: f64 = 64.0;

/// The shortest step, in roundings of time.
const SHORTEST_STEP: f64 = 8.0;

/// ε of numbers in which states beside change points keep digits.
const FINE: f64 = 1e-12;

/// Why a continuation ended early.
pub(crate) enum Ended<T, const N: usize> {
    /// There is no state at this time with these parameters.
    Refused(Cause<T>),
    /// No step from `here` towards `next`, however short, stays on the branch.
    Lost {
        /// Why the shortest step failed.
        error: StepError<T>,
        /// The last state.
        here: State<T, N>,
        /// The end of the shortest step, in s.
        next: T,
        /// Whether that state is a solution; if not, it is the given one, with other parameters or changed.
        is_solved: bool,
    },
    /// The limit of steps was reached, at `here`.
    TooManySteps { steps: usize, here: State<T, N> },
}

/// Takes a state to time `t` (s) on its branch, in any number of steps. If that fails, the state is unchanged.
///
/// * `state`: given, a solved state of the same mechanism with the same parameters; returned, the state at `t`.
///
/// # Errors
/// Where and why the branch could not be followed.
pub(crate) fn advance_by_steps<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    state: &mut State<T, N>,
    t: T,
) -> Result<(), Ended<T, N>> {
    let mechanism = Followed::new(&equations);
    let arrival = advance(&mechanism, state, t)?;
    // In single precision too many states would have to be refined.
    let from = if E::IS_REDUNDANT { largest_alone() } else { T::of(BLURRED) };
    let may_be_sharp = E::IS_REDUNDANT || T::EPSILON < T::of(FINE);
    if may_be_sharp && matches!(arrival, Arrival::Step) && state.condition > from {
        crossing::refine_beside(&mechanism, state);
    }
    Ok(())
}

/// How a continuation arrived.
enum Arrival {
    /// By a step.
    Step,
    /// By an extrapolation across a change point.
    Crossing,
}

/// The same, for any mechanism with this number of coordinates, without the digits that states on both sides of a change point give.
///
/// # Errors
/// Where and why the branch could not be followed.
#[cold]
#[inline(never)]
fn advance<T: Float, const N: usize>(mechanism: &Followed<'_, T, N>, state: &mut State<T, N>, t: T) -> Result<Arrival, Ended<T, N>> {
    if !t.is_finite() || !state.t.is_finite() {
        return Err(Ended::Refused(Cause::NotFinite { of: Culprit::Time }));
    }
    if let Err(parameter) = mechanism.validate() {
        return Err(Ended::Refused(Cause::ParameterOutOfRange(parameter)));
    }
    // A state of slightly different parameters is first solved again at its own time; a state of these parameters does not change
    // by that.
    let seated = cold_state(mechanism, state.t, ColdSolver::from_prediction(mechanism, state, T::of(0.0)));
    // A drive that has turned on by itself has left the others behind, perhaps by whole turns.
    let mut is_solved = matches!(&seated, Ok((seated, _)) if !turns_on(mechanism, &state.q, &seated.q));
    let given = || (state.clone(), true);
    let (mut here, fits) = seated.map_or_else(|_| given(), |(seated, off)| if is_solved { (seated, off.is_none()) } else { given() });
    // Next to a crossing the state has digits that it would not have by itself.
    if is_solved && crossing::is_close(state) && !state.was_changed() && state.parameter_hash == mechanism.parameter_hash {
        here = state.clone();
    }
    // Why there was no state at `t`, as far as a redundant equation is to blame.
    let mut refused = None;
    let mut waypoint = here.clone();
    let mut step = t - state.t;
    let most = const { MOST_STEPS / (1 + 10 * N / MANY) };
    for _ in 0..most {
        let next = if step.abs() >= (t - here.t).abs() { t } else { here.t + step };
        let failed = match cold_state(mechanism, next, ColdSolver::from_prediction(mechanism, &here, next - here.t)) {
            // The solved equations have branches on which redundant ones do not hold.
            Ok((_, Some(cause))) if fits => {
                refused = refused.or((next == t).then_some(cause));
                Ok(refused.unwrap_or(cause))
            }
            Ok((there, _)) if is_behind_peak(&waypoint, &here, &there) || !is_solved && turns_on(mechanism, &here.q, &there.q) => {
                Err(StepError::Far)
            }
            Ok((there, _)) if !stays(mechanism, &here, &there) && halves(mechanism, &mut step, next, &here, t - state.t) => {
                continue;
            }
            Ok((there, _)) if !keeps_sides(mechanism.links, &here.q, &there.q) => Err(StepError::Far),
            Ok((_, Some(cause))) if next == t => return Err(Ended::Refused(cause)),
            Ok((there, _)) if next == t => {
                *state = there;
                return Ok(Arrival::Step);
            }
            Ok((there, _)) => {
                // Two statements: without optimisation a tuple puts one more state on the stack.
                here = there;
                is_solved = true;
                step = step + step;
                if crossing::is_clear(&here) {
                    waypoint = here.clone();
                }
                continue;
            }
            Err(error) => Err(error),
        };
        if halves(mechanism, &mut step, next, &here, t - state.t) {
            continue;
        }
        match (crossing::cross(mechanism, &waypoint, &here, t), failed) {
            (Some(beyond), _) if beyond.t == t => {
                *state = beyond;
                return Ok(Arrival::Crossing);
            }
            (Some(beyond), _) => {
                step = t - beyond.t;
                (here, waypoint) = (beyond.clone(), beyond);
                is_solved = true;
            }
            (None, Ok(cause)) => return Err(Ended::Refused(cause)),
            (None, Err(error)) => return Err(Ended::Lost { error, here, next, is_solved }),
        }
    }
    Err(Ended::TooManySteps { steps: most, here })
}

/// Whether a step stayed on its branch.
#[inline(never)]
fn stays<T: Float, const N: usize>(mechanism: &Followed<'_, T, N>, here: &State<T, N>, there: &State<T, N>) -> bool {
    is_same_branch(mechanism, here, there) && (!turns_on(mechanism, &here.q, &there.q) || stays_in_first_half_turns(mechanism, here, there))
}

/// Whether a step in which drives turn on stays on its branch also where each of them has made its first half turn: behind a cross that is bent far, a
/// shaft swings through half a turn at once and rests before and after it.
#[cold]
#[inline(never)]
fn stays_in_first_half_turns<T: Float, const N: usize>(mechanism: &Followed<'_, T, N>, here: &State<T, N>, there: &State<T, N>) -> bool {
    let half = T::of(core::f64::consts::PI);
    mechanism.computed_angles.iter().all(|&i| {
        let way = there.q.get(i).zip(here.q.get(i)).map_or(T::of(0.0), |(&to, &from)| (to - from).abs());
        // Each comparison is false of NaN.
        let is_long = way > half;
        if !is_long {
            return true;
        }
        let h = (there.t - here.t) * (half / way);
        let between = cold_state(mechanism, here.t + h, ColdSolver::from_prediction(mechanism, here, h));
        between.is_ok_and(|(between, _)| is_same_branch(mechanism, here, &between))
    })
}

/// Whether a step leads away from a place that is so nearly singular that rounding would choose between the branches that cross there: their
/// distance, about 1 / condition, is hardly larger than the rounding errors of positions, about ε times the condition. Such a place is
/// [crossed](crossing::cross).
fn is_behind_peak<T: Float, const N: usize>(waypoint: &State<T, N>, here: &State<T, N>, there: &State<T, N>) -> bool {
    let is_peak = here.condition > T::of(LARGEST_PASSED) / T::ROOT_EPSILON && here.condition > T::of(RISEN) * waypoint.condition;
    is_peak && there.condition < here.condition
}

/// Halves a step; false if it cannot be shorter, because time would change by less than its rounding, or near the end of a branch the
/// coordinates would. Elsewhere the rates at hand tell nothing of a law that has yet to begin.
///
/// * `whole`: given, s, the whole time to be covered.
fn halves<T: Float, const N: usize>(mechanism: &Followed<'_, T, N>, step: &mut T, next: T, here: &State<T, N>, whole: T) -> bool {
    *step = (next - here.t) * T::of(0.5);
    let h = *step;
    let time = here.t.abs().max(next.abs()).max(T::EPSILON * whole.abs());
    let length = length_of(mechanism.length);
    // So close to a fold rounding errors let the shortest steps fail and succeed at random.
    let is_at_end = here.condition * T::ROOT_EPSILON > T::of(NEARLY_SINGULAR);
    // Laws that begin at rest have rates of rounding errors there, also near the end of a branch.
    let (mut moves, mut rests) = (false, true);
    for &i in mechanism.iterated {
        let (Some(&q), Some(&qd), Some(&qdd)) = (here.q.get(i), here.qd.get(i), here.qdd.get(i)) else { continue };
        let way = |h: T| (h * qd).abs() + (h * h * qdd).abs();
        let size = if names::coordinate(mechanism.coordinates, i).kind == CoordinateKind::Length { length } else { T::of(1.0) };
        let rounding = T::EPSILON * (q.abs() + size);
        moves |= way(h) > T::of(LEAST_WAY) * size / here.condition;
        rests &= way(whole) <= T::of(MOST_AT_REST) * rounding;
    }
    h.abs() > T::of(SHORTEST_STEP) * T::EPSILON * time && (rests || moves || !is_at_end)
}
