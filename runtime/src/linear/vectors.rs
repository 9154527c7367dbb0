//! Vectors, and orders of their entries.
//!
//! These functions are compiled once for each length; closures in functions of a mechanism would be compiled once for each mechanism.

use nalgebra::{ArrayStorage, SMatrix, SVector};

use crate::number::{Real, Scalar};

/// x + h y
pub(crate) fn moved<T: Real, const N: usize>(x: &SVector<T, N>, h: T, y: &SVector<T, N>) -> SVector<T, N> {
    SVector::from_fn(|k, _| x[k] + h * y[k])
}

/// x − y
pub(crate) fn difference<T: Real, const N: usize>(x: &SVector<T, N>, y: &SVector<T, N>) -> SVector<T, N> {
    SVector::from_fn(|k, _| x[k] - y[k])
}

/// s x
pub(crate) fn scaled<T: Real, const N: usize>(x: &SVector<T, N>, s: T) -> SVector<T, N> {
    x.map(|entry| s * entry)
}

/// x / s
pub(crate) fn divided<T: Real, const N: usize>(x: &SVector<T, N>, s: T) -> SVector<T, N> {
    x.map(|entry| entry / s)
}

/// A x, without an index that could be out of bounds.
pub(crate) fn product<T: Real, const N: usize>(matrix: &SMatrix<T, N, N>, x: &SVector<T, N>) -> SVector<T, N> {
    let mut product = SVector::<T, N>::from_element(T::of(0.0));
    for (column, &factor) in matrix.data.0.iter().zip(x.iter()) {
        for (sum, &entry) in product.iter_mut().zip(column) {
            *sum = *sum + entry * factor;
        }
    }
    product
}

/// The order 0, 1, 2 … of a list that is not rearranged.
pub(crate) fn unpermuted<const K: usize>() -> [usize; K] {
    let mut numbers = [0; K];
    for (number, entry) in numbers.iter_mut().enumerate() {
        *entry = number;
    }
    numbers
}

/// A matrix of zeros, made where it is wanted: large ones are costly to move.
#[inline(always)]
#[must_use]
pub fn zeros<T: Scalar, const R: usize, const C: usize>() -> SMatrix<T, R, C> {
    SMatrix::from_array_storage(ArrayStorage([[T::ZERO; R]; C]))
}
