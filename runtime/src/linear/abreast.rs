//! Many right-hand sides at once: each step is done for all of them before the next one.

use super::permuted::{entry, put};
use super::small::EXACT;
use super::{Factors, Linear, Small};
use crate::number::Float;

/// Factors that solve many right-hand sides at once.
pub trait Abreast<T: Float, const N: usize>: Linear<T, N> {
    /// X of A X = B as by [`solve_refined`](Linear::solve_refined), column by column; unspecified if A is singular.
    ///
    /// * `b`: given, B by rows.
    fn solve_abreast<const P: usize>(&self, b: &[[T; P]; N]) -> [[T; P]; N];
}

impl<T: Float, const N: usize> Abreast<T, N> for Small<T, N> {
    #[inline(always)]
    fn solve_abreast<const P: usize>(&self, b: &[[T; P]; N]) -> [[T; P]; N] {
        let mut x = self.solve_columns(b);
        if N > EXACT {
            let correction = self.solve_columns(&residual(&self.matrix.data.0, b, &x));
            add(&mut x, &correction);
        }
        x
    }
}

impl<T: Float, const N: usize> Small<T, N> {
    #[inline(always)]
    fn solve_columns<const P: usize>(&self, b: &[[T; P]; N]) -> [[T; P]; N] {
        let mut x = [[T::ZERO; P]; N];
        for i in 0..N {
            for p in 0..P {
                x[i][p] = (1..N).fold(self.adjugate[(i, 0)] * b[0][p], |sum, k| sum + self.adjugate[(i, k)] * b[k][p]) * self.reciprocal;
            }
        }
        x
    }
}

impl<T: Float, const N: usize> Abreast<T, N> for Factors<T, N> {
    fn solve_abreast<const P: usize>(&self, b: &[[T; P]; N]) -> [[T; P]; N] {
        let mut x = self.solve_columns(b);
        let correction = self.solve_columns(&residual(&self.matrix.data.0, b, &x));
        add(&mut x, &correction);
        x
    }
}

impl<T: Float, const N: usize> Factors<T, N> {
    /// Of a regular matrix; what belongs to no pivot of another is zero.
    fn solve_columns<const P: usize>(&self, b: &[[T; P]; N]) -> [[T; P]; N] {
        let rank = self.rank.min(N);
        let mut y = [[T::ZERO; P]; N];
        for (y, &row) in y.iter_mut().zip(&self.rows) {
            let scale = entry(self.row_scale.as_slice(), row);
            if let Some(b) = b.get(row) {
                *y = *b;
            }
            y.iter_mut().for_each(|y| *y = *y * scale);
        }
        for k in 0..rank {
            let known = y[k];
            for i in k + 1..rank {
                subtract(&mut y[i], self.lu[k][i], &known);
            }
        }
        for k in (0..rank).rev() {
            let pivot = self.lu[k][k];
            y[k].iter_mut().for_each(|y| *y = *y / pivot);
            let known = y[k];
            for i in 0..k {
                subtract(&mut y[i], self.lu[k][i], &known);
            }
        }
        let mut x = [[T::ZERO; P]; N];
        for (mut y, &column) in y.into_iter().zip(&self.columns).take(rank) {
            let scale = entry(self.column_scale.as_slice(), column);
            y.iter_mut().for_each(|y| *y = *y * scale);
            put(&mut x, column, y);
        }
        x
    }
}

/// B − A X, with A by columns.
#[inline(always)]
fn residual<T: Float, const N: usize, const P: usize>(matrix: &[[T; N]; N], b: &[[T; P]; N], x: &[[T; P]; N]) -> [[T; P]; N] {
    let mut rest = *b;
    for (column, known) in matrix.iter().zip(x) {
        for (rest, &factor) in rest.iter_mut().zip(column) {
            subtract(rest, factor, known);
        }
    }
    rest
}

/// Subtracts a multiple of another row.
#[inline(always)]
fn subtract<T: Float, const P: usize>(row: &mut [T; P], factor: T, other: &[T; P]) {
    for (entry, &other) in row.iter_mut().zip(other) {
        *entry = *entry - factor * other;
    }
}

#[inline(always)]
fn add<T: Float, const N: usize, const P: usize>(x: &mut [[T; P]; N], correction: &[[T; P]; N]) {
    for (x, correction) in x.iter_mut().zip(correction) {
        for (x, &correction) in x.iter_mut().zip(correction) {
            *x = *x + correction;
        }
    }
}
