//! The row and the unknown responsible where a matrix is singular, or nearly so.

use nalgebra::{SMatrix, SVector};

use super::factor::Pivoting;
use super::permuted::entry;
use super::{Factors, Linear};
use crate::number::Float;

/// The row that depends on the others and the unknown that they leave undetermined.
///
/// With full pivoting the first pivot that is noise, or else the last one, is taken for zero. Then one combination of rows
/// and one of columns vanish (the left and right null vectors, from L and U by back substitution); named are the row and, in
/// scaled unknowns, the column with the largest share. None for a matrix without entries or with one that is not finite.
///
/// * `matrix`: given.
/// * `size`: given, the scale of each unknown.
pub(crate) fn weakest<T: Float, const N: usize>(matrix: &SMatrix<T, N, N>, size: &SVector<T, N>) -> Option<(usize, usize)> {
    let mut factors = Factors::equilibrated(matrix).ok()?;
    factors.eliminate(Pivoting::Full);
    let free = factors.rank.min(N.checked_sub(1)?);
    let lu = &factors.lu;

    let mut left = SVector::<T, N>::from_element(T::of(0.0));
    let mut right = left;
    (left[free], right[free]) = (T::of(1.0), T::of(1.0));
    for k in (0..free).rev() {
        for other in k + 1..=free {
            left[k] = left[k] - lu[k][other] * left[other];
            right[k] = right[k] - lu[other][k] * right[other];
        }
        right[k] = right[k] / lu[k][k];
    }

    for (k, &column) in factors.columns.iter().enumerate() {
        right[k] = right[k] * entry(factors.column_scale.as_slice(), column) / entry(size.as_slice(), column);
    }
    Some((*factors.rows.get(largest(&left))?, *factors.columns.get(largest(&right))?))
}

/// x of A x = b in the regular part of A: entries and pivots below the fourth root of ε, relative to the others, count as zero, and
/// unknowns without another pivot are zero in x.
///
/// * `matrix`: given, A, in units in which rows and columns are about 1.
pub(crate) fn regular_part<T: Float, const N: usize>(matrix: &SMatrix<T, N, N>, b: &SVector<T, N>) -> Option<SVector<T, N>> {
    let (zero, weak) = (T::of(0.0), T::ROOT_EPSILON.sqrt());
    let mut factors = Factors::equilibrated(&matrix.map(|entry| if entry.abs() > weak { entry } else { zero })).ok()?;
    factors.eliminate(Pivoting::Full);
    factors.rank = (0..factors.rank.min(N)).find(|&k| factors.lu[k][k].abs() <= weak).unwrap_or(factors.rank);
    Some(factors.solve(b))
}

/// Index of the entry with the largest magnitude, the first of equals.
fn largest<T: Float, const N: usize>(vector: &SVector<T, N>) -> usize {
    let first = (0, T::of(-1.0));
    vector.iter().enumerate().fold(first, |best, (i, entry)| if entry.abs() > best.1 { (i, entry.abs()) } else { best }).0
}
