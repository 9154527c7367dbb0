//! A mechanism with all quantities precomputed that depend on its parameters only.
//!
//! In: [`Prepare`], which `mechanism!` implements. Out: [`Prepared`], which is solved like the mechanism itself. Not done here: selecting
//! the quantities that are worth keeping, which the compiler does.

use core::ops::Deref;

use nalgebra::SVector;

use super::{Mechanism, sweep};
use crate::explain::Failure;
use crate::names::{Coordinate, Description, ParameterOutOfRange, Row};
use crate::newton::StepError;
use crate::number::{Float, Times};
use crate::solve::{Solver, SolverReal, Stages};
use crate::state::{Coordinates, State, Values};

/// A mechanism that can be [`Prepared`]; `mechanism!` implements it.
///
/// `F` numbers depend on parameters only and are kept; `F` is 0 if recomputing them costs next to nothing.
pub trait Prepare<T: SolverReal, const N: usize, const F: usize>: Stages<T, N> + Copy {
    /// The state of the mechanism, with its bodies by name.
    type State: Deref<Target = State<T, N>>;

    /// A state with the names of the mechanism.
    #[doc(hidden)]
    fn named(state: State<T, N>) -> Self::State;

    /// The state without the names.
    #[doc(hidden)]
    fn unnamed(state: &mut Self::State) -> &mut State<T, N>;

    /// The quantities that depend on parameters only.
    #[doc(hidden)]
    fn fixed(&self) -> [T; F] {
        [T::of(0.0); F]
    }

    /// [`Stages::stages`], given the quantities that depend on parameters only.
    ///
    /// # Errors
    /// Why no state was found from the solver's start or prediction.
    #[doc(hidden)]
    #[inline(always)]
    fn stages_with(&self, fixed: &[T; F], t: T, solver: &mut Solver<'_, T, N>) -> Result<Coordinates<T, N>, StepError<T>> {
        let _ = fixed;
        self.stages(t, solver)
    }
}

/// A mechanism with all quantities precomputed that depend on its parameters only and are worth keeping, for loops with `advance`.
///
/// Every mechanism has a method `prepared` that creates it. It returns the same states as the mechanism, and derefs to it. The compiler
/// decides which quantities are kept; this changes no result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prepared<M, T, const N: usize, const F: usize> {
    mechanism: M,
    fixed: [T; F],
}

impl<M, T, const N: usize, const F: usize> Prepared<M, T, N, F>
where
    M: Prepare<T, N, F>,
    T: SolverReal,
{
    /// The mechanism with these parameters.
    #[must_use]
    pub fn new(mechanism: M) -> Self {
        Self { mechanism, fixed: mechanism.fixed() }
    }
}

impl<M, T, const N: usize, const F: usize> Prepared<M, T, N, F>
where
    M: Prepare<T, N, F>,
    T: Float,
{
    /// The state at time `t` (s): assembled at t = 0 from the declared start and followed from there, on the same branch.
    ///
    /// # Errors
    /// Why there is no such state, with the last valid one on the way.
    pub fn solve(&self, t: T) -> Result<M::State, Failure<T, N>> {
        Mechanism::<T, N>::solve(self, t).map(M::named)
    }

    /// The state at time `t` (s) that Newton's method finds from a guess of q.
    ///
    /// # Errors
    /// Why there is no such state.
    pub fn solve_near(&self, t: T, guess: &SVector<T, N>) -> Result<M::State, Failure<T, N>> {
        Mechanism::<T, N>::solve_near(self, t, guess).map(M::named)
    }

    /// The state at time `t` (s), followed from another state.
    ///
    /// # Errors
    /// Why there is no such state, with the last valid one on the way.
    pub fn solve_from(&self, t: T, from: &M::State) -> Result<M::State, Failure<T, N>> {
        Mechanism::<T, N>::solve_from(self, t, from).map(M::named)
    }

    /// Takes a state to time `t` (s) in place: [`solve_from`](Self::solve_from) without a copy. If that fails, the state is unchanged.
    ///
    /// # Errors
    /// Why there is no such state, with the last valid one on the way.
    #[inline]
    pub fn advance(&self, state: &mut M::State, t: T) -> Result<(), Failure<T, N>> {
        Mechanism::<T, N>::advance(self, M::unnamed(state), t)
    }

    /// The states at these times (s), each followed from the one before; ends after a failure.
    pub fn sweep<I: Times<T>>(&self, times: I) -> impl Iterator<Item = Result<M::State, Failure<T, N>>> + use<M, T, I, N, F> {
        sweep(*self, times).map(|result| result.map(M::named))
    }
}

impl<M, T, const N: usize, const F: usize> Deref for Prepared<M, T, N, F> {
    type Target = M;

    fn deref(&self) -> &M {
        &self.mechanism
    }
}

impl<M, T, const N: usize, const F: usize> Description<T, N> for Prepared<M, T, N, F>
where
    M: Prepare<T, N, F>,
    T: SolverReal,
{
    const NAME: &'static str = M::NAME;
    const COORDINATES: &'static [Coordinate] = M::COORDINATES;
    const ROWS: &'static [Row] = M::ROWS;

    fn start(&self) -> SVector<T, N> {
        self.mechanism.start()
    }

    fn characteristic_length(&self) -> T {
        self.mechanism.characteristic_length()
    }

    fn validate(&self) -> Result<(), ParameterOutOfRange<T>> {
        self.mechanism.validate()
    }
}

/// With nothing kept, every stage is that of the mechanism.
impl<M, T, const N: usize, const F: usize> Stages<T, N> for Prepared<M, T, N, F>
where
    M: Prepare<T, N, F>,
    T: SolverReal,
{
    const COMPUTED_ANGLES: &'static [usize] = M::COMPUTED_ANGLES;
    const LINKS: &'static [usize] = M::LINKS;
    const IS_REDUNDANT: bool = M::IS_REDUNDANT;
    const ITERATED: &'static [usize] = M::ITERATED;
    const UNIQUE: &'static [usize] = M::UNIQUE;
    const MAY_BE_NON_FINITE: Option<&'static [usize]> = M::MAY_BE_NON_FINITE;
    const IN_PLACE: bool = F == 0 && M::IN_PLACE;

    fn interpolated(&self, lambda: T) -> Option<Self> {
        self.mechanism.interpolated(lambda).map(Self::new)
    }

    fn refined_guess(&self, t: T, guess: &SVector<T, N>) -> SVector<T, N>
    where
        T: Float,
    {
        self.mechanism.refined_guess(t, guess)
    }

    fn parameter_hash(&self) -> u64
    where
        T: Float,
    {
        self.mechanism.parameter_hash()
    }

    #[inline]
    fn partial_step(&self, state: &mut State<T, N>, t: T) -> Option<bool>
    where
        T: Float,
    {
        self.mechanism.partial_step(state, t)
    }

    #[inline(always)]
    fn stages(&self, t: T, solver: &mut Solver<'_, T, N>) -> Result<Coordinates<T, N>, StepError<T>> {
        self.mechanism.stages_with(&self.fixed, t, solver)
    }

    #[inline(always)]
    fn stages_in_place(&self, t: T, solver: &mut Solver<'_, T, N>, found: &mut Values<T, N>) -> Result<(), StepError<T>> {
        if F == 0 {
            return self.mechanism.stages_in_place(t, solver, found);
        }
        found.put(self.stages(t, solver)?);
        Ok(())
    }
}
