//! Integrated entries of the vectors of a state.
//!
//! Loops, not closures over arrays: in functions of a mechanism these would be compiled once for each mechanism. `stiff` and `dense`, which few
//! mechanisms use, still have them.

use nalgebra::SVector;

use crate::number::Scalar;

/// Some entries of a vector.
#[inline(always)]
pub(super) fn picked<T: Scalar, const N: usize, const I: usize>(vector: &SVector<T, N>, places: &[usize; I]) -> [T; I] {
    let mut values = [T::ZERO; I];
    for (value, place) in values.iter_mut().zip(places) {
        if let Some(entry) = vector.get(*place) {
            *value = *entry;
        }
    }
    values
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
    let mut sums = *x;
    for (sum, y) in sums.iter_mut().zip(y) {
        *sum = *sum + h * *y;
    }
    sums
}

/// True if all numbers are finite. A finite sum has finite terms; each is looked at only where the sum is not. Four sums, which the processor
/// forms at a time.
#[inline(always)]
pub(super) fn are_finite<T: Scalar>(values: &[T]) -> bool {
    let mut sums = [T::ZERO; 4];
    let fours = values.chunks_exact(4);
    let rest = fours.remainder().iter().fold(T::ZERO, |sum, value| sum + *value);
    for four in fours {
        for (sum, value) in sums.iter_mut().zip(four) {
            *sum = *sum + *value;
        }
    }
    let sum = (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest;
    sum.is_finite() || values.iter().all(|value| value.is_finite())
}

/// The largest of some numbers, each divided by its length.
pub(super) fn largest<T: Scalar, const I: usize>(values: &[T; I], lengths: &[T; I]) -> T {
    values.iter().zip(lengths).fold(T::ZERO, |largest, (value, length)| largest.max((*value / *length).abs()))
}

/// The largest change of some entries of a vector, each divided by its length.
pub(super) fn largest_change<T: Scalar, const N: usize, const I: usize>(
    [from, to]: [&SVector<T, N>; 2],
    places: &[usize; I],
    lengths: &[T; I],
) -> T {
    largest(&moved(&picked(to, places), T::of(-1.0), &picked(from, places)), lengths)
}
