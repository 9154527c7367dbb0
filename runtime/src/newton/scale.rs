//! Scaling of metres and radians: lengths are divided by L, angles are taken as they are.

use nalgebra::{SMatrix, SVector};

use crate::names::{self, Coordinate, CoordinateKind};
use crate::number::order::greater;
use crate::number::{Float, Mask, SimdReal};

/// The size of each coordinate: L for lengths, 1 for angles.
#[derive(Clone)]
pub(crate) struct Scale<T, const N: usize> {
    /// L in m.
    pub(crate) length: T,
    /// L or 1, by coordinate.
    pub(crate) column: SVector<T, N>,
    /// 1/L or 1, by coordinate.
    pub(crate) reciprocal: SVector<T, N>,
}

impl<T: Float, const N: usize> Scale<T, N> {
    /// The scale of a mechanism with this characteristic length (m).
    pub(crate) fn of(length: T, coordinates: &[Coordinate]) -> Self {
        let length = length_of(length);
        Self::by_kind(length, T::of(1.0) / length, &core::array::from_fn(|i| names::coordinate(coordinates, i).kind))
    }

    /// The largest scaled entry, max(|δ_x| / L, |δ_φ|); NaN if an entry is, 0 if there is none.
    pub(crate) fn norm(&self, vector: &SVector<T, N>) -> T {
        vector.iter().zip(self.reciprocal.iter()).fold(T::of(0.0), |norm, (&entry, &reciprocal)| greater(norm, entry.abs() * reciprocal))
    }

    /// The gap of row `row` in m: |Φ_i| divided by the norm of its gradient, with angles weighted by L.
    pub(crate) fn gap(&self, row: usize, residual: T, jacobian: &SMatrix<T, N, N>) -> T {
        let squares = (0..N).fold(T::of(0.0), |sum, j| {
            let entry = jacobian.data.0[j].get(row).copied().unwrap_or(T::of(f64::NAN)) * self.column[j];
            sum + entry * entry
        });
        residual.abs() * self.length / squares.sqrt()
    }
}

impl<T: SimdReal, const N: usize> Scale<T, N> {
    /// The scale of coordinates of these kinds, with L and 1/L.
    #[inline(always)]
    pub(crate) fn by_kind(length: T, reciprocal: T, kinds: &[CoordinateKind; N]) -> Self {
        let pick = |of_length: T| {
            SVector::from_fn(|i, _| match kinds[i] {
                CoordinateKind::Length => of_length,
                CoordinateKind::Angle | CoordinateKind::Number => T::of(1.0),
            })
        };
        Self { length, column: pick(length), reciprocal: pick(reciprocal) }
    }
}

/// L in m; 1 m if the characteristic length is not a positive finite number.
#[inline(always)]
pub(crate) fn length_of<T: SimdReal>(length: T) -> T {
    let is_length = T::of(f64::from(f32::MIN_POSITIVE)).at_most(length).and(length.at_most(T::of(f64::from(f32::MAX))));
    T::pick(is_length, length, T::of(1.0))
}
