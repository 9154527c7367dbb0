//! From a rough guess to a solution.

use super::damped::damped;
use super::iterate::{History, Iterate};
use super::limits::LONGEST_STEP;
use super::position::{Miss, Position, accept};
use super::{Place, Problem};
use crate::number::Float;
use crate::number::order::smaller;

/// Corrections tried without damping. Over the reference mechanisms with guesses off by 0.6 rad and 0.6 L, 10 are usual.
const CLOSING_ITERATIONS: usize = 50;

/// Assembles from a rough guess: Newton's method with limited steps and, if that does not settle, damped from the same guess.
///
/// Limited steps may cross singular positions, which from rough guesses they often must; damped ones never do, but end at
/// the best position that can be reached without.
pub(crate) fn close<T: Float, P: Problem<T, N>, const N: usize>(
    problem: &P,
    guess: &Place<T, N>,
) -> Result<Position<T, P::Factors, N>, Miss<T, N>> {
    limited(problem, guess).or_else(|_| damped(problem, guess))
}

/// Newton's method with scaled steps of at most [`LONGEST_STEP`].
fn limited<T: Float, P: Problem<T, N>, const N: usize>(problem: &P, guess: &Place<T, N>) -> Result<Position<T, P::Factors, N>, Miss<T, N>> {
    let mut place = *guess;
    let mut history = History::new();
    for iterations in 1..=CLOSING_ITERATIONS {
        let iterate = Iterate::at(problem, place)?;
        if iterate.has_settled(&history) {
            return accept(problem, iterate, iterations);
        }
        let in_full = iterate.length <= T::of(LONGEST_STEP);
        place = iterate.moved(smaller(T::of(1.0), T::of(LONGEST_STEP) / iterate.length), problem);
        history = history.after(iterate.length, in_full);
    }
    Err(Miss::NoConvergence { correction: history.last().unwrap_or(T::of(LONGEST_STEP)), iterations: CLOSING_ITERATIONS })
}
