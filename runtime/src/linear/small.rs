//! One to three equations in closed form: A⁻¹ = adj A / det A.

use nalgebra::{SMatrix, SVector};

use super::{Factors, Linear};
use crate::number::{Float, SimdReal};

/// The adjugate and the determinant of a matrix of up to three rows.
///
/// Cofactors are sums of two products at most, so that x is as good as the condition allows; with three rows velocities
/// and accelerations get a step of refinement on top.
#[derive(Clone, Copy, Debug)]
pub struct Small<T, const N: usize> {
    pub(super) matrix: SMatrix<T, N, N>,
    pub(super) adjugate: SMatrix<T, N, N>,
    determinant: T,
    /// One over the determinant.
    pub(super) reciprocal: T,
    /// The determinant's expansion with the magnitudes of its terms, to which its rounding errors are proportional.
    magnitude: T,
}

/// Up to this size x is a quotient of two determinants of two products each, which are as good as they can be (Higham: Accuracy
/// and Stability of Numerical Algorithms, 1.10.1); a refinement would not change them.
pub(super) const EXACT: usize = 2;

/// A determinant below this many roundings of its terms is noise.
const NOISE: f64 = 8.0;

/// So is one below this, the smallest positive normal number of `f32`.
const NOTHING: f64 = f32::MIN_POSITIVE as f64;

impl<T: SimdReal, const N: usize> Linear<T, N> for Small<T, N> {
    type Matrix = SMatrix<T, N, N>;
    const IS_SMALL: bool = true;

    #[inline(always)]
    fn factor(matrix: &SMatrix<T, N, N>) -> Result<Self, usize> {
        let adjugate = adjugate(matrix);
        // The expansion along the first row; every row gives the same but for rounding.
        let term = |j: usize| matrix[(0, j)] * adjugate[(j, 0)];
        let determinant = (1..N).fold(term(0), |sum, j| sum + term(j));
        let magnitude = (1..N).fold(term(0).abs(), |sum, j| sum + term(j).abs());
        Ok(Self { matrix: *matrix, adjugate, determinant, reciprocal: T::of(1.0) / determinant, magnitude })
    }

    #[inline(always)]
    fn dense(matrix: &SMatrix<T, N, N>) -> SMatrix<T, N, N> {
        *matrix
    }

    #[inline(always)]
    fn solve_regular(&self, b: &SVector<T, N>) -> SVector<T, N> {
        // The quotient is taken last: it need not wait for b, nor b for it.
        SVector::from_fn(|i, _| (1..N).fold(self.adjugate[(i, 0)] * b[0], |sum, k| sum + self.adjugate[(i, k)] * b[k]) * self.reciprocal)
    }

    #[inline]
    fn solve(&self, b: &SVector<T, N>) -> SVector<T, N>
    where
        T: Float,
    {
        if self.is_regular() { self.solve_regular(b) } else { self.basic_solution(b) }
    }

    #[inline(always)]
    fn solve_refined(&self, b: &SVector<T, N>) -> SVector<T, N> {
        let x = self.solve_regular(b);
        if N <= EXACT {
            return x;
        }
        let residual = SVector::from_fn(|i, _| (0..N).fold(b[i], |rest, j| rest - self.matrix[(i, j)] * x[j]));
        let correction = self.solve_regular(&residual);
        SVector::from_fn(|i, _| x[i] + correction[i])
    }

    #[inline(always)]
    fn error_amplification(&self, sizes: &SVector<T, N>, reciprocals: &SVector<T, N>) -> T {
        // Loops, since rustc does not always compile a closure over the entries into its caller.
        let (reciprocal, mut largest) = (self.reciprocal.abs(), T::of(0.0));
        for i in 0..N {
            let mut amplification = self.adjugate[(i, 0)].abs() * sizes[0];
            for k in 1..N {
                amplification = amplification + self.adjugate[(i, k)].abs() * sizes[k];
            }
            let amplification = (amplification * reciprocal) * reciprocals[i];
            largest = if i == 0 { amplification } else { largest.max(amplification) };
        }
        largest
    }

    #[inline(always)]
    fn det_sign(&self) -> T::Signs {
        self.determinant.signs()
    }

    #[inline(always)]
    fn is_regular(&self) -> T::Mask {
        // One entry alone has no rounding errors.
        let noise = if N == 1 { T::of(NOTHING) } else { T::of(NOISE) * T::EPSILON * self.magnitude + T::of(NOTHING) };
        noise.at_most(self.determinant.abs())
    }
}

impl<T: Float, const N: usize> Small<T, N> {
    /// The basic solution for a singular matrix, by full pivoting, so that Newton's method can leave a singular position.
    #[cold]
    fn basic_solution(&self, b: &SVector<T, N>) -> SVector<T, N> {
        let nothing = SVector::from_element(T::of(f64::NAN));
        Factors::new(&self.matrix).map_or(nothing, |factors| factors.solve(b))
    }
}

/// adj A, with A adj A = det A.
#[inline(always)]
fn adjugate<T: SimdReal, const N: usize>(a: &SMatrix<T, N, N>) -> SMatrix<T, N, N> {
    let minor = |i: usize, j: usize| match N {
        1 => T::of(1.0),
        2 => {
            let entry = a[(1 - i, 1 - j)];
            if i == j { entry } else { -entry }
        }
        // Cyclic indices give the sign of the cofactor by themselves.
        _ => {
            let ([i1, i2], [j1, j2]) = ([(i + 1) % 3, (i + 2) % 3], [(j + 1) % 3, (j + 2) % 3]);
            a[(i1, j1)] * a[(i2, j2)] - a[(i1, j2)] * a[(i2, j1)]
        }
    };
    SMatrix::from_fn(|i, j| minor(j, i))
}
