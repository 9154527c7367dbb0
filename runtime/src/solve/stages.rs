//! How a mechanism is solved: stage by stage, or all at once.

use nalgebra::SVector;

use super::{Solver, SolverReal};
use crate::names::Description;
use crate::newton::StepError;
use crate::number::Float;
use crate::state::{Coordinates, State};

/// The way a mechanism is solved: block by block in emitted code. What is written by hand can have [`at_once`].
pub trait Stages<T: SolverReal, const N: usize>: Description<T, N> {
    /// The angles that are computed rather than iterated. Those that are iterated never go far in one step; of these it is checked
    /// that they came to where they were expected.
    const COMPUTED_ANGLES: &'static [usize] = &[];

    /// The unknowns that are iterated, of which a prediction is needed.
    const ITERATED: &'static [usize] = &ALL;

    /// The unknowns that may be found to be no finite numbers, or to have no finite rates, if the pass says that all went well; None if
    /// any may.
    const MAY_BE_NON_FINITE: Option<&'static [usize]> = None;

    /// The mechanism with parameters that are this share of the way from their declared defaults, for which
    /// [`start`](Description::start) is assembled, to these. None if they are the defaults, or have none.
    fn interpolated(&self, lambda: T) -> Option<Self>
    where
        Self: Sized,
    {
        let _ = lambda;
        None
    }

    /// A rough guess of q (m, rad) at time `t` (s), made better if there is a way.
    fn refined_guess(&self, t: T, guess: &SVector<T, N>) -> SVector<T, N>
    where
        T: Float,
    {
        let _ = t;
        *guess
    }

    /// Tells sets of parameters apart; 0 where nothing is left as it was in the state before, so that it does not matter.
    #[doc(hidden)]
    fn parameter_hash(&self) -> u64
    where
        T: Float,
    {
        0
    }

    /// A warm step of those coordinates that move, where the others rest; whether it was made. None if all may move.
    ///
    /// * `state`: given, the state to start from; returned, the state at `t` if the step was made, else as it was.
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
    /// Why there are none near what the pass sets out from.
    fn stages(&self, t: T, solver: &mut Solver<'_, T, N>) -> Result<Coordinates<T, N>, StepError<T>>;

    /// There are so many coordinates that they are better written in place than copied.
    #[doc(hidden)]
    const IN_PLACE: bool = false;

    /// The same in place.
    ///
    /// * `found`: given, anything if the pass [starts anew](Solver::is_cold_start), else the state it sets out from; returned, q, q̇ and q̈.
    ///
    /// # Errors
    /// Why there are none near what the pass sets out from.
    #[doc(hidden)]
    #[inline(always)]
    fn stages_in_place(&self, t: T, solver: &mut Solver<'_, T, N>, found: &mut Coordinates<T, N>) -> Result<(), StepError<T>> {
        *found = self.stages(t, solver)?;
        Ok(())
    }
}

/// The first indices there are; those beyond the number of coordinates are passed over.
static ALL: [usize; MOST] = {
    let mut indices = [0; MOST];
    let mut index = 0;
    while index < MOST {
        indices[index] = index;
        index += 1;
    }
    indices
};

/// Of a mechanism written by hand, as many unknowns as this get a better prediction.
const MOST: usize = 256;

/// Tells sets of parameters apart by all of their bits (the hash of Fowler, Noll and Vo, by words); not 0.
#[doc(hidden)]
pub fn parameter_hash<T: Float>(parameters: &[T]) -> u64 {
    let hash = parameters.iter().fold(0xcbf2_9ce4_8422_2325_u64, |hash, parameter| {
        let mixed = (hash ^ parameter.bits()).wrapping_mul(0x0000_0100_0000_01b3);
        mixed ^ (mixed >> 29)
    });
    hash | 1
}
