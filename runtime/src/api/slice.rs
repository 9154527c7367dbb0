//! Slices: the part of a mechanism on which one output depends, solved alone.
//!
//! In: [`Sliced`], which `mechanism!` implements for a `slice output`. Out: [`Slice`], a mechanism of its own, and its [`SliceState`]s.
//! Not done here: selecting the unknowns upstream of the output, which the compiler does.

use core::marker::PhantomData;
use core::ops::{Deref, DerefMut};

use nalgebra::SVector;

use super::{Mechanism, Output, OutputName, sweep};
use crate::explain::Failure;
use crate::names::{Coordinate, Description, ParameterOutOfRange, Plan, Row};
use crate::newton::StepError;
use crate::number::{Float, Real, Times};
use crate::solve::{Family, Solver, SolverReal, Stages};
use crate::state::{Coordinates, State, Values};

/// A mechanism of `WHOLE` coordinates that can be solved for one of its outputs alone; `mechanism!` implements it for each
/// `slice output`.
///
/// `OUTPUT` numbers the slices of the mechanism. A state of the slice has `N` entries: the coordinates that are needed for the next step,
/// and the components of the output.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no slice of this kind",
    note = "an output is solved alone where it is declared as `slice output name = …;`"
)]
pub trait Sliced<T: SolverReal, const OUTPUT: usize, const N: usize, const WHOLE: usize>: Stages<T, WHOLE> + Copy {
    /// The output with its derivatives in time.
    type Value: Output<T>;

    /// Plan of the solution: computed coordinates, coordinates iterated together, and their order.
    const PLAN: Plan;

    /// Entries of a state by their indices in q; the components of the output have indices from `WHOLE` on.
    const HELD: [usize; N];

    /// Names and units of the components of the output.
    const OUTPUTS: &'static [OutputName];

    /// The entries of a state that hold the output.
    const COMPONENTS: &'static [Coordinate];

    /// [`Stages::COMPUTED_ANGLES`] of the slice.
    const COMPUTED_ANGLES: &'static [usize];

    /// [`Stages::IS_REDUNDANT`] of the slice.
    const IS_REDUNDANT: bool = false;

    /// [`Stages::ITERATED`] of the slice.
    const ITERATED: &'static [usize];

    /// [`Stages::UNIQUE`] of the slice.
    const UNIQUE: &'static [usize] = &[];

    /// [`Stages::MAY_BE_NON_FINITE`] of the slice.
    const MAY_BE_NON_FINITE: &'static [usize];

    /// [`Stages::IN_PLACE`] of the slice: `upstream_in_place` is implemented instead of `upstream`.
    const IN_PLACE: bool = false;

    /// The output in a state of the slice.
    fn output(state: &State<T, N>) -> Self::Value;

    /// [`Stages::stages`] of the slice.
    ///
    /// # Errors
    /// Why no state was found from the solver's start or prediction.
    #[inline(always)]
    fn upstream(&self, t: T, solver: &mut Solver<'_, T, N>) -> Result<Coordinates<T, N>, StepError<T>> {
        let mut found = Values::zero();
        self.upstream_in_place(t, solver, &mut found)?;
        Ok(found.coordinates())
    }

    /// [`Stages::stages_in_place`] of the slice.
    ///
    /// # Errors
    /// Why no state was found from the solver's start or prediction.
    #[inline(always)]
    fn upstream_in_place(&self, t: T, solver: &mut Solver<'_, T, N>, found: &mut Values<T, N>) -> Result<(), StepError<T>> {
        found.put(self.upstream(t, solver)?);
        Ok(())
    }
}

/// A mechanism reduced to one of its outputs: everything that is not upstream of the output is neither solved nor compiled.
///
/// A mechanism has a method `solve_for_…` for each `slice output`. It returns a slice, which is a [`Mechanism`] of its own:
///
/// ```
/// reuleaux::mechanism! {
///     /// A crank that pushes a slide, and a lamp on the crank pin.
///     mechanism Pump {
///         ground { axis bore = (1, 0); }
///         body crank  { point A = (50mm, 0mm); }
///         body rod    { point A = (0mm, 0mm);  point B = (200mm, 0mm); }
///         body piston { }
///         joint main = revolute(ground.position, crank.position);
///         joint big_end = revolute(crank.A, rod.A);
///         joint small_end = revolute(rod.B, piston.position);
///         joint guide = translational(ground.bore, ground.position, piston.position);
///         drive motor = drive_angle(crank, 90rpm * t);
///         slice output lamp = crank.A;
///     }
/// }
///
/// let pump = Pump::default();
/// let lamp = pump.solve_for_lamp();
/// let mut state = lamp.solve(0.0)?;
/// lamp.advance(&mut state, 0.1)?;
/// assert_eq!(state.output().value, pump.lamp(&pump.solve(0.1)?).value);
/// assert_eq!(PumpForLamp::<f64>::PLAN.blocks().count(), 0);       // nothing is iterated for it
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slice<M, T, const OUTPUT: usize, const N: usize, const WHOLE: usize> {
    /// The whole mechanism, with its parameters.
    pub mechanism: M,
    over: PhantomData<T>,
}

/// A state of a [`Slice`]: the output, and the coordinates that are needed for the next step.
#[derive(Clone, Debug, PartialEq)]
pub struct SliceState<M, T, const OUTPUT: usize, const N: usize, const WHOLE: usize> {
    /// Time, positions, velocities and accelerations, as for any mechanism.
    pub state: State<T, N>,
    of: PhantomData<M>,
}

impl<M, T, const OUTPUT: usize, const N: usize, const WHOLE: usize> Slice<M, T, OUTPUT, N, WHOLE> {
    /// The slice of a mechanism.
    #[must_use]
    pub const fn of(mechanism: M) -> Self {
        Self { mechanism, over: PhantomData }
    }
}

impl<M, T, const OUTPUT: usize, const N: usize, const WHOLE: usize> Slice<M, T, OUTPUT, N, WHOLE>
where
    M: Sliced<T, OUTPUT, N, WHOLE>,
    T: SolverReal,
{
    /// Plan of the solution: computed coordinates, coordinates iterated together, and their order.
    pub const PLAN: Plan = M::PLAN;
}

impl<M, T, const OUTPUT: usize, const N: usize, const WHOLE: usize> Slice<M, T, OUTPUT, N, WHOLE>
where
    M: Sliced<T, OUTPUT, N, WHOLE>,
    T: Float,
{
    /// The state at time `t` (s): assembled at t = 0 from the declared start and followed from there, on the same branch.
    ///
    /// # Errors
    /// Why there is no such state, with the last valid one on the way.
    pub fn solve(&self, t: T) -> Result<SliceState<M, T, OUTPUT, N, WHOLE>, Failure<T, N>> {
        Mechanism::<T, N>::solve(self, t).map(SliceState::from)
    }

    /// The state at time `t` (s), followed from another state.
    ///
    /// # Errors
    /// Why there is no such state, with the last valid one on the way.
    pub fn solve_from(&self, t: T, from: &SliceState<M, T, OUTPUT, N, WHOLE>) -> Result<SliceState<M, T, OUTPUT, N, WHOLE>, Failure<T, N>> {
        Mechanism::<T, N>::solve_from(self, t, &from.state).map(SliceState::from)
    }

    /// Takes a state to time `t` (s) in place: [`solve_from`](Self::solve_from) without a copy. If that fails, the state is unchanged.
    ///
    /// # Errors
    /// Why there is no such state, with the last valid one on the way.
    #[inline]
    pub fn advance(&self, state: &mut SliceState<M, T, OUTPUT, N, WHOLE>, t: T) -> Result<(), Failure<T, N>> {
        Mechanism::<T, N>::advance(self, &mut state.state, t)
    }

    /// The states at these times (s), each followed from the one before; ends after a failure.
    pub fn sweep<I: Times<T>>(
        &self,
        times: I,
    ) -> impl Iterator<Item = Result<SliceState<M, T, OUTPUT, N, WHOLE>, Failure<T, N>>> + use<M, T, I, OUTPUT, N, WHOLE> {
        sweep(*self, times).map(|result| result.map(SliceState::from))
    }
}

impl<M, T, const OUTPUT: usize, const N: usize, const WHOLE: usize> SliceState<M, T, OUTPUT, N, WHOLE>
where
    M: Sliced<T, OUTPUT, N, WHOLE>,
    T: SolverReal,
{
    /// The output with its first and second derivative in time.
    #[must_use]
    pub fn output(&self) -> M::Value {
        M::output(&self.state)
    }
}

/// A state that has the output with the number `OUTPUT` among the slices of the mechanism `M`: a state of the whole mechanism, or of the
/// slice. The method of the output takes both.
///
/// ```
/// use reuleaux::HasOutput;
///
/// reuleaux::mechanism! {
///     mechanism Crank {
///         body crank { point A = (50mm, 0mm); }
///         joint axle = revolute(ground.position, crank.position);
///         drive motor = drive_angle(crank, 90rpm * t);
///         slice output pin = crank.A;
///     }
/// }
///
/// let crank = Crank::default();
/// let (whole, alone) = (crank.solve(0.1)?, crank.solve_for_pin().solve(0.1)?);
/// assert_eq!(crank.pin(&whole).value, crank.pin(&alone).value);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no state with this output of `{M}`",
    note = "the output takes states of the whole mechanism and of the slice that solves for this output"
)]
pub trait HasOutput<M, const OUTPUT: usize> {
    /// The output with its derivatives in time.
    type Value;

    /// The output in this state of `mechanism`.
    fn output_of(&self, mechanism: &M) -> Self::Value;
}

impl<M, T, const OUTPUT: usize, const N: usize, const WHOLE: usize> HasOutput<M, OUTPUT> for SliceState<M, T, OUTPUT, N, WHOLE>
where
    M: Sliced<T, OUTPUT, N, WHOLE>,
    T: SolverReal,
{
    type Value = M::Value;

    fn output_of(&self, _: &M) -> M::Value {
        self.output()
    }
}

impl<M, S: HasOutput<M, OUTPUT>, const OUTPUT: usize> HasOutput<M, OUTPUT> for &S {
    type Value = S::Value;

    fn output_of(&self, mechanism: &M) -> S::Value {
        (**self).output_of(mechanism)
    }
}

impl<M, T, const OUTPUT: usize, const N: usize, const WHOLE: usize> From<State<T, N>> for SliceState<M, T, OUTPUT, N, WHOLE> {
    fn from(state: State<T, N>) -> Self {
        Self { state, of: PhantomData }
    }
}

impl<M, T, const OUTPUT: usize, const N: usize, const WHOLE: usize> Deref for SliceState<M, T, OUTPUT, N, WHOLE> {
    type Target = State<T, N>;

    fn deref(&self) -> &State<T, N> {
        &self.state
    }
}

impl<M, T, const OUTPUT: usize, const N: usize, const WHOLE: usize> DerefMut for SliceState<M, T, OUTPUT, N, WHOLE> {
    fn deref_mut(&mut self) -> &mut State<T, N> {
        &mut self.state
    }
}

impl<M: Family<T>, T, const OUTPUT: usize, const N: usize, const WHOLE: usize> Family<T> for Slice<M, T, OUTPUT, N, WHOLE> {
    type Over<U: Real> = Slice<M::Over<U>, U, OUTPUT, N, WHOLE>;
    const HAS_INPUTS: bool = M::HAS_INPUTS;

    fn gather<U: Real, const L: usize>(each: [&Self; L], combine: impl Fn([T; L]) -> U) -> Self::Over<U> {
        Slice::of(M::gather(each.map(|slice| &slice.mechanism), combine))
    }

    fn later(self, h: T) -> Self {
        Slice::of(self.mechanism.later(h))
    }
}

impl<M, T, const OUTPUT: usize, const N: usize, const WHOLE: usize> Slice<M, T, OUTPUT, N, WHOLE>
where
    M: Sliced<T, OUTPUT, N, WHOLE>,
    T: SolverReal,
{
    /// Entries of a state.
    const NAMES: [Coordinate; N] = held(<M as Description<T, WHOLE>>::COORDINATES, M::COMPONENTS, &M::HELD);
}

/// The coordinates with these indices; the components of the output follow the coordinates of the mechanism.
const fn held<const N: usize>(whole: &[Coordinate], components: &[Coordinate], held: &[usize; N]) -> [Coordinate; N] {
    let mut names = [Coordinate::length("?", "?"); N];
    let mut place = 0;
    while place < N {
        let index = held[place];
        if index < whole.len() {
            names[place] = whole[index];
        } else if index - whole.len() < components.len() {
            names[place] = components[index - whole.len()];
        }
        place += 1;
    }
    names
}

impl<M, T, const OUTPUT: usize, const N: usize, const WHOLE: usize> Description<T, N> for Slice<M, T, OUTPUT, N, WHOLE>
where
    M: Sliced<T, OUTPUT, N, WHOLE>,
    T: SolverReal,
{
    const NAME: &'static str = <M as Description<T, WHOLE>>::NAME;
    const COORDINATES: &'static [Coordinate] = &Self::NAMES;
    const ROWS: &'static [Row] = <M as Description<T, WHOLE>>::ROWS;

    fn start(&self) -> SVector<T, N> {
        let start = self.mechanism.start();
        SVector::from(M::HELD.map(|index| start.get(index).copied().unwrap_or(T::of(0.0))))
    }

    fn characteristic_length(&self) -> T {
        self.mechanism.characteristic_length()
    }

    fn validate(&self) -> Result<(), ParameterOutOfRange<T>> {
        self.mechanism.validate()
    }
}

impl<M, T, const OUTPUT: usize, const N: usize, const WHOLE: usize> Stages<T, N> for Slice<M, T, OUTPUT, N, WHOLE>
where
    M: Sliced<T, OUTPUT, N, WHOLE>,
    T: SolverReal,
{
    const COMPUTED_ANGLES: &'static [usize] = <M as Sliced<T, OUTPUT, N, WHOLE>>::COMPUTED_ANGLES;
    const IS_REDUNDANT: bool = <M as Sliced<T, OUTPUT, N, WHOLE>>::IS_REDUNDANT;
    const ITERATED: &'static [usize] = <M as Sliced<T, OUTPUT, N, WHOLE>>::ITERATED;
    const UNIQUE: &'static [usize] = <M as Sliced<T, OUTPUT, N, WHOLE>>::UNIQUE;
    const MAY_BE_NON_FINITE: Option<&'static [usize]> = Some(<M as Sliced<T, OUTPUT, N, WHOLE>>::MAY_BE_NON_FINITE);
    const IN_PLACE: bool = <M as Sliced<T, OUTPUT, N, WHOLE>>::IN_PLACE;

    fn interpolated(&self, lambda: T) -> Option<Self> {
        self.mechanism.interpolated(lambda).map(Self::of)
    }

    #[inline(always)]
    fn stages(&self, t: T, solver: &mut Solver<'_, T, N>) -> Result<Coordinates<T, N>, StepError<T>> {
        self.mechanism.upstream(t, solver)
    }

    #[inline(always)]
    fn stages_in_place(&self, t: T, solver: &mut Solver<'_, T, N>, found: &mut Values<T, N>) -> Result<(), StepError<T>> {
        self.mechanism.upstream_in_place(t, solver, found)
    }
}
