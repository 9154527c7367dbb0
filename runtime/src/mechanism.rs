//! What one can ask of a mechanism.

use nalgebra::SVector;

use crate::assembly::assemble;
use crate::careful::Care;
use crate::continuation;
use crate::stages::Stages;
use crate::verdict;
use crate::{Cause, Culprit, Failure, Float, State, Sweep};

/// A mechanism with as many equations as coordinates, which can be solved. Everything with [`Stages`] is one.
///
/// Methods that take a time return the state then, with q, q̇ and q̈ at the rounding limit.
/// They fail with the [`Cause`] and the last valid state, and never panic.
pub trait Mechanism<T: Float, const N: usize>: Stages<T, N> {
    /// The state at `t` (s) on the branch of the declared start: assembled at t = 0, then followed in time, which takes the longer
    /// the further `t` is. Parameters that differ from the defaults are followed from there as well,
    /// and where the branch ends on that way, [`Failure::end`] says where.
    ///
    /// # Errors
    /// Any [`Cause`]. For many times in order, [`sweep`](Self::sweep) does not begin at zero again and again.
    fn solve(&self, t: T) -> Result<State<T, N>, Failure<T, N>>
    where
        Self: Sized,
    {
        let mut state = assemble(self)?;
        if t != state.t {
            continuation::advance(self, &mut state, t)?;
        }
        Ok(state)
    }

    /// The state at `t` (s) that Newton's method finds from a rough `guess` of q (m, rad), of whatever branch.
    ///
    /// # Errors
    /// Any [`Cause`] but `BranchLost` and `TooManySteps`.
    fn solve_near(&self, t: T, guess: &SVector<T, N>) -> Result<State<T, N>, Failure<T, N>> {
        let fail = |cause| Failure { mechanism: Self::NAME, cause, time: t, end: None, last: None };
        self.validate().map_err(|parameter| fail(Cause::ParameterOutOfRange(parameter)))?;
        if !t.is_finite() {
            return Err(fail(Cause::NotFinite { of: Culprit::Time }));
        }
        let guess = self.improved(t, guess);
        continuation::state(self, t, Care::close(self, &guess)).map_err(|stop| fail(verdict::open(stop)))
    }

    /// The state at `t` (s) on the branch of `from`, a state of this mechanism with these parameters.
    ///
    /// # Errors
    /// Any [`Cause`].
    fn solve_from(&self, t: T, from: &State<T, N>) -> Result<State<T, N>, Failure<T, N>> {
        self.validate().map_err(|parameter| {
            let cause = Cause::ParameterOutOfRange(parameter);
            Failure { mechanism: Self::NAME, cause, time: t, end: None, last: Some(from.clone()) }
        })?;
        let mut state = from.clone();
        continuation::advance(self, &mut state, t)?;
        Ok(state)
    }

    /// Takes a state of this mechanism to time `t` (s) in place: [`solve_from`](Self::solve_from) without a copy, for loops in
    /// which every nanosecond counts. A state that cannot be taken there stays as it is.
    ///
    /// # Errors
    /// Any [`Cause`].
    #[inline]
    fn advance(&self, state: &mut State<T, N>, t: T) -> Result<(), Failure<T, N>> {
        continuation::advance(self, state, t)
    }

    /// The states at these times (s): the first as by [`solve`](Self::solve), each further one from the one before.
    ///
    /// The iterator ends after the first failure.
    fn sweep<I: IntoIterator<Item = T>>(&self, times: I) -> Sweep<'_, Self, I::IntoIter, T, N>
    where
        Self: Sized,
    {
        Sweep::new(self, times.into_iter())
    }
}

impl<T: Float, const N: usize, E: Stages<T, N> + ?Sized> Mechanism<T, N> for E {}
