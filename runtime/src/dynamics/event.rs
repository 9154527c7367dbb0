//! Instants at which an event changes its sign.

use super::equations::Dynamics;
use super::method::Method;
use super::places::{picked, put};
use super::step::land;
use super::stopped::Stopped;
use crate::number::Scalar;
use crate::state::State;

/// Most steps of the search for an instant.
const SEARCH: usize = 60;

/// Corrections of the derivatives of an instant; each leaves a part √ε of their error.
const DERIVATIVES: usize = 2;

/// How often an event is looked at in a step.
const LOOKS: usize = 8;

/// The first state between two others at which an event changes its sign; none if it does not.
pub(super) fn first_event<K: Method, T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    from: &State<T, N>,
    to: &State<T, N>,
    event: &impl Fn(&State<T, N>) -> T,
) -> Result<Option<State<T, N>>, Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let whole = to.t - from.t;
    let is_other = |one: T, two: T| one < T::ZERO && two >= T::ZERO || one > T::ZERO && two <= T::ZERO;
    let (mut low, mut part) = ((T::ZERO, event(from)), T::ZERO);
    for look in 1..=LOOKS {
        part = part + T::of(1.0 / LOOKS as f64);
        let value = if look == LOOKS { event(to) } else { event(&between(mechanism, from, to, part)) };
        if !(low.1.is_finite() && value.is_finite()) {
            return Err(Stopped::NotFinite { time: from.t + part * whole });
        }
        let high = (part * whole, value);
        if is_other(low.1, high.1) {
            let found = locate::<K, T, S, N, I, M, R>(mechanism, from, (low, high), event)?;
            if found.is_some() {
                return Ok(found);
            }
        }
        low = high;
    }
    Ok(None)
}

/// A state on the way between two others, by the polynomials of degree five through their positions, speeds and accelerations.
fn between<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    from: &State<T, N>,
    to: &State<T, N>,
    part: T,
) -> State<T, N>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let h = to.t - from.t;
    let [from_q, from_u, from_a] = [&from.q, &from.qd, &from.qdd].map(|vector| picked(vector, &S::INTEGRATED));
    let [to_q, to_u, to_a] = [&to.q, &to.qd, &to.qdd].map(|vector| picked(vector, &S::INTEGRATED));
    let mut values = [[T::ZERO; I]; 3];
    let [q, u, a] = &mut values;
    for k in 0..I {
        // Σ c_i s^i, s from 0 to 1
        let (v0, v1) = (h * from_u[k], h * to_u[k]);
        let (a0, a1) = (h * h * from_a[k], h * h * to_a[k]);
        let d = to_q[k] - from_q[k] - v0 - T::of(0.5) * a0;
        let (e, f) = (v1 - v0 - a0, a1 - a0);
        let c3 = T::of(10.0) * d - T::of(4.0) * e + T::of(0.5) * f;
        let c4 = T::of(-15.0) * d + T::of(7.0) * e - f;
        let c5 = T::of(6.0) * d - T::of(3.0) * e + T::of(0.5) * f;
        let s = part;
        q[k] = from_q[k] + s * (v0 + s * (T::of(0.5) * a0 + s * (c3 + s * (c4 + s * c5))));
        u[k] = (v0 + s * (a0 + s * (T::of(3.0) * c3 + s * (T::of(4.0) * c4 + s * T::of(5.0) * c5)))) / h;
        a[k] = (a0 + s * (T::of(6.0) * c3 + s * (T::of(12.0) * c4 + s * T::of(20.0) * c5))) / (h * h);
    }
    let mut vectors = [from.q, from.qd, from.qdd];
    for (vector, values) in vectors.iter_mut().zip(&values) {
        put(vector, &S::INTEGRATED, values);
    }
    let t = from.t + part * h;
    let [q, qd, qdd] = mechanism.complete(&vectors[0], &vectors[1], &vectors[2], t);
    State::new(t, q, qd, qdd)
}

/// The state at which an event has the value zero, by steps from the same state; none if its values there do not differ in sign.
fn locate<K: Method, T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    from: &State<T, N>,
    (low, high): ((T, T), (T, T)),
    event: &impl Fn(&State<T, N>) -> T,
) -> Result<Option<State<T, N>>, Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let at = |h: T| {
        let trial = K::trial(mechanism, from, h)?;
        land(mechanism, from, &trial, h, None).map(|(state, _)| (h, event(&state), state))
    };
    let mut found = at(high.0)?;
    let mut high = (high.0, found.1);
    let mut low = if low.0 == T::ZERO { low } else { at(low.0).map(|(h, value, _)| (h, value))? };
    if low.1 < T::ZERO && high.1 < T::ZERO || low.1 > T::ZERO && high.1 > T::ZERO {
        return Ok(None);
    }
    // Regula falsi with halved weights (Illinois).
    let mut last = T::ZERO;
    for _ in 0..SEARCH {
        if high.1 == T::ZERO || (high.0 - low.0).abs() <= T::EPSILON * (from.t.abs() + high.0.abs()) {
            break;
        }
        let here = at((low.0 * high.1 - high.0 * low.1) / (high.1 - low.1))?;
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
    }
    // The search compares values: how the instant depends on parameters follows by Newton's method.
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
    Ok(Some(found.2))
}
