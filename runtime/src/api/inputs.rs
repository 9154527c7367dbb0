//! States of mechanisms with inputs, for generated code.

use crate::explain::{Failure, verdict};
use crate::names::{Cause, ParameterOutOfRange};
use crate::number::Float;
use crate::path::{self, Unassembled};
use crate::solve::{Commanded, Followed, Stages};
use crate::state::State;

/// The state at `t` (s) with these inputs: assembled at t = 0 with those of the start, and followed from there.
///
/// # Errors
/// Any [`Cause`].
#[doc(hidden)]
pub fn solve_with_inputs<T: Float, E: Commanded<T> + Stages<T, N>, const N: usize>(
    mechanism: &E,
    t: T,
    inputs: E::Inputs,
) -> Result<State<T, N>, Failure<T, N>> {
    mechanism.with(inputs).validate().map_err(|parameter| refused::<T, E, N>(parameter, t, None))?;
    let first = mechanism.at_start();
    let mut state = path::assemble(&first).map_err(|Unassembled { cause, end, last }| {
        let time = T::of(0.0);
        Failure { mechanism: E::NAME, cause, time, end, last }
    })?;
    let mut before = first.inputs();
    advance_with_inputs(mechanism, &mut state, &mut before, t, inputs)?;
    Ok(state)
}

/// Takes a state to time `t` (s) and these inputs in place. A state that cannot be taken there stays as it is, and so do its inputs.
///
/// * `before`: given, the inputs of the state; returned, those of the new one.
///
/// # Errors
/// Any [`Cause`].
#[doc(hidden)]
#[inline]
pub fn advance_with_inputs<T: Float, E: Commanded<T> + Stages<T, N>, const N: usize>(
    mechanism: &E,
    state: &mut State<T, N>,
    before: &mut E::Inputs,
    t: T,
    inputs: E::Inputs,
) -> Result<(), Failure<T, N>> {
    // One step is the usual case.
    if !path::step(&mechanism.with(inputs), state, t) {
        by_steps(mechanism, state, [*before, inputs], t)?;
    }
    *before = inputs;
    Ok(())
}

/// Takes a state to time `t` (s) and these inputs by one warm step: whether that was enough. If not, nothing is changed.
#[doc(hidden)]
#[inline]
pub fn advance_once_with_inputs<T: Float, E: Commanded<T> + Stages<T, N>, const N: usize>(
    mechanism: &E,
    state: &mut State<T, N>,
    before: &mut E::Inputs,
    t: T,
    inputs: E::Inputs,
) -> bool {
    let is_made = path::step(&mechanism.with(inputs), state, t);
    if is_made {
        *before = inputs;
    }
    is_made
}

#[cold]
#[inline(never)]
fn by_steps<T: Float, E: Commanded<T> + Stages<T, N>, const N: usize>(
    mechanism: &E,
    state: &mut State<T, N>,
    [from, to]: [E::Inputs; 2],
    t: T,
) -> Result<(), Failure<T, N>> {
    mechanism.with(to).validate().map_err(|parameter| refused::<T, E, N>(parameter, t, Some(state.clone())))?;
    let (time, first) = (state.t, state.clone());
    path::lead(mechanism, state, t, [from, to]).map_err(|(way, ended)| {
        let mut failure = verdict::of_continuation(&Followed::new(&&way), &first, t, ended);
        if way.stands_still() {
            failure.time = t;
            if let Some(last) = &mut failure.last {
                last.values.t = time;
            }
        }
        failure
    })
}

fn refused<T: Float, E: Stages<T, N>, const N: usize>(
    parameter: ParameterOutOfRange<T>,
    time: T,
    last: Option<State<T, N>>,
) -> Failure<T, N> {
    Failure { mechanism: E::NAME, cause: Cause::ParameterOutOfRange(parameter), time, end: None, last }
}

/// The states at these times (s) with these inputs, each followed from the one before; ends after a failure.
#[doc(hidden)]
pub fn sweep_with_inputs<E, T, const N: usize>(
    mechanism: E,
    times: impl IntoIterator<Item = (T, E::Inputs)>,
) -> impl Iterator<Item = Result<(State<T, N>, E::Inputs), Failure<T, N>>>
where
    E: Commanded<T> + Stages<T, N>,
    T: Float,
{
    let (mut times, mut here, mut has_ended) = (times.into_iter(), None, false);
    core::iter::from_fn(move || {
        let (t, inputs) = times.next().filter(|_| !has_ended)?;
        let found = match here.take() {
            None => solve_with_inputs(&mechanism, t, inputs),
            Some((mut state, mut before)) => advance_with_inputs(&mechanism, &mut state, &mut before, t, inputs).map(|()| state),
        };
        has_ended = found.is_err();
        here = found.as_ref().ok().map(|state| (state.clone(), inputs));
        Some(found.map(|state| (state, inputs)))
    })
}
