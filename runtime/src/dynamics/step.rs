//! The end of a step: where it leads, and how far it is off.

use nalgebra::SMatrix;

use super::accelerate::{lengths, singular};
use super::checks::holds;
use super::equations::Dynamics;
use super::explicit::Explicit;
use super::method::{Method, Trial};
use super::partition::Pivots;
use super::places::{is_finite, largest, picked};
use super::project::{project, refresh};
use super::rank::keeps_rank;
use super::stopped::Stopped;
use crate::number::Scalar;
use crate::state::State;

/// One step of fixed size, without an estimate of its error.
pub fn fixed_step<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &mut State<T, N>,
    h: T,
) -> Result<(), Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    // Parameters may have changed since the accelerations were computed.
    let mut start = state.clone();
    refresh(mechanism, &mut start)?;
    let trial = Explicit::trial(mechanism, &start, h)?;
    let (next, reached) = land(mechanism, &start, &trial, h, None)?;
    keeps_rank::<Explicit, T, S, N, I, M, R>(mechanism, (&start, None), (&next, &reached))?;
    *state = next;
    Ok(())
}

/// The state after a step, brought back to where the equations hold.
///
/// * `before`: given, J before the step.
pub(super) fn land<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &State<T, N>,
    trial: &Trial<T, N, I>,
    h: T,
    before: Option<&Reached<T, M, I>>,
) -> Result<(State<T, N>, Reached<T, M, I>), Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let ([mut q, mut qd], t) = (trial.end, state.t + h);
    if !(is_finite(&q) && is_finite(&qd)) {
        return Err(Stopped::NotFinite { time: t });
    }
    let known = before.map(|(_, pivots)| pivots);
    let reached = project(mechanism, known, (&mut q, &mut qd), t).map_err(|open| singular::<T, S, N, I, M, R>(t, open.row()))?;
    holds::<T, S, N, I, M, R>(mechanism, &q, t)?;
    let mut next = State::new(t, q, qd, state.qdd);
    refresh(mechanism, &mut next)?;
    Ok((next, reached))
}

/// J at the end of a step, with an order of its elimination.
pub(super) type Reached<T, const M: usize, const I: usize> = (SMatrix<T, M, I>, Pivots<T, M, I>);

/// A speed counts as none if it takes a thousand steps for a radian, or for L.
const SLOW: f64 = 1e-3;

/// Errors of steps add up: each may have this fraction of the tolerance.
const EACH: f64 = 0.02;

/// Estimated error of a step, relative to the tolerance, and the largest speed so far.
pub(super) fn error<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &State<T, N>,
    trial: &Trial<T, N, I>,
    h: T,
    (tolerance, mut fastest): (T, T),
) -> (T, T)
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let lengths = lengths(mechanism);
    let [end, moving] = &trial.end;
    for vector in [&state.qd, moving] {
        fastest = fastest.max(largest(&picked(vector, &S::INTEGRATED), &lengths));
    }
    let [before, after] = [&state.q, end].map(|vector| picked(vector, &S::INTEGRATED));
    let (mut first, mut second, allowed) = (T::ZERO, T::ZERO, T::of(EACH) * tolerance);
    for k in 0..I {
        let value = (before[k] / lengths[k]).abs().max((after[k] / lengths[k]).abs()).max(T::of(1.0));
        for (errors, scale) in trial.errors.iter().zip([value, fastest.max(T::of(SLOW) / h.abs())]) {
            let [one, two] = errors[k].map(|error| error / (allowed * scale * lengths[k]));
            (first, second) = (first + one * one, second + two * two);
        }
    }
    if first == T::ZERO && second == T::ZERO {
        return (T::ZERO, fastest);
    }
    let count = T::of(2.0) * (0..I).fold(T::ZERO, |count, _| count + T::of(1.0));
    let bound = first + T::of(0.01) * second;
    (first / (bound * count).sqrt(), fastest)
}
