//! The solver that stages call for each block: a warm start from the previous state, or a cold start.

use nalgebra::{SMatrix, SVector};

use super::{ColdStart, SolverReal, lengths_of};
use crate::linear::{AtIterate, Elimination, Entries, FactorReal, Linear, Turning};
use crate::names::Description;
use crate::newton::{Block, BlockData, Iterate, Linearized, Predictor, Scale, Solved, SolvedInPlace, StepError};
use crate::number::{Mask, SimdReal};
use crate::state::Values;

/// Solves the blocks of one evaluation of [`Stages`](crate::solve::Stages), in order.
///
/// The data of a cold start lies elsewhere, so that a warm start stays in registers, and rustc compiles only the branch that is
/// taken.
pub struct Solver<'a, T: SolverReal, const N: usize>(Method<'a, T, N>);

/// Factors by turns and by elimination in a fixed order.
type ByTurns<T, E, const K: usize, const ENTRIES: usize, const FACTORS: usize> =
    Turning<T, <T as FactorReal>::Sparse<E, K, ENTRIES, FACTORS>, E, K, ENTRIES, FACTORS>;

/// How blocks are solved.
enum Method<'a, T: SolverReal, const N: usize> {
    WarmStart(WarmStart<'a, T, N>),
    ColdStart(&'a T::Cold<'a, N>),
}

/// A warm start, the usual case.
struct WarmStart<'a, T: SolverReal, const N: usize> {
    predictor: Predictor<'a, T, N>,
    /// L and 1/L.
    length: T,
    reciprocal: T,
    report: StepReport<T>,
}

/// The result of a warm start.
#[derive(Clone, Copy)]
pub(crate) struct StepReport<T: SolverReal> {
    /// The lanes in which all blocks were solved.
    pub(crate) found: T::Mask,
    /// The largest condition of a block.
    pub(crate) condition: T,
    /// The largest number of factorisations of a block.
    pub(crate) iterations: usize,
}

/// A redundant equation holds if its residual is at most this many roundings of its terms and of the scales of its coordinates,
/// times the condition of the previous blocks. The bound covers the accumulated errors of several blocks, and is far below any real
/// misfit: about 1e-13 of the size of the mechanism in double precision at a condition of 1.
pub(crate) const HOLDS: f64 = 64.0;

/// From this condition on, as a fraction of ε^(−1/4), a state with redundant equations is found from states on both sides of the place
/// where the solved equations are singular.
const SINGULAR_ALONE: f64 = 0.125;

/// The least such limit, for single precision.
const LEAST_SINGULAR_ALONE: f64 = 64.0;

impl<'a, T: SolverReal, const N: usize> Solver<'a, T, N> {
    /// A warm start from a previous state.
    #[inline(always)]
    pub(crate) fn warm<E: Description<T, N> + ?Sized>(equations: &E, predictor: Predictor<'a, T, N>) -> Self {
        let (length, reciprocal) = lengths_of(equations.characteristic_length());
        let report = StepReport { found: T::Mask::of(true), condition: T::of(1.0), iterations: 0 };
        Self(Method::WarmStart(WarmStart { predictor, length, reciprocal, report }))
    }

    /// A cold start.
    #[inline(always)]
    pub(crate) fn cold(cold: &'a T::Cold<'a, N>) -> Self {
        Self(Method::ColdStart(cold))
    }

    /// The result of a warm start.
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

    /// True on a cold start, which must write every entry. A warm start overwrites the previous state in place, where constants are
    /// already right.
    #[inline(always)]
    pub fn is_cold_start(&self) -> bool {
        matches!(self.0, Method::ColdStart(_))
    }

    /// The unknowns `own` of a block at rest: their previous values, if they and all `inputs` were and are at rest. None if the
    /// block must be solved.
    #[inline]
    pub fn resting<const K: usize>(&self, found: &Values<T, N>, inputs: &[usize], own: [usize; K]) -> Option<[T; K]> {
        match &self.0 {
            Method::WarmStart(warm) => warm.predictor.resting(found, inputs, own),
            Method::ColdStart(_) => None,
        }
    }

    /// Solves a block of one to three unknowns: in closed form.
    ///
    /// `evaluate` returns residuals and their Jacobian, with all previous blocks solved; rounding errors of the residuals are
    /// proportional to `sizes`.
    ///
    /// # Errors
    /// Why the block was not solved.
    #[inline(always)]
    pub fn small<const K: usize>(
        &mut self,
        block: &Block<K>,
        sizes: [T; K],
        evaluate: impl Fn(&Iterate<T, K>) -> ([T; K], [[T; K]; K]),
    ) -> Result<Solved<T, T::Small<K>, K>, StepError<T>> {
        self.block(
            block,
            sizes,
            #[inline(always)]
            |iterate| dense(evaluate(iterate)),
        )
    }

    /// Solves a larger block: by a pivoted factorisation.
    ///
    /// # Errors
    /// Why the block was not solved.
    pub fn large<const K: usize>(
        &mut self,
        block: &Block<K>,
        sizes: [T; K],
        evaluate: impl Fn(&Iterate<T, K>) -> ([T; K], [[T; K]; K]),
    ) -> Result<Solved<T, T::Dense<K>, K>, StepError<T>> {
        self.block(block, sizes, |iterate| dense(evaluate(iterate)))
    }

    /// Solves a larger block with a sparse Jacobian: by elimination in a fixed order, or by a pivoted factorisation where that
    /// order meets a small pivot. `evaluate` returns the entries that are not identically zero, in the order of the elimination's
    /// pattern.
    ///
    /// # Errors
    /// Why the block was not solved.
    #[inline]
    pub fn sparse<E: Elimination<T, K, ENTRIES, FACTORS>, const K: usize, const ENTRIES: usize, const FACTORS: usize>(
        &mut self,
        elimination: E,
        block: &Block<K>,
        sizes: [T; K],
        evaluate: impl Fn(&Iterate<T, K>) -> ([T; K], [T; ENTRIES]),
    ) -> Result<Solved<T, T::Sparse<E, K, ENTRIES, FACTORS>, K>, StepError<T>> {
        // Only the type of the elimination is needed.
        let _ = elimination;
        let columns = self.columns(block);
        self.block(block, sizes, |iterate| {
            let (phi, values) = evaluate(iterate);
            (SVector::from(phi), Entries { values, columns })
        })
    }

    /// Solves a block with quaternions and a sparse Jacobian: `evaluate` returns the entries of the Jacobian by turns.
    ///
    /// * `factors`: returned, the factors at the solution.
    ///
    /// # Errors
    /// Why the block was not solved.
    #[inline]
    pub fn turning<'f, E: Elimination<T, K, ENTRIES, FACTORS>, const K: usize, const ENTRIES: usize, const FACTORS: usize>(
        &mut self,
        elimination: E,
        factors: &'f mut Option<ByTurns<T, E, K, ENTRIES, FACTORS>>,
        block: &Block<K>,
        sizes: [T; K],
        evaluate: impl Fn(&Iterate<T, K>) -> ([T; K], [T; ENTRIES]),
    ) -> Result<SolvedInPlace<'f, T, ByTurns<T, E, K, ENTRIES, FACTORS>, K>, StepError<T>> {
        let _ = elimination;
        let columns = self.columns(block);
        self.block_in_place(block, sizes, factors, |iterate| {
            let (phi, values) = evaluate(iterate);
            (SVector::from(phi), AtIterate { matrix: Entries { values, columns }, x: iterate.x })
        })
    }

    /// Verifies a redundant equation, which is not solved because it follows from others.
    ///
    /// * `row`: given, its index in Φ.
    /// * `terms`, `lengths`, `angles`: given, the magnitude of its terms, and its slopes by lengths and by angles, whose errors are
    ///   proportional to L and to 1.
    #[inline(always)]
    pub fn check(&mut self, row: usize, residual: T, [terms, lengths, angles]: [T; 3]) {
        let size = terms + self.lengths().0 * lengths + angles;
        match &mut self.0 {
            Method::WarmStart(WarmStart { report, .. }) => {
                let holds = residual.abs().at_most(bound(report.condition, size));
                report.found = report.found.and(holds).and(report.condition.at_most(largest_alone()));
            }
            Method::ColdStart(cold) => cold.check(row, residual, size),
        }
    }

    /// The size of each unknown of a block.
    #[inline(always)]
    fn columns<const K: usize>(&self, block: &Block<K>) -> [T; K] {
        let (length, reciprocal) = self.lengths();
        Scale::by_kind(length, reciprocal, &block.kinds).column.data.0[0]
    }

    #[inline(always)]
    fn block<L: Linear<T, K>, const K: usize>(
        &mut self,
        block: &Block<K>,
        sizes: [T; K],
        evaluate: impl Fn(&Iterate<T, K>) -> Linearized<T, L, K>,
    ) -> Result<Solved<T, L, K>, StepError<T>> {
        let mut factors = None;
        let SolvedInPlace { x, sin_cos, .. } = self.block_in_place(block, sizes, &mut factors, evaluate)?;
        factors.map(|factors| Solved { x, sin_cos, factors }).ok_or(StepError::Far)
    }

    #[inline(always)]
    fn block_in_place<'f, L: Linear<T, K>, const K: usize>(
        &mut self,
        block: &Block<K>,
        sizes: [T; K],
        factors: &'f mut Option<L>,
        evaluate: impl Fn(&Iterate<T, K>) -> Linearized<T, L, K>,
    ) -> Result<SolvedInPlace<'f, T, L, K>, StepError<T>> {
        let WarmStart { predictor, length, reciprocal, report } = match &mut self.0 {
            Method::WarmStart(warm) => warm,
            Method::ColdStart(cold) => {
                let Solved { x, sin_cos, factors: found } = cold.solve_block(block, sizes, &evaluate)?;
                return Ok(SolvedInPlace { x, sin_cos, factors: factors.insert(found) });
            }
        };
        let data = BlockData {
            unknowns: &block.unknowns,
            needs_sin_cos: &block.needs_sin_cos,
            reciprocal: &Scale::by_kind(*length, *reciprocal, &block.kinds).reciprocal,
            sizes: &SVector::from(sizes),
        };
        let name = block.unknowns.first().copied().unwrap_or(0);
        let Some(solution) = predictor.solve(&data, name, factors, evaluate) else { return Err(StepError::Far) };
        let Some(factors) = factors else { return Err(StepError::Far) };
        report.found = report.found.and(solution.found);
        report.condition = report.condition.max(solution.condition);
        report.iterations = report.iterations.max(solution.iterations);
        Ok(SolvedInPlace { x: solution.iterate.x.data.0[0], sin_cos: solution.iterate.sin_cos, factors })
    }
}

/// The largest residual that may be a rounding error.
#[inline(always)]
pub(crate) fn bound<T: SimdReal>(condition: T, size: T) -> T {
    T::of(HOLDS) * T::EPSILON * condition * size
}

/// Up to this condition the solved equations alone give rates of states with redundant equations.
#[inline(always)]
pub(crate) fn largest_alone<T: SimdReal>() -> T {
    (T::of(SINGULAR_ALONE) / T::ROOT_EPSILON.sqrt()).max(T::of(LEAST_SINGULAR_ALONE))
}

/// Residuals and a Jacobian by rows.
#[inline(always)]
fn dense<T: SimdReal, const K: usize>((phi, rows): ([T; K], [[T; K]; K])) -> (SVector<T, K>, SMatrix<T, K, K>) {
    (SVector::from(phi), SMatrix::from_fn(|i, j| rows[i][j]))
}
