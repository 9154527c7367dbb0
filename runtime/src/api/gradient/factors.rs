//! Factors of a matrix of numbers, and the derivatives of its entries: A ∂x = ∂b − ∂A x.

use core::fmt;
use core::marker::PhantomData;

use nalgebra::{SMatrix, SVector};

use super::Gradient;
use crate::linear::{Abreast, Elimination, Entries, Linear, Sparse};
use crate::number::{DetSign, Float, row};

/// Factors `F` of a matrix of numbers, with the derivatives of its entries. All parameters are right-hand sides of the same factors.
#[derive(Clone, Copy, Debug)]
pub struct GradientFactors<T: Float, F, S: Storage<T, P, K>, const P: usize, const K: usize> {
    factors: F,
    matrix: S::Matrix,
}

/// Storage format of a matrix.
pub trait Storage<T: Float, const P: usize, const K: usize>: 'static {
    /// A matrix of numbers with derivatives.
    type Matrix: Copy + fmt::Debug + 'static;

    /// A matrix of numbers.
    type Values: 'static;

    /// The matrix without derivatives.
    fn values(matrix: &Self::Matrix) -> Self::Values;

    /// The dense matrix.
    fn dense(matrix: &Self::Matrix) -> SMatrix<Gradient<T, P>, K, K>;

    /// Subtracts ∂A x.
    fn subtract(matrix: &Self::Matrix, x: &SVector<T, K>, from: &mut [[T; P]; K]);
}

/// All entries of a matrix.
#[derive(Clone, Copy, Debug)]
pub struct Whole;

impl<T: Float, const P: usize, const K: usize> Storage<T, P, K> for Whole {
    type Matrix = SMatrix<Gradient<T, P>, K, K>;
    type Values = SMatrix<T, K, K>;

    #[inline(always)]
    fn values(matrix: &Self::Matrix) -> SMatrix<T, K, K> {
        let mut values = SMatrix::<T, K, K>::from_element(T::ZERO);
        for (value, entry) in values.iter_mut().zip(matrix) {
            *value = entry.value;
        }
        values
    }

    #[inline(always)]
    fn dense(matrix: &Self::Matrix) -> Self::Matrix {
        *matrix
    }

    #[inline(always)]
    fn subtract(matrix: &Self::Matrix, x: &SVector<T, K>, from: &mut [[T; P]; K]) {
        for i in 0..K {
            for j in 0..K {
                from[i] = row::less(x[j], &from[i], &matrix[(i, j)].by);
            }
        }
    }
}

/// The entries in the pattern of the elimination `E`.
#[derive(Clone, Copy, Debug)]
pub struct Pattern<E, const ENTRIES: usize, const FACTORS: usize>(PhantomData<E>);

impl<T, E, const P: usize, const K: usize, const ENTRIES: usize, const FACTORS: usize> Storage<T, P, K> for Pattern<E, ENTRIES, FACTORS>
where
    T: Float,
    E: Elimination<Gradient<T, P>, K, ENTRIES, FACTORS>,
{
    type Matrix = Entries<Gradient<T, P>, K, ENTRIES>;
    type Values = Entries<T, K, ENTRIES>;

    #[inline]
    fn values(matrix: &Self::Matrix) -> Entries<T, K, ENTRIES> {
        let mut entries = Entries { values: [T::ZERO; ENTRIES], columns: [T::ZERO; K] };
        for (value, entry) in entries.values.iter_mut().zip(&matrix.values) {
            *value = entry.value;
        }
        for (value, entry) in entries.columns.iter_mut().zip(&matrix.columns) {
            *value = entry.value;
        }
        entries
    }

    fn dense(matrix: &Self::Matrix) -> SMatrix<Gradient<T, P>, K, K> {
        Sparse::<Gradient<T, P>, E, K, ENTRIES, FACTORS>::dense(matrix)
    }

    #[inline]
    fn subtract(matrix: &Self::Matrix, x: &SVector<T, K>, from: &mut [[T; P]; K]) {
        for (entry, &(i, j)) in matrix.values.iter().zip(&E::ORDER.pattern) {
            if let (Some(from), Some(&x)) = (from.get_mut(i), x.get(j)) {
                *from = row::less(x, from, &entry.by);
            }
        }
    }
}

/// The numbers of a vector, without their derivatives.
#[inline(always)]
fn values<T: Float, const P: usize, const K: usize>(b: &SVector<Gradient<T, P>, K>) -> SVector<T, K> {
    let mut values = SVector::<T, K>::from_element(T::ZERO);
    for (value, entry) in values.iter_mut().zip(b) {
        *value = entry.value;
    }
    values
}

/// The derivatives of a vector.
#[inline(always)]
fn derivatives<T: Float, const P: usize, const K: usize>(b: &SVector<Gradient<T, P>, K>) -> [[T; P]; K] {
    let mut derivatives = [[T::ZERO; P]; K];
    for (by, entry) in derivatives.iter_mut().zip(b) {
        *by = entry.by;
    }
    derivatives
}

/// Numbers with their derivatives.
#[inline(always)]
fn together<T: Float, const P: usize, const K: usize>(values: &SVector<T, K>, derivatives: &[[T; P]; K]) -> SVector<Gradient<T, P>, K> {
    let mut x = SVector::<Gradient<T, P>, K>::from_element(Gradient::constant(T::ZERO));
    for ((entry, &value), &by) in x.iter_mut().zip(values).zip(derivatives) {
        *entry = Gradient { value, by };
    }
    x
}

impl<T, F, S, const P: usize, const K: usize> Linear<Gradient<T, P>, K> for GradientFactors<T, F, S, P, K>
where
    T: Float,
    S: Storage<T, P, K>,
    F: Abreast<T, K> + Linear<T, K, Matrix = S::Values>,
{
    type Matrix = S::Matrix;

    #[inline(always)]
    fn factor(matrix: &Self::Matrix) -> Result<Self, usize> {
        Ok(Self { factors: F::factor(&S::values(matrix))?, matrix: *matrix })
    }

    #[inline(always)]
    fn dense(matrix: &Self::Matrix) -> SMatrix<Gradient<T, P>, K, K> {
        S::dense(matrix)
    }

    #[inline(always)]
    fn solve_regular(&self, b: &SVector<Gradient<T, P>, K>) -> SVector<Gradient<T, P>, K> {
        let x = self.factors.solve_refined(&values(b));
        let mut rest = derivatives(b);
        S::subtract(&self.matrix, &x, &mut rest);
        together(&x, &self.factors.solve_abreast(&rest))
    }

    #[inline(always)]
    fn solve(&self, b: &SVector<Gradient<T, P>, K>) -> SVector<Gradient<T, P>, K> {
        self.solve_regular(b)
    }

    #[inline(always)]
    fn solve_refined(&self, b: &SVector<Gradient<T, P>, K>) -> SVector<Gradient<T, P>, K> {
        self.solve_regular(b)
    }

    #[inline(always)]
    fn solve_as_constant(&self, b: &SVector<Gradient<T, P>, K>) -> SVector<Gradient<T, P>, K> {
        together(&self.factors.solve_refined(&values(b)), &self.factors.solve_abreast(&derivatives(b)))
    }

    #[inline(always)]
    fn with_derivatives_of(self, matrix: &Self::Matrix) -> Result<Self, usize> {
        Ok(Self { factors: self.factors, matrix: *matrix })
    }

    fn error_amplification(&self, sizes: &SVector<Gradient<T, P>, K>, reciprocals: &SVector<Gradient<T, P>, K>) -> Gradient<T, P> {
        Gradient::constant(self.factors.error_amplification(&values(sizes), &values(reciprocals)))
    }

    fn det_sign(&self) -> DetSign {
        self.factors.det_sign()
    }

    #[inline(always)]
    fn is_regular(&self) -> bool {
        self.factors.is_regular()
    }
}
