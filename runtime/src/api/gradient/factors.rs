//! Factors of a matrix of numbers, and the derivatives of its entries: A ∂x = ∂b − ∂A x.

use nalgebra::{SMatrix, SVector};

use super::Gradient;
use crate::linear::{Abreast, Linear};
use crate::number::{DetSign, Float};

/// The factors `F` of a matrix of numbers, with the derivatives of its entries. All parameters are right-hand sides of the same factors.
#[derive(Clone, Copy, Debug)]
pub struct GradientFactors<T, F, const P: usize, const K: usize> {
    factors: F,
    matrix: SMatrix<Gradient<T, P>, K, K>,
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

impl<T, F, const P: usize, const K: usize> Linear<Gradient<T, P>, K> for GradientFactors<T, F, P, K>
where
    T: Float,
    F: Abreast<T, K> + Linear<T, K, Matrix = SMatrix<T, K, K>>,
{
    type Matrix = SMatrix<Gradient<T, P>, K, K>;

    #[inline(always)]
    fn factor(matrix: &Self::Matrix) -> Result<Self, usize> {
        let mut values = SMatrix::<T, K, K>::from_element(T::ZERO);
        for (value, entry) in values.iter_mut().zip(matrix) {
            *value = entry.value;
        }
        Ok(Self { factors: F::factor(&values)?, matrix: *matrix })
    }

    #[inline(always)]
    fn dense(matrix: &Self::Matrix) -> Self::Matrix {
        *matrix
    }

    #[inline(always)]
    fn solve_regular(&self, b: &SVector<Gradient<T, P>, K>) -> SVector<Gradient<T, P>, K> {
        let x = self.factors.solve_refined(&values(b));
        let mut rest = derivatives(b);
        for i in 0..K {
            for j in 0..K {
                for (rest, &by) in rest[i].iter_mut().zip(&self.matrix[(i, j)].by) {
                    *rest = *rest - by * x[j];
                }
            }
        }
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
