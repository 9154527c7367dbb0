//! Forces that jump: how the instant depends on parameters.
//!
//! ```text
//! u(τ) = u₀ + f⁻ (t* − t₀) + f⁺ (τ − t*)          t* the instant, f⁻ and f⁺ the accelerations before and after it
//! ∂u/∂p ← ∂u/∂p + (f⁻ − f⁺) ∂(t* − t₀)/∂p
//! ```
//!
//! In: the states at both ends of a short step. Out: whether accelerations jump within it, and the derivatives of the speeds at its end.
//!
//! The condition of the jump is unknown. The search repeats with each parameter slightly larger and slightly smaller, from the state that belongs
//! to it; a state lies behind the jump if its accelerations are nearer to those after it. Relative error of the derivative: about ε^(5/8).
//!
//! Not done here: several jumps at one instant, and jumps so small that no step is shortened for them.
//!
//! Reference: Leine and Nijmeijer, Dynamics and Bifurcations of Non-Smooth Mechanical Systems (saltation matrix).

use nalgebra::SVector;

use super::accelerate::lengths;
use super::equations::Dynamics;
use super::places::{largest, largest_change, picked};
use super::project::{Reached, project, refresh};
use super::step::{INSTANT, first_step};
use super::stopped::Stopped;
use crate::number::Scalar;
use crate::state::State;

/// A smaller change of the largest acceleration is no jump.
const SMALL: f64 = 1e-5;

/// Times ε over the square of the longest step: a smaller change moves nothing.
const NEGLIGIBLE: f64 = 1e3;

/// Accelerations change smoothly if neither half of an interval has more than this part of the change.
const SMOOTH: f64 = 0.75;

/// Growth of the interval in which an instant is looked for.
const GROWTH: f64 = 8.0;

/// Most halvings of an interval.
const HALVINGS: usize = 80;

/// An instant at which accelerations jump.
struct Jump<T, const N: usize> {
    /// Time from the beginning of the step, in s.
    later: T,
    /// Accelerations before it.
    before: SVector<T, N>,
    /// Accelerations after it.
    after: SVector<T, N>,
    /// The change relative to the largest acceleration.
    share: T,
}

/// True if the accelerations on both sides of an instant are not the same.
///
/// * `ends`: given, accelerations at both ends of a longer time around, with which the difference is compared: at the instant they may pass through
///   zero.
pub(super) fn accelerations_jump<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    sides: [&SVector<T, N>; 2],
    ends: [&SVector<T, N>; 2],
) -> bool
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let lengths = lengths(mechanism);
    let all = sides.iter().chain(&ends);
    let greatest = all.fold(T::ZERO, |most, vector| most.max(largest(&picked(vector, &S::INTEGRATED), &lengths)));
    largest_change(sides, &S::INTEGRATED, &lengths) > T::of(SMALL) * greatest
}

/// The jump of accelerations within a step, if there is one. A smooth change divides about evenly between the halves of a step; a jump lies in
/// one of them.
///
/// * `longest`: given, the longest step so far, in s.
#[inline(never)]
fn jump_within<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    (from, longest): (&State<T, N>, T),
    next: &State<T, N>,
) -> Option<Jump<T, N>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let lengths = lengths(mechanism);
    let change = |one: &SVector<T, N>, two: &SVector<T, N>| largest_change([one, two], &S::INTEGRATED, &lengths).without_derivatives();
    let size = |vector| largest(&picked(vector, &S::INTEGRATED), &lengths).without_derivatives();
    let greatest = size(&from.qdd).max(size(&next.qdd));
    let step = (next.t - from.t).without_derivatives();
    let shortest = shortest(from, step);
    let least = (T::of(NEGLIGIBLE) * T::EPSILON / (longest * longest)).without_derivatives();
    // Before the first step nothing is known to be too small.
    let least = if longest > T::ZERO { least } else { T::ZERO };
    let (mut near, mut far) = ((T::ZERO, from.qdd), (step, next.qdd));
    for _ in 0..HALVINGS {
        let whole = change(&near.1, &far.1);
        let jumps = whole > (T::of(SMALL) * greatest).max(least);
        if !jumps {
            return None;
        }
        let middle = T::of(0.5) * (near.0 + far.0);
        if middle == near.0 || middle == far.0 || (far.0 - near.0).abs() <= shortest {
            return Some(Jump { later: far.0, before: near.1, after: far.1, share: whole / greatest });
        }
        let middle = (middle, later_state(mechanism, from, |value| value.without_derivatives(), middle)?.qdd);
        let (first, second) = (change(&near.1, &middle.1), change(&middle.1, &far.1));
        let is_uneven = first.max(second) > T::of(SMOOTH) * (first + second);
        if !is_uneven {
            return None;
        }
        if first > second { far = middle } else { near = middle }
    }
    None
}

/// Gives the speeds after a jump their derivatives by parameters on which its instant depends.
///
/// * `from`, `longest`: given, the state before the step, and the longest step so far.
/// * `next`: given, the state after it, with the derivatives of a smooth motion; returned, with those of this one.
#[inline(never)]
pub(super) fn with_derivatives_of_instant<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    (from, longest): (&State<T, N>, T),
    next: &mut State<T, N>,
    reached: &mut Reached<T, M, I>,
) -> Result<(), Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let Some(jump) = jump_within(mechanism, (from, longest), next) else { return Ok(()) };
    let lengths = lengths(mechanism);
    let fastest = largest(&picked(&from.qd, &S::INTEGRATED), &lengths).without_derivatives();
    for number in 0.. {
        if from.t.derivative(number).is_none() {
            break;
        }
        // The change of a parameter by which no entry of the state changes by more than ε^(3/8).
        let mut relative = T::of(1.0) / mechanism.parameter_size(number);
        for (place, length) in S::INTEGRATED.into_iter().zip(&lengths) {
            let entries = [from.q.get(place), from.qd.get(place)].map(|entry| entry.copied().unwrap_or(T::ZERO));
            let by = |entry: T| entry.derivative(number).unwrap_or(T::ZERO).abs();
            relative = relative.max(by(entries[0]) / entries[0].without_derivatives().abs().max(*length));
            relative = relative.max(if fastest > T::ZERO { by(entries[1]) / (fastest * *length) } else { T::ZERO });
        }
        let root = T::ROOT_EPSILON.sqrt();
        let change = root * root.sqrt() / relative.without_derivatives();
        let by = instant_by::<T, S, N, I, M, R>(mechanism, from, &jump, (number, change));
        let by = by.ok_or(Stopped::StepTooShort { time: from.t })?;
        let rest = (next.t - from.t).without_derivatives() - jump.later;
        for place in S::INTEGRATED {
            let accelerations =
                [&jump.before, &jump.after].map(|vector| vector.get(place).map_or(T::ZERO, |value| value.without_derivatives()));
            let missing = (accelerations[0] - accelerations[1]) * by;
            let values = &mut next.values;
            for (entry, missing) in [(values.q.get_mut(place), missing * rest), (values.qd.get_mut(place), missing)] {
                if let Some(entry) = entry {
                    *entry = entry.with_derivative(number, entry.derivative(number).unwrap_or(T::ZERO) + missing);
                }
            }
        }
    }
    let values = &mut next.values;
    project(mechanism, None, (&mut values.q, &mut values.qd), values.t, reached).map_err(|_| Stopped::StepTooShort { time: from.t })?;
    refresh(mechanism, next)
}

/// How much shorter a change of a parameter is made if the jump is not found with it, and how often.
const SHORTER: f64 = 0.125;
const TRIES: usize = 6;

/// The derivative of the time from the state `from` to the jump by a parameter, from changes of it.
fn instant_by<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    from: &State<T, N>,
    jump: &Jump<T, N>,
    (number, mut change): (usize, T),
) -> Option<T>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    for _ in 0..TRIES {
        let instant = |change| instant::<T, S, N, I, M, R>(mechanism, from, jump, (number, change));
        if let (Some(later), Some(earlier)) = (instant(change), instant(T::ZERO - change)) {
            return Some((later - earlier) / (T::of(2.0) * change));
        }
        change = change * T::of(SHORTER);
    }
    None
}

/// No two instants after the state `from` are told apart within this time.
fn shortest<T: Scalar, const N: usize>(from: &State<T, N>, later: T) -> T {
    T::of(INSTANT) * T::EPSILON * (from.t.without_derivatives().abs() + later.abs())
}

/// The time from the state `from` to the jump, with a parameter changed, and the state as it depends on it.
fn instant<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    from: &State<T, N>,
    jump: &Jump<T, N>,
    (number, change): (usize, T),
) -> Option<T>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let (other, lengths) = (mechanism.varied(number, change), lengths(mechanism));
    let other = other.as_ref().unwrap_or(mechanism);
    let changed = |value: T| value.without_derivatives() + change * value.derivative(number).unwrap_or(T::ZERO);
    let is_after = |later: T| {
        let state = later_state(other, from, changed, later)?;
        let away = |other: &SVector<T, N>| largest_change([&state.qdd, other], &S::INTEGRATED, &lengths);
        Some(away(&jump.after) < away(&jump.before))
    };
    // Accelerations change by less than the jump within this time.
    let longest = jump.share * first_step(mechanism, from).without_derivatives();
    let width = shortest(from, jump.later);
    let forward = if jump.later < T::ZERO { T::ZERO - width } else { width };
    let was_after = is_after(jump.later)?;
    let mut reach = if was_after { T::ZERO - forward } else { forward };
    let (mut near, mut far) = (jump.later, jump.later + reach);
    while is_after(far)? == was_after {
        reach = reach * T::of(GROWTH);
        (near, far) = (far, jump.later + reach);
        let is_short = reach.abs() <= longest;
        if !is_short {
            return None;
        }
    }
    for _ in 0..HALVINGS {
        let middle = T::of(0.5) * (near + far);
        if middle == near || middle == far {
            break;
        }
        if is_after(middle)? == was_after {
            near = middle;
        } else {
            far = middle;
        }
    }
    Some(T::of(0.5) * (near + far))
}

/// The state a short time later, from the state `from` with other numbers.
fn later_state<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    from: &State<T, N>,
    changed: impl Fn(T) -> T,
    later: T,
) -> Option<State<T, N>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let mut state = from.clone();
    state.values.t = changed(from.t) + later;
    for place in 0..N {
        let [q, qd, qdd] = [&from.q, &from.qd, &from.qdd].map(|vector| vector.get(place).map_or(T::ZERO, |value| changed(*value)));
        if let (Some(to), Some(speed)) = (state.values.q.get_mut(place), state.values.qd.get_mut(place)) {
            (*to, *speed) = (q + later * (qd + T::of(0.5) * later * qdd), qd + later * qdd);
        }
    }
    refresh(mechanism, &mut state).ok()?;
    Some(state)
}
