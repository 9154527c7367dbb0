//! How a mechanism is solved: stage by stage, or all at once.

use nalgebra::SVector;

use crate::linear::Linear;
use crate::pass::{Pass, Stop};
use crate::problem::{Problem, Whole};
use crate::scale::Scale;
use crate::{Equations, Float};

/// Position, velocity and acceleration of all coordinates.
pub struct Coordinates<T, const N: usize> {
    /// q in m and rad.
    pub q: SVector<T, N>,
    /// q̇ in m/s and rad/s.
    pub qd: SVector<T, N>,
    /// q̈ in m/s² and rad/s².
    pub qdd: SVector<T, N>,
}

impl<T: Float, const N: usize> Coordinates<T, N> {
    /// All zero.
    #[must_use]
    pub fn zero() -> Self {
        let zero = SVector::from_element(T::of(0.0));
        Self { q: zero, qd: zero, qdd: zero }
    }
}

/// The way a mechanism is solved. Emitted code goes block by block; the provided way takes all equations as one system, and is
/// what a mechanism written by hand gets with an empty `impl`.
pub trait Stages<T: Float, const N: usize>: Equations<T, N, N> {
    /// The angles that are computed rather than iterated. Those that are iterated never go far in one step; of these it is checked
    /// that they came to where they were expected.
    const COMPUTED_ANGLES: &'static [usize] = &[];

    /// The mechanism with parameters that are this share of the way from their declared defaults, for which
    /// [`start`](Equations::start) is assembled, to these. None if they are the defaults, or have none.
    fn toward(&self, share: T) -> Option<Self>
    where
        Self: Sized,
    {
        let _ = share;
        None
    }

    /// q, q̇ and q̈ at time `t` (s).
    ///
    /// # Errors
    /// Why there are none near what the pass sets out from.
    fn stages(&self, t: T, pass: &mut Pass<'_, T, N>) -> Result<Coordinates<T, N>, Stop<T>> {
        let whole = Whole { equations: self, t, scale: Scale::of(self) };
        let all = core::array::from_fn(|index| index);
        let position = pass.run(&whole, &all, 0)?;
        let q = position.place.x;
        let qd = rates(&whole, &position.factors, &self.nu(&q, t))?;
        let qdd = rates(&whole, &position.factors, &self.gamma(&q, &qd, t))?;
        Ok(Coordinates { q, qd, qdd })
    }
}

/// Φ_q x = b for the rates x of first or second order, with one step of refinement.
fn rates<T: Float, P: Problem<T, N>, const N: usize>(
    problem: &P,
    factors: &P::Factors,
    b: &SVector<T, N>,
) -> Result<SVector<T, N>, Stop<T>> {
    if let Some(row) = b.iter().position(|entry| !entry.is_finite()) {
        return Err(Stop::NotFinite(crate::Culprit::Row(problem.row(row))));
    }
    let x = factors.solve_refined(b);
    problem.first_not_finite(&x).map_or(Ok(x), |of| Err(Stop::NotFinite(of)))
}
