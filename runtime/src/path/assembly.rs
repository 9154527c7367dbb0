//! The first state, on the branch of the declared start, for any parameters.
//!
//! The declared start is assembled at the default parameters. Other parameters are reached by continuation along the straight line
//! λ ↦ defaults + λ (parameters − defaults), as in `continuation` along time: a step is accepted if Newton's method needs only
//! short corrections in every block and the determinants keep their signs. The length of a step is not tied to that of the whole
//! line: an offset of 1 m may become 1e10 m, and whatever it moves goes as far. So the last step predicts the next one (a secant),
//! and a long step is also accepted if the solution is close to the prediction, relative to the predicted change. Where the branch
//! ends on the line, at a fold, the same branch may still exist at the parameters themselves: an assembly there is accepted if
//! every determinant has the same sign as at the defaults; finding only another one is a failure. A block that is linear in its unknowns has
//! no other solution, whatever its sign. Where a parameter that changes its sign would turn what it drives without end, a transmission ratio with zero
//! between, it becomes infinite on the way instead. Where the equations that are solved lose rank on the line, and redundant ones do not, the way leaps over the
//! place.

use nalgebra::SVector;

use super::branch::{LARGEST_LAPSE, jump};
use super::cold::{CheckedState, cold_state, inspect, valid_state};
use crate::linear::{difference, divided, moved};
use crate::names::{self, BranchEnd, Cause, CoordinateKind, Culprit};
use crate::newton::StepError;
use crate::number::Float;
use crate::solve::{ColdSolver, Followed, Stages};
use crate::state::State;

/// Largest number of steps from the defaults to the parameters, accepted or not, for a mechanism of a few coordinates: enough for ten thousand turns
/// of a drive. It decreases with the number of coordinates.
const MOST_STEPS: usize = 1_000_000;

/// With this many coordinates the limit is about a tenth.
const MANY: usize = 90;

/// After so many steps it is seen whether those that are left lead to the parameters.
const PACE: usize = 1000;

/// A way of constant speed becomes slower by less than this from one look to the next.
const SLOWER: f64 = 0.9;

/// A step in which no angle is predicted to turn by more than this (rad) is not limited by turns.
const SHORT_TURN: f64 = 0.1;

/// Largest distance between solution and prediction: of a length, as a fraction of the predicted change plus L; of an angle, in
/// rad.
const SURPRISE: f64 = 0.05;

/// Largest change of an angle in one step, in rad.
const LONGEST_TURN: f64 = 0.8;

/// A state of a smaller condition is far from any place where the equations lose rank.
const CLEAR: f64 = 1e4;

/// Largest number of places that are leaped over.
const MOST_LEAPS: usize = 4;

/// Why there is no first state.
pub(crate) struct Unassembled<T, const N: usize> {
    pub(crate) cause: Cause<T>,
    /// Where the branch ends on the way from the declared defaults.
    pub(crate) end: Option<BranchEnd<T>>,
    /// The last state on that line.
    pub(crate) last: Option<State<T, N>>,
}

/// The state at t = 0 on the branch of the declared start.
///
/// # Errors
/// Why there is none, at these parameters or on the line to them.
#[inline(never)]
pub(crate) fn assemble<T: Float, E: Stages<T, N>, const N: usize>(equations: &E) -> Result<State<T, N>, Unassembled<T, N>> {
    let zero = T::of(0.0);
    let near = |guess: &SVector<T, N>| assemble_near(equations, zero, guess);
    let alone = |cause| Unassembled { cause, end: None, last: None };
    let start = equations.start();
    // The defaults may be placeholders that do not close; then the start is only a guess.
    let origin = equations.interpolated(zero).and_then(|defaults| assemble_near(&defaults, zero, &defaults.start()).ok());
    let Some(origin) = origin.filter(|_| equations.validate().is_ok()) else { return near(&start).map_err(alone) };
    if !E::UNIQUE.is_empty()
        && let Some(state) = beyond_zero(equations, &origin)
    {
        return Ok(state);
    }
    match follow(equations, &origin, T::of(1.0)) {
        Ok((state, None)) => Ok(state),
        Ok((_, Some(cause))) => Err(alone(cause)),
        Err(unfinished) => elsewhere(equations, &origin, unfinished),
    }
}

/// The state at the parameters through infinite values, if only blocks with one solution have another sign there. Where their determinant vanishes they
/// have none, so that the straight way ends there.
#[cold]
#[inline(never)]
fn beyond_zero<T: Float, E: Stages<T, N>, const N: usize>(equations: &E, origin: &State<T, N>) -> Option<State<T, N>> {
    let state = assemble_near(equations, T::of(0.0), &equations.start()).ok()?;
    if is_beyond::<T, E, N>(&state, origin) { around(equations, origin) } else { None }
}

/// Whether blocks with one solution have other signs than at the origin, and all others the same.
fn is_beyond<T: Float, E: Stages<T, N>, const N: usize>(state: &State<T, N>, origin: &State<T, N>) -> bool {
    state.branch != origin.branch && has_same_signs(E::UNIQUE, state, origin)
}

/// The state at the parameters where the straight way does not lead there.
#[cold]
#[inline(never)]
fn elsewhere<T: Float, E: Stages<T, N>, const N: usize>(
    equations: &E,
    origin: &State<T, N>,
    unfinished: Unfinished<T, N>,
) -> Result<State<T, N>, Unassembled<T, N>> {
    let start = equations.start();
    let near = |guess: &SVector<T, N>| assemble_near(equations, T::of(0.0), guess);
    let alone = |cause| Unassembled { cause, end: None, last: None };
    let (lambda, here) = match unfinished {
        Unfinished::BranchEnds(lambda, here) => (lambda, here),
        Unfinished::TooFar if E::ITERATED.is_empty() => return near(&start).map_err(alone),
        // An assembly near the last state may have turned less often than its drive.
        Unfinished::TooFar => {
            if let Some(state) = around(equations, origin) {
                return Ok(state);
            }
            return match near(&start) {
                Ok(state) if is_beyond::<T, E, N>(&state, origin) => Ok(state),
                _ => Err(alone(Cause::TooManySteps { steps: const { most_steps(N) } })),
            };
        }
    };
    let first = match near(&here.q) {
        Ok(state) if has_same_signs(E::UNIQUE, &state, origin) => return Ok(state),
        other => other,
    };
    let second = match near(&start) {
        Ok(state) if has_same_signs(E::UNIQUE, &state, origin) => return Ok(state),
        other => other,
    };
    let cause = why_not(&Followed::new(&equations), &here, [first, second]);
    Err(Unassembled { cause, end: end(equations, lambda, &here), last: Some(here) })
}

/// Whether the determinants of blocks that may have several solutions have the same signs.
///
/// * `unique`: given, [`Stages::UNIQUE`].
fn has_same_signs<T: Float, const N: usize>(unique: &[usize], one: &State<T, N>, other: &State<T, N>) -> bool {
    one.branch.iter().zip(&other.branch).enumerate().all(|(unknown, (one, other))| one == other || unique.contains(&unknown))
}

/// Why two guesses, from `here` and from the start, led to no state on the branch.
fn why_not<T: Float, const N: usize>(
    mechanism: &Followed<'_, T, N>,
    here: &State<T, N>,
    [first, second]: [Result<State<T, N>, Cause<T>>; 2],
) -> Cause<T> {
    let mirrored = |state: State<T, N>| jump(mechanism, &here.q, &state.q);
    match (first.map_or_else(|cause| cause, mirrored), second) {
        (_, Ok(state)) => mirrored(state),
        // Of two open loops the one with the smaller gap; else the first cause.
        (Cause::DoesNotClose { gap: one, .. }, Err(now @ Cause::DoesNotClose { gap: two, .. })) if two < one => now,
        (before, Err(_)) => before,
    }
}

/// The state at `t` (s) that Newton's method finds from a rough `guess` of q, on any branch.
///
/// # Errors
/// Why there is none.
#[inline(never)]
pub(crate) fn assemble_near<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    guess: &SVector<T, N>,
) -> Result<State<T, N>, Cause<T>> {
    equations.validate().map_err(Cause::ParameterOutOfRange)?;
    if !t.is_finite() {
        return Err(Cause::NotFinite { of: Culprit::Time });
    }
    let guess = equations.refined_guess(t, guess);
    let mechanism = Followed::new(&equations);
    Ok(valid_state(&mechanism, t, ColdSolver::from_guess(&mechanism, &guess))?)
}

/// Why the parameters were not reached from the defaults.
enum Unfinished<T, const N: usize> {
    /// The branch ends at this λ; the last state before.
    BranchEnds(T, State<T, N>),
    /// The steps were used up.
    TooFar,
}

/// The state at the parameters on a way on which those that change their sign become infinite instead of zero: a transmission ratio with zero between
/// turns what it drives without end on the straight way, and does not move it far on this one.
#[cold]
#[inline(never)]
fn around<T: Float, E: Stages<T, N>, const N: usize>(equations: &E, origin: &State<T, N>) -> Option<State<T, N>> {
    // No parameter changes its sign: it would be the straight way.
    equations.interpolated(T::of(-1.0))?;
    follow(equations, origin, T::of(-1.0)).ok().and_then(|(state, misfit)| if misfit.is_none() { Some(state) } else { None })
}

/// Follows the branch from the defaults. Returns the state at the parameters, with the redundant joint that does not fit there if
/// there is one.
///
/// * `sense`: given, 1 for the straight way, −1 for the one through infinite values: the sign of λ in [`Stages::interpolated`].
fn follow<T: Float, E: Stages<T, N>, const N: usize>(
    equations: &E,
    origin: &State<T, N>,
    sense: T,
) -> Result<CheckedState<T, N>, Unfinished<T, N>> {
    let (zero, one) = (T::of(0.0), T::of(1.0));
    let (mut here, mut reached, mut step) = (origin.clone(), zero, one);
    // dq/dλ, from the last step.
    let mut slope = SVector::from_element(zero);
    let (mut clear, mut leaps) = (None, 0);
    let (mut looked_at, mut progress, mut left) = (zero, zero, T::of(const { most_steps(N) as f64 / PACE as f64 }));
    for taken in 0..const { most_steps(N) } {
        // Towards a place where an angle grows without bounds steps become ever shorter.
        if taken % PACE == PACE - 1 {
            let before = progress;
            (progress, looked_at, left) = (reached - looked_at, reached, left - one);
            if progress < T::of(SLOWER) * before && progress * left < one - reached {
                return Err(Unfinished::TooFar);
            }
        }
        let next = if reached + step < one { reached + step } else { one };
        let between = if next < one { equations.interpolated(sense * next) } else { None };
        let by = next - reached;
        match stride(&Followed::new(&between.as_ref().unwrap_or(equations)), &here, &slope, by) {
            // Redundant joints need not fit between the defaults and the parameters.
            Ok((state, _)) if next < one => {
                slope = divided(&difference(&state.q, &here.q), by);
                (here, reached, step) = (state, next, step + step);
                if E::IS_REDUNDANT && here.condition < T::of(CLEAR) {
                    clear = Some((here.clone(), reached, slope));
                }
            }
            Ok(found) => return Ok(found),
            Err(_) => step = T::of(0.5) * by,
        }
        // Rounding errors of the parameters move a fold by about this much; those of the defaults are smaller than any step.
        if step < T::ROOT_EPSILON * reached + T::EPSILON * T::EPSILON && !turns(equations, &slope, step) {
            if leaps < MOST_LEAPS
                && let Some(before) = &clear
                && let Some((found, beyond)) = leap(equations, before, reached, sense)
            {
                if beyond == one {
                    return Ok(found);
                }
                let state = found.0;
                slope = divided(&difference(&state.q, &before.0.q), beyond - before.1);
                (here, reached, step, leaps) = (state, beyond, beyond - reached, leaps + 1);
                continue;
            }
            return Err(Unfinished::BranchEnds(reached, here));
        }
    }
    Err(Unfinished::TooFar)
}

/// The state beyond the place λ where the equations that are solved lose rank, and the λ there; as far beyond it as the state `before` is on this
/// side, or at the parameters. The redundant equations hold there, and the state is where the one before leads.
#[cold]
fn leap<T: Float, E: Stages<T, N>, const N: usize>(
    equations: &E,
    (before, from, slope): &(State<T, N>, T, SVector<T, N>),
    place: T,
    sense: T,
) -> Option<(CheckedState<T, N>, T)> {
    let (one, beyond) = (T::of(1.0), place + (place - *from));
    if beyond <= place {
        return None;
    }
    let beyond = if beyond < one { beyond } else { one };
    let between = if beyond < one { equations.interpolated(sense * beyond) } else { None };
    let there = between.as_ref().unwrap_or(equations);
    let mechanism = Followed::new(&there);
    let predicted = moved(&before.q, beyond - *from, slope);
    match cold_state(&mechanism, T::of(0.0), ColdSolver::from_guess(&mechanism, &predicted)) {
        Ok(found) if found.1.is_none() && is_as_predicted(&mechanism, &before.q, &predicted, &found.0, T::of(SURPRISE)) => {
            Some((found, beyond))
        }
        _ => None,
    }
}

/// Largest number of steps for this number of coordinates.
const fn most_steps(coordinates: usize) -> usize {
    MOST_STEPS / (1 + 10 * coordinates / MANY)
}

/// Whether an angle is predicted to turn in a step, so that the step is short because the way is long.
fn turns<T: Float, E: Stages<T, N>, const N: usize>(equations: &E, slope: &SVector<T, N>, step: T) -> bool {
    let coordinates = Followed::new(&equations).coordinates;
    (0..N).any(|i| names::coordinate(coordinates, i).kind == CoordinateKind::Angle && (slope[i] * step).abs() > T::of(SHORT_TURN))
}

/// One step from `here` to other parameters, with the predicted change `slope` times `by`.
fn stride<T: Float, const N: usize>(
    mechanism: &Followed<'_, T, N>,
    here: &State<T, N>,
    slope: &SVector<T, N>,
    by: T,
) -> Result<CheckedState<T, N>, StepError<T>> {
    let zero = T::of(0.0);
    let mut slanted = here.clone();
    (slanted.qd, slanted.qdd) = (*slope, SVector::from_element(zero));
    let predicted = moved(&here.q, by, slope);
    match cold_state(mechanism, zero, ColdSolver::from_prediction(mechanism, &slanted, by)) {
        // No other assembly with the same sign can be this close.
        Ok(found) if is_as_predicted(mechanism, &here.q, &predicted, &found.0, T::of(LARGEST_LAPSE) / found.0.condition) => Ok(found),
        Ok(_) => Err(StepError::Far),
        Err(error) => {
            let found = cold_state(mechanism, zero, ColdSolver::from_guess(mechanism, &predicted))?;
            let is_same = has_same_signs(mechanism.unique, &found.0, here);
            if is_same && is_as_predicted(mechanism, &here.q, &predicted, &found.0, T::of(SURPRISE)) { Ok(found) } else { Err(error) }
        }
    }
}

/// Whether q is close to its prediction, relative to the predicted change.
fn is_as_predicted<T: Float, const N: usize>(
    mechanism: &Followed<'_, T, N>,
    before: &SVector<T, N>,
    predicted: &SVector<T, N>,
    found: &State<T, N>,
    surprise: T,
) -> bool {
    let scale = mechanism.scale();
    (0..N).all(|i| {
        let (way, off) = ((predicted[i] - before[i]).abs(), (found.q[i] - predicted[i]).abs());
        match names::coordinate(mechanism.coordinates, i).kind {
            CoordinateKind::Angle | CoordinateKind::Number => way <= T::of(LONGEST_TURN) && off <= surprise,
            CoordinateKind::Length => off <= surprise * (way + scale.length),
        }
    })
}

/// The block that is nearest to singular where a branch ends.
fn end<T: Float, E: Stages<T, N>, const N: usize>(equations: &E, lambda: T, here: &State<T, N>) -> Option<BranchEnd<T>> {
    let there = equations.interpolated(lambda)?;
    match inspect(&Followed::new(&&there), here.t, &here.q)? {
        Cause::Singular { row, coordinate, .. } => Some(BranchEnd { lambda, row, coordinate }),
        _ => None,
    }
}
