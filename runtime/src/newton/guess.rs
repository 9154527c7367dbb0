//! Newton's method from a rough guess.

use super::damped::damped;
use super::limits::LONGEST_STEP;
use super::newton_step::{History, NewtonStep, Settled};
use super::position::{NewtonError, Position, accept};
use super::{Iterate, Problem};
use crate::number::Float;
use crate::number::order::smaller;

/// Largest number of corrections without damping. The reference mechanisms need about 10 from guesses that are off by 0.6 rad and
/// 0.6 L.
const CLOSING_ITERATIONS: usize = 50;

/// Solves from a rough guess: Newton's method with limited steps and, if it does not converge, the damped method from the same
/// guess.
///
/// Limited steps can cross singular positions, as is often necessary from a rough guess. Damped steps never do; they end at the
/// best position on this side.
pub(crate) fn solve_from_guess<T: Float, P: Problem<T, N>, const N: usize>(
    problem: &P,
    guess: &Iterate<T, N>,
) -> Result<Position<T, P::Factors, N>, NewtonError<T, N>> {
    let accepted = |settled| accept(problem, settled);
    limited(problem, guess).and_then(accepted).or_else(|_| damped(problem, guess).and_then(accepted))
}

/// A better guess: the iterate at which the same methods settle. It may be singular.
pub(crate) fn refined<T: Float, P: Problem<T, N>, const N: usize>(problem: &P, guess: &Iterate<T, N>) -> Option<Iterate<T, N>> {
    let settled = limited(problem, guess).or_else(|_| damped(problem, guess)).ok()?;
    Some(settled.nudged(problem))
}

/// Newton's method with scaled steps of at most [`LONGEST_STEP`].
fn limited<T: Float, P: Problem<T, N>, const N: usize>(
    problem: &P,
    guess: &Iterate<T, N>,
) -> Result<Settled<T, P::Factors, N>, NewtonError<T, N>> {
    let mut iterate = *guess;
    let mut history = History::new();
    for iterations in 1..=CLOSING_ITERATIONS {
        let step = NewtonStep::at(problem, iterate)?;
        if step.has_settled(&history) {
            return Ok(Settled { step, iterations });
        }
        let in_full = step.length <= T::of(LONGEST_STEP);
        iterate = step.moved(smaller(T::of(1.0), T::of(LONGEST_STEP) / step.length), problem);
        history = history.after(step.length, in_full);
    }
    Err(NewtonError::NoConvergence { correction: history.last().unwrap_or(T::of(LONGEST_STEP)), iterations: CLOSING_ITERATIONS })
}
