//! P (R A C) Q = L U.

use core::array;

use nalgebra::{SMatrix, SVector};

use super::permuted::exchange;
use crate::number::order::greater;
use crate::number::{DetSign, Float};

/// The factors of one matrix. Matrices of plain arrays are stored by columns: `lu[j][i]` is row i, column j.
#[derive(Clone, Copy, Debug)]
pub struct Factors<T, const N: usize> {
    /// A as given.
    pub(crate) matrix: SMatrix<T, N, N>,
    /// U on and above the diagonal, L below it (its diagonal is 1).
    pub(crate) lu: [[T; N]; N],
    /// R and C, powers of two.
    pub(crate) row_scale: SVector<T, N>,
    pub(crate) column_scale: SVector<T, N>,
    /// Row `rows[i]` and column `columns[j]` of A stand at (i, j) of L U.
    pub(crate) rows: [usize; N],
    pub(crate) columns: [usize; N],
    /// Number of pivots that are not rounding noise; N for a regular matrix.
    pub(crate) rank: usize,
    /// Sign of the determinant; unspecified if the rank is below N.
    pub(crate) orientation: DetSign,
}

/// Where to look for the next pivot.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Pivoting {
    /// Below it in its column.
    Partial,
    /// In the whole remaining matrix, which shows the rank.
    Full,
}

impl<T: Float, const N: usize> Factors<T, N> {
    /// Factors a matrix: with partial pivoting and, if a pivot is rounding noise, again with full pivoting.
    ///
    /// * `matrix`: given, A.
    ///
    /// # Errors
    /// The index of a row that has an entry that is not finite.
    pub(crate) fn new(matrix: &SMatrix<T, N, N>) -> Result<Self, usize> {
        let mut factors = Self::equilibrated(matrix)?;
        let scaled = factors.lu;
        factors.eliminate(Pivoting::Partial);
        if factors.rank < N {
            factors.lu = scaled;
            factors.eliminate(Pivoting::Full);
        }
        Ok(factors)
    }

    /// R A C in place of the factors: the largest entry of each column, then of each row, is brought between 1 and 2.
    ///
    /// Columns come first: an entry of a revolute's row by an angle is an arm, and positions are then scaled by their own arms,
    /// whether these are nanometres or kilometres.
    pub(super) fn equilibrated(matrix: &SMatrix<T, N, N>) -> Result<Self, usize> {
        let (zero, one) = (T::of(0.0), T::of(1.0));
        let mut lu = matrix.data.0;
        let mut column_scale = SVector::<T, N>::from_element(one);
        for (column, scale) in lu.iter_mut().zip(column_scale.iter_mut()) {
            *scale = one / column.iter().fold(zero, |largest, entry| greater(largest, entry.abs())).binade();
            column.iter_mut().for_each(|entry| *entry = *entry * *scale);
        }
        let mut row_scale = SVector::<T, N>::from_element(one);
        for i in 0..N {
            let largest = lu.iter().fold(zero, |largest, column| greater(largest, column[i].abs()));
            if !largest.is_finite() {
                return Err(i);
            }
            row_scale[i] = one / largest.binade();
        }
        for column in &mut lu {
            column.iter_mut().zip(row_scale.iter()).for_each(|(entry, &scale)| *entry = *entry * scale);
        }
        Ok(Self {
            matrix: *matrix,
            lu,
            row_scale,
            column_scale,
            rows: array::from_fn(|i| i),
            columns: array::from_fn(|j| j),
            rank: N,
            orientation: DetSign::Positive,
        })
    }

    /// Gaussian elimination of R A C, ending where no pivot is above rounding noise.
    pub(super) fn eliminate(&mut self, pivoting: Pivoting) {
        // The matrix is equilibrated, so that its entries are about 1 and carry errors of about N ε after elimination.
        let noise = T::of(8.0 * N as f64) * T::EPSILON;
        let mut odd = false;
        self.rows = array::from_fn(|i| i);
        self.columns = array::from_fn(|j| j);
        self.rank = N;

        for k in 0..N {
            let (row, column) = self.pivot(k, pivoting);
            odd ^= (row != k) ^ (column != k);
            self.exchange(k, row, column);
            let pivot = self.lu[k][k];
            if pivot.abs() <= noise {
                self.rank = k;
                return;
            }
            odd ^= pivot < T::of(0.0);
            self.clear_below(k, pivot);
        }
        self.orientation = if odd { DetSign::Negative } else { DetSign::Positive };
    }

    /// The place of the largest entry among the candidates for pivot k.
    fn pivot(&self, k: usize, pivoting: Pivoting) -> (usize, usize) {
        let last = match pivoting {
            Pivoting::Partial => k,
            Pivoting::Full => N - 1,
        };
        let (mut place, mut best) = ((k, k), T::of(-1.0));
        for (j, column) in self.lu.iter().enumerate().take(last + 1).skip(k) {
            for (i, entry) in column.iter().enumerate().skip(k) {
                if entry.abs() > best {
                    (place, best) = ((i, j), entry.abs());
                }
            }
        }
        place
    }

    /// Brings the entry at (`row`, `column`) to the diagonal.
    fn exchange(&mut self, k: usize, row: usize, column: usize) {
        exchange(&mut self.lu, k, column);
        exchange(&mut self.columns, k, column);
        if row != k {
            self.lu.iter_mut().for_each(|column| exchange(column, k, row));
            exchange(&mut self.rows, k, row);
        }
    }

    /// Subtracts row k from those below it so that column k vanishes there; the multipliers, column k of L, stay in its place.
    fn clear_below(&mut self, k: usize, pivot: T) {
        let (done, rest) = self.lu.split_at_mut(k + 1);
        let multipliers = &mut done[k];
        multipliers[k + 1..].iter_mut().for_each(|entry| *entry = *entry / pivot);
        for column in rest {
            let factor = column[k];
            if factor == T::of(0.0) {
                continue;
            }
            for (entry, &multiplier) in column[k + 1..].iter_mut().zip(&multipliers[k + 1..]) {
                *entry = *entry - multiplier * factor;
            }
        }
    }
}
