//! One to three equations in closed form: A⁻¹ by cofactors.

use nalgebra::{SMatrix, SVector};

use super::{Factors, Linear};
use crate::order::greater;
use crate::{Float, Orientation};

/// The inverse of a matrix of up to three rows, from its adjugate and its determinant.
///
/// Cofactors are sums of two products at most, so that the inverse is as good as the condition allows; with three rows velocities
/// and accelerations get a step of refinement on top.
#[derive(Clone, Copy, Debug)]
pub struct Small<T, const N: usize> {
    matrix: SMatrix<T, N, N>,
    inverse: SMatrix<T, N, N>,
    determinant: T,
    /// The determinant's expansion with all terms positive: what its rounding errors are a share of.
    magnitude: T,
}

/// Up to this size x is a quotient of two determinants of two products each, which are as good as they can be (Higham: Accuracy
/// and Stability of Numerical Algorithms, 1.10.1); a refinement would not change them.
const EXACT: usize = 2;

/// A determinant below this many roundings of its terms is noise.
const NOISE: f64 = 8.0;

impl<T: Float, const N: usize> Linear<T, N> for Small<T, N> {
    type Matrix = SMatrix<T, N, N>;

    #[inline(always)]
    fn factor(matrix: &SMatrix<T, N, N>) -> Result<Self, usize> {
        let adjugate = adjugate(matrix);
        let zero = T::of(0.0);
        // The expansion along the first row; every row gives the same but for rounding.
        let determinant = (1..N).fold(matrix[(0, 0)] * adjugate[(0, 0)], |sum, j| sum + matrix[(0, j)] * adjugate[(j, 0)]);
        let magnitude = (0..N).fold(zero, |sum, j| sum + (matrix[(0, j)] * adjugate[(j, 0)]).abs());
        let share = T::of(1.0) / determinant;
        Ok(Self { matrix: *matrix, inverse: adjugate.map(|cofactor| cofactor * share), determinant, magnitude })
    }

    fn dense(matrix: &SMatrix<T, N, N>) -> SMatrix<T, N, N> {
        *matrix
    }

    #[inline(always)]
    fn solve(&self, b: &SVector<T, N>) -> SVector<T, N> {
        if !self.is_regular() {
            return self.basic_solution(b);
        }
        SVector::from_fn(|i, _| (1..N).fold(self.inverse[(i, 0)] * b[0], |sum, k| sum + self.inverse[(i, k)] * b[k]))
    }

    #[inline(always)]
    fn solve_refined(&self, b: &SVector<T, N>) -> SVector<T, N> {
        let x = self.solve(b);
        if N <= EXACT {
            return x;
        }
        let residual = SVector::from_fn(|i, _| (0..N).fold(b[i], |rest, j| rest - self.matrix[(i, j)] * x[j]));
        let correction = self.solve(&residual);
        SVector::from_fn(|i, _| x[i] + correction[i])
    }

    #[inline(always)]
    fn condition(&self, sizes: &SVector<T, N>, shares: &SVector<T, N>) -> T {
        if !self.is_regular() {
            return T::of(f64::INFINITY);
        }
        (0..N).fold(T::of(1.0), |largest, i| {
            let growth = (0..N).fold(T::of(0.0), |sum, k| sum + self.inverse[(i, k)].abs() * sizes[k]);
            greater(largest, growth * shares[i])
        })
    }

    #[inline(always)]
    fn orientation(&self) -> Orientation {
        if self.determinant < T::of(0.0) { Orientation::Negative } else { Orientation::Positive }
    }

    #[inline(always)]
    fn is_regular(&self) -> bool {
        self.determinant.abs() > T::of(NOISE) * T::EPSILON * self.magnitude
    }
}

impl<T: Float, const N: usize> Small<T, N> {
    /// With a singular matrix: what full pivoting makes of it, so that Newton's method can leave a singular position.
    #[cold]
    fn basic_solution(&self, b: &SVector<T, N>) -> SVector<T, N> {
        let nothing = SVector::from_element(T::of(f64::NAN));
        Factors::new(&self.matrix).map_or(nothing, |factors| factors.solve(b))
    }
}

/// adj A, with A adj A = det A.
#[inline(always)]
fn adjugate<T: Float, const N: usize>(a: &SMatrix<T, N, N>) -> SMatrix<T, N, N> {
    let minor = |i: usize, j: usize| match N {
        1 => T::of(1.0),
        2 => {
            let entry = a[(1 - i, 1 - j)];
            if i == j { entry } else { -entry }
        }
        // Cyclic indices give the sign of the cofactor by themselves.
        _ => {
            let ([i1, i2], [j1, j2]) = ([(i + 1) % 3, (i + 2) % 3], [(j + 1) % 3, (j + 2) % 3]);
            a[(i1, j1)] * a[(i2, j2)] - a[(i1, j2)] * a[(i2, j1)]
        }
    };
    SMatrix::from_fn(|i, j| minor(j, i))
}
