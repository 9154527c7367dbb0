//! The condition of a linear system.

use nalgebra::SVector;

use super::Factors;
use super::permuted::entry;
use crate::number::Float;
use crate::number::order::greater;

impl<T: Float, const N: usize> Factors<T, N> {
    /// An estimate, from below, of ‖ |A⁻¹| |A| ‖ in scaled unknowns: the factor by which one rounding of each entry of A is
    /// amplified in x. Infinite for a singular matrix; it does not depend on the units of rows.
    ///
    /// A z = ± |A| c is solved with the signs that make the forward substitution grow.
    /// Skeel: Scaling for numerical stability in Gaussian elimination, 1979; Cline, Moler, Stewart, Wilkinson: An estimate for the
    /// condition number of a matrix, 1979.
    ///
    /// * `sizes`: given, by row, the magnitude to which the rounding errors of b are proportional; used where it is larger than the
    ///   row of |A| c.
    /// * `columns`, `reciprocals`: given, the scale c of each unknown, and 1/c.
    pub(super) fn error_amplification_by(&self, sizes: &SVector<T, N>, columns: &SVector<T, N>, reciprocals: &SVector<T, N>) -> T {
        if self.rank < N {
            return T::of(f64::INFINITY);
        }
        let zero = T::of(0.0);
        let size = SVector::<T, N>::from_fn(|i, _| {
            let row = self.rows[i];
            let sum = (0..N).fold(zero, |sum, j| sum + entry(&self.matrix.data.0[j], row).abs() * columns[j]);
            greater(sum, entry(sizes.as_slice(), row)) * entry(self.row_scale.as_slice(), row)
        });
        let mut y = SVector::<T, N>::from_element(zero);
        for k in 0..N {
            y[k] = if y[k] < zero { y[k] - size[k] } else { y[k] + size[k] };
            for i in k + 1..N {
                y[i] = y[i] - self.lu[k][i] * y[k];
            }
        }
        self.substitute_back(&mut y);
        y.iter()
            .zip(&self.columns)
            .map(|(y, &column)| y.abs() * (entry(self.column_scale.as_slice(), column) * entry(reciprocals.as_slice(), column)))
            .fold(T::of(0.0), greater)
    }
}
