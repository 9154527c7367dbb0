//! Instants at which an event changes its sign.

use super::equations::Dynamics;
use super::looks::{LOOKS, Looks, changes};
use super::method::Method;
use super::project::Reached;
use super::quintic::between;
use super::step::land;
use super::stopped::Stopped;
use crate::number::Scalar;
use crate::state::State;

/// Most steps of the search for an instant.
const SEARCH: usize = 200;

/// The search halves its interval if so many steps have not done so.
const SLOW: usize = 3;

/// Part of a step, the value of the event there, and the state.
type Instant<T, const N: usize> = (T, T, State<T, N>);

/// Corrections of the derivatives of an instant; each leaves a part √ε of their error.
const DERIVATIVES: usize = 2;

/// The first state between two others at which an event changes its sign; none if it does not.
///
/// Interpolated states show roughly where that is. States at the ends of steps decide, since near the instant the two may differ in sign.
///
/// * `stopped`: given, the instant at which the motion was stopped before, and the event there: in that state the event counts as zero.
/// * `tolerance`: given, that of steps, as for [`land`].
pub(super) fn first_event<K: Method, T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    (from, to, stopped): (&State<T, N>, &State<T, N>, Option<(T, T)>),
    event: &impl Fn(&State<T, N>) -> T,
    tolerance: (T, T),
) -> Result<Option<State<T, N>>, Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let whole = to.t - from.t;
    let look = |part| event(&between(mechanism, from, to, part));
    // With the sign of its rounding, a body that rebounds would be stopped again before it has moved.
    let first = if stopped == Some((from.t, event(from))) { T::ZERO } else { event(from) };
    let exactly = |part: T| {
        if part == T::ZERO {
            return Ok((part, first, from.clone()));
        } else if part == T::of(1.0) {
            return Ok((part, event(to), to.clone()));
        }
        let trial = K::trial(mechanism, from, part * whole)?;
        land(mechanism, (from, None), &trial, part * whole, tolerance, &mut Reached::empty()).map(|state| (part, event(&state), state))
    };
    let mut looks = Looks::new(|number, part| match number {
        0 => first,
        LOOKS => event(to),
        _ => look(part),
    });
    if let Some((part, _)) = looks.all().iter().find(|look| !look.1.is_finite()) {
        return Err(Stopped::NotFinite { time: from.t + *part * whole });
    }
    looks.at_turns(look, |part| exactly(part).map(|found| found.1))?;
    looks.soon(look);
    let looks = looks.all();
    let Some(mut low) = looks.first().copied() else { return Ok(None) };
    for (number, high) in looks.iter().enumerate().skip(1) {
        if !changes(low.1, high.1) {
            low = *high;
            continue;
        }
        let beyond = exactly(high.0)?;
        let mut before = exactly(low.0)?;
        let mut is_first = !changes(low.1, before.1);
        if is_first && !changes(before.1, beyond.1) {
            low = (beyond.0, beyond.1);
            continue;
        }
        let mut after = beyond;
        // By exact states the event passed zero earlier than interpolated ones show.
        for earlier in looks.iter().take(number.saturating_sub(1)).rev() {
            if is_first {
                break;
            }
            (after, before) = (before, exactly(earlier.0)?);
            is_first = changes(before.1, after.1);
        }
        if changes(before.1, after.1) {
            let found = locate::<K, T, S, N, I, M, R>(mechanism, from, (before, after), (whole, &exactly), event, tolerance)?;
            return Ok(Some(found));
        }
        low = *high;
    }
    Ok(None)
}

/// The state at which an event has the value zero, between two at which it has different signs.
///
/// * `whole`, `exactly`: given, the size of the step, and the state at a part of it.
/// * `tolerance`: given, that of steps, as for [`land`].
#[allow(clippy::type_complexity)] // Parts, values and states.
fn locate<K: Method, T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    from: &State<T, N>,
    (before, after): (Instant<T, N>, Instant<T, N>),
    (whole, exactly): (T, &impl Fn(T) -> Result<Instant<T, N>, Stopped<T>>),
    event: &impl Fn(&State<T, N>) -> T,
    tolerance: (T, T),
) -> Result<State<T, N>, Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let (mut low, mut high) = ((before.0, before.1), (after.0, after.1));
    let (mut found, mut last, mut slow, mut width) = (after, T::ZERO, 0, high.0 - low.0);
    // Regula falsi with halved weights (Illinois), and halves where it is slow.
    for _ in 0..SEARCH {
        if high.1 == T::ZERO || ((high.0 - low.0) * whole).abs() <= T::EPSILON * (from.t.abs() + (high.0 * whole).abs()) {
            break;
        }
        let half = (low.0 + high.0) * T::of(0.5);
        let by_values = (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1);
        let is_within = by_values > low.0 && by_values < high.0 && slow < SLOW;
        let here = exactly(if is_within { by_values } else { half })?;
        let is_like_high = here.1 == T::ZERO || (here.1 > T::ZERO) == (high.1 > T::ZERO);
        if is_like_high {
            high = (here.0, here.1);
            found = here;
            low.1 = if last > T::ZERO { low.1 * T::of(0.5) } else { low.1 };
            last = T::of(1.0);
        } else {
            low = (here.0, here.1);
            high.1 = if last < T::ZERO { high.1 * T::of(0.5) } else { high.1 };
            last = T::of(-1.0);
        }
        slow += 1;
        if high.0 - low.0 <= width * T::of(0.5) {
            (slow, width) = (0, high.0 - low.0);
        }
    }
    // The search compares values: how the instant depends on parameters follows by Newton's method.
    let at = |h: T| {
        let trial = K::trial(mechanism, from, h)?;
        land(mechanism, (from, None), &trial, h, tolerance, &mut Reached::empty()).map(|state| (h, event(&state), state))
    };
    let mut found = (found.0 * whole, found.1, found.2);
    for _ in 0..DERIVATIVES {
        let (h, value, _) = found;
        let by_parameters = value - value.without_derivatives();
        if by_parameters == T::ZERO {
            break;
        }
        let later = at(h + T::ROOT_EPSILON * h)?;
        let slope = (later.1 - value).without_derivatives() / (T::ROOT_EPSILON * h).without_derivatives();
        found = at(h - by_parameters / slope)?;
    }
    Ok(found.2)
}
