//! All equations of a mechanism as one system.

use nalgebra::{SMatrix, SVector};

use super::{Equations, Solver, SolverReal};
use crate::linear::Factors;
use crate::names::{self, Coordinate, Row};
use crate::newton::{self, Block, Iterate, Problem, Scale, StepError};
use crate::number::Float;
use crate::state::Coordinates;

/// A square selection of a mechanism's equations at one time.
struct Chosen<'a, E: ?Sized, T, const M: usize, const N: usize> {
    equations: &'a E,
    /// Their indices in Φ.
    rows: &'a [usize; N],
    t: T,
    scale: Scale<T, N>,
}

impl<T: Float, E: Equations<T, M, N> + ?Sized, const M: usize, const N: usize> Problem<T, N> for Chosen<'_, E, T, M, N> {
    type Factors = Factors<T, N>;

    fn linearize(&self, iterate: &Iterate<T, N>) -> (SVector<T, N>, SMatrix<T, N, N>) {
        let (phi, jacobian) = self.equations.linearize(&iterate.x, self.t);
        chosen(&phi, &jacobian, self.rows)
    }

    fn needs_sin_cos(&self) -> &[bool; N] {
        &[false; N]
    }

    fn scale(&self) -> &Scale<T, N> {
        &self.scale
    }

    fn sizes(&self) -> SVector<T, N> {
        SVector::from_element(T::of(0.0))
    }

    fn row(&self, index: usize) -> Row {
        names::row(E::ROWS, self.rows.get(index).copied().unwrap_or(index))
    }

    fn coordinate(&self, index: usize) -> Coordinate {
        names::coordinate(E::COORDINATES, index)
    }
}

/// Some rows of Φ and Φ_q. A row that does not exist is zero, and the matrix is singular.
fn chosen<T: Float, const M: usize, const N: usize>(
    phi: &SVector<T, M>,
    jacobian: &SMatrix<T, M, N>,
    rows: &[usize; N],
) -> (SVector<T, N>, SMatrix<T, N, N>) {
    let (is_row, zero) = (|i: usize| rows[i] < M, T::of(0.0));
    (
        SVector::from_fn(|i, _| if is_row(i) { phi[rows[i]] } else { zero }),
        SMatrix::from_fn(|i, j| if is_row(i) { jacobian[(rows[i], j)] } else { zero }),
    )
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
    let all = core::array::from_fn(|index| index);
    let kinds = core::array::from_fn(|index| names::coordinate(E::COORDINATES, index).kind);
    let block = Block { unknowns: all, equations: all, kinds, needs_sin_cos: [false; N] };
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
    let chosen = Chosen { equations, rows, t, scale: Scale::of(equations) };
    newton::solve_from_guess(&chosen, &Iterate::at(*guess, chosen.needs_sin_cos())).map_or(*guess, |position| position.iterate.x)
}
