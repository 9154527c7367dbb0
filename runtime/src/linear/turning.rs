//! Systems whose unknowns include quaternions: solved for turns instead.
//!
//! ```text
//! A = M D        (ρ, θ) = D δe for each quaternion e, D = 1 for all other unknowns
//!
//! ρ = 2 e · δe               θ = 2/(e · e) vec(δe ē)          a turn about the axes of ground
//! δe = e ρ/(2 e · e) + θ e/2
//! ```
//!
//! The row of the norm of A is 2 eᵀ, that of M is a single 1, in the column of e₀. The columns of e₁ to e₃ in M are derivatives by θ. They are
//! shorter than those of A, and there is one less; the solution is the same, because no other row changes with the length of e.

#[cfg(test)]
mod tests;

use core::marker::PhantomData;

use nalgebra::{SMatrix, SVector};

use super::{Elimination, Linear};
use crate::number::{Float, SimdReal};

/// √3/2
const HALF_DIAGONAL: f64 = 0.866_025_403_784_438_6;

/// M, and the iterate.
#[derive(Clone, Copy, Debug)]
pub struct AtIterate<T, M, const K: usize> {
    pub(crate) matrix: M,
    pub(crate) x: SVector<T, K>,
}

/// The factors of M by `L`; the order of elimination `E` names the quaternions.
#[derive(Clone, Copy, Debug)]
pub struct Turning<T, L, E, const K: usize, const ENTRIES: usize, const FACTORS: usize> {
    factors: L,
    x: SVector<T, K>,
    elimination: PhantomData<E>,
}

/// The parts of an unknown that are a quaternion.
fn parts<T: SimdReal, const K: usize>(x: &SVector<T, K>, columns: &[usize; 4]) -> [T; 4] {
    // Always in range; without this test rustc keeps a bounds check in code optimised for size.
    columns.map(|column| x.get(column).copied().unwrap_or(T::of(f64::NAN)))
}

/// e · e
#[inline(always)]
fn square<T: SimdReal>([w, x, y, z]: [T; 4]) -> T {
    (w * w + x * x) + (y * y + z * z)
}

/// 2 eᵀ and, three times, a row of 2 vec(δe ē) by the components of δe.
fn rows<T: SimdReal>([w, x, y, z]: [T; 4]) -> [[T; 4]; 4] {
    [[w, x, y, z], [-x, w, -z, y], [-y, z, w, -x], [-z, -y, x, w]].map(|row| row.map(|entry| entry + entry))
}

impl<T, L, E, const K: usize, const ENTRIES: usize, const FACTORS: usize> Turning<T, L, E, K, ENTRIES, FACTORS>
where
    T: SimdReal,
    L: Linear<T, K>,
    E: Elimination<T, K, ENTRIES, FACTORS>,
{
    /// δe from ρ and θ.
    #[inline(always)]
    fn by_components(&self, solution: SVector<T, K>) -> SVector<T, K> {
        Self::components(&self.x, solution)
    }

    /// The same at an iterate `x`.
    #[inline(always)]
    fn components(x: &SVector<T, K>, mut solution: SVector<T, K>) -> SVector<T, K> {
        for columns in E::QUATERNIONS {
            let [w, x, y, z] = parts(x, columns);
            let [norm, a, b, c] = parts(&solution, columns);
            let along = norm / square([w, x, y, z]);
            let change = [
                along * w - (a * x + b * y + c * z),
                along * x + (a * w + b * z - c * y),
                along * y + (b * w + c * x - a * z),
                along * z + (c * w + a * y - b * x),
            ];
            for (&column, entry) in columns.iter().zip(change) {
                if let Some(there) = solution.get_mut(column) {
                    *there = T::of(0.5) * entry;
                }
            }
        }
        solution
    }
}

impl<T, L, E, const K: usize, const ENTRIES: usize, const FACTORS: usize> Linear<T, K> for Turning<T, L, E, K, ENTRIES, FACTORS>
where
    T: SimdReal,
    L: Linear<T, K>,
    E: Elimination<T, K, ENTRIES, FACTORS>,
{
    type Matrix = AtIterate<T, L::Matrix, K>;

    #[inline]
    fn factor(of: &Self::Matrix) -> Result<Self, usize> {
        Ok(Self { factors: L::factor(&of.matrix)?, x: of.x, elimination: PhantomData })
    }

    #[inline]
    fn factor_at<'a>(place: &'a mut Option<Self>, of: &Self::Matrix) -> Result<&'a Self, usize> {
        let factors = L::factor(&of.matrix)?;
        Ok(place.insert(Self { factors, x: of.x, elimination: PhantomData }))
    }

    const HAS_UNTESTED_CORRECTION: bool = L::HAS_UNTESTED_CORRECTION;

    #[inline]
    fn correction(of: &Self::Matrix, b: &SVector<T, K>) -> Result<(SVector<T, K>, T::Signs), usize> {
        let (solution, sign) = L::correction(&of.matrix, b)?;
        Ok((Self::components(&of.x, solution), sign))
    }

    fn dense(of: &Self::Matrix) -> SMatrix<T, K, K> {
        let mut dense = L::dense(&of.matrix);
        for columns in E::QUATERNIONS {
            let e = parts(&of.x, columns);
            let (per, [along, about @ ..]) = (T::of(1.0) / square(e), rows(e));
            for row in 0..K {
                let entries = columns.map(|column| dense.get((row, column)).copied().unwrap_or(T::of(f64::NAN)));
                for (k, &column) in columns.iter().enumerate() {
                    let turned = (0..3).fold(T::of(0.0), |sum, axis| sum + entries[axis + 1] * about[axis][k]);
                    if let Some(there) = dense.get_mut((row, column)) {
                        *there = entries[0] * along[k] + turned * per;
                    }
                }
            }
        }
        dense
    }

    #[inline]
    fn solve_regular(&self, b: &SVector<T, K>) -> SVector<T, K> {
        self.by_components(self.factors.solve_regular(b))
    }

    #[inline]
    fn solve(&self, b: &SVector<T, K>) -> SVector<T, K>
    where
        T: Float,
    {
        self.by_components(self.factors.solve(b))
    }

    #[inline]
    fn solve_refined(&self, b: &SVector<T, K>) -> SVector<T, K> {
        self.by_components(self.factors.solve_refined(b))
    }

    fn solve_as_constant(&self, b: &SVector<T, K>) -> SVector<T, K> {
        self.by_components(self.factors.solve_as_constant(b))
    }

    fn with_derivatives_of(self, of: &Self::Matrix) -> Result<Self, usize> {
        Ok(Self { factors: self.factors.with_derivatives_of(&of.matrix)?, x: of.x, elimination: PhantomData })
    }

    #[inline]
    fn is_rounding(&self, b: &SVector<T, K>, sizes: &SVector<T, K>, multiple: T) -> T::Mask {
        self.factors.is_rounding(b, sizes, multiple)
    }

    /// Of a unit quaternion δe = θ e/2, each component of which is at most √3/2 times the largest of θ.
    #[inline]
    fn error_amplification(&self, sizes: &SVector<T, K>, reciprocals: &SVector<T, K>) -> T {
        let mut shares = *reciprocals;
        for &column in E::QUATERNIONS.iter().flatten() {
            if let Some(share) = shares.get_mut(column) {
                *share = T::of(HALF_DIAGONAL) * *share;
            }
        }
        self.factors.error_amplification(sizes, &shares)
    }

    /// det D is positive.
    #[inline]
    fn det_sign(&self) -> T::Signs {
        self.factors.det_sign()
    }

    #[inline]
    fn is_regular(&self) -> T::Mask {
        self.factors.is_regular()
    }
}
