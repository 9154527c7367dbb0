//! The stages of a mechanism's solution, which emitted code implements.

use nalgebra::SVector;

use super::{Solver, SolverReal};
use crate::names::Description;
use crate::newton::StepError;
use crate::number::{Float, Scalar};
use crate::state::{Coordinates, State, Values};

/// The solution of a mechanism, stage by stage. Emitted code implements it block by block; hand-written mechanisms can call
/// [`at_once`](crate::at_once).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not solved for a time",
    note = "with freedoms, and where it is `#[integrated]`, write `initial_state`, and `advance` or `sweep` with an `Integrator`"
)]
pub trait Stages<T: SolverReal, const N: usize>: Description<T, N> {
    /// Angles that are computed rather than iterated. Iterated angles never change much in one step; computed angles are compared
    /// with their prediction after each step.
    const COMPUTED_ANGLES: &'static [usize] = &[];

    /// The first entries of the rotation matrices of binary links. The cross of such a link folds where the link lies along the arm in its
    /// neighbour, and beyond such a pose the link lies on its other side; each step tests that it does not.
    const LINKS: &'static [usize] = &[];

    /// Whether equations are [verified](Solver::check) instead of solved, because they follow from the others.
    const IS_REDUNDANT: bool = false;

    /// Unknowns that are iterated and therefore predicted.
    const ITERATED: &'static [usize] = &ALL;

    /// The first unknowns of blocks that are linear in their unknowns. They have at most one solution, and the sign of their determinant tells no
    /// branches apart.
    const UNIQUE: &'static [usize] = &[];

    /// Coordinates that must be tested for NaN and infinity even after a successful step; None for all.
    const MAY_BE_NON_FINITE: Option<&'static [usize]> = None;

    /// The mechanism with parameters interpolated between the declared defaults (λ = 0), for which [`start`](Description::start) is
    /// assembled, and these (λ = 1). With λ from 0 to −1 parameters that change their sign become infinite on the way instead of zero. None if
    /// there are no such parameters, or they are the defaults.
    fn interpolated(&self, lambda: T) -> Option<Self>
    where
        Self: Sized,
    {
        let _ = lambda;
        None
    }

    /// A rough guess of q (m, rad) at time `t` (s), refined if the mechanism has a method for it.
    #[doc(hidden)]
    fn refined_guess(&self, t: T, guess: &SVector<T, N>) -> SVector<T, N>
    where
        T: Float,
    {
        let _ = t;
        *guess
    }

    /// A hash of the parameters; 0 for mechanisms that keep nothing from the previous state and need none.
    #[doc(hidden)]
    fn parameter_hash(&self) -> u64
    where
        T: Float,
    {
        0
    }

    /// A warm step of the moving coordinates of a mechanism that is partly at rest; whether it succeeded. None if all coordinates
    /// may move.
    ///
    /// * `state`: given, the previous state; returned, the state at `t` if the step succeeded, else unchanged.
    #[doc(hidden)]
    #[inline]
    fn partial_step(&self, state: &mut State<T, N>, t: T) -> Option<bool>
    where
        T: Float,
    {
        let _ = (state, t);
        None
    }

    /// q, q̇ and q̈ at time `t` (s).
    ///
    /// # Errors
    /// Why a block was not solved.
    fn stages(&self, t: T, solver: &mut Solver<'_, T, N>) -> Result<Coordinates<T, N>, StepError<T>>;

    /// Whether there are so many coordinates that writing them in place is faster than copying.
    #[doc(hidden)]
    const IN_PLACE: bool = false;

    /// q, q̇ and q̈ at time `t` (s), written in place.
    ///
    /// * `found`: given, the previous state, or anything on a [cold start](Solver::is_cold_start); returned, q, q̇ and q̈.
    ///
    /// # Errors
    /// Why a block was not solved.
    #[doc(hidden)]
    #[inline(always)]
    fn stages_in_place(&self, t: T, solver: &mut Solver<'_, T, N>, found: &mut Values<T, N>) -> Result<(), StepError<T>> {
        found.put(self.stages(t, solver)?);
        Ok(())
    }
}

/// The first indices; those beyond the number of coordinates are skipped.
static ALL: [usize; MOST] = {
    let mut indices = [0; MOST];
    let mut index = 0;
    while index < MOST {
        indices[index] = index;
        index += 1;
    }
    indices
};

/// In a hand-written mechanism this many unknowns get an extrapolated prediction.
const MOST: usize = 256;

/// A hash of all bits of the parameters (Fowler, Noll and Vo, by words); never 0.
#[doc(hidden)]
pub fn parameter_hash<T: Scalar>(parameters: &[T]) -> u64 {
    parameter_hash_of(0, parameters)
}

/// The same together with a hash of the declaration.
#[doc(hidden)]
pub fn parameter_hash_of<T: Scalar>(declaration: u64, parameters: &[T]) -> u64 {
    let hash = parameters.iter().fold(0xcbf2_9ce4_8422_2325_u64 ^ declaration, |hash, parameter| {
        let mixed = (hash ^ parameter.bits()).wrapping_mul(0x0000_0100_0000_01b3);
        mixed ^ (mixed >> 29)
    });
    hash | 1
}
