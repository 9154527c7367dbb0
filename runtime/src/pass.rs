//! One pass through the stages of a mechanism: what its blocks are solved from, and what that leaves behind.

use nalgebra::{SMatrix, SVector};

use crate::lanes::Mask;
use crate::linear::{Elimination, Entries, Linear, Small, Sparse};
use crate::place::Place;
use crate::problem::{Block, Linearized};
use crate::scale::{Scale, length_of};
use crate::straight::{Departure, Scene};
use crate::{Cause, Coordinate, Culprit, Description, Float, Lanes, Row, State};

/// What a block is solved from.
pub(crate) enum Mode<'a, T: Lanes, const N: usize> {
    /// What the last states tell; the usual case.
    Straight { from: Departure<'a, T, N>, found: T::Mask },
    /// A prediction from this state, `h` seconds before.
    Follow { here: &'a State<T, N>, h: T },
    /// A rough guess of q.
    Close { guess: &'a SVector<T, N> },
    /// Nothing is solved: these are the positions, and the block that is nearest to singular is looked for.
    Inspect { q: &'a SVector<T, N>, worst: Option<Cause<T>> },
}

/// One pass through the stages of a mechanism.
pub struct Pass<'a, T: Lanes, const N: usize> {
    pub(crate) mode: Mode<'a, T, N>,
    /// L and 1/L.
    pub(crate) length: T,
    pub(crate) share: T,
    pub(crate) rows: &'static [Row],
    pub(crate) coordinates: &'static [Coordinate],
    /// Of blocks that were not solved straight on: those that were have kept the sign they had.
    pub(crate) branch: [T::Sides; N],
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
    pub(crate) factors: L,
}

impl<'a, T: Float, const N: usize> Pass<'a, T, N> {
    /// From a state, to a moment h later.
    pub(crate) fn follow<E: Description<T, N> + ?Sized>(equations: &E, here: &'a State<T, N>, h: T) -> Self {
        Self { branch: here.branch, ..Self::new(equations, Mode::Follow { here, h }) }
    }

    /// From a rough guess.
    pub(crate) fn close<E: Description<T, N> + ?Sized>(equations: &E, guess: &'a SVector<T, N>) -> Self {
        Self::new(equations, Mode::Close { guess })
    }

    /// At given positions.
    pub(crate) fn inspect<E: Description<T, N> + ?Sized>(equations: &E, q: &'a SVector<T, N>) -> Self {
        Self::new(equations, Mode::Inspect { q, worst: None })
    }

    /// The block nearest to singular, after an inspection.
    pub(crate) fn worst(&self) -> Option<Cause<T>> {
        if let Mode::Inspect { worst, .. } = self.mode { worst } else { None }
    }
}

impl<'a, T: Lanes, const N: usize> Pass<'a, T, N> {
    /// From a state to a moment h later, straight on.
    #[inline(always)]
    pub(crate) fn straight<E: Description<T, N> + ?Sized>(equations: &E, from: Departure<'a, T, N>) -> Self {
        Self::new(equations, Mode::Straight { from, found: T::Mask::of(true) })
    }

    #[inline(always)]
    fn new<E: Description<T, N> + ?Sized>(equations: &E, mode: Mode<'a, T, N>) -> Self {
        let length = length_of(equations.characteristic_length());
        let (one, rows, coordinates) = (T::of(1.0), E::ROWS, E::COORDINATES);
        Self { mode, length, share: one / length, rows, coordinates, branch: [one.sides(); N], condition: one, iterations: 0 }
    }

    /// The lanes in which everything was found, after a pass straight on.
    #[inline(always)]
    pub(crate) fn found(&self) -> T::Mask {
        if let Mode::Straight { found, .. } = self.mode { found } else { T::Mask::of(false) }
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
    ) -> Result<Solved<T, T::Dense<K>, K>, Stop<T>> {
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
        let Mode::Straight { from, found } = &mut self.mode else {
            return T::carefully(self, block, sizes, &evaluate);
        };
        let scene = Scene {
            unknowns: &block.unknowns,
            turns: &block.turns,
            share: &Scale::by_kind(self.length, self.share, &block.kinds).share,
            sizes: &SVector::from(sizes),
        };
        let name = block.unknowns.first().copied().unwrap_or(0);
        let Some(arrival) = from.solve(&scene, name, evaluate) else { return Err(Stop::Far) };
        *found = found.and(arrival.found);
        self.condition = self.condition.max(arrival.condition);
        self.iterations = self.iterations.max(arrival.iterations);
        Ok(Solved { x: arrival.place.x.data.0[0], turn: arrival.place.turn, factors: arrival.factors })
    }
}

impl<T: Lanes, L: Linear<T, K>, const K: usize> Solved<T, L, K> {
    /// The rates that the block's Jacobian maps to `b`, refined where that makes them better.
    #[inline(always)]
    pub fn rates(&self, b: [T; K]) -> [T; K] {
        self.factors.solve_refined(&SVector::from(b)).data.0[0]
    }
}

/// Residuals and a Jacobian by rows.
#[inline(always)]
fn dense<T: Lanes, const K: usize>((phi, rows): ([T; K], [[T; K]; K])) -> (SVector<T, K>, SMatrix<T, K, K>) {
    (SVector::from(phi), SMatrix::from_fn(|i, j| rows[i][j]))
}
