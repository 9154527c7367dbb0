//! Forces that jump: how the instant depends on parameters.
//!
//! ```text
//! u(τ) = u₀ + f⁻ (t* − t₀) + f⁺ (τ − t*)          t* the instant, f⁻ and f⁺ the accelerations before and after it
//! ∂u/∂p ← ∂u/∂p + (f⁻ − f⁺) ∂(t* − t₀)/∂p
//! ```
//!
//! In: the states at both ends of a short step. Out: whether accelerations jump within it, and the derivatives of the speeds at its end.
//!
//! The condition of a jump is not known here. Its instant is looked for with each parameter a little larger and a little smaller, from states
//! that are varied as they depend on it: whether the accelerations are nearer to those before or to those after the jump tells the side. The
//! derivative is exact to about ε^(2/3).
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

/// If a half of a step has less than this part of the change, accelerations jump in no half of it.
const SMOOTH: f64 = 0.75;

/// Growth of the interval in which an instant is looked for.
const GROWTH: f64 = 8.0;

/// Most halvings of an interval.
const HALVINGS: usize = 80;

/// An instant at which accelerations jump.
pub(super) struct Jump<T, const N: usize> {
    /// Time from the beginning of the step, in s.
    pub(super) later: T,
    /// Accelerations before it.
    pub(super) before: SVector<T, N>,
    /// Accelerations after it.
    pub(super) after: SVector<T, N>,
    /// The change relative to the largest acceleration.
    share: T,
}

/// The jump of accelerations within a step, if there is one. In halves of a smooth change there is as much of it.
#[inline(never)]
pub(super) fn jump_within<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    from: &State<T, N>,
    next: &State<T, N>,
) -> Option<Jump<T, N>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let lengths = lengths(mechanism);
    let change = |one: &SVector<T, N>, two: &SVector<T, N>| largest_change([one, two], &S::INTEGRATED, &lengths).without_derivatives();
    let size = |vector| largest(&picked(vector, &S::INTEGRATED), &lengths).without_derivatives();
    let size = size(&from.qdd).max(size(&next.qdd));
    let shortest = T::of(INSTANT) * T::EPSILON * from.t.without_derivatives().abs();
    let (mut near, mut far) = ((T::ZERO, from.qdd), ((next.t - from.t).without_derivatives(), next.qdd));
    for _ in 0..HALVINGS {
        let whole = change(&near.1, &far.1);
        let jumps = whole > T::of(SMALL) * size;
        if !jumps {
            return None;
        }
        let middle = T::of(0.5) * (near.0 + far.0);
        if middle == near.0 || middle == far.0 || (far.0 - near.0).abs() <= shortest {
            return Some(Jump { later: far.0, before: near.1, after: far.1, share: whole / size });
        }
        let middle = (middle, varied_state(mechanism, from, (0, T::ZERO, T::ZERO), middle)?.qdd);
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
/// * `from`: given, the state before the step.
/// * `next`: given, the state after it, with the derivatives of a smooth motion; returned, with those of this one.
#[inline(never)]
pub(super) fn with_derivatives_of_instant<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    from: &State<T, N>,
    next: &mut State<T, N>,
    reached: &mut Reached<T, M, I>,
) -> Result<(), Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let Some(jump) = jump_within(mechanism, from, next) else { return Ok(()) };
    let lengths = lengths(mechanism);
    let fastest = largest(&picked(&from.qd, &S::INTEGRATED), &lengths).without_derivatives();
    for number in 0.. {
        let Some(by_time) = from.t.derivative(number) else { break };
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
        let instant = |change| instant::<T, S, N, I, M, R>(mechanism, from, &jump, (number, change, by_time));
        let (Some(later), Some(earlier)) = (instant(change), instant(T::ZERO - change)) else {
            return Err(Stopped::StepTooShort { time: from.t });
        };
        let by = (later - earlier) / (T::of(2.0) * change);
        for place in S::INTEGRATED {
            if let (Some(before), Some(after), Some(speed)) = (jump.before.get(place), jump.after.get(place), next.values.qd.get_mut(place))
            {
                let so_far = speed.derivative(number).unwrap_or(T::ZERO);
                *speed = speed.with_derivative(number, so_far + (*before - *after).without_derivatives() * by);
            }
        }
    }
    let values = &mut next.values;
    project(mechanism, None, (&mut values.q, &mut values.qd), values.t, reached).map_err(|_| Stopped::StepTooShort { time: from.t })?;
    refresh(mechanism, next)
}

/// The time from the state `from` to the jump, with a parameter changed, and the state as it depends on it.
fn instant<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    from: &State<T, N>,
    jump: &Jump<T, N>,
    (number, change, by_time): (usize, T, T),
) -> Option<T>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let (varied, lengths) = (mechanism.varied(number, change), lengths(mechanism));
    let varied = varied.as_ref().unwrap_or(mechanism);
    let is_after = |later: T| {
        let state = varied_state(varied, from, (number, change, by_time), later)?;
        let away = |other: &SVector<T, N>| largest_change([&state.qdd, other], &S::INTEGRATED, &lengths);
        Some(away(&jump.after) < away(&jump.before))
    };
    // Accelerations change by less than the jump within this time.
    let longest = jump.share * first_step(mechanism, from).without_derivatives();
    let width = T::of(INSTANT) * T::EPSILON * from.t.without_derivatives().abs();
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

/// The state a short time later, of a mechanism with a parameter changed, from a state that is changed as it depends on it.
fn varied_state<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    from: &State<T, N>,
    (number, change, by_time): (usize, T, T),
    later: T,
) -> Option<State<T, N>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let changed = |value: Option<&T>| {
        value.map_or(T::ZERO, |value| value.without_derivatives() + change * value.derivative(number).unwrap_or(T::ZERO))
    };
    let mut state = from.clone();
    state.values.t = from.t.without_derivatives() + change * by_time + later;
    for place in 0..N {
        let [q, qd, qdd] = [from.q.get(place), from.qd.get(place), from.qdd.get(place)].map(changed);
        if let (Some(to), Some(speed)) = (state.values.q.get_mut(place), state.values.qd.get_mut(place)) {
            (*to, *speed) = (q + later * (qd + T::of(0.5) * later * qdd), qd + later * qdd);
        }
    }
    refresh(mechanism, &mut state).ok()?;
    Some(state)
}
