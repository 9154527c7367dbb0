//! One step: its stages, its end, and its error.
//!
//! ```text
//! trial     positions and speeds at the end, and estimates of their errors
//! land      the state there, brought back to where the equations hold
//! ```

use nalgebra::{SMatrix, SVector};

use super::accelerate::{accelerations, lengths, singular};
use super::equations::Dynamics;
use super::partition::Pivots;
use super::places::{largest, picked, put};
use super::project::{levels, project, refresh};
use super::rank::keeps_rank;
use super::stiff::{evaluations, stiff};
use super::stopped::Stopped;
use super::tableau::{STAGES, errors, node, stage, step};
use crate::number::Float;
use crate::state::State;

/// Rates of positions and of speeds, of each integrated coordinate in all stages.
pub(super) type Rates<T, const I: usize> = [[[T; STAGES]; I]; 2];

/// One step of fixed size, without an estimate of its error.
pub fn fixed_step<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &mut State<T, N>,
    h: T,
) -> Result<(), Stopped<T>>
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    // Parameters may have changed since the accelerations were computed.
    let mut start = state.clone();
    refresh(mechanism, &mut start)?;
    let trial = explicit(mechanism, &start, h)?;
    let (next, reached) = land(mechanism, &start, &trial, h)?;
    keeps_rank::<Explicit, T, S, N, I, M, R>(mechanism, &start, &next, &reached)?;
    *state = next;
    Ok(())
}

/// How a step is made.
pub trait Method: Copy {
    /// Times the square root is taken of an error for the change of the step size.
    #[doc(hidden)]
    const ROOTS: usize;

    /// True if steps know the rates in their stages.
    #[doc(hidden)]
    const IS_DENSE: bool;

    /// How often a step computes accelerations of so many coordinates.
    #[doc(hidden)]
    fn evaluations(coordinates: usize) -> usize;

    /// Tries a step.
    #[doc(hidden)]
    fn trial<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
        mechanism: &S,
        state: &State<T, N>,
        h: T,
    ) -> Result<Trial<T, N, I>, Stopped<T>>
    where
        T: Float,
        S: Dynamics<T, N, I, M, R>;
}

/// Steps by rates in stages that follow from each other: order 8.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Explicit;

/// Steps by linear equations with the derivatives of the accelerations: order 4, for stiff motions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stiff;

impl Method for Explicit {
    const ROOTS: usize = 3;
    const IS_DENSE: bool = true;

    fn evaluations(_: usize) -> usize {
        STAGES
    }

    fn trial<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
        mechanism: &S,
        state: &State<T, N>,
        h: T,
    ) -> Result<Trial<T, N, I>, Stopped<T>>
    where
        T: Float,
        S: Dynamics<T, N, I, M, R>,
    {
        explicit(mechanism, state, h)
    }
}

impl Method for Stiff {
    const ROOTS: usize = 2;
    const IS_DENSE: bool = false;

    fn evaluations(coordinates: usize) -> usize {
        evaluations(coordinates)
    }

    fn trial<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
        mechanism: &S,
        state: &State<T, N>,
        h: T,
    ) -> Result<Trial<T, N, I>, Stopped<T>>
    where
        T: Float,
        S: Dynamics<T, N, I, M, R>,
    {
        stiff(mechanism, state, h)
    }
}

/// A step before the equations are fulfilled.
pub struct Trial<T, const N: usize, const I: usize> {
    /// Positions and speeds at its end.
    pub(super) end: [SVector<T, N>; 2],
    /// Two estimates of the error of each, of which the second damps the first.
    pub(super) errors: [[[T; 2]; I]; 2],
    /// Rates in the stages, of an explicit step.
    pub(super) rates: Option<Rates<T, I>>,
}

/// A step of order 8.
fn explicit<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &State<T, N>,
    h: T,
) -> Result<Trial<T, N, I>, Stopped<T>>
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    let rates = stages(mechanism, state, h)?;
    let mut end = [state.q, state.qd];
    for (vector, rates) in end.iter_mut().zip(&rates) {
        let before = picked(vector, &S::INTEGRATED);
        put(vector, &S::INTEGRATED, &core::array::from_fn(|k| before[k] + h * step(&rates[k])));
    }
    let errors = core::array::from_fn(|part| core::array::from_fn(|k| errors(&rates[part][k]).map(|error| h * error)));
    Ok(Trial { end, errors, rates: Some(rates) })
}

/// Rates in each stage of a step.
fn stages<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &State<T, N>,
    h: T,
) -> Result<Rates<T, I>, Stopped<T>>
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    let [q, u, a] = [&state.q, &state.qd, &state.qdd].map(|vector| picked(vector, &S::INTEGRATED));
    let mut rates = [[[T::ZERO; STAGES]; I]; 2];
    let enter = |rates: &mut Rates<T, I>, stage: usize, found: [&[T; I]; 2]| {
        for (of, found) in rates.iter_mut().zip(found) {
            for (of, found) in of.iter_mut().zip(found) {
                if let Some(rate) = of.get_mut(stage) {
                    *rate = *found;
                }
            }
        }
    };
    enter(&mut rates, 0, [&u, &a]);
    let (mut there, mut moving, mut pivots) = (state.q, state.qd, None);
    for number in 1..STAGES {
        let at: [T; I] = core::array::from_fn(|k| q[k] + h * stage(number, &rates[0][k]));
        let speeds: [T; I] = core::array::from_fn(|k| u[k] + h * stage(number, &rates[1][k]));
        put(&mut there, &S::INTEGRATED, &at);
        put(&mut moving, &S::INTEGRATED, &speeds);
        let found = accelerations(mechanism, (&there, &moving), state.t + node::<T>(number) * h, &mut pivots)?;
        enter(&mut rates, number, [&speeds, &found]);
    }
    Ok(rates)
}

/// The state after a step, brought back to where the equations hold.
pub(super) fn land<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &State<T, N>,
    trial: &Trial<T, N, I>,
    h: T,
) -> Result<(State<T, N>, Reached<T, M, I>), Stopped<T>>
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    let ([mut q, mut qd], t) = (trial.end, state.t + h);
    let is_finite = |vector: &SVector<T, N>| vector.iter().all(|value| value.is_finite());
    if !(is_finite(&q) && is_finite(&qd)) {
        return Err(Stopped::NotFinite { time: t });
    }
    let reached = project(mechanism, (&mut q, &mut qd), |q| mechanism.constraints(q, t), levels::<T, S, N, I, M, R>)
        .map_err(|open| singular::<T, S, N, I, M, R>(t, open.row()))?;
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
    T: Float,
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
