//! Cold start: globalised Newton for one block, from a rough guess or an unreliable prediction. It returns the solution or the
//! cause of failure.
//!
//! It runs seldom, so that it is compiled once for each size of block and calls the equations through a pointer.

use core::cell::Cell;

use nalgebra::{SMatrix, SVector};

use super::solver::bound;
use super::{ColdStart, SolverReal, lengths_of};
use crate::linear::{Linear, regular_part};
use crate::names::{self, Cause, Coordinate, CoordinateKind, Culprit, Description, Row};
use crate::newton::{
    self, Block, Evaluate, Iterate, LONGEST_PREDICTION, NewtonError, Part, Position, Problem, Scale, Solved, StepError, TrackError,
};
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
    /// A rough guess of q.
    Guess(&'a SVector<T, N>),
    /// Nothing is solved: q is given, and the block nearest to singular is looked for.
    Inspection(&'a SVector<T, N>),
    /// A position between two crossing branches: it is corrected only in the directions that the equations determine.
    Crossing(&'a SVector<T, N>),
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
    /// Whether there are equations to be verified.
    pub(crate) is_verified: bool,
}

impl<'a, T: Float, const N: usize> ColdSolver<'a, T, N> {
    fn new<E: Description<T, N> + ?Sized>(equations: &E, origin: Origin<'a, T, N>, branch: [DetSign; N]) -> Self {
        let report = Cell::new(ColdReport { branch, condition: T::of(1.0), iterations: 0, worst: None, off: None, is_verified: false });
        Self { origin, lengths: lengths_of(equations), rows: E::ROWS, coordinates: E::COORDINATES, report }
    }

    /// From a state to a moment `h` (s) later.
    pub(crate) fn from_prediction<E: Description<T, N> + ?Sized>(equations: &E, here: &'a State<T, N>, h: T) -> Self {
        Self::new(equations, Origin::Prediction { here, h, is_across: false }, here.branch)
    }

    /// From a state to a moment `h` (s) later, on the other side of a change point.
    pub(crate) fn across<E: Description<T, N> + ?Sized>(equations: &E, here: &'a State<T, N>, h: T) -> Self {
        Self::new(equations, Origin::Prediction { here, h, is_across: true }, here.branch)
    }

    /// From a rough guess of q.
    pub(crate) fn from_guess<E: Description<T, N> + ?Sized>(equations: &E, guess: &'a SVector<T, N>) -> Self {
        Self::new(equations, Origin::Guess(guess), [DetSign::Positive; N])
    }

    /// At a given q.
    pub(crate) fn inspection<E: Description<T, N> + ?Sized>(equations: &E, q: &'a SVector<T, N>) -> Self {
        Self::new(equations, Origin::Inspection(q), [DetSign::Positive; N])
    }

    /// Next to q, at which branches cross.
    pub(crate) fn at_crossing<E: Description<T, N> + ?Sized>(equations: &E, q: &'a SVector<T, N>) -> Self {
        Self::new(equations, Origin::Crossing(q), [DetSign::Positive; N])
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
        let picked = |q: &SVector<T, N>| Iterate::at(SVector::from_fn(|k, _| of(q, block.unknowns[k])), &block.needs_sin_cos);
        let mut report = self.report.get();
        let position = match &self.origin {
            Origin::Prediction { here, h, is_across } => {
                part.scale = grown(part.scale, block, &here.q);
                let sign = here.branch.get(first).copied().filter(|_| !is_across);
                let position = follow(&part, here, *h, &block.unknowns, sign)?;
                if sign.is_some_and(|before| before != position.factors.det_sign()) {
                    return Err(StepError::Far);
                }
                position
            }
            Origin::Guess(guess) => newton::solve_from_guess(&part, &picked(guess)).map_err(|error| open(&part, error))?,
            Origin::Inspection(q) => {
                let iterate = picked(q);
                let (_, jacobian) = part.linearize(&iterate);
                let factors = L::factor(&jacobian).map_err(|row| StepError::NotFinite(Culprit::Row(part.row(row))))?;
                // A link without length leaves its angle open, however exact its row is.
                let condition = greater(factors.condition(&part.sizes, &part.scale.reciprocal), part.weakness(&L::dense(&jacobian)));
                if report.worst.is_none() || condition > report.condition {
                    report.worst = Some(part.singular(&iterate));
                }
                Position { iterate, factors, condition, iterations: 0 }
            }
            Origin::Crossing(q) => {
                let iterate = settled(&part, picked(q))?;
                let factors = L::factor(&part.linearize(&iterate).1).map_err(|row| StepError::NotFinite(Culprit::Row(part.row(row))))?;
                Position { iterate, factors, condition: T::of(1.0), iterations: SETTLING }
            }
        };
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
        report.is_verified = true;
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

/// Number of corrections of a position between two crossing branches; half of its digits are already right in the directions that
/// are corrected.
const SETTLING: usize = 2;

/// At a crossing residuals are at most this many roundings of their terms; where two branches only come close, a gap remains.
const GAP: f64 = 8.0;

/// An iterate at which the equations hold to rounding, corrected in the directions that they determine.
///
/// # Errors
/// If a gap remains.
fn settled<T: Float, P: Problem<T, K>, const K: usize>(problem: &P, mut iterate: Iterate<T, K>) -> Result<Iterate<T, K>, StepError<T>> {
    let column = &problem.scale().column;
    for _ in 0..SETTLING {
        let (phi, jacobian) = problem.linearize(&iterate);
        let (sizes, rows) = (newton::sizes(problem, &jacobian), P::Factors::dense(&jacobian));
        let scaled = SMatrix::<T, K, K>::from_fn(|i, j| rows[(i, j)] * column[j] / sizes[i]);
        let residual = SVector::<T, K>::from_fn(|i, _| -phi[i] / sizes[i]);
        let correction = regular_part(&scaled, &residual).ok_or(StepError::Far)?;
        iterate = iterate.moved(T::of(1.0), &SVector::from_fn(|j, _| correction[j] * column[j]), problem.needs_sin_cos());
    }
    let (phi, jacobian) = problem.linearize(&iterate);
    let sizes = newton::sizes(problem, &jacobian);
    let holds = phi.iter().zip(&sizes).all(|(residual, &size)| residual.abs() <= T::of(GAP) * T::EPSILON * size);
    if holds { Ok(iterate) } else { Err(StepError::Far) }
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

/// Tracks from the prediction q + h q̇ + h² q̈ / 2.
fn follow<T: Float, P: Problem<T, K>, const K: usize, const N: usize>(
    problem: &P,
    here: &State<T, N>,
    h: T,
    unknowns: &[usize; K],
    sign: Option<DetSign>,
) -> Result<Position<T, P::Factors, K>, StepError<T>> {
    let mut x = SVector::from_element(T::of(0.0));
    let mut way = x;
    for k in 0..K {
        let i = unknowns[k];
        let (first, second) = (h * of(&here.qd, i), h * h * T::of(0.5) * of(&here.qdd, i));
        x[k] = of(&here.q, i) + (first + second);
        way[k] = first.abs() + second.abs();
    }
    // Angles are periodic: a long prediction may lead to the solution a whole turn away.
    if problem.scale().norm(&way) > T::of(LONGEST_PREDICTION) {
        return Err(StepError::Far);
    }
    Ok(newton::track(problem, &Iterate::at(x, problem.needs_sin_cos()), sign)?)
}

/// The entry of an unknown, whose index is in range.
fn of<T: Float, const N: usize>(vector: &SVector<T, N>, unknown: usize) -> T {
    vector.get(unknown).copied().unwrap_or(T::of(f64::NAN))
}

/// Why a block was not solved from a guess.
fn open<T: Float, P: Problem<T, K>, const K: usize>(problem: &P, error: NewtonError<T, K>) -> StepError<T> {
    match error {
        NewtonError::NotFinite(of) => StepError::NotFinite(of),
        NewtonError::Singular(iterate) | NewtonError::Stuck(iterate) => {
            StepError::Open(problem.widest_gap(&iterate).unwrap_or_else(|| problem.singular(&iterate)))
        }
        NewtonError::NoConvergence { correction, iterations } => StepError::Open(Cause::NoConvergence { correction, iterations }),
    }
}

impl<T> From<TrackError> for StepError<T> {
    fn from(error: TrackError) -> Self {
        match error {
            TrackError::NotFinite(of) => StepError::NotFinite(of),
            TrackError::Singular | TrackError::Far => StepError::Far,
        }
    }
}
