//! Sparse systems: elimination in a fixed order, with a test of its stability.
//!
//! A fixed order may meet a small pivot although the matrix is regular; elimination with pivoting then replaces it.

#[cfg(test)]
pub(super) mod tests;

use core::marker::PhantomData;

use nalgebra::{SMatrix, SVector};

use super::elimination::{Eliminated, Elimination};
use super::{FactorReal, Linear};
use crate::number::{Float, Mask, SimdReal};

/// Up to this growth elimination is as accurate as with pivoting.
const TIGHT: f64 = 2.0;

/// A matrix by its entries that are not always zero.
#[derive(Clone, Copy, Debug)]
pub struct Entries<T, const K: usize, const ENTRIES: usize> {
    /// In the order of the pattern.
    pub(crate) values: [T; ENTRIES],
    /// c: the scale of each unknown.
    pub(crate) columns: [T; K],
}

/// The factors of a matrix whose order of elimination is `E`.
///
/// ```text
/// |L| |U| c ≤ g |A| c        row by row, g = ε^(−1/4)
/// |U(i, i)| c_i ≥ √ε (|A| c)_i
/// ```
///
/// is required. Then L U equals A up to relative changes of its rows by at most about K g ε (Higham: Accuracy and Stability of
/// Numerical Algorithms, 9.3), x is correct to about cond(A) g ε, and one step of refinement leaves the square of this, which is
/// below the unavoidable cond(A) ε up to the condition of 1/√ε that counts as singular. If growth is at most 2, refinement is not
/// needed. The units of rows do not matter, and the determinant has the sign that it shows. Where the two conditions do not hold,
/// [dense factors](FactorReal::Dense) are used.
#[derive(Clone, Copy, Debug)]
pub struct Sparse<T: FactorReal, E, const K: usize, const ENTRIES: usize, const FACTORS: usize> {
    pub(super) matrix: Entries<T, K, ENTRIES>,
    /// L and U.
    pub(super) lu: [T; FACTORS],
    /// |A| c by pivot.
    sizes: [T; K],
    /// Whether L and U are stable.
    pub(super) is_stable: T::Mask,
    /// Whether they are as accurate as with pivoting, so that refinement improves nothing.
    pub(super) is_tight: T::Mask,
    elimination: PhantomData<E>,
}

impl<T, E, const K: usize, const ENTRIES: usize, const FACTORS: usize> Linear<T, K> for Sparse<T, E, K, ENTRIES, FACTORS>
where
    T: FactorReal,
    E: Elimination<T, K, ENTRIES, FACTORS>,
{
    type Matrix = Entries<T, K, ENTRIES>;

    #[inline]
    fn factor(matrix: &Entries<T, K, ENTRIES>) -> Result<Self, usize> {
        let Eliminated { lu, pivots, grown, sizes } = E::eliminate(&matrix.values, &matrix.columns);
        let (limit, smallest) = (largest_growth::<T>(), T::ROOT_EPSILON);
        // Without a branch for each row. Comparisons with NaN are false, and infinite entries are excluded by the bound on the row size.
        let is_good = |i: usize| {
            grown[i].at_most(limit * sizes[i]).and((smallest * sizes[i]).at_most(pivots[i])).and(sizes[i].at_most(T::of(f64::MAX)))
        };
        let is_stable = (0..K).fold(T::Mask::of(true), |good, i| good.and(is_good(i)));
        if !is_stable.all() {
            any_finite(&matrix.values, &E::ORDER.pattern)?;
        }
        let is_tight = (0..K).fold(is_stable, |tight, i| tight.and(grown[i].at_most(T::of(TIGHT) * sizes[i])));
        Ok(Self { matrix: *matrix, lu, sizes, is_stable, is_tight, elimination: PhantomData })
    }

    const HAS_UNTESTED_CORRECTION: bool = true;

    /// By L and U as they are.
    #[inline]
    fn correction(matrix: &Entries<T, K, ENTRIES>, b: &SVector<T, K>) -> Result<(SVector<T, K>, T::Signs), usize> {
        let Eliminated { lu, .. } = E::eliminate(&matrix.values, &matrix.columns);
        Ok((SVector::from(E::substitute(&lu, &b.data.0[0], |b, known| b - known)), sign::<T, E, K, ENTRIES, FACTORS>(&lu)))
    }

    fn dense(matrix: &Entries<T, K, ENTRIES>) -> SMatrix<T, K, K> {
        let mut dense = SMatrix::<T, K, K>::from_element(T::of(0.0));
        for (&entry, &place) in matrix.values.iter().zip(&E::ORDER.pattern) {
            if let Some(there) = dense.get_mut(place) {
                *there = entry;
            }
        }
        dense
    }

    #[inline]
    fn solve_regular(&self, b: &SVector<T, K>) -> SVector<T, K> {
        if self.is_stable.all() { self.by_order(b) } else { self.with_pivoting(|factors| factors.solve_regular(b)) }
    }

    #[inline]
    fn solve(&self, b: &SVector<T, K>) -> SVector<T, K>
    where
        T: Float,
    {
        if self.is_stable.all() { self.by_order(b) } else { self.with_pivoting(|factors| factors.solve(b)) }
    }

    #[inline]
    fn solve_refined(&self, b: &SVector<T, K>) -> SVector<T, K> {
        if !self.is_stable.all() {
            return self.with_pivoting(|factors| factors.solve_refined(b));
        }
        let x = self.by_order(b);
        if self.is_tight.all() {
            return x;
        }
        let product = E::product(&self.matrix.values, &x.data.0[0]);
        let correction = self.by_order(&SVector::from_fn(|i, _| b[i] - product[i]));
        SVector::from_fn(|j, _| x[j] + T::pick(self.is_tight, T::of(0.0), correction[j]))
    }

    #[inline]
    fn is_rounding(&self, b: &SVector<T, K>, sizes: &SVector<T, K>, multiple: T) -> T::Mask {
        let limit = multiple * T::EPSILON;
        let is_small = |(&row, &size): (&usize, &T)| match (b.get(row), sizes.get(row)) {
            (Some(b), Some(&terms)) => b.abs().at_most(limit * size.max(terms)),
            _ => T::Mask::of(false),
        };
        E::ORDER.rows.iter().zip(&self.sizes).fold(self.is_stable, |all, row| all.and(is_small(row)))
    }

    /// Same estimate as for dense factors, in unknowns scaled by their own size.
    #[inline]
    fn error_amplification(&self, sizes: &SVector<T, K>, reciprocals: &SVector<T, K>) -> T {
        if !self.is_stable.all() {
            return self.pivoted().map_or(T::of(f64::NAN), |factors| factors.error_amplification(sizes, reciprocals));
        }
        let zero = T::of(0.0);
        let mut b = [zero; K];
        for (&row, &size) in E::ORDER.rows.iter().zip(&self.sizes) {
            // Always true; without this test rustc keeps a bounds check in code optimised for size.
            if row < K {
                b[row] = size.max(sizes[row]);
            }
        }
        // Each sign is chosen so that the sum grows.
        let z = E::substitute(&self.lu, &b, |size, known| T::select_less(zero, known, -(size + known), size - known));
        z.iter().zip(reciprocals.iter()).fold(T::of(0.0), |largest, (&entry, &share)| largest.max(entry.abs() * share))
    }

    #[inline]
    fn det_sign(&self) -> T::Signs {
        if !self.is_stable.all() {
            return self.pivoted().map_or(T::of(1.0).signs(), |factors| factors.det_sign());
        }
        sign::<T, E, K, ENTRIES, FACTORS>(&self.lu)
    }

    #[inline]
    fn is_regular(&self) -> T::Mask {
        if self.is_stable.all() {
            return self.is_stable;
        }
        self.pivoted().map_or(T::Mask::of(false), |factors| factors.is_regular())
    }
}

impl<T, E, const K: usize, const ENTRIES: usize, const FACTORS: usize> Sparse<T, E, K, ENTRIES, FACTORS>
where
    T: FactorReal,
    E: Elimination<T, K, ENTRIES, FACTORS>,
{
    /// x of A x = b by L and U.
    #[inline]
    fn by_order(&self, b: &SVector<T, K>) -> SVector<T, K> {
        SVector::from(E::substitute(&self.lu, &b.data.0[0], |b, known| b - known))
    }

    /// The factors with pivoting. They are computed on demand: storing them would make every other state copy them.
    #[cold]
    #[inline(never)]
    pub(super) fn pivoted(&self) -> Result<T::Dense<K>, usize> {
        T::Dense::<K>::factor(&Self::dense(&self.matrix))
    }

    /// A solution by the pivoted factors.
    #[cold]
    fn with_pivoting(&self, solve: impl Fn(&T::Dense<K>) -> SVector<T, K>) -> SVector<T, K> {
        self.pivoted().map_or(SVector::from_element(T::of(f64::NAN)), |factors| solve(&factors))
    }
}

/// The sign of det A by L and U.
#[inline(always)]
fn sign<T, E, const K: usize, const ENTRIES: usize, const FACTORS: usize>(lu: &[T; FACTORS]) -> T::Signs
where
    T: FactorReal,
    E: Elimination<T, K, ENTRIES, FACTORS>,
{
    // Found when compiling: to look for the pivots among all entries takes as long as half an elimination.
    let pivots = const { E::ORDER.pivots() };
    let sign = T::of(if const { E::ORDER.is_odd() } { -1.0 } else { 1.0 });
    pivots.iter().fold(sign, |sign, &place| T::select_less(lu[place], T::of(0.0), -sign, sign)).signs()
}

/// Refuses the first row with an entry that is not finite in any lane; lanes with finite entries continue.
#[cold]
fn any_finite<T: SimdReal>(values: &[T], pattern: &[(usize, usize)]) -> Result<(), usize> {
    let is_bad = |value: &T| value.abs().at_most(T::of(f64::MAX)).not().all();
    values.iter().zip(pattern).find(|(value, _)| is_bad(value)).map_or(Ok(()), |(_, &(row, _))| Err(row))
}

/// A power of two next to ε^(−1/4).
#[inline(always)]
fn largest_growth<T: SimdReal>() -> T {
    T::select_less(T::EPSILON, T::of(1e-12), T::of(8192.0), T::of(64.0))
}
