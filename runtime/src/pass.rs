//! One pass through the stages of a mechanism: what Newton's method sets out from, and what it leaves behind.

use core::marker::PhantomData;

use nalgebra::{SMatrix, SVector};

use crate::linear::{Elimination, Entries, Factors, Linear, Small, Sparse};
use crate::order::greater;
use crate::place::Place;
use crate::position::{self, Miss, Position, Refusal};
use crate::problem::{Block, Linearized, Part, Problem};
use crate::scale::Scale;
use crate::{Cause, Coordinate, Culprit, Equations, Float, Orientation, Row, State};

/// Longest way of a prediction, scaled; an eighth of a turn, so that it cannot be mistaken for another turn.
const LONGEST_PREDICTION: f64 = 0.8;

/// What Newton's method sets out from in every block.
enum Mode<'a, T, const N: usize> {
    /// A prediction from this state, `h` seconds before.
    Follow { here: &'a State<T, N>, h: T },
    /// A rough guess of q.
    Close { guess: &'a SVector<T, N> },
    /// Nothing is solved: these are the positions, and the block that is nearest to singular is looked for.
    Inspect { q: &'a SVector<T, N>, worst: Option<Cause<T>> },
}

/// One pass through the stages of a mechanism.
pub struct Pass<'a, T, const N: usize> {
    mode: Mode<'a, T, N>,
    length: T,
    share: T,
    rows: &'static [Row],
    coordinates: &'static [Coordinate],
    pub(crate) branch: [Orientation; N],
    pub(crate) condition: T,
    pub(crate) iterations: usize,
}

/// Why a pass ended early.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stop<T> {
    /// A shorter step may do.
    Far,
    /// A number is not finite.
    NotFinite(Culprit),
    /// The equations do not hold anywhere near, or their Jacobian is singular.
    Open(Cause<T>),
}

/// A block with its unknowns found.
pub struct Solved<T, L, const K: usize> {
    /// The unknowns, in m and rad.
    pub x: [T; K],
    /// (sine, cosine) of those that turn.
    pub turn: [(T, T); K],
    factors: L,
}

impl<'a, T: Float, const N: usize> Pass<'a, T, N> {
    /// From a state, to a moment h later.
    #[inline(always)]
    pub(crate) fn follow<E: Equations<T, N, N> + ?Sized>(equations: &E, here: &'a State<T, N>, h: T) -> Self {
        Self::new(equations, Mode::Follow { here, h })
    }

    /// From a rough guess.
    pub(crate) fn close<E: Equations<T, N, N> + ?Sized>(equations: &E, guess: &'a SVector<T, N>) -> Self {
        Self::new(equations, Mode::Close { guess })
    }

    /// At given positions.
    pub(crate) fn inspect<E: Equations<T, N, N> + ?Sized>(equations: &E, q: &'a SVector<T, N>) -> Self {
        Self::new(equations, Mode::Inspect { q, worst: None })
    }

    #[inline(always)]
    fn new<E: Equations<T, N, N> + ?Sized>(equations: &E, mode: Mode<'a, T, N>) -> Self {
        let length = equations.characteristic_length();
        let length = if length > T::of(0.0) && length.is_finite() { length } else { T::of(1.0) };
        // A state that is followed keeps its branch.
        let branch = if let Mode::Follow { here, .. } = &mode { here.branch } else { [Orientation::Positive; N] };
        Self {
            mode,
            length,
            share: T::of(1.0) / length,
            rows: E::ROWS,
            coordinates: E::COORDINATES,
            branch,
            condition: T::of(1.0),
            iterations: 0,
        }
    }

    /// The block nearest to singular, after an inspection.
    pub(crate) fn worst(&self) -> Option<Cause<T>> {
        if let Mode::Inspect { worst, .. } = self.mode { worst } else { None }
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
        evaluate: impl Fn(&Place<T, K>) -> ([T; K], [[T; K]; K]),
    ) -> Result<Solved<T, Small<T, K>, K>, Stop<T>> {
        self.block(block, sizes, |place| dense(evaluate(place)))
    }

    /// Solves a larger block: by a pivoted factorisation.
    ///
    /// # Errors
    /// Why the block has no solution near.
    pub fn large<const K: usize>(
        &mut self,
        block: &Block<K>,
        sizes: [T; K],
        evaluate: impl Fn(&Place<T, K>) -> ([T; K], [[T; K]; K]),
    ) -> Result<Solved<T, Factors<T, K>, K>, Stop<T>> {
        self.block(block, sizes, |place| dense(evaluate(place)))
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
        evaluate: impl Fn(&Place<T, K>) -> ([T; K], [T; ENTRIES]),
    ) -> Result<Solved<T, Sparse<T, E, K, ENTRIES, FACTORS>, K>, Stop<T>> {
        // Of the elimination only the type is needed.
        let _ = elimination;
        let columns = Scale::by_kind(self.length, self.share, &block.kinds).column.data.0[0];
        self.block(block, sizes, |place| {
            let (phi, values) = evaluate(place);
            (SVector::from(phi), Entries { values, columns })
        })
    }

    #[inline(always)]
    fn block<L: Linear<T, K>, const K: usize>(
        &mut self,
        block: &Block<K>,
        sizes: [T; K],
        evaluate: impl Fn(&Place<T, K>) -> Linearized<T, L, K>,
    ) -> Result<Solved<T, L, K>, Stop<T>> {
        let part = Part {
            evaluate,
            block,
            scale: Scale::by_kind(self.length, self.share, &block.kinds),
            sizes: SVector::from(sizes),
            rows: self.rows,
            coordinates: self.coordinates,
            factors: PhantomData::<L>,
        };
        let first = block.unknowns.first().copied().unwrap_or(0);
        let position = self.run(&part, &block.unknowns, first)?;
        Ok(Solved { x: position.place.x.data.0[0], turn: position.place.turn, factors: position.factors })
    }

    /// Solves a problem from a guess, or looks at it where it is.
    #[cold]
    #[inline(never)]
    fn assemble<P: Problem<T, K>, const K: usize>(
        &mut self,
        problem: &P,
        unknowns: &[usize; K],
    ) -> Result<Position<T, P::Factors, K>, Stop<T>> {
        let picked = |q: &SVector<T, N>| Place::at(SVector::from_fn(|k, _| q[unknowns[k]]), problem.turns());
        match &mut self.mode {
            Mode::Follow { .. } => Err(Stop::Far),
            Mode::Close { guess } => position::close(problem, &picked(guess)).map_err(|miss| open(problem, miss)),
            Mode::Inspect { q, worst } => {
                let place = picked(q);
                let (_, jacobian) = problem.linearize(&place);
                let factors = P::Factors::factor(&jacobian).map_err(|row| Stop::NotFinite(Culprit::Row(problem.row(row))))?;
                let condition = factors.condition(&problem.sizes(), &problem.scale().share);
                if worst.is_none() || condition > self.condition {
                    *worst = Some(problem.singular(&place));
                }
                Ok(Position { place, factors, condition, iterations: 0 })
            }
        }
    }

    /// Solves a problem whose unknowns have these indices; its orientation is kept at index `name`.
    #[inline(always)]
    pub(crate) fn run<P: Problem<T, K>, const K: usize>(
        &mut self,
        problem: &P,
        unknowns: &[usize; K],
        name: usize,
    ) -> Result<Position<T, P::Factors, K>, Stop<T>> {
        let position = if let Mode::Follow { here, h } = &self.mode {
            let mut x = SVector::from_element(T::of(0.0));
            let mut way = x;
            for k in 0..K {
                let i = unknowns[k];
                let (first, second) = (*h * here.qd[i], *h * *h * T::of(0.5) * here.qdd[i]);
                x[k] = here.q[i] + (first + second);
                way[k] = first.abs() + second.abs();
            }
            // Angles repeat: a prediction that goes far may come to the solution of another turn.
            if problem.scale().norm(&way) > T::of(LONGEST_PREDICTION) {
                return Err(Stop::Far);
            }
            let position = position::follow(problem, &Place::at(x, problem.turns()))?;
            if here.branch.get(name).is_some_and(|before| *before != position.factors.orientation()) {
                return Err(Stop::Far);
            }
            position
        } else {
            let position = self.assemble(&problem.erased(), unknowns)?;
            if let Some(orientation) = self.branch.get_mut(name) {
                *orientation = position.factors.orientation();
            }
            position
        };
        self.condition = greater(self.condition, position.condition);
        self.iterations = self.iterations.max(position.iterations);
        Ok(position)
    }
}

impl<T: Float, L: Linear<T, K>, const K: usize> Solved<T, L, K> {
    /// The rates that the block's Jacobian maps to `b`, refined where that makes them better.
    #[inline]
    pub fn rates(&self, b: [T; K]) -> [T; K] {
        self.factors.solve_refined(&SVector::from(b)).data.0[0]
    }
}

/// Residuals and a Jacobian by rows.
#[inline(always)]
fn dense<T: Float, const K: usize>((phi, rows): ([T; K], [[T; K]; K])) -> (SVector<T, K>, SMatrix<T, K, K>) {
    (SVector::from(phi), SMatrix::from_fn(|i, j| rows[i][j]))
}

/// Why a block could not be closed.
fn open<T: Float, P: Problem<T, K>, const K: usize>(problem: &P, miss: Miss<T, K>) -> Stop<T> {
    match miss {
        Miss::NotFinite(of) => Stop::NotFinite(of),
        Miss::Singular(place) | Miss::Stuck(place) => Stop::Open(problem.widest_gap(&place).unwrap_or_else(|| problem.singular(&place))),
        Miss::NoConvergence { correction, iterations } => Stop::Open(Cause::NoConvergence { correction, iterations }),
    }
}

impl<T> From<Refusal> for Stop<T> {
    #[inline]
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::NotFinite(of) => Stop::NotFinite(of),
            Refusal::Singular | Refusal::Far => Stop::Far,
        }
    }
}

impl<T> From<Culprit> for Stop<T> {
    fn from(culprit: Culprit) -> Self {
        Self::NotFinite(culprit)
    }
}
