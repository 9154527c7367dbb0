//! Cold start: globalised Newton for one block, from a rough guess or an unreliable prediction. It returns the solution or the
//! cause of failure.
//!
//! It runs seldom, so that it is compiled once for each size of block and calls the equations through a pointer.

use core::cell::Cell;

use nalgebra::SVector;

use super::block::{Manner, Start};
use super::solver::bound;
use super::{ColdStart, Followed, SolverReal, lengths_of, once};
use crate::linear::Linear;
use crate::names::{self, Cause, Coordinate, CoordinateKind, Row};
use crate::newton::{Block, Evaluate, Iterate, Part, Scale, Solved, StepError};
use crate::number::order::greater;
use crate::number::{DetSign, Float};
use crate::state::State;

impl<T: Float> SolverReal for T {
    type Cold<'a, const N: usize> = ColdSolver<'a, T, N>;
}

/// Cold start of the blocks of a mechanism, and its report so far.
pub struct ColdSolver<'a, T: Float, const N: usize> {
    origin: Origin<'a, T, N>,
    /// L and 1/L.
    lengths: (T, T),
    rows: &'static [Row],
    coordinates: &'static [Coordinate],
    report: Cell<ColdReport<T, N>>,
}

/// The point from which blocks are solved.
enum Origin<'a, T, const N: usize> {
    /// A prediction from this state, `h` seconds before; across a change point determinants may change their signs.
    Prediction { here: &'a State<T, N>, h: T, is_across: bool },
    /// This q.
    Position(&'a SVector<T, N>, Use),
}

/// Uses of a given q.
#[derive(Clone, Copy)]
enum Use {
    /// It is a rough guess.
    Guess,
    /// Nothing is solved, and the block nearest to singular is looked for.
    Inspection,
    /// It lies between two crossing branches, and is corrected only in the directions that the equations determine.
    Crossing,
}

/// The result of a cold start.
#[derive(Clone, Copy)]
pub(crate) struct ColdReport<T, const N: usize> {
    /// The signs of the blocks' determinants, each at the index of the block's first unknown.
    pub(crate) branch: [DetSign; N],
    /// The largest condition of a block.
    pub(crate) condition: T,
    /// The largest number of factorisations of a block.
    pub(crate) iterations: usize,
    /// At an inspection: the block nearest to singular.
    pub(crate) worst: Option<Cause<T>>,
    /// Of the verified equations that do not hold, the one with the largest residual by its bound: its index in Φ, its residual,
    /// and the residual divided by the bound.
    pub(crate) off: Option<(usize, T, T)>,
}

impl<'a, T: Float, const N: usize> ColdSolver<'a, T, N> {
    fn new(mechanism: &Followed<'_, T, N>, origin: Origin<'a, T, N>, branch: [DetSign; N]) -> Self {
        let report = Cell::new(ColdReport { branch, condition: T::of(1.0), iterations: 0, worst: None, off: None });
        Self { origin, lengths: lengths_of(mechanism.length), rows: mechanism.rows, coordinates: mechanism.coordinates, report }
    }

    /// From a state to a moment `h` (s) later.
    pub(crate) fn from_prediction(mechanism: &Followed<'_, T, N>, here: &'a State<T, N>, h: T) -> Self {
        Self::new(mechanism, Origin::Prediction { here, h, is_across: false }, here.branch)
    }

    /// From a state to a moment `h` (s) later, on the other side of a change point.
    pub(crate) fn across(mechanism: &Followed<'_, T, N>, here: &'a State<T, N>, h: T) -> Self {
        Self::new(mechanism, Origin::Prediction { here, h, is_across: true }, here.branch)
    }

    /// From a rough guess of q.
    pub(crate) fn from_guess(mechanism: &Followed<'_, T, N>, guess: &'a SVector<T, N>) -> Self {
        Self::new(mechanism, Origin::Position(guess, Use::Guess), [DetSign::Positive; N])
    }

    /// At a given q.
    pub(crate) fn inspection(mechanism: &Followed<'_, T, N>, q: &'a SVector<T, N>) -> Self {
        Self::new(mechanism, Origin::Position(q, Use::Inspection), [DetSign::Positive; N])
    }

    /// Next to q, at which branches cross.
    pub(crate) fn at_crossing(mechanism: &Followed<'_, T, N>, q: &'a SVector<T, N>) -> Self {
        Self::new(mechanism, Origin::Position(q, Use::Crossing), [DetSign::Positive; N])
    }

    /// The result so far.
    pub(crate) fn report(&self) -> ColdReport<T, N> {
        self.report.get()
    }

    /// The verified equation that is off most, if one does not hold.
    pub(crate) fn contradiction(&self) -> Option<Cause<T>> {
        let (row, residual, _) = self.report.get().off?;
        Some(Cause::DoesNotHold { row: names::row(self.rows, row), residual })
    }
}

impl<T: Float, const N: usize> ColdStart<T, N> for ColdSolver<'_, T, N> {
    fn lengths(&self) -> (T, T) {
        self.lengths
    }

    #[cold]
    #[inline(never)]
    fn solve_block<L: Linear<T, K>, const K: usize>(
        &self,
        block: &Block<K>,
        sizes: [T; K],
        evaluate: &Evaluate<'_, T, L, K>,
    ) -> Result<Solved<T, L, K>, StepError<T>> {
        let mut part: Part<'_, T, L, K> = Part {
            evaluate,
            block,
            scale: Scale::by_kind(self.lengths.0, self.lengths.1, &block.kinds),
            sizes: SVector::from(sizes),
            rows: self.rows,
            coordinates: self.coordinates,
        };
        let first = block.unknowns.first().copied().unwrap_or(0);
        let mut report = self.report.get();
        let (x, manner) = match self.origin {
            Origin::Prediction { here, h, is_across } => {
                part.scale = grown(part.scale, block, &here.q);
                let (x, way) = predicted(here, h, block);
                (x, Manner::Tracking { way, sign: here.branch.get(first).copied().filter(|_| !is_across) })
            }
            Origin::Position(q, Use::Guess) => (picked(q, block), Manner::FromGuess),
            Origin::Position(q, Use::Crossing) => (picked(q, block), Manner::Settling),
            Origin::Position(q, Use::Inspection) => {
                (picked(q, block), Manner::Inspection { known: report.worst.map(|_| report.condition) })
            }
        };
        let start = Start { iterate: Iterate::at(x, &block.needs_sin_cos), manner };
        let (position, worse) = once::solved(&part, &start)?;
        report.worst = worse.or(report.worst);
        if let Some(sign) = report.branch.get_mut(first) {
            *sign = position.factors.det_sign();
        }
        report.condition = greater(report.condition, position.condition);
        report.iterations = report.iterations.max(position.iterations);
        self.report.set(report);
        Ok(Solved { x: position.iterate.x.data.0[0], sin_cos: position.iterate.sin_cos, factors: position.factors })
    }

    fn check(&self, row: usize, residual: T, size: T) {
        let mut report = self.report.get();
        let bound = bound(report.condition, size);
        let holds = residual.abs() <= bound;
        // NaN never holds, and no residual is off by more.
        let excess = residual.abs() / bound;
        let is_known = report.off.is_some_and(|(_, _, most)| excess <= most || !most.at_most(most));
        if !holds && !is_known && size.at_most(size) {
            report.off = Some((row, residual, excess));
        }
        self.report.set(report);
    }
}

/// A length larger than L is scaled by its own value.
fn grown<T: Float, const K: usize, const N: usize>(mut scale: Scale<T, K>, block: &Block<K>, q: &SVector<T, N>) -> Scale<T, K> {
    for k in 0..K {
        let size = of(q, block.unknowns[k]).abs();
        if block.kinds[k] == CoordinateKind::Length && size > scale.length {
            (scale.column[k], scale.reciprocal[k]) = (size, T::of(1.0) / size);
        }
    }
    scale
}

/// The prediction q + h q̇ + h² q̈ / 2, and the distance of each unknown from the state.
fn predicted<T: Float, const K: usize, const N: usize>(here: &State<T, N>, h: T, block: &Block<K>) -> (SVector<T, K>, SVector<T, K>) {
    let mut x = SVector::from_element(T::of(0.0));
    let mut way = x;
    for (k, &i) in block.unknowns.iter().enumerate() {
        let (first, second) = (h * of(&here.qd, i), h * h * T::of(0.5) * of(&here.qdd, i));
        x[k] = of(&here.q, i) + (first + second);
        way[k] = first.abs() + second.abs();
    }
    (x, way)
}

/// The unknowns of a block.
fn picked<T: Float, const K: usize, const N: usize>(q: &SVector<T, N>, block: &Block<K>) -> SVector<T, K> {
    SVector::from(block.unknowns.map(|unknown| of(q, unknown)))
}

/// The entry of an unknown, whose index is in range.
fn of<T: Float, const N: usize>(vector: &SVector<T, N>, unknown: usize) -> T {
    vector.get(unknown).copied().unwrap_or(T::of(f64::NAN))
}
