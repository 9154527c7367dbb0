//! Integrated entries of the vectors of a state.

use nalgebra::SVector;

use crate::number::Scalar;

/// Some entries of a vector.
#[inline(always)]
pub(super) fn picked<T: Scalar, const N: usize, const I: usize>(vector: &SVector<T, N>, places: &[usize; I]) -> [T; I] {
    places.map(|place| vector.get(place).copied().unwrap_or(T::ZERO))
}

/// Writes some entries of a vector.
#[inline(always)]
pub(super) fn put<T: Scalar, const N: usize, const I: usize>(vector: &mut SVector<T, N>, places: &[usize; I], values: &[T; I]) {
    for (place, value) in places.iter().zip(values) {
        if let Some(entry) = vector.get_mut(*place) {
            *entry = *value;
        }
    }
}

/// True if all entries are finite. Without branches, so that the processor compares several at a time.
#[inline(always)]
pub(super) fn is_finite<T: Scalar, const N: usize>(vector: &SVector<T, N>) -> bool {
    vector.as_slice().iter().fold(true, |all, value| all & value.is_finite())
}

/// The largest of some numbers, each divided by its length.
pub(super) fn largest<T: Scalar, const I: usize>(values: &[T; I], lengths: &[T; I]) -> T {
    values.iter().zip(lengths).fold(T::ZERO, |largest, (value, length)| largest.max((*value / *length).abs()))
}
