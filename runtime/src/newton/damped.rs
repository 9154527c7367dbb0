//! Damped Newton method: every accepted step reduces the error estimate (error-controlled damping).
//!
//! Deuflhard: Newton Methods for Nonlinear Problems, 3.3.3, algorithm NLEQ-ERR. A step q + λ δ is accepted if the simplified
//! correction δ̄, computed at the new iterate with the old Jacobian, is shorter than δ (natural monotonicity test).

use nalgebra::SVector;

use super::limits::LONGEST_STEP;
use super::newton_step::{History, NewtonStep, Settled};
use super::position::NewtonError;
use super::{Iterate, Problem};
use crate::linear::{Linear, difference, moved, scaled};
use crate::number::Float;
use crate::number::order::smaller;

/// Largest number of steps. Damped convergence is slow only next to singular positions.
const ITERATIONS: usize = 100;

/// Smallest damping factor; below it the iteration ends.
const SMALLEST_FACTOR: f64 = 1e-6;

/// Newton's method with damped steps from a rough guess. It does not cross singular positions.
///
/// # Errors
/// `Stuck` with the best position, from which no step passes the test; `NoConvergence` or `NotFinite`.
pub(crate) fn damped<T: Float, P: Problem<T, N>, const N: usize>(
    problem: &P,
    guess: &Iterate<T, N>,
) -> Result<Settled<T, P::Factors, N>, NewtonError<T, N>> {
    let scale = problem.scale();
    let one = T::of(1.0);
    let mut step = NewtonStep::at(problem, *guess)?;
    let mut history = History::new();
    let mut predicted = one;
    for iterations in 1..=ITERATIONS {
        if step.has_settled(&history) {
            return Ok(Settled { step, iterations });
        }
        let longest = smaller(one, T::of(LONGEST_STEP) / step.length);
        let Some(DampedStep { lambda, simplified }) = monotone_step(problem, &step, smaller(predicted, longest)) else {
            return Err(NewtonError::Stuck(step.iterate));
        };
        let next = NewtonStep::at(problem, step.moved(lambda, problem))?;
        let change = scale.norm(&difference(&simplified, &next.correction));
        predicted = at_most_one(step.length * scale.norm(&simplified) * lambda / (change * next.length));
        history = history.after(step.length, lambda == one);
        step = next;
    }
    Err(NewtonError::NoConvergence { correction: step.length, iterations: ITERATIONS })
}

/// A step that passed the test.
struct DampedStep<T, const N: usize> {
    /// λ.
    lambda: T,
    /// δ̄ with Φ_q(q) δ̄ = −Φ(q + λ δ).
    simplified: SVector<T, N>,
}

/// The first step, from λ = `first` down, for which |δ̄| < |δ|.
fn monotone_step<T: Float, P: Problem<T, N>, const N: usize>(
    problem: &P,
    step: &NewtonStep<T, P::Factors, N>,
    first: T,
) -> Option<DampedStep<T, N>> {
    let scale = problem.scale();
    let (half, one) = (T::of(0.5), T::of(1.0));
    let mut lambda = first;
    while lambda >= T::of(SMALLEST_FACTOR) {
        let (phi, _) = problem.linearize(&step.moved(lambda, problem));
        let simplified = step.factors.solve(&scaled(&phi, T::of(-1.0)));
        if scale.norm(&simplified) < step.length {
            return Some(DampedStep { lambda, simplified });
        }
        let remainder = scale.norm(&moved(&simplified, lambda - one, &step.correction));
        lambda = smaller(half * lambda, half * step.length * lambda * lambda / remainder);
    }
    None
}

/// The smaller of x and 1; 1 for NaN, which is 0 / 0 after an exact solution.
fn at_most_one<T: Float>(x: T) -> T {
    smaller(T::of(1.0), x)
}
