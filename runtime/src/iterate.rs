//! One Newton iterate: Φ and Φ_q at q, the factors of Φ_q, and the correction δ they ask for.

use nalgebra::SVector;

use crate::linear::Factors;
use crate::scale::Scale;
use crate::{Culprit, Equations, Float, names};

/// How much longer than the rounding of q a correction may be that counts as rounding: a few roundings in Φ and in the solve.
const FEW_ROUNDINGS: f64 = 4.0;

/// The same per unit of condition: rounding errors in Φ reach δ multiplied by it, and the pivots underestimate it.
const MORE_ROUNDINGS: f64 = 64.0;

/// A position with its linearisation.
pub(crate) struct Iterate<T, const N: usize> {
    /// q.
    pub(crate) q: SVector<T, N>,
    /// Factors of Φ_q(q, t).
    pub(crate) factors: Factors<T, N>,
    /// δ with Φ_q δ = −Φ, a basic solution if Φ_q is singular.
    pub(crate) correction: SVector<T, N>,
    /// Scaled norm of δ.
    pub(crate) length: T,
}

/// What is known of the corrections before this one.
#[derive(Clone, Copy)]
pub(crate) struct History<T> {
    /// Length of the last correction; None if it was not made in full.
    pub(crate) previous: Option<T>,
    /// Length that the next one should have.
    pub(crate) expected: T,
}

impl<T: Float, const N: usize> Iterate<T, N> {
    /// Linearises at q and solves for the correction.
    ///
    /// # Errors
    /// The row or the coordinate that is not finite.
    pub(crate) fn at<E: Equations<T, N, N> + ?Sized>(equations: &E, t: T, q: SVector<T, N>, scale: &Scale<T, N>) -> Result<Self, Culprit> {
        let (phi, jacobian) = equations.linearize(&q, t);
        let not_finite = |row| Culprit::Row(names::row(E::ROWS, row));
        if let Some(row) = phi.iter().position(|residual| !residual.is_finite()) {
            return Err(first_not_finite::<T, E, N>(&q).unwrap_or(not_finite(row)));
        }
        let factors = Factors::new(&jacobian, &scale.column).map_err(not_finite)?;
        let correction = factors.solve(&phi.map(|residual| -residual));
        match first_not_finite::<T, E, N>(&correction) {
            Some(coordinate) => Err(coordinate),
            None => Ok(Self { q, factors, length: scale.norm(&correction), correction }),
        }
    }

    /// q + λ δ.
    pub(crate) fn moved(&self, lambda: T) -> SVector<T, N> {
        SVector::from_fn(|i, _| self.q[i] + lambda * self.correction[i])
    }

    /// Whether δ is nothing but rounding, so that q + δ is the solution and Φ_q at q its Jacobian.
    ///
    /// It is if it is no longer than a few roundings of q, or no longer than the condition explains and either expected to be
    /// shorter than one rounding or no longer getting shorter.
    pub(crate) fn has_settled(&self, history: &History<T>, scale: &Scale<T, N>) -> bool {
        let rounding = scale.rounding(&self.q);
        let stalled = || history.previous.is_some_and(|previous| self.length * T::of(4.0) >= previous);
        self.length <= T::of(FEW_ROUNDINGS) * rounding
            || self.length <= T::of(MORE_ROUNDINGS) * rounding * self.factors.condition && (history.expected <= rounding || stalled())
    }
}

impl<T: Float> History<T> {
    /// Before the first correction.
    pub(crate) fn new() -> Self {
        Self { previous: None, expected: T::of(f64::INFINITY) }
    }

    /// θ = |δ| / |previous δ|, for a correction that follows one made in full.
    pub(crate) fn contraction(&self, length: T) -> Option<T> {
        self.previous.map(|previous| length / previous)
    }

    /// After a correction of this length, made in full or not.
    ///
    /// Newton's method converges quadratically, |next δ| ≈ ω/2 |δ|², so that contractions square: |next δ| ≈ θ² |δ|.
    /// Deuflhard: Newton Methods for Nonlinear Problems, 2.1.
    pub(crate) fn after(&self, length: T, in_full: bool) -> Self {
        match self.contraction(length) {
            Some(theta) if in_full => Self { previous: Some(length), expected: theta * theta * length },
            _ => Self { previous: in_full.then_some(length), ..Self::new() },
        }
    }
}

/// The first coordinate in which a vector is not finite.
pub(crate) fn first_not_finite<T: Float, E: Equations<T, N, N> + ?Sized, const N: usize>(vector: &SVector<T, N>) -> Option<Culprit> {
    let index = vector.iter().position(|entry| !entry.is_finite())?;
    Some(Culprit::Coordinate(names::coordinate(E::COORDINATES, index)))
}
