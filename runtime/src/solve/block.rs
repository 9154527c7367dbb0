//! Cold start of one block, which knows nothing of the mechanism but the block's equations.

use nalgebra::{SMatrix, SVector};

use crate::linear::{Linear, regular_part};
use crate::names::{Cause, Culprit};
use crate::newton::{self, Iterate, LONGEST_PREDICTION, NewtonError, Part, Position, Problem, StepError, TrackError};
use crate::number::order::greater;
use crate::number::{DetSign, Float};

/// Where a block is solved from, and how.
pub(super) struct Start<T, const K: usize> {
    pub(super) iterate: Iterate<T, K>,
    pub(super) manner: Manner<T, K>,
}

/// How a block is solved.
pub(super) enum Manner<T, const K: usize> {
    /// From a prediction, each unknown `way` from the previous state. The determinant keeps its `sign`, if there is one.
    Tracking { way: SVector<T, K>, sign: Option<DetSign> },
    /// From a rough guess.
    FromGuess,
    /// Nothing is solved: the condition is compared with the largest `known` one.
    Inspection { known: Option<T> },
    /// From a position between two crossing branches.
    Settling,
}

/// The position of a block and, at an inspection, the cause if its condition is larger than the known one; else why it was not solved.
pub(super) type Outcome<T, L, const K: usize> = Result<(Position<T, L, K>, Option<Cause<T>>), StepError<T>>;

/// Solves a block.
pub(super) fn solved<T: Float, L: Linear<T, K>, const K: usize>(part: &Part<'_, T, L, K>, start: &Start<T, K>) -> Outcome<T, L, K> {
    let Start { iterate, manner } = start;
    let position = match manner {
        Manner::Tracking { way, sign } => {
            // Angles are periodic: a long prediction may lead to the solution a whole turn away.
            if part.scale.norm(way) > T::of(LONGEST_PREDICTION) {
                return Err(StepError::Far);
            }
            let position = newton::track(part, iterate, *sign)?;
            if sign.is_some_and(|before| before != position.factors.det_sign()) {
                return Err(StepError::Far);
            }
            position
        }
        Manner::FromGuess => newton::solve_from_guess(part, iterate).map_err(|error| open(part, error))?,
        Manner::Inspection { known } => {
            let (factors, jacobian) = factored(part, iterate)?;
            // A link without length leaves its angle open, however exact its row is.
            let condition = greater(factors.condition(&part.sizes, &part.scale.reciprocal), part.weakness(&jacobian));
            let is_worse = known.is_none_or(|known| condition > known);
            let position = Position { iterate: *iterate, factors, condition, iterations: 0 };
            return Ok((position, is_worse.then(|| part.singular(iterate))));
        }
        Manner::Settling => {
            let iterate = settled(part, *iterate)?;
            let (factors, _) = factored(part, &iterate)?;
            Position { iterate, factors, condition: T::of(1.0), iterations: SETTLING }
        }
    };
    Ok((position, None))
}

/// The factors of the Jacobian, and the Jacobian.
fn factored<T: Float, P: Problem<T, K>, const K: usize>(
    problem: &P,
    iterate: &Iterate<T, K>,
) -> Result<(P::Factors, SMatrix<T, K, K>), StepError<T>> {
    let (_, jacobian) = problem.linearize(iterate);
    let factors = P::Factors::factor(&jacobian).map_err(|row| StepError::NotFinite(Culprit::Row(problem.row(row))))?;
    Ok((factors, P::Factors::dense(&jacobian)))
}

/// Number of corrections of a position between two crossing branches; half of its digits are already right in the directions that
/// are corrected.
const SETTLING: usize = 2;

/// At a crossing residuals are at most this many roundings of their terms; where two branches only come close, a gap remains.
const GAP: f64 = 8.0;

/// An iterate at which the equations hold to rounding, corrected in the directions that they determine.
///
/// # Errors
/// If a gap remains.
fn settled<T: Float, P: Problem<T, K>, const K: usize>(problem: &P, mut iterate: Iterate<T, K>) -> Result<Iterate<T, K>, StepError<T>> {
    let column = &problem.scale().column;
    for _ in 0..SETTLING {
        let (phi, jacobian) = problem.linearize(&iterate);
        let (sizes, rows) = (newton::sizes(problem, &jacobian), P::Factors::dense(&jacobian));
        let scaled = SMatrix::<T, K, K>::from_fn(|i, j| rows[(i, j)] * column[j] / sizes[i]);
        let residual = SVector::<T, K>::from_fn(|i, _| -phi[i] / sizes[i]);
        let correction = regular_part(&scaled, &residual).ok_or(StepError::Far)?;
        iterate = iterate.moved(T::of(1.0), &SVector::from_fn(|j, _| correction[j] * column[j]), problem.needs_sin_cos());
    }
    let (phi, jacobian) = problem.linearize(&iterate);
    let sizes = newton::sizes(problem, &jacobian);
    let holds = phi.iter().zip(&sizes).all(|(residual, &size)| residual.abs() <= T::of(GAP) * T::EPSILON * size);
    if holds { Ok(iterate) } else { Err(StepError::Far) }
}

/// Why a block was not solved from a guess.
fn open<T: Float, P: Problem<T, K>, const K: usize>(problem: &P, error: NewtonError<T, K>) -> StepError<T> {
    match error {
        NewtonError::NotFinite(of) => StepError::NotFinite(of),
        NewtonError::Singular(iterate) | NewtonError::Stuck(iterate) => {
            StepError::Open(problem.widest_gap(&iterate).unwrap_or_else(|| problem.singular(&iterate)))
        }
        NewtonError::NoConvergence { correction, iterations } => StepError::Open(Cause::NoConvergence { correction, iterations }),
    }
}

impl<T> From<TrackError> for StepError<T> {
    fn from(error: TrackError) -> Self {
        match error {
            TrackError::NotFinite(of) => StepError::NotFinite(of),
            TrackError::Singular | TrackError::Far => StepError::Far,
        }
    }
}
