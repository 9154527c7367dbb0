//! A state from a cold start.

use nalgebra::SVector;

use crate::names::{self, Cause, Culprit};
use crate::newton::StepError;
use crate::number::Float;
use crate::solve::{ColdReport, ColdSolver, Followed};
use crate::state::{Coordinates, State, Values};

/// The state found by a cold start; all equations hold in it.
///
/// # Errors
/// Why there is none.
pub(crate) fn valid_state<T: Float, const N: usize>(
    mechanism: &Followed<'_, T, N>,
    t: T,
    solver: ColdSolver<'_, T, N>,
) -> Result<State<T, N>, StepError<T>> {
    match cold_state(mechanism, t, solver)? {
        (_, Some(cause)) => Err(StepError::Open(cause)),
        (state, None) => Ok(state),
    }
}

/// A state, and the redundant equation that does not hold in it, if there is one.
pub(crate) type CheckedState<T, const N: usize> = (State<T, N>, Option<Cause<T>>);

/// The state found by a cold start, and the redundant equation that does not hold in it, if there is one.
///
/// # Errors
/// Why there is none.
pub(crate) fn cold_state<T: Float, const N: usize>(
    mechanism: &Followed<'_, T, N>,
    t: T,
    solver: ColdSolver<'_, T, N>,
) -> Result<CheckedState<T, N>, StepError<T>> {
    let there = mechanism.solve(t, &solver)?;
    let Coordinates { q, qd, qdd } = there;
    for vector in [&q, &qd, &qdd] {
        if let Some(index) = vector.iter().position(|entry| !entry.is_finite()) {
            return Err(StepError::NotFinite(Culprit::Coordinate(names::coordinate(mechanism.coordinates, index))));
        }
    }
    let ColdReport { branch, condition, iterations, .. } = solver.report();
    let state = State::solved(Values { t, q, qd, qdd, branch, condition, iterations }, mechanism.parameter_hash);
    Ok((state, solver.contradiction()))
}

/// The block nearest to singular at q.
pub(crate) fn inspect<T: Float, const N: usize>(mechanism: &Followed<'_, T, N>, t: T, q: &SVector<T, N>) -> Option<Cause<T>> {
    let solver = ColdSolver::inspection(mechanism, q);
    // Only the report is needed, not the rates.
    let _ = mechanism.solve(t, &solver);
    solver.report().worst
}
