//! Factors of small dense matrices.
//!
//! LU with complete pivoting measures how close a matrix is to singular. Cholesky tests whether a symmetric matrix is positive definite, so
//! that the step it yields is a descent direction.
//!
//! Reference: Golub, Van Loan, Matrix Computations, sections 3.4 and 4.2.

/// P A Q = L U; each pivot is the largest remaining entry.
pub(crate) struct Factors {
    lu: Vec<Vec<f64>>,
    rows: Vec<usize>,
    columns: Vec<usize>,
    /// Sign of det A; 0 if A is singular.
    pub(crate) sign: f64,
    /// ln |det A|
    pub(crate) size: f64,
    /// Smallest |pivot|; infinite for an empty matrix.
    pub(crate) smallest_pivot: f64,
}

impl Factors {
    /// Factorises A; `None` if a pivot is not finite.
    pub(crate) fn new(mut a: Vec<Vec<f64>>) -> Option<Factors> {
        let n = a.len();
        let (mut sign, mut size, mut smallest_pivot) = (1.0, 0.0, f64::INFINITY);
        let (mut rows, mut columns): (Vec<usize>, Vec<usize>) = ((0..n).collect(), (0..n).collect());
        for k in 0..n {
            let (row, column) = largest(&a, k);
            if row != k {
                a.swap(k, row);
                rows.swap(k, row);
                sign = -sign;
            }
            if column != k {
                a.iter_mut().for_each(|row| row.swap(k, column));
                columns.swap(k, column);
                sign = -sign;
            }
            let (done, rest) = a.split_at_mut(k + 1);
            let pivot = done[k][k];
            if !pivot.is_finite() {
                return None;
            }
            sign *= if pivot == 0.0 { 0.0 } else { pivot.signum() };
            size += pivot.abs().ln();
            smallest_pivot = smallest_pivot.min(pivot.abs());
            for row in rest {
                if row[k] != 0.0 {
                    row[k] /= pivot;
                    let multiplier = row[k];
                    row[k + 1..].iter_mut().zip(&done[k][k + 1..]).for_each(|(entry, above)| *entry -= multiplier * above);
                }
            }
        }
        Some(Factors { lu: a, rows, columns, sign, size, smallest_pivot })
    }

    /// A⁻¹ b; `None` if A is singular.
    pub(crate) fn solve(&self, b: &[f64]) -> Option<Vec<f64>> {
        let n = b.len();
        let mut y: Vec<f64> = self.rows.iter().map(|row| b[*row]).collect();
        for k in 0..n {
            let known: f64 = (0..k).map(|j| self.lu[k][j] * y[j]).sum();
            y[k] -= known;
        }
        for k in (0..n).rev() {
            let known: f64 = (k + 1..n).map(|j| self.lu[k][j] * y[j]).sum();
            y[k] = (y[k] - known) / self.lu[k][k];
        }
        let mut x = vec![0.0; n];
        self.columns.iter().zip(y).for_each(|(column, value)| x[*column] = value);
        x.iter().all(|value| value.is_finite()).then_some(x)
    }
}

/// Row and column of the entry of largest magnitude in the remaining submatrix; NaN counts as largest.
fn largest(a: &[Vec<f64>], k: usize) -> (usize, usize) {
    let (mut place, mut most) = ((k, k), a[k][k].abs());
    for (i, row) in a.iter().enumerate().skip(k) {
        for (j, entry) in row.iter().enumerate().skip(k) {
            if entry.abs() > most || entry.is_nan() {
                (place, most) = ((i, j), entry.abs());
            }
        }
    }
    place
}

/// A⁻¹ b; `None` if A is singular or has entries that are not finite.
pub(crate) fn solve(a: Vec<Vec<f64>>, b: &[f64]) -> Option<Vec<f64>> {
    Factors::new(a)?.solve(b)
}

/// Solves A x = b for a symmetric A, of which only the lower half is read; `None` if A is not positive definite.
pub(crate) fn cholesky(mut matrix: Vec<Vec<f64>>, mut right: Vec<f64>) -> Option<Vec<f64>> {
    let n = right.len();
    for i in 0..n {
        for j in 0..=i {
            let sum: f64 = (0..j).map(|k| matrix[i][k] * matrix[j][k]).sum();
            let value = matrix[i][j] - sum;
            if i == j {
                if value <= 0.0 || !value.is_finite() {
                    return None;
                }
                matrix[i][i] = value.sqrt();
            } else {
                matrix[i][j] = value / matrix[j][j];
            }
        }
    }
    for i in 0..n {
        let sum: f64 = (0..i).map(|k| matrix[i][k] * right[k]).sum();
        right[i] = (right[i] - sum) / matrix[i][i];
    }
    for i in (0..n).rev() {
        let sum: f64 = (i + 1..n).map(|k| matrix[k][i] * right[k]).sum();
        right[i] = (right[i] - sum) / matrix[i][i];
    }
    Some(right)
}
