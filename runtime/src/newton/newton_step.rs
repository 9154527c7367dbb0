//! One Newton step: Φ and Φ_q at q, the factors of Φ_q, and the correction δ.

use nalgebra::{SMatrix, SVector};

use super::{Iterate, Problem};
use crate::linear::{Linear, scaled};
use crate::names::Culprit;
use crate::number::Float;

/// Largest relative change of Φ_q along δ, in ε, at which Φ_q at q is still used at q + δ. The relative error in q̇ is the same.
const SAME_JACOBIAN: f64 = 32.0;

/// Contraction from which on the iteration has stalled. At a double solution Newton's method still contracts by 1/2.
const STALLED: f64 = 0.7;

/// A correction may be a rounding error up to this multiple of the first-order effect of one rounding in each term.
const ROUNDINGS: f64 = 4.0;

/// A position with its linearisation.
pub(crate) struct NewtonStep<T, L, const N: usize> {
    /// q.
    pub(crate) iterate: Iterate<T, N>,
    /// Factors of Φ_q(q, t).
    pub(crate) factors: L,
    /// δ with Φ_q δ = −Φ, a basic solution if Φ_q is singular.
    pub(crate) correction: SVector<T, N>,
    /// Scaled norm of δ.
    pub(crate) length: T,
    /// The magnitudes of the terms of each residual, to which its rounding errors are proportional.
    sizes: SVector<T, N>,
}

/// The last step, whose correction leads to the solution.
pub(crate) struct Settled<T, L, const N: usize> {
    pub(crate) step: NewtonStep<T, L, N>,
    /// Number of factorisations.
    pub(crate) iterations: usize,
}

impl<T: Float, L: Linear<T, N>, const N: usize> Settled<T, L, N> {
    /// The iterate after the last correction.
    pub(crate) fn nudged<P: Problem<T, N>>(&self, problem: &P) -> Iterate<T, N> {
        self.step.iterate.nudged(&self.step.correction, problem.needs_sin_cos())
    }
}

/// Lengths and contractions of the previous corrections.
#[derive(Clone, Copy)]
pub(crate) struct History<T> {
    /// Length of the last correction; None if it was shortened.
    previous: Option<T>,
    /// ω, estimated from the previous contraction.
    curvature: Option<T>,
}

impl<T: Float, L: Linear<T, N>, const N: usize> NewtonStep<T, L, N> {
    /// Linearises at an iterate and solves for the correction.
    ///
    /// # Errors
    /// The row or the coordinate that is not finite.
    pub(crate) fn at<P: Problem<T, N, Factors = L>>(problem: &P, iterate: Iterate<T, N>) -> Result<Self, Culprit> {
        let (phi, jacobian) = problem.linearize(&iterate);
        let factors = L::factor(&jacobian).map_err(|row| Culprit::Row(problem.row(row)))?;
        let sizes = sizes::<T, P, N>(problem, &jacobian);
        let correction = factors.solve(&scaled(&phi, T::of(-1.0)));
        let length = problem.scale().norm(&correction);
        // Any entry of Φ or δ that is not finite makes the length not finite.
        if length.is_finite() {
            Ok(Self { iterate, factors, correction, length, sizes })
        } else {
            Err(culprit(problem, &iterate, &phi, &correction))
        }
    }

    /// q + λ δ.
    pub(crate) fn moved<P: Problem<T, N>>(&self, lambda: T, problem: &P) -> Iterate<T, N> {
        self.iterate.moved(lambda, &self.correction, problem.needs_sin_cos())
    }

    /// Whether q + δ is the solution to rounding, with Φ_q at q as its Jacobian.
    ///
    /// True if δ is at most ε² (rad, L), since an unknown that is zero by symmetry has no rounding error to compare it with; if Φ_q does
    /// not change along δ, so that the next correction would be far shorter than this one; or if corrections have stopped shrinking and δ
    /// may be a rounding error. At a double solution corrections are halved each time until then.
    pub(crate) fn has_settled(&self, history: &History<T>) -> bool {
        let change = history.curvature(self.length).map(|curvature| curvature * self.length);
        let is_stalled = || history.contraction(self.length).is_some_and(|theta| theta >= T::of(STALLED));
        self.length <= T::EPSILON * T::EPSILON
            || change.is_some_and(|change| change <= T::of(SAME_JACOBIAN) * T::EPSILON)
            || (is_stalled() && self.is_rounding())
    }

    /// Whether rounding errors alone may cause this correction: |δ| ≤ 4 ε (|Φ_q⁻¹| s + |q|) in each unknown, s the magnitudes of
    /// the terms of Φ.
    pub(crate) fn is_rounding(&self) -> bool {
        let zero = T::of(0.0);
        let mut effect = self.iterate.x.map(|x| x.abs());
        for row in 0..N {
            let unit = SVector::from_fn(|k, _| if k == row { self.sizes[row] } else { zero });
            let column = self.factors.solve(&unit);
            effect = effect.zip_map(&column, |sum, entry| sum + entry.abs());
        }
        self.correction.iter().zip(&effect).all(|(correction, &effect)| correction.abs() <= T::of(ROUNDINGS) * T::EPSILON * effect)
    }
}

/// The magnitudes of the terms of each residual; where they are unknown, the magnitude of its row of Φ_q, with lengths weighted by
/// L.
pub(crate) fn sizes<T: Float, P: Problem<T, N>, const N: usize>(
    problem: &P,
    jacobian: &<P::Factors as Linear<T, N>>::Matrix,
) -> SVector<T, N> {
    let sizes = problem.sizes();
    if sizes.iter().all(|&size| size > T::of(0.0)) {
        return sizes;
    }
    known_or_of_rows(&sizes, &P::Factors::dense(jacobian), &problem.scale().column)
}

/// The sizes that are known, and of the other rows the sums of their entries in comparable units.
fn known_or_of_rows<T: Float, const N: usize>(sizes: &SVector<T, N>, rows: &SMatrix<T, N, N>, column: &SVector<T, N>) -> SVector<T, N> {
    let mut of_rows = SVector::<T, N>::from_element(T::of(0.0));
    for (entries, &size) in rows.data.0.iter().zip(column) {
        for (sum, entry) in of_rows.iter_mut().zip(entries) {
            *sum = *sum + entry.abs() * size;
        }
    }
    for (size, &known) in of_rows.iter_mut().zip(sizes) {
        if known > T::of(0.0) {
            *size = known;
        }
    }
    of_rows
}

/// The first number that is not finite: in q, else in Φ, else in δ.
#[cold]
fn culprit<T: Float, P: Problem<T, N>, const N: usize>(
    problem: &P,
    iterate: &Iterate<T, N>,
    phi: &SVector<T, N>,
    correction: &SVector<T, N>,
) -> Culprit {
    let row = || phi.iter().position(|residual| !residual.is_finite()).map(|row| Culprit::Row(problem.row(row)));
    let iterate = problem.first_not_finite(&iterate.x);
    iterate.or_else(row).or_else(|| problem.first_not_finite(correction)).unwrap_or(Culprit::Row(problem.row(0)))
}

impl<T: Float> History<T> {
    /// Before the first correction.
    pub(crate) fn new() -> Self {
        Self { previous: None, curvature: None }
    }

    /// θ = |δ| / |previous δ|, if the previous correction was applied in full.
    pub(crate) fn contraction(&self, length: T) -> Option<T> {
        self.previous.map(|previous| length / previous)
    }

    /// ω, the relative change of Φ_q per unit of length, from θ ≈ ω/2 |previous δ|; the previous contraction is preferred, because
    /// this one may be rounding already. Deuflhard: Newton Methods for Nonlinear Problems, 2.1.
    fn curvature(&self, length: T) -> Option<T> {
        self.curvature.or_else(|| self.curvature_seen(length))
    }

    /// The same from this correction.
    fn curvature_seen(&self, length: T) -> Option<T> {
        self.previous.map(|previous| T::of(2.0) * length / (previous * previous))
    }

    /// After a correction of this length, applied in full or shortened.
    pub(crate) fn after(&self, length: T, in_full: bool) -> Self {
        let previous = in_full.then_some(length);
        Self { previous, curvature: self.curvature_seen(length) }
    }

    /// Length of the last correction, if it was applied in full.
    pub(crate) fn last(&self) -> Option<T> {
        self.previous
    }
}
