//! Systems on the stack: A x = b with A an N × N matrix.
//!
//! In: a matrix. Out: its factors, for any number of right-hand sides, its rank, the sign of its determinant, and an estimate of its
//! condition. The caller decides how to treat a singular matrix.
//!
//! ```text
//! P (R A C) Q = L U        R, C diagonal, powers of two (exact);  P, Q permutations, Q = 1 unless A is nearly singular
//! ```
//!
//! Golub, Van Loan: Matrix Computations, 4th ed., 3.4 (pivoting), 3.5.2 (scaling), 3.5.3 (iterative refinement).
//!
//! Systems of one to three unknowns are solved in closed form ([`Small`]), and larger ones with known zeros by elimination in an
//! order that the compiler chose ([`Sparse`]).

mod abreast;
mod condition;
mod elimination;
mod factor;
mod permuted;
mod rank;
mod selection;
mod small;
mod solve;
mod sparse;
mod turning;
mod vectors;

use nalgebra::{SMatrix, SVector};

use crate::number::{Float, Mask, SimdReal};

pub(crate) use abreast::Abreast;
pub(crate) use elimination::InOrder;
pub use elimination::{Eliminated, Elimination, Order};
pub use factor::Factors;
pub(crate) use rank::{regular_part, weakest};
pub use selection::third_derivatives;
pub use small::Small;
pub use sparse::{Entries, Sparse};
pub use turning::{AtIterate, Turning};
pub use vectors::zeros;
pub(crate) use vectors::{difference, divided, moved, product, scaled, unpermuted};

/// A [`SimdReal`] with a factorisation of matrices.
pub trait FactorReal: SimdReal {
    /// Factors of matrices of one to three rows.
    type Small<const K: usize>: Linear<Self, K, Matrix = SMatrix<Self, K, K>>;

    /// Factors of matrices by elimination in a fixed order.
    type Sparse<E, const K: usize, const ENTRIES: usize, const FACTORS: usize>: Linear<Self, K, Matrix = Entries<Self, K, ENTRIES>>
    where
        E: Elimination<Self, K, ENTRIES, FACTORS>;

    /// Factors of matrices of any size.
    type Dense<const K: usize>: Linear<Self, K, Matrix = SMatrix<Self, K, K>>;
}

impl<T: Float> FactorReal for T {
    type Small<const K: usize> = Small<T, K>;
    type Sparse<E, const K: usize, const ENTRIES: usize, const FACTORS: usize>
        = Sparse<T, E, K, ENTRIES, FACTORS>
    where
        E: Elimination<Self, K, ENTRIES, FACTORS>;
    type Dense<const K: usize> = Factors<T, K>;
}

/// Factors of a square matrix.
pub trait Linear<T: SimdReal, const N: usize>: Sized + 'static {
    /// The form in which the matrix is given.
    type Matrix: 'static;

    /// Whether these are the factors of [`Small`].
    const IS_SMALL: bool = false;

    /// Factors `matrix`.
    ///
    /// # Errors
    /// The index of a row with an entry that is not finite, unless every solution then is not finite.
    fn factor(matrix: &Self::Matrix) -> Result<Self, usize>;

    /// Factors `matrix` and leaves the factors in `place`: a result of many numbers would be copied each time it is handed on.
    ///
    /// # Errors
    /// As [`factor`](Self::factor).
    #[inline(always)]
    fn factor_at<'a>(place: &'a mut Option<Self>, matrix: &Self::Matrix) -> Result<&'a Self, usize> {
        Ok(place.insert(Self::factor(matrix)?))
    }

    /// Whether [`correction`](Self::correction) tests less than [`factor`](Self::factor).
    const HAS_UNTESTED_CORRECTION: bool = false;

    /// x of A x = b, and the sign of det A, without a test of their accuracy: for corrections that the next one judges.
    ///
    /// # Errors
    /// As [`factor`](Self::factor).
    #[inline(always)]
    fn correction(matrix: &Self::Matrix, b: &SVector<T, N>) -> Result<(SVector<T, N>, T::Signs), usize> {
        let factors = Self::factor(matrix)?;
        Ok((factors.solve_regular(b), factors.det_sign()))
    }

    /// The dense matrix.
    fn dense(matrix: &Self::Matrix) -> SMatrix<T, N, N>;

    /// x of A x = b; unspecified if A is singular.
    fn solve_regular(&self, b: &SVector<T, N>) -> SVector<T, N>;

    /// x of A x = b; a basic solution if A is singular.
    fn solve(&self, b: &SVector<T, N>) -> SVector<T, N>
    where
        T: Float;

    /// x of A x = b, with a step of iterative refinement where that improves it; unspecified if A is singular.
    fn solve_refined(&self, b: &SVector<T, N>) -> SVector<T, N>;

    /// x of A x = b as if the entries of A were constants, for numbers that carry derivatives.
    fn solve_as_constant(&self, b: &SVector<T, N>) -> SVector<T, N> {
        self.solve_refined(b)
    }

    /// Factors of a matrix with the same numbers and other derivatives, for numbers that carry them.
    ///
    /// # Errors
    /// As [`factor`](Self::factor).
    fn with_derivatives_of(self, matrix: &Self::Matrix) -> Result<Self, usize> {
        Self::factor(matrix)
    }

    /// The factor by which rounding errors of A x − b are amplified in x; unspecified if A is singular.
    ///
    /// * `sizes`: given, by row, the magnitude to which the rounding errors of b are proportional; the row of A is used where it is
    ///   larger.
    /// * `reciprocals`: given, by unknown, one over its scale.
    fn error_amplification(&self, sizes: &SVector<T, N>, reciprocals: &SVector<T, N>) -> T;

    /// True if every entry of b is a rounding error, at most `multiple` ε of the magnitude that
    /// [`error_amplification`](Self::error_amplification) assumes for its row, so that A⁻¹ b is one as well. False also where this test would take
    /// longer than the solution.
    #[inline(always)]
    fn is_rounding(&self, b: &SVector<T, N>, sizes: &SVector<T, N>, multiple: T) -> T::Mask {
        let _ = (b, sizes, multiple);
        T::Mask::of(false)
    }

    /// The [`error_amplification`](Self::error_amplification) of rounding errors, at least 1; infinite if A is singular.
    fn condition(&self, sizes: &SVector<T, N>, reciprocals: &SVector<T, N>) -> T {
        T::pick(self.is_regular(), self.error_amplification(sizes, reciprocals).max(T::of(1.0)), T::of(f64::INFINITY))
    }

    /// The sign of det A; unspecified if A is singular.
    fn det_sign(&self) -> T::Signs;

    /// A has full rank, to rounding.
    fn is_regular(&self) -> T::Mask;
}
