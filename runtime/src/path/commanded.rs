//! From some inputs to others. In: a state, the inputs it was solved for, a time and other inputs. Out: the state there, on the same
//! branch.
//!
//! Where one warm step is not enough, the inputs are led along polynomials of fifth degree in time that have the given values, rates and
//! accelerations at both ends. If that leads astray, as rates do over a long time, they are led from rest to rest. Either is a motion by laws of
//! time, which is followed like any other: by steps short enough that the branch
//! is certain, and across change points. Inputs that jump at one time are led along in a time of their own, in which `t` stands still. It is
//! so short that laws of `t` would change nothing in it: their rates are among the rates on the way, and steps follow these.

use core::marker::PhantomData;

use nalgebra::SVector;

use super::cold::cold_state;
use super::continuation::{Ended, advance_by_steps};
use crate::names::{Cause, Coordinate, Description, ParameterOutOfRange, Row};
use crate::newton::StepError;
use crate::number::{Float, Real};
use crate::solve::{ColdSolver, Commanded, Followed, Solver, SolverReal, Stages};
use crate::state::{Coordinates, State, Values};

/// Times closer to each other than this many of their roundings are one.
const ONE_TIME: f64 = 1024.0;

/// A mechanism whose inputs follow from time.
pub(crate) struct Along<'a, T: Real, E: Commanded<T>> {
    mechanism: &'a E,
    from: E::Inputs,
    to: E::Inputs,
    /// When the way begins, and when it ends.
    times: [T; 2],
    /// The time that laws read, if it stands still.
    still: Option<T>,
    /// True if the inputs begin and end at rest, whatever their rates.
    rests: bool,
    over: PhantomData<T>,
}

impl<T: Real, E: Commanded<T>> Along<'_, T, E> {
    /// True if the time that laws read stands still.
    pub(crate) fn stands_still(&self) -> bool {
        self.still.is_some()
    }

    /// The mechanism at a time on the way, and the time that its laws read.
    fn at(&self, t: T) -> (E, T) {
        let [begin, end] = self.times;
        let whole = end - begin;
        let felt = if self.rests { T::of(0.0) } else { whole };
        let inputs = if t == end { self.to } else { E::between(&self.from, &self.to, [whole, felt], (t - begin) / whole) };
        (self.mechanism.with(inputs), self.still.unwrap_or(t))
    }
}

impl<T: Real, E: Commanded<T> + Description<T, N>, const N: usize> Description<T, N> for Along<'_, T, E> {
    const NAME: &'static str = E::NAME;
    const COORDINATES: &'static [Coordinate] = E::COORDINATES;
    const ROWS: &'static [Row] = E::ROWS;

    fn start(&self) -> SVector<T, N> {
        self.mechanism.start()
    }

    fn characteristic_length(&self) -> T {
        self.mechanism.characteristic_length()
    }

    fn validate(&self) -> Result<(), ParameterOutOfRange<T>> {
        self.mechanism.with(self.to).validate()
    }
}

impl<T: SolverReal, E: Commanded<T> + Stages<T, N>, const N: usize> Stages<T, N> for Along<'_, T, E> {
    const COMPUTED_ANGLES: &'static [usize] = E::COMPUTED_ANGLES;
    const LINKS: &'static [usize] = E::LINKS;
    const IS_REDUNDANT: bool = E::IS_REDUNDANT;
    const ITERATED: &'static [usize] = E::ITERATED;
    const UNIQUE: &'static [usize] = E::UNIQUE;
    const MAY_BE_NON_FINITE: Option<&'static [usize]> = E::MAY_BE_NON_FINITE;
    const IN_PLACE: bool = E::IN_PLACE;

    fn parameter_hash(&self) -> u64
    where
        T: Float,
    {
        self.mechanism.parameter_hash()
    }

    fn stages(&self, t: T, solver: &mut Solver<'_, T, N>) -> Result<Coordinates<T, N>, StepError<T>> {
        let (mechanism, t) = self.at(t);
        mechanism.stages(t, solver)
    }

    fn stages_in_place(&self, t: T, solver: &mut Solver<'_, T, N>, found: &mut Values<T, N>) -> Result<(), StepError<T>> {
        let (mechanism, t) = self.at(t);
        mechanism.stages_in_place(t, solver, found)
    }
}

/// Takes a state to time `t` (s) and other inputs by as many steps as it takes. A state that cannot be taken there stays as it is.
///
/// * `from`: given, the inputs for which the state was solved.
///
/// # Errors
/// The way that could not be followed, where and why.
#[cold]
#[inline(never)]
#[allow(clippy::type_complexity)] // Seen by one caller, which turns it into a failure.
pub(crate) fn lead<'a, T: Float, E: Commanded<T> + Stages<T, N>, const N: usize>(
    mechanism: &'a E,
    state: &mut State<T, N>,
    t: T,
    [from, to]: [E::Inputs; 2],
) -> Result<(), (Along<'a, T, E>, Ended<T, N>)> {
    let near = T::of(ONE_TIME) * T::EPSILON * state.t.abs().max(t.abs());
    if (t - state.t).abs() > near || !t.is_finite() {
        let times = [state.t, t];
        let way = |rests| Along { mechanism, from, to, times, still: None, rests, over: PhantomData };
        let Err(ended) = advance_by_steps(&way(false), state, t) else { return Ok(()) };
        // Over a long time rates lead far away from both ends.
        return advance_by_steps(&way(true), state, t).map_err(|_| (way(false), ended));
    }
    let brief = T::EPSILON;
    let way = Along { mechanism, from, to, times: [T::of(0.0), brief], still: Some(t), rests: false, over: PhantomData };
    let mut led = state.clone();
    led.values.t = T::of(0.0);
    if let Err(ended) = advance_by_steps(&way, &mut led, brief) {
        return Err((way, ended));
    }
    let there = &mechanism.with(to);
    let there = Followed::new(&there);
    match cold_state(&there, t, ColdSolver::from_prediction(&there, &led, T::of(0.0))) {
        Ok((found, None)) => {
            *state = found;
            Ok(())
        }
        Ok((_, Some(cause))) => Err((way, Ended::Refused(cause))),
        Err(error) => Err((way, Ended::Refused(Cause::from(error)))),
    }
}
