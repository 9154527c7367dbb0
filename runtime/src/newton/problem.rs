//! What Newton's method is run on: a square system with names.

use nalgebra::SVector;

use super::{Iterate, Scale};
use crate::linear::{Linear, weakest};
use crate::names::{self, Cause, Coordinate, CoordinateKind, Culprit, Row};
use crate::number::Float;
use crate::number::order::smaller;

/// A square system of K unknowns.
pub(crate) trait Problem<T: Float, const K: usize> {
    /// How its matrices are factored.
    type Factors: Linear<T, K>;

    /// Residuals and their Jacobian.
    fn linearize(&self, iterate: &Iterate<T, K>) -> Linearized<T, Self::Factors, K>;

    /// Of which unknowns sine and cosine are needed.
    fn needs_sin_cos(&self) -> &[bool; K];

    /// The size of each unknown.
    fn scale(&self) -> &Scale<T, K>;

    /// What the rounding errors of each residual are a share of; 0 where the Jacobian tells.
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

    /// Which row depends on the others here, and which unknown they leave free.
    fn singular(&self, iterate: &Iterate<T, K>) -> Cause<T> {
        let (_, jacobian) = self.linearize(iterate);
        let (row, coordinate) = weakest(&Self::Factors::dense(&jacobian), &self.scale().column).unwrap_or((0, 0));
        let factors = Self::Factors::factor(&jacobian);
        let condition = factors.map_or(T::of(f64::NAN), |factors| factors.condition(&self.sizes(), &self.scale().reciprocal));
        Cause::Singular { row: self.row(row), coordinate: self.coordinate(coordinate), condition }
    }

    /// Which row stays open furthest here; None if all are closed.
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

/// A gap is no larger than its residual allows: at a dead point the gradient that it was divided by vanishes.
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

/// A gap of √ε L times this is closed: at a dead point, where rounding errors in Φ move q by about √ε.
const CLOSED: f64 = 16.0;

/// Residuals and their Jacobian, in the form that is factored.
pub(crate) type Linearized<T, L, const K: usize> = (SVector<T, K>, <L as Linear<T, K>>::Matrix);

/// Residuals and their Jacobian at a place.
pub(crate) type Evaluate<'b, T, L, const K: usize> = dyn Fn(&Iterate<T, K>) -> Linearized<T, L, K> + 'b;

/// A block of a mechanism: some of its equations and unknowns, everything before them known.
pub(crate) struct Part<'a, T, L: Linear<T, K>, const K: usize>
where
    T: Float,
{
    /// Called through a pointer, so that what is done with it is compiled once and not for every block anew.
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
    /// What the unknowns measure.
    pub kinds: [CoordinateKind; K],
    /// Of which unknowns sine and cosine are needed.
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
