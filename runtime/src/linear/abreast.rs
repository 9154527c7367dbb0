//! Many right-hand sides at once: each step of the substitution is done for all of them before the next step.

use super::elimination::substitute_rows;
use super::permuted::{entry, put};
use super::small::EXACT;
use super::{Elimination, Factors, Linear, Small, Sparse};
use crate::number::{Float, row};

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
        for (i, x) in x.iter_mut().enumerate() {
            // An entry of the inverse.
            let of = |k: usize| self.adjugate[(i, k)] * self.reciprocal;
            *x = match N {
                1 => row::scaled(of(0), &b[0]),
                2 => row::combined(of(0), of(1), &b[0], &b[1]),
                _ => row::less(-of(2), &row::combined(of(0), of(1), &b[0], &b[1]), &b[2]),
            };
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
    /// For a regular matrix; with a lower rank, unknowns without a pivot are zero.
    fn solve_columns<const P: usize>(&self, b: &[[T; P]; N]) -> [[T; P]; N] {
        let rank = self.rank.min(N);
        let mut y = [[T::ZERO; P]; N];
        for (y, &row) in y.iter_mut().zip(&self.rows) {
            let scale = entry(self.row_scale.as_slice(), row);
            if let Some(b) = b.get(row) {
                *y = *b;
            }
            *y = row::scaled(scale, y);
        }
        for k in 0..rank {
            let known = y[k];
            for (y, &multiplier) in y.iter_mut().zip(&self.lu[k]).take(rank).skip(k + 1) {
                *y = row::less(multiplier, y, &known);
            }
        }
        for k in (0..rank).rev() {
            let pivot = self.lu[k][k];
            y[k].iter_mut().for_each(|y| *y = *y / pivot);
            let known = y[k];
            for (y, &entry) in y.iter_mut().zip(&self.lu[k]).take(k) {
                *y = row::less(entry, y, &known);
            }
        }
        let mut x = [[T::ZERO; P]; N];
        for (y, &column) in y.iter().zip(&self.columns).take(rank) {
            let scale = entry(self.column_scale.as_slice(), column);
            put(&mut x, column, row::scaled(scale, y));
        }
        x
    }
}

impl<T, E, const K: usize, const ENTRIES: usize, const FACTORS: usize> Abreast<T, K> for Sparse<T, E, K, ENTRIES, FACTORS>
where
    T: Float,
    E: Elimination<T, K, ENTRIES, FACTORS>,
{
    fn solve_abreast<const P: usize>(&self, b: &[[T; P]; K]) -> [[T; P]; K] {
        if !self.is_stable {
            return self.pivoted().map_or([[T::of(f64::NAN); P]; K], |factors| factors.solve_abreast(b));
        }
        let solve = |b: &[[T; P]; K]| substitute_rows::<T, E, K, ENTRIES, FACTORS, P>(&self.lu, b);
        let mut x = solve(b);
        if self.is_tight {
            return x;
        }
        let mut rest = *b;
        for (&entry, &(i, j)) in self.matrix.values.iter().zip(&E::ORDER.pattern) {
            if let (Some(rest), Some(known)) = (rest.get_mut(i), x.get(j)) {
                *rest = row::less(entry, rest, known);
            }
        }
        add(&mut x, &solve(&rest));
        x
    }
}

/// B − A X, with A by columns.
#[inline(always)]
fn residual<T: Float, const N: usize, const P: usize>(matrix: &[[T; N]; N], b: &[[T; P]; N], x: &[[T; P]; N]) -> [[T; P]; N] {
    let mut rest = *b;
    for (column, known) in matrix.iter().zip(x) {
        for (rest, &factor) in rest.iter_mut().zip(column) {
            *rest = row::less(factor, rest, known);
        }
    }
    rest
}

#[inline(always)]
fn add<T: Float, const N: usize, const P: usize>(x: &mut [[T; P]; N], correction: &[[T; P]; N]) {
    for (x, correction) in x.iter_mut().zip(correction) {
        *x = row::sum(x, correction);
    }
}
