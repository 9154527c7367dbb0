//! One pass through the stages of a mechanism: what its blocks are solved from, and what that leaves behind.

use nalgebra::{SMatrix, SVector};

use super::{ColdStart, SolverReal, lengths_of};
use crate::linear::{Elimination, Entries, Linear, Small, Sparse};
use crate::names::Description;
use crate::newton::{Block, BlockData, Iterate, Linearized, Predictor, Scale, Solved, StepError};
use crate::number::{Mask, SimdReal};
use crate::state::Coordinates;

/// One pass through the stages of a mechanism.
///
/// What is needed for care lies elsewhere, so that a pass straight on can stay in registers, and of the two ways through a block
/// rustc compiles only the one that is gone.
pub struct Solver<'a, T: SolverReal, const N: usize>(Method<'a, T, N>);

/// How blocks are solved.
enum Method<'a, T: SolverReal, const N: usize> {
    WarmStart(WarmStart<'a, T, N>),
    ColdStart(&'a T::Cold<'a, N>),
}

/// A pass straight on, the usual case.
struct WarmStart<'a, T: SolverReal, const N: usize> {
    predictor: Predictor<'a, T, N>,
    /// L and 1/L.
    length: T,
    reciprocal: T,
    report: StepReport<T>,
}

/// What a pass straight on leaves behind.
#[derive(Clone, Copy)]
pub(crate) struct StepReport<T: SolverReal> {
    /// The lanes in which all blocks were solved.
    pub(crate) found: T::Mask,
    /// The worst condition of a block.
    pub(crate) condition: T,
    /// The most factorisations of a block.
    pub(crate) iterations: usize,
}

/// An equation that follows from others holds if its residual is at most this many roundings of its terms, and of what its coordinates
/// are a share of, times the condition of the blocks before it. Errors of some blocks one after the other have room in that, and
/// what is felt in a machine has not: some 1e-13 of its size in double precision, at a condition of 1.
pub(crate) const HOLDS: f64 = 64.0;

impl<'a, T: SolverReal, const N: usize> Solver<'a, T, N> {
    /// From a state to a moment later, straight on.
    #[inline(always)]
    pub(crate) fn warm<E: Description<T, N> + ?Sized>(equations: &E, predictor: Predictor<'a, T, N>) -> Self {
        let (length, reciprocal) = lengths_of(equations);
        let report = StepReport { found: T::Mask::of(true), condition: T::of(1.0), iterations: 0 };
        Self(Method::WarmStart(WarmStart { predictor, length, reciprocal, report }))
    }

    /// With care.
    #[inline(always)]
    pub(crate) fn cold(cold: &'a T::Cold<'a, N>) -> Self {
        Self(Method::ColdStart(cold))
    }

    /// What a pass straight on leaves behind.
    #[inline(always)]
    pub(crate) fn report(&self) -> Option<StepReport<T>> {
        if let Method::WarmStart(warm) = &self.0 { Some(warm.report) } else { None }
    }

    /// L and 1/L
    #[inline(always)]
    fn lengths(&self) -> (T, T) {
        match &self.0 {
            Method::WarmStart(warm) => (warm.length, warm.reciprocal),
            Method::ColdStart(cold) => cold.lengths(),
        }
    }

    /// It begins with nothing; a pass straight on writes over the state before, in which constants are what they always are.
    #[inline(always)]
    pub fn is_cold_start(&self) -> bool {
        matches!(self.0, Method::ColdStart(_))
    }

    /// Where unknowns of a block are if nothing moves it: where they were, if they rested and so did and do all `inputs`. None if
    /// it has to be solved.
    #[inline]
    pub fn resting<const K: usize>(&self, found: &Coordinates<T, N>, inputs: &[usize], own: [usize; K]) -> Option<[T; K]> {
        match &self.0 {
            Method::WarmStart(warm) => warm.predictor.resting(found, inputs, own),
            Method::ColdStart(_) => None,
        }
    }

    /// Solves a block of one to three unknowns: in closed form.
    ///
    /// `evaluate` gives residuals and their Jacobian, everything before the block known; rounding errors of the residuals are a
    /// share of `sizes`.
    ///
    /// # Errors
    /// Why the block has no solution near.
    #[inline(always)]
    pub fn small<const K: usize>(
        &mut self,
        block: &Block<K>,
        sizes: [T; K],
        evaluate: impl Fn(&Iterate<T, K>) -> ([T; K], [[T; K]; K]),
    ) -> Result<Solved<T, Small<T, K>, K>, StepError<T>> {
        self.block(block, sizes, |iterate| dense(evaluate(iterate)))
    }

    /// Solves a larger block: by a pivoted factorisation.
    ///
    /// # Errors
    /// Why the block has no solution near.
    pub fn large<const K: usize>(
        &mut self,
        block: &Block<K>,
        sizes: [T; K],
        evaluate: impl Fn(&Iterate<T, K>) -> ([T; K], [[T; K]; K]),
    ) -> Result<Solved<T, T::Dense<K>, K>, StepError<T>> {
        self.block(block, sizes, |iterate| dense(evaluate(iterate)))
    }

    /// Solves a larger block of whose Jacobian `evaluate` gives the entries that are not always zero, in the order of the
    /// elimination's pattern: by elimination in its order, and where that meets a small pivot by a pivoted factorisation.
    ///
    /// # Errors
    /// Why the block has no solution near.
    #[inline]
    pub fn sparse<E: Elimination<T, K, ENTRIES, FACTORS>, const K: usize, const ENTRIES: usize, const FACTORS: usize>(
        &mut self,
        elimination: E,
        block: &Block<K>,
        sizes: [T; K],
        evaluate: impl Fn(&Iterate<T, K>) -> ([T; K], [T; ENTRIES]),
    ) -> Result<Solved<T, Sparse<T, E, K, ENTRIES, FACTORS>, K>, StepError<T>> {
        // Of the elimination only the type is needed.
        let _ = elimination;
        let (length, reciprocal) = self.lengths();
        let columns = Scale::by_kind(length, reciprocal, &block.kinds).column.data.0[0];
        self.block(block, sizes, |iterate| {
            let (phi, values) = evaluate(iterate);
            (SVector::from(phi), Entries { values, columns })
        })
    }

    /// Takes note of the residual of an equation that is not solved since it follows from others.
    ///
    /// * `row`: given, its index in Φ.
    /// * `terms`, `lengths`, `angles`: given, the magnitude of its terms, and its slope by lengths and by angles: it shows their errors
    ///   too, which are a share of L and of 1.
    #[inline(always)]
    pub fn check(&mut self, row: usize, residual: T, [terms, lengths, angles]: [T; 3]) {
        let size = terms + self.lengths().0 * lengths + angles;
        match &mut self.0 {
            Method::WarmStart(WarmStart { report, .. }) => {
                report.found = report.found.and(residual.abs().at_most(bound(report.condition, size)));
            }
            Method::ColdStart(cold) => cold.check(row, residual, size),
        }
    }

    #[inline(always)]
    fn block<L: Linear<T, K>, const K: usize>(
        &mut self,
        block: &Block<K>,
        sizes: [T; K],
        evaluate: impl Fn(&Iterate<T, K>) -> Linearized<T, L, K>,
    ) -> Result<Solved<T, L, K>, StepError<T>> {
        let WarmStart { predictor, length, reciprocal, report } = match &mut self.0 {
            Method::WarmStart(warm) => warm,
            Method::ColdStart(cold) => return cold.solve_block(block, sizes, &evaluate),
        };
        let data = BlockData {
            unknowns: &block.unknowns,
            needs_sin_cos: &block.needs_sin_cos,
            reciprocal: &Scale::by_kind(*length, *reciprocal, &block.kinds).reciprocal,
            sizes: &SVector::from(sizes),
        };
        let name = block.unknowns.first().copied().unwrap_or(0);
        let Some(solution) = predictor.solve(&data, name, evaluate) else { return Err(StepError::Far) };
        report.found = report.found.and(solution.found);
        report.condition = report.condition.max(solution.condition);
        report.iterations = report.iterations.max(solution.iterations);
        Ok(Solved { x: solution.iterate.x.data.0[0], sin_cos: solution.iterate.sin_cos, factors: solution.factors })
    }
}

/// The largest residual that may be a rounding error.
#[inline(always)]
pub(crate) fn bound<T: SimdReal>(condition: T, size: T) -> T {
    T::of(HOLDS) * T::EPSILON * condition * size
}

/// Residuals and a Jacobian by rows.
#[inline(always)]
fn dense<T: SimdReal, const K: usize>((phi, rows): ([T; K], [[T; K]; K])) -> (SVector<T, K>, SMatrix<T, K, K>) {
    (SVector::from(phi), SMatrix::from_fn(|i, j| rows[i][j]))
}
