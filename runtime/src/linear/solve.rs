//! Right-hand sides: x = C Q U⁻¹ L⁻¹ P R b.

use nalgebra::{SMatrix, SVector};

use super::permuted::{entry, put};
use super::{Factors, Linear};
use crate::number::{DetSign, Float};

impl<T: Float, const N: usize> Linear<T, N> for Factors<T, N> {
    type Matrix = SMatrix<T, N, N>;

    fn factor(matrix: &SMatrix<T, N, N>) -> Result<Self, usize> {
        Factors::new(matrix)
    }

    fn dense(matrix: &SMatrix<T, N, N>) -> SMatrix<T, N, N> {
        *matrix
    }

    fn solve_regular(&self, b: &SVector<T, N>) -> SVector<T, N> {
        self.solve(b)
    }

    /// A x = b. With rank r below N: a basic solution, fulfilling r independent rows with the other N − r unknowns zero.
    ///
    /// * `b`: given, by row.
    /// * returned: x, by column; not finite where b is not.
    fn solve(&self, b: &SVector<T, N>) -> SVector<T, N> {
        let rank = self.rank.min(N);
        let mut y = SVector::<T, N>::from_fn(|i, _| entry(b.as_slice(), self.rows[i]) * entry(self.row_scale.as_slice(), self.rows[i]));
        for k in 0..rank {
            let known = y[k];
            for i in k + 1..rank {
                y[i] = y[i] - self.lu[k][i] * known;
            }
        }
        self.substitute_back(&mut y);
        let mut x = SVector::<T, N>::from_element(T::of(0.0));
        for (k, &column) in self.columns.iter().enumerate().take(rank) {
            put(x.as_mut_slice(), column, y[k] * entry(self.column_scale.as_slice(), column));
        }
        x
    }

    /// A x = b with one step of iterative refinement: the residual b − A x is solved for as well and added.
    ///
    /// In working precision this makes x as good as if the largest error were one rounding of each entry of A (Skeel 1980).
    fn solve_refined(&self, b: &SVector<T, N>) -> SVector<T, N> {
        let x = self.solve(b);
        let residual = SVector::from_fn(|i, _| (0..N).fold(b[i], |rest, j| rest - self.matrix[(i, j)] * x[j]));
        let correction = self.solve(&residual);
        SVector::from_fn(|i, _| x[i] + correction[i])
    }

    fn error_amplification(&self, sizes: &SVector<T, N>, _: &SVector<T, N>) -> T {
        self.error_amplification_by(sizes, &self.column_scale, &self.column_scale.map(|scale| T::of(1.0) / scale))
    }

    fn det_sign(&self) -> DetSign {
        self.orientation
    }

    fn is_regular(&self) -> bool {
        self.rank == N
    }
}

impl<T: Float, const N: usize> Factors<T, N> {
    /// y ← U⁻¹ y, as far as the rank goes.
    pub(super) fn substitute_back(&self, y: &mut SVector<T, N>) {
        for k in (0..self.rank.min(N)).rev() {
            let known = y[k] / self.lu[k][k];
            y[k] = known;
            for i in 0..k {
                y[i] = y[i] - self.lu[k][i] * known;
            }
        }
    }
}
