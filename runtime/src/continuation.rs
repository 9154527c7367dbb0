//! From one state to another along the branch. In: a state and a time. Out: the state then, reached by steps that are each short
//! enough to be sure of the branch.
//!
//! A step is accepted if in every block the prediction does not go far, the solution is near it, Newton's method contracts well,
//! and the determinant keeps its sign: assemblies that meet somewhere have different signs; if the new state, seen backwards, came from
//! the old one: two assemblies of the same sign, one of which ended on the way, do not; and if computed angles came to where they were
//! expected. Otherwise it is halved; after a success it is doubled.

use nalgebra::SVector;

use crate::careful::{Care, Found};
use crate::crossing;
use crate::order::greater;
use crate::pass::{Pass, Stop, Walk};
use crate::scale::length_of;
use crate::stages::{Coordinates, Stages};
use crate::straight::{Departure, SURE};
use crate::verdict;
use crate::{Cause, CoordinateKind, Culprit, Failure, Float, Lanes, Mask, State, Values, names};

/// Steps of one continuation, accepted or not, by a mechanism of a few coordinates; more coordinates take fewer, in about the same time.
const MOST_STEPS: usize = 1_000_000;

/// The coordinates that take a tenth of them.
const MANY: usize = 90;

/// How far an angle may be from its prediction, in rad.
const LARGEST_SURPRISE: f64 = 0.6;

/// A state and the one that the state after it expects behind it may be this share of 1 / condition apart: about so far away may
/// another assembly be.
pub(crate) const LARGEST_LAPSE: f64 = 0.2;

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
    if equations.step(state, t) { Ok(()) } else { advance_by_steps(equations, state, t) }
}

/// One step straight on; whether it was made.
///
/// A function of its own for each mechanism, so that its stages are compiled into it and their results never leave the registers.
#[inline(never)]
pub(crate) fn step<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(equations: &E, state: &mut State<T, N>, t: T) -> bool {
    if state.mark != equations.mark() {
        return false;
    }
    // Every block keeps its sign: the branch's name stays.
    let sides = state.branch;
    stride(equations, state, &sides, t, true)
}

/// One step straight on of those coordinates that move; whether it was made.
///
/// * `part`: given, what moves, as a mechanism of its own.
/// * `held`: given, the indices in q of its coordinates.
/// * `mark`: given, of the parameters.
#[doc(hidden)]
pub fn step_in_part<T: Float, E: Stages<T, P>, const P: usize, const N: usize>(
    part: &E,
    state: &mut State<T, N>,
    held: &[usize; P],
    mark: u64,
    t: T,
) -> bool {
    // With other parameters what rested does not rest.
    if state.mark != mark {
        return false;
    }
    let mut moving = state.part(held);
    let is_made = step(part, &mut moving, t);
    if is_made {
        state.take(held, &moving);
    }
    is_made
}

/// What a step straight on comes to.
pub(crate) struct Stride<T: Lanes> {
    /// The time it takes, s.
    pub(crate) h: T,
    /// The lanes in which it was made, one at least.
    pub(crate) found: T::Mask,
    pub(crate) condition: T,
    pub(crate) iterations: usize,
}

/// One step straight on, in the lanes that are `moving`; the lanes that made it. The state is then the one at `t` in these.
///
/// * `sides`: given, the branch: by block, at the index of its first unknown.
#[inline(always)]
pub(crate) fn stride<T: Lanes, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    state: &mut State<T, N>,
    sides: &[T::Sides; N],
    t: T,
    moving: T::Mask,
) -> T::Mask {
    let h = t - state.t;
    let mut pass = Pass::straight(equations, Departure::new(state, sides, h, moving, E::ITERATED.len()));
    let nowhere = T::Mask::of(false);
    if E::IN_PLACE {
        let mut there = Coordinates::of(state);
        let is_found = equations.stages_in_place(t, &mut pass, &mut there).is_ok();
        let Some(walk) = pass.walk().filter(|_| is_found) else { return nowhere };
        follow(equations, state, t, &there, walk, moving)
    } else {
        let Ok(there) = equations.stages(t, &mut pass) else { return nowhere };
        let Some(walk) = pass.walk() else { return nowhere };
        follow(equations, state, t, &there, walk, moving)
    }
}

/// Makes the step to where a pass has led, in the lanes in which it led anywhere; which they are.
#[inline(always)]
fn follow<T: Lanes, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    state: &mut State<T, N>,
    t: T,
    there: &Coordinates<T, N>,
    walk: Walk<T>,
    moving: T::Mask,
) -> T::Mask {
    let h = t - state.t;
    let Walk { found, condition, iterations } = walk;
    let found = found.and(moving).and(is_resolved(state, &there.q, h, E::COMPUTED_ANGLES));
    // In memory what is iterated is looked at once only; what lies in registers is put there when it is sure.
    let accelerations = if E::IN_PLACE { state.extrapolate(h, found, there, E::ITERATED) } else { sum(&there.qdd, E::ITERATED) };
    let mut found = found.and(is_surely_finite(h + accelerations, there, E::UNSURE));
    // A prediction that was right to half of its digits comes from the same branch.
    if iterations > SURE {
        // A copy, so that the usual case need not have it in memory.
        let there = Coordinates { q: there.q, qd: there.qd, qdd: there.qdd };
        found = found.and(comes_from(equations, state, h, &there, condition));
    }
    if !found.not().all() {
        if !E::IN_PLACE {
            state.extrapolate(h, found, there, E::ITERATED);
        }
        state.follow_on(t, &Stride { h, found, condition, iterations }, there);
    }
    if E::IN_PLACE && !found.all() {
        state.forget_trend(found);
    }
    found
}

/// The same by as many steps as it takes.
#[cold]
#[inline(never)]
fn advance_by_steps<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    state: &mut State<T, N>,
    t: T,
) -> Result<(), Failure<T, N>> {
    let fail = |cause, time, last: &State<T, N>| Err(Failure { mechanism: E::NAME, cause, time, end: None, last: Some(last.clone()) });
    if !t.is_finite() || !state.t.is_finite() {
        return fail(Cause::NotFinite { of: Culprit::Time }, t, state);
    }
    if let Err(parameter) = equations.validate() {
        return fail(Cause::ParameterOutOfRange(parameter), t, state);
    }
    // A state of slightly other parameters is first put in order where it is; one of these parameters stays as it is.
    let seated = self::reached(equations, state.t, Care::follow(equations, state, T::of(0.0)));
    let mut here = seated.map_or_else(|_| state.clone(), |(seated, _)| seated);
    let mut waypoint = here.clone();
    let mut step = t - state.t;
    let most = const { MOST_STEPS / (1 + 10 * N / MANY) };
    for _ in 0..most {
        let next = if step.abs() >= (t - here.t).abs() { t } else { here.t + step };
        match self::reached(equations, next, Care::follow(equations, &here, next - here.t)) {
            Ok((reached, _)) if !is_same_branch(equations, &here, &reached) && halves(equations, &mut step, next, &here, t - state.t) => {}
            Ok((reached, off)) if next == t => match off {
                Some(cause) => return fail(cause, t, state),
                None => {
                    *state = reached;
                    return Ok(());
                }
            },
            Ok((reached, _)) => {
                here = reached;
                step = step + step;
                if here.condition <= greater(largest_condition(CLEAR), T::of(LEAST_CLEAR)) {
                    waypoint = here.clone();
                }
            }
            Err(refusal) => {
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
                    let ended = || (verdict::end_of_branch(equations, next, &here, refusal), next);
                    let (cause, time) = verdict::diverging(equations, &here, next).unwrap_or_else(ended);
                    return fail(cause, time, &here);
                }
            }
        }
    }
    let (cause, time) = verdict::diverging(equations, &here, t).unwrap_or((Cause::TooManySteps { steps: most }, t));
    fail(cause, time, &here)
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

/// Every computed angle came to where it was expected: a drive that goes on after a rest may turn anything in one long step.
#[inline(always)]
fn is_resolved<T: Lanes, const N: usize>(here: &State<T, N>, q: &SVector<T, N>, h: T, angles: &[usize]) -> T::Mask {
    let mut resolved = T::Mask::of(true);
    for &i in angles {
        if i < N {
            let off = q[i] - (here.q[i] + h * (here.qd[i] + h * T::of(0.5) * here.qdd[i]));
            resolved = resolved.and(off.abs().at_most(T::of(LARGEST_SURPRISE)));
        }
    }
    resolved
}

/// A step came to where it was expected, and from where it began.
pub(crate) fn is_same_branch<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    here: &State<T, N>,
    there: &State<T, N>,
) -> bool {
    let h = there.t - here.t;
    let coordinates = Coordinates { q: there.q, qd: there.qd, qdd: there.qdd };
    is_resolved(here, &there.q, h, E::COMPUTED_ANGLES) && comes_from(equations, here, h, &coordinates, there.condition)
}

/// Rounding errors of positions, as a multiple of ε times their condition.
const ROUNDINGS: f64 = 4.0;

/// The state after a step expects behind it, at q − h q̇ + h² q̈ / 2, the state before, as far as another assembly may be away.
#[cold]
#[inline(never)]
fn comes_from<T: Lanes, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    here: &State<T, N>,
    h: T,
    there: &Coordinates<T, N>,
    condition: T,
) -> T::Mask {
    let length = length_of(equations.characteristic_length());
    let condition = condition.max(here.condition);
    // What rounding errors may make of two positions is no lapse.
    let nearest = T::of(LARGEST_LAPSE) / condition + T::of(ROUNDINGS) * T::EPSILON * condition;
    let mut comes = T::Mask::of(true);
    for &i in E::ITERATED {
        let Some(coordinate) = E::COORDINATES.get(i) else { continue };
        let lapse = (there.q[i] - here.q[i]) - h * (there.qd[i] - T::of(0.5) * (h * there.qdd[i]));
        // A length that is larger than L is measured by itself.
        let size = if coordinate.kind == CoordinateKind::Length { length.max(here.q[i].abs()) } else { T::of(1.0) };
        comes = comes.and(lapse.abs().at_most(nearest * size));
    }
    comes
}

/// A careful pass through all stages, compiled once for each mechanism.
///
/// # Errors
/// Why it ended early.
#[inline(never)]
pub(crate) fn pass<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    care: &Care<'_, T, N>,
) -> Result<Coordinates<T, N>, Stop<T>> {
    equations.stages(t, &mut Pass::careful(care))
}

/// The state at the end of a careful pass, in which all equations hold.
///
/// # Errors
/// Why there is none.
pub(crate) fn state<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    care: Care<'_, T, N>,
) -> Result<State<T, N>, Stop<T>> {
    match reached(equations, t, care)? {
        (_, Some(cause)) => Err(Stop::Open(cause)),
        (state, None) => Ok(state),
    }
}

/// A state, and why it is none if an equation that is checked does not hold in it.
pub(crate) type Reached<T, const N: usize> = (State<T, N>, Option<Cause<T>>);

/// The state at the end of a careful pass, and which of the equations that are not solved does not hold in it.
///
/// # Errors
/// Why there is none.
pub(crate) fn reached<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    care: Care<'_, T, N>,
) -> Result<Reached<T, N>, Stop<T>> {
    let there = pass(equations, t, &care)?;
    let Coordinates { q, qd, qdd } = there;
    for vector in [&q, &qd, &qdd] {
        if let Some(index) = vector.iter().position(|entry| !entry.is_finite()) {
            return Err(Stop::NotFinite(Culprit::Coordinate(names::coordinate(E::COORDINATES, index))));
        }
    }
    let Found { branch, condition, iterations, .. } = care.found();
    let state = State::solved(Values { t, q, qd, qdd, branch, condition, iterations }, equations.mark());
    Ok((state, care.contradiction()))
}

/// The sum of these entries.
#[inline(always)]
fn sum<T: Lanes, const N: usize>(vector: &SVector<T, N>, indices: &[usize]) -> T {
    let mut sum = T::of(0.0);
    for &i in indices {
        if i < N {
            sum = sum + vector[i];
        }
    }
    sum
}

/// A sum is not finite if a term is not. Of rates the squares are looked at, which accelerations contain; what is iterated is finite, and
/// so are its rates if its accelerations are.
///
/// * `sum`: given, the time that the step takes and the accelerations of what is iterated.
#[inline(always)]
fn is_surely_finite<T: Lanes, const N: usize>(sum: T, there: &Coordinates<T, N>, unsure: Option<&[usize]>) -> T::Mask {
    // Three sums side by side, so that none has to wait long for the one before.
    let mut sums = [sum, T::of(0.0), T::of(0.0)];
    let mut add = |i: usize| {
        sums[0] = sums[0] + there.q[i];
        sums[1] = sums[1] + there.qdd[i];
        sums[2] = sums[2] + there.qd[i] * there.qd[i];
    };
    match unsure {
        Some(unsure) => unsure.iter().filter(|i| **i < N).for_each(|i| add(*i)),
        None => (0..N).for_each(add),
    }
    let sum = (sums[0] + sums[1]) + sums[2];
    // Nothing is left of a number; ∞ and NaN stay NaN.
    (T::of(0.0) * sum).at_most(T::of(0.0))
}
