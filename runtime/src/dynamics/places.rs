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

/// x + h y
#[inline(always)]
pub(super) fn moved<T: Scalar, const I: usize>(x: &[T; I], h: T, y: &[T; I]) -> [T; I] {
    core::array::from_fn(|k| x[k] + h * y[k])
}

/// True if all entries are finite. A finite sum has finite terms; each is looked at only where the sum is not. Four sums, which the processor
/// forms at a time.
#[inline(always)]
pub(super) fn is_finite<T: Scalar, const N: usize>(vector: &SVector<T, N>) -> bool {
    let mut sums = [T::ZERO; 4];
    let fours = vector.as_slice().chunks_exact(4);
    let rest = fours.remainder().iter().fold(T::ZERO, |sum, value| sum + *value);
    for four in fours {
        sums = core::array::from_fn(|k| sums[k] + four[k]);
    }
    let sum = (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest;
    sum.is_finite() || vector.as_slice().iter().all(|value| value.is_finite())
}

/// The largest of some numbers, each divided by its length.
pub(super) fn largest<T: Scalar, const I: usize>(values: &[T; I], lengths: &[T; I]) -> T {
    values.iter().zip(lengths).fold(T::ZERO, |largest, (value, length)| largest.max((*value / *length).abs()))
}
