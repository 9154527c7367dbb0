//! A mechanism as seen by the functions that follow its branch.

use super::{ColdSolver, Solver, Stages};
use crate::names::{Coordinate, Description, ParameterOutOfRange, Row};
use crate::newton::{Scale, StepError};
use crate::number::Float;
use crate::state::Coordinates;

/// A mechanism whose branch is followed, with its equations behind a pointer: functions of it are compiled once for each number of
/// coordinates, and not once for each mechanism. None of them is called in a sweep whose steps succeed.
pub(crate) struct Followed<'a, T: Float, const N: usize> {
    pub(crate) name: &'static str,
    pub(crate) coordinates: &'static [Coordinate],
    pub(crate) rows: &'static [Row],
    pub(crate) iterated: &'static [usize],
    pub(crate) unique: &'static [usize],
    pub(crate) computed_angles: &'static [usize],
    pub(crate) links: &'static [usize],
    /// The characteristic length in m.
    pub(crate) length: T,
    pub(crate) parameter_hash: u64,
    equations: &'a dyn Solvable<T, N>,
}

/// The functions of a mechanism that a cold start calls.
trait Solvable<T: Float, const N: usize> {
    fn solve(&self, t: T, solver: &ColdSolver<'_, T, N>) -> Result<Coordinates<T, N>, StepError<T>>;

    fn validate(&self) -> Result<(), ParameterOutOfRange<T>>;
}

impl<T: Float, E: Stages<T, N> + ?Sized, const N: usize> Solvable<T, N> for &E {
    fn solve(&self, t: T, solver: &ColdSolver<'_, T, N>) -> Result<Coordinates<T, N>, StepError<T>> {
        self.stages(t, &mut Solver::cold(solver))
    }

    fn validate(&self) -> Result<(), ParameterOutOfRange<T>> {
        Description::validate(*self)
    }
}

impl<'a, T: Float, const N: usize> Followed<'a, T, N> {
    /// This mechanism.
    #[inline(never)]
    pub(crate) fn new<E: Stages<T, N> + ?Sized>(mechanism: &'a &'a E) -> Self {
        Self {
            name: E::NAME,
            coordinates: E::COORDINATES,
            rows: E::ROWS,
            iterated: E::ITERATED,
            unique: E::UNIQUE,
            computed_angles: E::COMPUTED_ANGLES,
            links: E::LINKS,
            length: mechanism.characteristic_length(),
            parameter_hash: mechanism.parameter_hash(),
            equations: mechanism,
        }
    }

    /// The size of each coordinate.
    pub(crate) fn scale(&self) -> Scale<T, N> {
        Scale::of(self.length, self.coordinates)
    }

    /// A cold start through all stages.
    ///
    /// # Errors
    /// Why a block was not solved.
    pub(crate) fn solve(&self, t: T, solver: &ColdSolver<'_, T, N>) -> Result<Coordinates<T, N>, StepError<T>> {
        self.equations.solve(t, solver)
    }

    /// Whether every parameter has a value for which the equations are defined.
    ///
    /// # Errors
    /// The first parameter that does not.
    pub(crate) fn validate(&self) -> Result<(), ParameterOutOfRange<T>> {
        self.equations.validate()
    }
}
