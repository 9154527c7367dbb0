//! Newton's method that only ever comes nearer: error-controlled damping.
//!
//! Deuflhard: Newton Methods for Nonlinear Problems, 3.3.3, algorithm NLEQ-ERR. A step q + λ δ is accepted if the correction
//! δ̄ that the old Jacobian asks for at the new place is shorter than δ (natural monotonicity test).

use nalgebra::SVector;

use super::iterate::{History, Iterate};
use super::limits::LONGEST_STEP;
use super::position::{Miss, Position, accept};
use super::{Place, Problem};
use crate::linear::Linear;
use crate::number::Float;
use crate::number::order::smaller;

/// Steps tried. Damped convergence is slow only next to singular positions.
const ITERATIONS: usize = 100;

/// Smallest damping factor: below it the step is called off.
const SMALLEST_FACTOR: f64 = 1e-6;

/// Newton's method with damped steps from a rough guess. It does not cross singular positions.
///
/// # Errors
/// `Stuck` with the best position where no step brings Φ nearer to zero, `Singular`, `NoConvergence` or `NotFinite`.
pub(crate) fn damped<T: Float, P: Problem<T, N>, const N: usize>(
    problem: &P,
    guess: &Place<T, N>,
) -> Result<Position<T, P::Factors, N>, Miss<T, N>> {
    let scale = problem.scale();
    let one = T::of(1.0);
    let mut iterate = Iterate::at(problem, *guess)?;
    let mut history = History::new();
    let mut predicted = one;
    for iterations in 1..=ITERATIONS {
        if iterate.has_settled(&history) {
            return accept(problem, iterate, iterations);
        }
        let longest = smaller(one, T::of(LONGEST_STEP) / iterate.length);
        let Some(DampedStep { lambda, simplified }) = monotone_step(problem, &iterate, smaller(predicted, longest)) else {
            return Err(Miss::Stuck(iterate.place));
        };
        let next = Iterate::at(problem, iterate.moved(lambda, problem))?;
        let change = scale.norm(&SVector::from_fn(|i, _| simplified[i] - next.correction[i]));
        predicted = at_most_one(iterate.length * scale.norm(&simplified) * lambda / (change * next.length));
        history = history.after(iterate.length, lambda == one);
        iterate = next;
    }
    Err(Miss::NoConvergence { correction: iterate.length, iterations: ITERATIONS })
}

/// A step that passed the test.
struct DampedStep<T, const N: usize> {
    /// λ.
    lambda: T,
    /// δ̄ with Φ_q(q) δ̄ = −Φ(q + λ δ).
    simplified: SVector<T, N>,
}

/// The longest of the steps tried, from λ = `first` down, for which |δ̄| < |δ|.
fn monotone_step<T: Float, P: Problem<T, N>, const N: usize>(
    problem: &P,
    iterate: &Iterate<T, P::Factors, N>,
    first: T,
) -> Option<DampedStep<T, N>> {
    let scale = problem.scale();
    let (half, one) = (T::of(0.5), T::of(1.0));
    let mut lambda = first;
    while lambda >= T::of(SMALLEST_FACTOR) {
        let (phi, _) = problem.linearize(&iterate.moved(lambda, problem));
        let simplified = iterate.factors.solve(&phi.map(|residual| -residual));
        if scale.norm(&simplified) < iterate.length {
            return Some(DampedStep { lambda, simplified });
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
