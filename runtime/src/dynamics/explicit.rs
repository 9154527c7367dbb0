//! Explicit Runge-Kutta steps, of order 8.

use super::accelerate::accelerations;
use super::equations::Dynamics;
use super::method::{Method, Trial};
use super::places::{moved, picked, put};
use super::stopped::Stopped;
use super::tableau::{Rates, STAGES, errors, node, stage, step};
use crate::number::Scalar;
use crate::state::State;

/// Explicit Runge-Kutta steps, of order 8.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Explicit;

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
        T: Scalar,
        S: Dynamics<T, N, I, M, R>,
    {
        let rates = stages(mechanism, state, h)?;
        let mut end = [state.q, state.qd];
        for (vector, steps) in end.iter_mut().zip(step(&rates)) {
            let before = picked(vector, &S::INTEGRATED);
            put(vector, &S::INTEGRATED, &moved(&before, h, &steps));
        }
        Ok(Trial { end, errors: errors(&rates, h), rates: Some(rates) })
    }
}

/// Rates in each stage of a step.
fn stages<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &State<T, N>,
    h: T,
) -> Result<Rates<T, I>, Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let (q, u) = (picked(&state.q, &S::INTEGRATED), picked(&state.qd, &S::INTEGRATED));
    let mut rates = [[[T::ZERO; I]; 2]; STAGES];
    rates[0] = [u, picked(&state.qdd, &S::INTEGRATED)];
    let (mut there, mut moving, mut pivots) = (state.q, state.qd, None);
    for number in 1..STAGES {
        let [of_positions, of_speeds] = stage(number, &rates);
        let speeds = moved(&u, h, &of_speeds);
        put(&mut there, &S::INTEGRATED, &moved(&q, h, &of_positions));
        put(&mut moving, &S::INTEGRATED, &speeds);
        let found = accelerations(mechanism, (&there, &moving), state.t + node::<T>(number) * h, &mut pivots)?;
        if let Some(rates) = rates.get_mut(number) {
            *rates = [speeds, found];
        }
    }
    Ok(rates)
}
