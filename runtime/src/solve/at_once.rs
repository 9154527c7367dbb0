//! All equations of a mechanism as one system.

use nalgebra::{SMatrix, SVector};

use super::{Equations, Solver, SolverReal};
use crate::linear::Factors;
use crate::names;
use crate::newton::{self, Block, Iterate, Part, Scale, StepError};
use crate::number::{Float, Real};
use crate::state::Coordinates;

/// Some rows of Φ and Φ_q. A row that does not exist is zero, and the matrix is singular.
fn chosen<T: Float, const M: usize, const N: usize>(
    phi: &SVector<T, M>,
    jacobian: &SMatrix<T, M, N>,
    rows: &[usize; N],
) -> (SVector<T, N>, SMatrix<T, N, N>) {
    let zero = T::of(0.0);
    let mut square = SMatrix::<T, N, N>::from_element(zero);
    for (column, of_all) in square.data.0.iter_mut().zip(&jacobian.data.0) {
        for (entry, &row) in column.iter_mut().zip(rows) {
            *entry = of_all.get(row).copied().unwrap_or(zero);
        }
    }
    (SVector::from(rows.map(|row| phi.get(row).copied().unwrap_or(zero))), square)
}

/// All equations of a mechanism as one system.
///
/// # Errors
/// Why it was not solved.
pub fn at_once<T: SolverReal, E: Equations<T, N, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    solver: &mut Solver<'_, T, N>,
) -> Result<Coordinates<T, N>, StepError<T>> {
    let block = whole::<T, E, N, N>(core::array::from_fn(|row| row));
    let solved = solver.large(&block, [T::of(0.0); N], |iterate| {
        let (phi, jacobian) = equations.linearize(&iterate.x, t);
        (phi.data.0[0], jacobian.transpose().data.0)
    })?;
    let q = SVector::from(solved.x);
    let rates = |b: SVector<T, N>| SVector::from(solved.solve(b.data.0[0]));
    let qd = rates(equations.nu(&q, t));
    let qdd = rates(equations.gamma(&q, &qd, t));
    Ok(Coordinates { q, qd, qdd })
}

/// Up to this many coordinates a guess is refined with all equations as one dense system.
const LARGEST_WHOLE: usize = 48;

/// A guess of q, refined by Newton's method on all coordinates; the guess itself if that fails.
///
/// Solved together, the equations distribute the error of the guess, and the nearest assembly is found. Solved block by block, the first
/// blocks would pull the later ones away from it.
pub fn refined_guess_at_once<T: Float, E: Equations<T, N, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    guess: &SVector<T, N>,
) -> SVector<T, N> {
    refined_guess_by_rows(equations, &core::array::from_fn(|row| row), t, guess)
}

/// The same for a mechanism with more equations than coordinates, of which those in `rows` are solved.
pub fn refined_guess_by_rows<T: Float, E: Equations<T, M, N> + ?Sized, const M: usize, const N: usize>(
    equations: &E,
    rows: &[usize; N],
    t: T,
    guess: &SVector<T, N>,
) -> SVector<T, N> {
    // A constant condition, so that for large N the dense system is not compiled at all.
    if const { N > LARGEST_WHOLE } {
        return *guess;
    }
    let evaluate = |iterate: &Iterate<T, N>| {
        let (phi, jacobian) = equations.linearize(&iterate.x, t);
        chosen(&phi, &jacobian, rows)
    };
    let part: Part<'_, T, Factors<T, N>, N> = Part {
        evaluate: &evaluate,
        block: &whole::<T, E, M, N>(*rows),
        scale: Scale::of(equations.characteristic_length(), E::COORDINATES),
        sizes: SVector::from_element(T::of(0.0)),
        rows: E::ROWS,
        coordinates: E::COORDINATES,
    };
    newton::refined(&part, &Iterate::at(*guess, &[false; N])).map_or(*guess, |iterate| iterate.x)
}

/// All coordinates and as many equations as one block.
fn whole<T: Real, E: Equations<T, M, N> + ?Sized, const M: usize, const N: usize>(equations: [usize; N]) -> Block<N> {
    let kinds = core::array::from_fn(|index| names::coordinate(E::COORDINATES, index).kind);
    Block { unknowns: core::array::from_fn(|index| index), equations, kinds, needs_sin_cos: [false; N] }
}
