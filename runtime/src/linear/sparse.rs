//! Systems whose zeros are known: elimination in a fixed order, watched.
//!
//! A fixed order may meet a small pivot, although the matrix is regular: there elimination with pivoting takes its place.

#[cfg(test)]
mod tests;

use core::marker::PhantomData;

use nalgebra::{SMatrix, SVector};

use super::elimination::{Eliminated, Elimination};
use super::{Factors, Linear};
use crate::order::greater;
use crate::{Float, Orientation};

/// A matrix by its entries that are not always zero.
#[derive(Clone, Copy, Debug)]
pub struct Entries<T, const K: usize, const ENTRIES: usize> {
    /// In the order of the pattern.
    pub(crate) values: [T; ENTRIES],
    /// c: what counts as 1 in each unknown.
    pub(crate) columns: [T; K],
}

/// The factors of a matrix whose order of elimination is `E`.
///
/// ```text
/// |L| |U| c ≤ g |A| c        row by row, g = ε^(−1/4)
/// |U(i, i)| c_i ≥ √ε (|A| c)_i
/// ```
///
/// is asked for. Then L U is A but for relative changes of its rows by at most about K g ε (Higham: Accuracy and Stability of
/// Numerical Algorithms, 9.3), x is correct to about cond(A) g ε, and one step of refinement leaves the square of this, which is
/// below the unavoidable cond(A) ε up to the condition of 1/√ε that counts as singular. The units of rows do not matter, and the
/// determinant has the sign that it shows. Where this does not hold, [`Factors`] are used.
#[derive(Clone, Copy, Debug)]
pub struct Sparse<T, E, const K: usize, const ENTRIES: usize, const FACTORS: usize> {
    matrix: Entries<T, K, ENTRIES>,
    /// L and U.
    lu: [T; FACTORS],
    /// |A| c by pivot.
    sizes: [T; K],
    /// Whether L and U are good.
    is_stable: bool,
    elimination: PhantomData<E>,
}

impl<T, E, const K: usize, const ENTRIES: usize, const FACTORS: usize> Linear<T, K> for Sparse<T, E, K, ENTRIES, FACTORS>
where
    T: Float,
    E: Elimination<T, K, ENTRIES, FACTORS>,
{
    type Matrix = Entries<T, K, ENTRIES>;

    #[inline]
    fn factor(matrix: &Entries<T, K, ENTRIES>) -> Result<Self, usize> {
        let Eliminated { lu, pivots, grown, sizes } = E::eliminate(&matrix.values, &matrix.columns);
        let (limit, smallest) = (largest_growth::<T>(), T::ROOT_EPSILON);
        // Without a branch for each row, and false where anything is not finite.
        let is_good = |i: usize| sizes[i].is_finite() & (grown[i] <= limit * sizes[i]) & (pivots[i] >= smallest * sizes[i]);
        let is_stable = (0..K).fold(true, |good, i| good & is_good(i));
        if !is_stable {
            all_finite(&matrix.values, &E::ORDER.pattern)?;
        }
        Ok(Self { matrix: *matrix, lu, sizes, is_stable, elimination: PhantomData })
    }

    fn dense(matrix: &Entries<T, K, ENTRIES>) -> SMatrix<T, K, K> {
        let mut dense = SMatrix::from_element(T::of(0.0));
        for (&entry, &place) in matrix.values.iter().zip(&E::ORDER.pattern) {
            dense[place] = entry;
        }
        dense
    }

    #[inline]
    fn solve(&self, b: &SVector<T, K>) -> SVector<T, K> {
        if self.is_stable {
            SVector::from(E::substitute(&self.lu, &b.data.0[0], |b, known| b - known))
        } else {
            self.with_pivoting(|factors| factors.solve(b))
        }
    }

    #[inline]
    fn solve_refined(&self, b: &SVector<T, K>) -> SVector<T, K> {
        if !self.is_stable {
            return self.with_pivoting(|factors| factors.solve_refined(b));
        }
        let x = self.solve(b);
        let product = E::product(&self.matrix.values, &x.data.0[0]);
        let correction = self.solve(&SVector::from_fn(|i, _| b[i] - product[i]));
        SVector::from_fn(|j, _| x[j] + correction[j])
    }

    /// As [`Factors`] estimate it, in unknowns by their own size.
    #[inline]
    fn condition(&self, sizes: &SVector<T, K>, shares: &SVector<T, K>) -> T {
        if !self.is_stable {
            return self.pivoted().map_or(T::of(f64::NAN), |factors| factors.growth(sizes, &SVector::from(self.matrix.columns), shares));
        }
        let mut b = [T::of(0.0); K];
        for (&row, &size) in E::ORDER.rows.iter().zip(&self.sizes) {
            b[row] = greater(size, sizes[row]);
        }
        // Each sign is the one that makes the sum longer.
        let z = E::substitute(&self.lu, &b, |size, known| if known > T::of(0.0) { -(size + known) } else { size - known });
        z.iter().zip(shares.iter()).fold(T::of(1.0), |largest, (&entry, &share)| greater(largest, entry.abs() * share))
    }

    #[inline]
    fn orientation(&self) -> Orientation {
        if !self.is_stable {
            return self.pivoted().map_or(Orientation::Positive, |factors| factors.orientation());
        }
        let is_pivot = |place: &usize| E::ORDER.factors[*place].0 == E::ORDER.factors[*place].1;
        let negative = (0..FACTORS).filter(is_pivot).fold(const { E::ORDER.is_odd() }, |odd, place| odd ^ (self.lu[place] < T::of(0.0)));
        if negative { Orientation::Negative } else { Orientation::Positive }
    }

    #[inline]
    fn is_regular(&self) -> bool {
        self.is_stable || self.pivoted().is_ok_and(|factors| factors.is_regular())
    }
}

impl<T, E, const K: usize, const ENTRIES: usize, const FACTORS: usize> Sparse<T, E, K, ENTRIES, FACTORS>
where
    T: Float,
    E: Elimination<T, K, ENTRIES, FACTORS>,
{
    /// The factors with pivoting. They are made when they are asked for: to keep them would cost every other pose their copies.
    #[cold]
    #[inline(never)]
    fn pivoted(&self) -> Result<Factors<T, K>, usize> {
        Factors::new(&Self::dense(&self.matrix))
    }

    /// A solution by them.
    #[cold]
    fn with_pivoting(&self, solve: impl Fn(&Factors<T, K>) -> SVector<T, K>) -> SVector<T, K> {
        self.pivoted().map_or(SVector::from_element(T::of(f64::NAN)), |factors| solve(&factors))
    }
}

/// Refuses the first row with an entry that is not finite.
#[cold]
fn all_finite<T: Float>(values: &[T], pattern: &[(usize, usize)]) -> Result<(), usize> {
    values.iter().zip(pattern).find(|(value, _)| !value.is_finite()).map_or(Ok(()), |(_, &(row, _))| Err(row))
}

/// A power of two next to ε^(−1/4).
#[inline(always)]
fn largest_growth<T: Float>() -> T {
    if T::EPSILON < T::of(1e-12) { T::of(8192.0) } else { T::of(64.0) }
}
