//! Instants at which an event changes its sign.

use nalgebra::SVector;

use super::equations::Dynamics;
use super::looks::{LOOKS, Looks, changes};
use super::method::Method;
use super::project::{Reached, complete, refresh};
use super::quintic::between;
use super::step::{first_step, land};
use super::stopped::Stopped;
use super::switch::accelerations_jump;
use crate::number::Scalar;
use crate::state::State;

/// Most steps of the search for an instant.
const SEARCH: usize = 200;

/// The search halves its interval if so many steps have not done so.
const SLOW: usize = 3;

/// Part of a step, the value of the event there, and the state.
type Instant<T, const N: usize> = (T, T, State<T, N>);

/// In a first step a state changes by a hundredth.
const CHANGE_IN_FIRST_STEPS: f64 = 100.0;

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
            let found = locate::<T, S, N, I, M, R>(mechanism, from, (before, after), (whole, &exactly), event)?;
            return Ok(Some(found));
        }
        low = *high;
    }
    Ok(None)
}

/// Whether an event is zero before it is zero.
enum Zeros {
    /// It was not zero yet.
    Unknown,
    /// It is zero at one instant.
    Single,
    /// It stays zero.
    Many,
}

/// The state at which an event has the value zero, between two at which it has different signs.
///
/// * `whole`, `exactly`: given, the size of the step, and the state at a part of it.
#[allow(clippy::type_complexity)] // Parts, values and states.
fn locate<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    from: &State<T, N>,
    (before, after): (Instant<T, N>, Instant<T, N>),
    (whole, exactly): (T, &impl Fn(T) -> Result<Instant<T, N>, Stopped<T>>),
    event: &impl Fn(&State<T, N>) -> T,
) -> Result<State<T, N>, Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let bare = |instant: &Instant<T, N>| (instant.0.without_derivatives(), instant.1.without_derivatives());
    let (mut low, mut high) = (bare(&before), bare(&after));
    let (end, mut zeros) = (after.2.qdd, Zeros::Unknown);
    let (mut found, mut last, mut slow, mut width) = (after, T::ZERO, 0, high.0 - low.0);
    let instant = |part: T| (T::EPSILON * (from.t.abs() + (part * whole).abs()) / whole.abs()).without_derivatives();
    // Regula falsi with halved weights (Illinois), and halves where it is slow.
    for _ in 0..SEARCH {
        let width_of_instant = instant(high.0);
        if high.0 - low.0 <= width_of_instant || matches!(zeros, Zeros::Single) {
            break;
        }
        if high.1 == T::ZERO && matches!(zeros, Zeros::Unknown) {
            // What is zero just before as well became so earlier.
            let before = exactly((high.0 - width_of_instant).max(low.0))?;
            zeros = if changes(low.1, before.1.without_derivatives()) { Zeros::Many } else { Zeros::Single };
            continue;
        }
        let half = (low.0 + high.0) * T::of(0.5);
        let by_values = (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1);
        // An event that stays zero tells nothing about the place where it became so.
        let is_within = by_values > low.0 && by_values < high.0 && slow < SLOW && high.1 != T::ZERO;
        let here = exactly(if is_within { by_values } else { half })?;
        if !changes(low.1, here.1.without_derivatives()) {
            low = bare(&here);
            high.1 = if last < T::ZERO { high.1 * T::of(0.5) } else { high.1 };
            last = T::of(-1.0);
        } else {
            high = bare(&here);
            found = here;
            low.1 = if last > T::ZERO { low.1 * T::of(0.5) } else { low.1 };
            last = T::of(1.0);
        }
        slow += 1;
        if high.0 - low.0 <= width * T::of(0.5) {
            (slow, width) = (0, high.0 - low.0);
        }
    }
    if T::HAS_DERIVATIVES {
        let earlier = exactly((high.0 - instant(high.0)).max(low.0))?.2;
        let before = accelerations_jump(mechanism, [&earlier.qdd, &found.2.qdd], [&from.qdd, &end]).then_some(earlier.qdd);
        return with_derivatives(mechanism, found.2, before, event);
    }
    Ok(found.2)
}

/// The state at an event with the derivatives of its instant: the search compares values.
///
/// * `before`: given, the accelerations before the event, where they jump there.
#[inline(never)]
fn with_derivatives<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    mut found: State<T, N>,
    before: Option<SVector<T, N>>,
    event: &impl Fn(&State<T, N>) -> T,
) -> Result<State<T, N>, Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    found.values.qdd = before.unwrap_or(found.qdd);
    let moved = |state: &State<T, N>, later: T| {
        let mut moved = state.clone();
        moved.values.t = moved.t + later;
        for place in 0..N {
            let (Some(speed), Some(acceleration)) = (state.qd.get(place), state.qdd.get(place)) else { continue };
            if let (Some(to), Some(rate)) = (moved.values.q.get_mut(place), moved.values.qd.get_mut(place)) {
                (*to, *rate) = (*to + later * *speed, *rate + later * *acceleration);
            }
        }
        match before {
            Some(accelerations) => complete(mechanism, &mut moved, &accelerations)?,
            None => refresh(mechanism, &mut moved)?,
        }
        Ok::<_, Stopped<T>>(moved)
    };
    let ahead = (T::of(CHANGE_IN_FIRST_STEPS) * T::ROOT_EPSILON * first_step(mechanism, &found)).without_derivatives();
    for _ in 0..DERIVATIVES {
        let derivatives = |value: T| value - value.without_derivatives();
        let [later, here, earlier, earliest] = [ahead, T::ZERO, T::ZERO - ahead, T::ZERO - ahead - ahead].map(|time| moved(&found, time));
        let [later, here, earlier, earliest] = [event(&later?), event(&here?), event(&earlier?), event(&earliest?)];
        // Where an event stays zero, only values before the instant depend on anything.
        let (by_parameters, change, time) = match derivatives(here) == T::ZERO && later.without_derivatives() == T::ZERO {
            false => (derivatives(here), later - earlier, ahead + ahead),
            true => (derivatives(earlier), earlier - earliest, ahead),
        };
        if by_parameters == T::ZERO {
            // Values that jump do not tell on what the instant depends.
            let jumps = here != earlier && earlier == earliest;
            return if jumps { Err(Stopped::StepTooShort { time: found.t }) } else { refresh(mechanism, &mut found).map(|()| found) };
        }
        let slope = change.without_derivatives() / time;
        found = moved(&found, T::ZERO - by_parameters / slope)?;
    }
    refresh(mechanism, &mut found)?;
    Ok(found)
}
