//! Newton's method that only ever comes nearer: error-controlled damping.
//!
//! Deuflhard: Newton Methods for Nonlinear Problems, 3.3.3, algorithm NLEQ-ERR. A step q + λ δ is accepted if the correction
//! δ̄ that the old Jacobian asks for at the new place is shorter than δ (natural monotonicity test).

use nalgebra::SVector;

use crate::iterate::{History, Iterate};
use crate::order::smaller;
use crate::position::{LONGEST_STEP, Miss, Position, accept};
use crate::scale::Scale;
use crate::{Equations, Float};

/// Steps tried. Damped convergence is slow only next to singular positions.
const ITERATIONS: usize = 100;

/// Smallest damping factor: below it the step is called off.
const SMALLEST_FACTOR: f64 = 1e-6;

/// Newton's method with damped steps from a rough guess. It does not cross singular positions.
///
/// # Errors
/// `Stuck` with the best position where no step brings Φ nearer to zero, `Singular`, `NoConvergence` or `NotFinite`.
pub(crate) fn damped<T: Float, E: Equations<T, N, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    guess: &SVector<T, N>,
    scale: &Scale<T, N>,
) -> Result<Position<T, N>, Miss<T, N>> {
    let one = T::of(1.0);
    let mut iterate = Iterate::at(equations, t, *guess, scale)?;
    let mut history = History::new();
    let mut predicted = one;
    for iterations in 1..=ITERATIONS {
        if iterate.has_settled(&history, scale) {
            return accept(iterate, iterations, scale);
        }
        let longest = smaller(one, T::of(LONGEST_STEP) / iterate.length);
        let Some(Step { lambda, simplified }) = monotone_step(equations, t, &iterate, smaller(predicted, longest), scale) else {
            return Err(Miss::Stuck(iterate.q));
        };
        let next = Iterate::at(equations, t, iterate.moved(lambda), scale)?;
        let change = scale.norm(&SVector::from_fn(|i, _| simplified[i] - next.correction[i]));
        predicted = at_most_one(iterate.length * scale.norm(&simplified) * lambda / (change * next.length));
        history = history.after(iterate.length, lambda == one);
        iterate = next;
    }
    Err(Miss::NoConvergence { correction: iterate.length, iterations: ITERATIONS })
}

/// A step that passed the test.
struct Step<T, const N: usize> {
    /// λ.
    lambda: T,
    /// δ̄ with Φ_q(q) δ̄ = −Φ(q + λ δ).
    simplified: SVector<T, N>,
}

/// The longest of the steps tried, from λ = `first` down, for which |δ̄| < |δ|.
fn monotone_step<T: Float, E: Equations<T, N, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    iterate: &Iterate<T, N>,
    first: T,
    scale: &Scale<T, N>,
) -> Option<Step<T, N>> {
    let (half, one) = (T::of(0.5), T::of(1.0));
    let mut lambda = first;
    while lambda >= T::of(SMALLEST_FACTOR) {
        let phi = equations.phi(&iterate.moved(lambda), t);
        let simplified = iterate.factors.solve(&phi.map(|residual| -residual));
        if scale.norm(&simplified) < iterate.length {
            return Some(Step { lambda, simplified });
        }
        let remainder = scale.norm(&SVector::from_fn(|i, _| simplified[i] - (one - lambda) * iterate.correction[i]));
        lambda = smaller(half * lambda, half * iterate.length * lambda * lambda / remainder);
    }
    None
}

/// The smaller of x and 1; 1 for NaN, which stands for 0 / 0 where there is nothing left to correct.
fn at_most_one<T: Float>(x: T) -> T {
    smaller(T::of(1.0), x)
}
