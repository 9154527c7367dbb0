//! How a mechanism is solved: stage by stage, or all at once.

use nalgebra::SVector;

use crate::continuation;
use crate::pass::{Pass, Stop};
use crate::place::Place;
use crate::position;
use crate::problem::{Block, Chosen, Problem, Whole};
use crate::scale::Scale;
use crate::{Description, Equations, Float, Lanes, Real, State, names};

/// Position, velocity and acceleration of all coordinates.
pub struct Coordinates<T, const N: usize> {
    /// q in m and rad.
    pub q: SVector<T, N>,
    /// q̇ in m/s and rad/s.
    pub qd: SVector<T, N>,
    /// q̈ in m/s² and rad/s².
    pub qdd: SVector<T, N>,
}

impl<T: Real, const N: usize> Coordinates<T, N> {
    /// All zero.
    #[must_use]
    pub fn zero() -> Self {
        let zero = SVector::from_element(T::of(0.0));
        Self { q: zero, qd: zero, qdd: zero }
    }

    /// Those of a state.
    #[inline(always)]
    pub(crate) fn of(state: &State<T, N>) -> Self {
        Self { q: state.q, qd: state.qd, qdd: state.qdd }
    }
}

/// The way a mechanism is solved: block by block in emitted code. What is written by hand can have [`at_once`].
pub trait Stages<T: Lanes, const N: usize>: Description<T, N> {
    /// The angles that are computed rather than iterated. Those that are iterated never go far in one step; of these it is checked
    /// that they came to where they were expected.
    const COMPUTED_ANGLES: &'static [usize] = &[];

    /// The unknowns that are iterated, of which a prediction is needed.
    const ITERATED: &'static [usize] = &ALL;

    /// The unknowns that may be found to be no finite numbers, or to have no finite rates, if the pass says that all went well; None if
    /// any may.
    const UNSURE: Option<&'static [usize]> = None;

    /// The mechanism with parameters that are this share of the way from their declared defaults, for which
    /// [`start`](Description::start) is assembled, to these. None if they are the defaults, or have none.
    fn toward(&self, share: T) -> Option<Self>
    where
        Self: Sized,
    {
        let _ = share;
        None
    }

    /// A rough guess of q (m, rad) at time `t` (s), made better if there is a way.
    fn improved(&self, t: T, guess: &SVector<T, N>) -> SVector<T, N>
    where
        T: Float,
    {
        let _ = t;
        *guess
    }

    /// Tells sets of parameters apart; 0 where nothing is left as it was in the state before, so that it does not matter.
    #[doc(hidden)]
    fn mark(&self) -> u64
    where
        T: Float,
    {
        0
    }

    /// One step straight on, in place; whether it was made. Emitted code has its own where a part of the mechanism rests.
    #[doc(hidden)]
    #[inline]
    fn step(&self, state: &mut State<T, N>, t: T) -> bool
    where
        T: Float,
    {
        continuation::step(self, state, t)
    }

    /// q, q̇ and q̈ at time `t` (s).
    ///
    /// # Errors
    /// Why there are none near what the pass sets out from.
    fn stages(&self, t: T, pass: &mut Pass<'_, T, N>) -> Result<Coordinates<T, N>, Stop<T>>;

    /// There are so many coordinates that they are better written in place than copied.
    #[doc(hidden)]
    const IN_PLACE: bool = false;

    /// The same in place.
    ///
    /// * `found`: given, anything if the pass [starts anew](Pass::starts_anew), else the state it sets out from; returned, q, q̇ and q̈.
    ///
    /// # Errors
    /// Why there are none near what the pass sets out from.
    #[doc(hidden)]
    #[inline(always)]
    fn stages_in_place(&self, t: T, pass: &mut Pass<'_, T, N>, found: &mut Coordinates<T, N>) -> Result<(), Stop<T>> {
        *found = self.stages(t, pass)?;
        Ok(())
    }
}

/// All equations of a mechanism as one system.
///
/// # Errors
/// Why there is no solution near what the pass sets out from.
pub fn at_once<T: Lanes, E: Equations<T, N, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    pass: &mut Pass<'_, T, N>,
) -> Result<Coordinates<T, N>, Stop<T>> {
    let all = core::array::from_fn(|index| index);
    let kinds = core::array::from_fn(|index| names::coordinate(E::COORDINATES, index).kind);
    let block = Block { unknowns: all, equations: all, kinds, turns: [false; N] };
    let solved = pass.large(&block, [T::of(0.0); N], |place| {
        let (phi, jacobian) = equations.linearize(&place.x, t);
        (phi.data.0[0], jacobian.transpose().data.0)
    })?;
    let q = SVector::from(solved.x);
    let rates = |b: SVector<T, N>| SVector::from(solved.rates(b.data.0[0]));
    let qd = rates(equations.nu(&q, t));
    let qdd = rates(equations.gamma(&q, &qd, t));
    Ok(Coordinates { q, qd, qdd })
}

/// Up to this many coordinates a guess is improved with all equations as one dense system.
const LARGEST_WHOLE: usize = 48;

/// A guess of q improved by Newton's method on all coordinates; the guess itself where that leads nowhere.
///
/// Taken all at once, equations share the error of the guess, and the assembly that is found is the one near it. Block by block,
/// what is solved first pulls what comes after.
pub fn improved_at_once<T: Float, E: Equations<T, N, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    guess: &SVector<T, N>,
) -> SVector<T, N> {
    // A constant condition: for large N the dense system is not even compiled.
    if const { N > LARGEST_WHOLE } {
        return *guess;
    }
    let whole = Whole { equations, t, scale: Scale::of(equations) };
    position::close(&whole, &Place::at(*guess, whole.turns())).map_or(*guess, |position| position.place.x)
}

/// The same where there are more equations than coordinates, of which those in `rows` are solved.
pub fn improved_by<T: Float, E: Equations<T, M, N> + ?Sized, const M: usize, const N: usize>(
    equations: &E,
    rows: &[usize; N],
    t: T,
    guess: &SVector<T, N>,
) -> SVector<T, N> {
    if const { N > LARGEST_WHOLE } {
        return *guess;
    }
    let chosen = Chosen { equations, rows, t, scale: Scale::of(equations) };
    position::close(&chosen, &Place::at(*guess, chosen.turns())).map_or(*guess, |position| position.place.x)
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
pub fn mark_of<T: Float>(parameters: &[T]) -> u64 {
    let hash = parameters.iter().fold(0xcbf2_9ce4_8422_2325_u64, |hash, parameter| {
        let mixed = (hash ^ parameter.bits()).wrapping_mul(0x0000_0100_0000_01b3);
        mixed ^ (mixed >> 29)
    });
    hash | 1
}
