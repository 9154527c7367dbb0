//! A state from a cold start.

use nalgebra::SVector;

use crate::names::{self, Cause, Culprit};
use crate::newton::StepError;
use crate::number::Float;
use crate::solve::{ColdReport, ColdSolver, Solver, Stages};
use crate::state::{Coordinates, State, Values};

/// A cold start through all stages, compiled once for each mechanism.
///
/// # Errors
/// Why a block was not solved.
#[inline(never)]
pub(crate) fn solve_stages<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    solver: &ColdSolver<'_, T, N>,
) -> Result<Coordinates<T, N>, StepError<T>> {
    equations.stages(t, &mut Solver::cold(solver))
}

/// The state found by a cold start; all equations hold in it.
///
/// # Errors
/// Why there is none.
pub(crate) fn valid_state<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    solver: ColdSolver<'_, T, N>,
) -> Result<State<T, N>, StepError<T>> {
    match cold_state(equations, t, solver)? {
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
pub(crate) fn cold_state<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    solver: ColdSolver<'_, T, N>,
) -> Result<CheckedState<T, N>, StepError<T>> {
    let there = solve_stages(equations, t, &solver)?;
    let Coordinates { q, qd, qdd } = there;
    for vector in [&q, &qd, &qdd] {
        if let Some(index) = vector.iter().position(|entry| !entry.is_finite()) {
            return Err(StepError::NotFinite(Culprit::Coordinate(names::coordinate(E::COORDINATES, index))));
        }
    }
    let ColdReport { branch, condition, iterations, .. } = solver.report();
    let state = State::solved(Values { t, q, qd, qdd, branch, condition, iterations }, equations.parameter_hash());
    Ok((state, solver.contradiction()))
}

/// The block nearest to singular at q.
pub(crate) fn inspect<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(equations: &E, t: T, q: &SVector<T, N>) -> Option<Cause<T>> {
    let solver = ColdSolver::inspection(equations, q);
    // Only the report is needed, not the rates.
    let _ = solve_stages(equations, t, &solver);
    solver.report().worst
}
