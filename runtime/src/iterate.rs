//! One Newton iterate: Φ and Φ_q at q, the factors of Φ_q, and the correction δ they ask for.

use nalgebra::SVector;

use crate::linear::Linear;
use crate::place::Place;
use crate::problem::Problem;
use crate::scale::Scale;
use crate::{Culprit, Float};

/// Relative change of Φ_q along δ, in ε, up to which Φ_q at q serves at q + δ. It is also the relative error that this leaves in q̇.
const SAME_JACOBIAN: f64 = 32.0;

/// Corrections that shrink no faster than this, and are short, are rounding errors. Near the solution others shrink quadratically.
const STALLED: f64 = 0.25;

/// A position with its linearisation.
pub(crate) struct Iterate<T, L, const N: usize> {
    /// q.
    pub(crate) place: Place<T, N>,
    /// Factors of Φ_q(q, t).
    pub(crate) factors: L,
    /// δ with Φ_q δ = −Φ, a basic solution if Φ_q is singular.
    pub(crate) correction: SVector<T, N>,
    /// Scaled norm of δ.
    pub(crate) length: T,
}

/// What is known from the corrections before this one.
#[derive(Clone, Copy)]
pub(crate) struct History<T> {
    /// Length of the last correction; None if it was not made in full.
    previous: Option<T>,
    /// ω as it was seen in the contraction before.
    curvature: Option<T>,
    /// θ of the last two corrections.
    ratio: Option<T>,
}

impl<T: Float, L: Linear<T, N>, const N: usize> Iterate<T, L, N> {
    /// Linearises at a place and solves for the correction.
    ///
    /// # Errors
    /// The row or the coordinate that is not finite.
    pub(crate) fn at<P: Problem<T, N, Factors = L>>(problem: &P, place: Place<T, N>) -> Result<Self, Culprit> {
        let (phi, jacobian) = problem.linearize(&place);
        let factors = L::factor(&jacobian).map_err(|row| Culprit::Row(problem.row(row)))?;
        let correction = factors.solve(&phi.map(|residual| -residual));
        let length = problem.scale().norm(&correction);
        // Whatever is not finite in Φ or δ shows in the length.
        if length.is_finite() { Ok(Self { place, factors, correction, length }) } else { Err(culprit(problem, &place, &phi, &correction)) }
    }

    /// q + λ δ.
    pub(crate) fn moved<P: Problem<T, N>>(&self, lambda: T, problem: &P) -> Place<T, N> {
        self.place.moved(lambda, &self.correction, problem.turns())
    }

    /// Whether q + δ is the solution, to rounding, and Φ_q at q its Jacobian.
    ///
    /// They are if δ is short, at most √ε, and either Φ_q does not change along it, so that the next correction would be below
    /// rounding, or corrections no longer get shorter.
    pub(crate) fn has_settled(&self, history: &History<T>, scale: &Scale<T, N>) -> bool {
        if self.length > T::ROOT_EPSILON * (T::of(1.0) + scale.norm(&self.place.x)) {
            return false;
        }
        let stalled = history.contraction(self.length).is_some_and(|theta| theta >= T::of(STALLED));
        let change = history.curvature(self.length).map(|curvature| curvature * self.length);
        stalled || self.length == T::of(0.0) || change.is_some_and(|change| change <= T::of(SAME_JACOBIAN) * T::EPSILON)
    }
}

/// What was not finite first: a coordinate, else a row, else a correction.
#[cold]
fn culprit<T: Float, P: Problem<T, N>, const N: usize>(
    problem: &P,
    place: &Place<T, N>,
    phi: &SVector<T, N>,
    correction: &SVector<T, N>,
) -> Culprit {
    let row = || phi.iter().position(|residual| !residual.is_finite()).map(|row| Culprit::Row(problem.row(row)));
    let place = problem.first_not_finite(&place.x);
    place.or_else(row).or_else(|| problem.first_not_finite(correction)).unwrap_or(Culprit::Row(problem.row(0)))
}

impl<T: Float> History<T> {
    /// Before the first correction.
    pub(crate) fn new() -> Self {
        Self { previous: None, curvature: None, ratio: None }
    }

    /// θ = |δ| / |previous δ|, for a correction that follows one made in full.
    pub(crate) fn contraction(&self, length: T) -> Option<T> {
        self.previous.map(|previous| length / previous)
    }

    /// ω, the relative change of Φ_q per unit of length, from θ ≈ ω/2 |previous δ|; from the contraction before this one if
    /// there was one, because this one may be rounding already. Deuflhard: Newton Methods for Nonlinear Problems, 2.1.
    fn curvature(&self, length: T) -> Option<T> {
        let seen_now = || self.previous.map(|previous| T::of(2.0) * length / (previous * previous));
        self.curvature.or_else(seen_now)
    }

    /// After a correction of this length, made in full or not.
    pub(crate) fn after(&self, length: T, in_full: bool) -> Self {
        let latest = Self { curvature: None, ..*self };
        Self { previous: in_full.then_some(length), curvature: latest.curvature(length), ratio: self.contraction(length) }
    }

    /// The corrections became shorter by the same factor each time, not quadratically, and the last was no rounding: this is
    /// how Newton's method approaches a place where two solutions meet.
    pub(crate) fn is_linear(&self) -> bool {
        let was_long = self.previous.is_some_and(|previous| previous > T::of(4.0 * SAME_JACOBIAN) * T::EPSILON);
        was_long && self.ratio.is_some_and(|ratio| ratio >= T::of(STALLED))
    }

    /// Length of the last correction, if it was made in full.
    pub(crate) fn last(&self) -> Option<T> {
        self.previous
    }
}
