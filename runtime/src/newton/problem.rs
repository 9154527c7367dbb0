//! Square systems, with names, to which Newton's method is applied.

use nalgebra::{SMatrix, SVector};

use super::{Iterate, Scale};
use crate::linear::{Linear, weakest};
use crate::names::{self, Cause, Coordinate, CoordinateKind, Culprit, Row};
use crate::number::Float;
use crate::number::order::{greater, smaller};

/// A square system of K unknowns.
pub(crate) trait Problem<T: Float, const K: usize> {
    /// How its matrices are factored.
    type Factors: Linear<T, K>;

    /// Residuals and their Jacobian.
    fn linearize(&self, iterate: &Iterate<T, K>) -> Linearized<T, Self::Factors, K>;

    /// Which unknowns occur in sines or cosines.
    fn needs_sin_cos(&self) -> &[bool; K];

    /// The size of each unknown.
    fn scale(&self) -> &Scale<T, K>;

    /// The magnitude of the terms of each residual, to which its rounding errors are proportional; 0 to take it from the Jacobian.
    fn sizes(&self) -> SVector<T, K>;

    /// The name of a row.
    fn row(&self, index: usize) -> Row;

    /// The name of an unknown.
    fn coordinate(&self, index: usize) -> Coordinate;

    /// The first unknown in which a vector is not finite.
    fn first_not_finite(&self, vector: &SVector<T, K>) -> Option<Culprit> {
        let index = vector.iter().position(|entry| !entry.is_finite())?;
        Some(Culprit::Coordinate(self.coordinate(index)))
    }

    /// The row that depends on the others here, and the unknown that they leave undetermined.
    fn singular(&self, iterate: &Iterate<T, K>) -> Cause<T> {
        let (_, jacobian) = self.linearize(iterate);
        let (row, coordinate) = weakest(&Self::Factors::dense(&jacobian), &self.scale().column).unwrap_or((0, 0));
        let factors = Self::Factors::factor(&jacobian);
        let condition = factors.map_or(T::of(f64::NAN), |factors| factors.condition(&self.sizes(), &self.scale().reciprocal));
        Cause::Singular { row: self.row(row), coordinate: self.coordinate(coordinate), condition }
    }

    /// The largest ratio, over the rows, of the natural size of a row (L, L² or 1) to its largest entry in units of the unknowns.
    fn weakness(&self, jacobian: &SMatrix<T, K, K>) -> T {
        let length = self.scale().length;
        let natural = |row: usize| match self.row(row).unit {
            "m" => length,
            "m²" => length * length,
            _ => T::of(1.0),
        };
        let moved = |row: usize| (0..K).fold(T::of(0.0), |most, k| greater(most, (jacobian[(row, k)] * self.scale().column[k]).abs()));
        (0..K).fold(T::of(0.0), |weakest, row| greater(weakest, natural(row) / moved(row)))
    }

    /// The row with the largest gap here; None if all are closed.
    fn widest_gap(&self, iterate: &Iterate<T, K>) -> Option<Cause<T>> {
        let (phi, jacobian) = self.linearize(iterate);
        let jacobian = Self::Factors::dense(&jacobian);
        let mut widest = T::of(CLOSED) * T::ROOT_EPSILON * self.scale().length;
        let mut cause = None;
        for (row, &residual) in phi.iter().enumerate() {
            let gap = at_most(self.scale().gap(row, residual, &jacobian), residual, self.row(row).unit, self.scale().length);
            if gap > widest {
                widest = gap;
                cause = Some(Cause::DoesNotClose { row: self.row(row), residual, gap });
            }
        }
        cause
    }
}

/// Bounds a gap by its residual; at a dead point the gradient in the denominator vanishes.
fn at_most<T: Float>(gap: T, residual: T, unit: &str, length: T) -> T {
    let residual = residual.abs();
    match unit {
        "m" => smaller(residual, gap),
        "rad" => smaller(residual * length, gap),
        // |d − c| ≤ √|d² − c²| for lengths d and c.
        "m²" => smaller(residual.sqrt(), gap),
        _ => gap,
    }
}

/// Gaps up to this multiple of √ε L count as closed: at a dead point rounding errors in Φ move q by about √ε.
const CLOSED: f64 = 16.0;

/// Residuals and their Jacobian, in the form in which it is factored.
pub(crate) type Linearized<T, L, const K: usize> = (SVector<T, K>, <L as Linear<T, K>>::Matrix);

/// Residuals and their Jacobian as a function of the iterate.
pub(crate) type Evaluate<'b, T, L, const K: usize> = dyn Fn(&Iterate<T, K>) -> Linearized<T, L, K> + 'b;

/// A block of a mechanism: some of its equations and unknowns; all previous blocks are solved.
pub(crate) struct Part<'a, T, L: Linear<T, K>, const K: usize>
where
    T: Float,
{
    /// Called through a pointer, so that the algorithms are compiled once for each size and not for each block.
    pub(crate) evaluate: &'a Evaluate<'a, T, L, K>,
    pub(crate) block: &'a Block<K>,
    pub(crate) scale: Scale<T, K>,
    pub(crate) sizes: SVector<T, K>,
    pub(crate) rows: &'static [Row],
    pub(crate) coordinates: &'static [Coordinate],
}

/// Which equations and unknowns make a block.
#[derive(Clone, Copy, Debug)]
pub struct Block<const K: usize> {
    /// Indices in q.
    pub unknowns: [usize; K],
    /// Indices in Φ.
    pub equations: [usize; K],
    /// Quantity that each unknown measures.
    pub kinds: [CoordinateKind; K],
    /// Which unknowns occur in sines or cosines.
    pub needs_sin_cos: [bool; K],
}

impl<T: Float, L: Linear<T, K>, const K: usize> Problem<T, K> for Part<'_, T, L, K> {
    type Factors = L;

    fn linearize(&self, iterate: &Iterate<T, K>) -> Linearized<T, L, K> {
        (self.evaluate)(iterate)
    }

    fn needs_sin_cos(&self) -> &[bool; K] {
        &self.block.needs_sin_cos
    }

    fn scale(&self) -> &Scale<T, K> {
        &self.scale
    }

    fn sizes(&self) -> SVector<T, K> {
        self.sizes
    }

    fn row(&self, index: usize) -> Row {
        names::row(self.rows, self.block.equations.get(index).copied().unwrap_or(usize::MAX))
    }

    fn coordinate(&self, index: usize) -> Coordinate {
        names::coordinate(self.coordinates, self.block.unknowns.get(index).copied().unwrap_or(usize::MAX))
    }
}
