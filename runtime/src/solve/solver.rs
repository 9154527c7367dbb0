//! One pass through the stages of a mechanism: what its blocks are solved from, and what that leaves behind.

use nalgebra::{SMatrix, SVector};

use super::{ColdStart, SolverReal, lengths_of};
use crate::linear::{Elimination, Entries, Linear, Small, Sparse};
use crate::names::Description;
use crate::newton::{Block, Departure, Linearized, Place, Scale, Scene, Solved, Stop};
use crate::number::{Mask, SimdReal};
use crate::state::Coordinates;

/// One pass through the stages of a mechanism.
///
/// What is needed for care lies elsewhere, so that a pass straight on can stay in registers, and of the two ways through a block
/// rustc compiles only the one that is gone.
pub struct Pass<'a, T: SolverReal, const N: usize>(Way<'a, T, N>);

/// How blocks are solved.
enum Way<'a, T: SolverReal, const N: usize> {
    Straight(Straight<'a, T, N>),
    Careful(&'a T::Cold<'a, N>),
}

/// A pass straight on, the usual case.
struct Straight<'a, T: SolverReal, const N: usize> {
    from: Departure<'a, T, N>,
    /// L and 1/L.
    length: T,
    share: T,
    walk: Walk<T>,
}

/// What a pass straight on leaves behind.
#[derive(Clone, Copy)]
pub(crate) struct Walk<T: SolverReal> {
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

impl<'a, T: SolverReal, const N: usize> Pass<'a, T, N> {
    /// From a state to a moment later, straight on.
    #[inline(always)]
    pub(crate) fn straight<E: Description<T, N> + ?Sized>(equations: &E, from: Departure<'a, T, N>) -> Self {
        let (length, share) = lengths_of(equations);
        let walk = Walk { found: T::Mask::of(true), condition: T::of(1.0), iterations: 0 };
        Self(Way::Straight(Straight { from, length, share, walk }))
    }

    /// With care.
    #[inline(always)]
    pub(crate) fn cold(cold: &'a T::Cold<'a, N>) -> Self {
        Self(Way::Careful(cold))
    }

    /// What a pass straight on leaves behind.
    #[inline(always)]
    pub(crate) fn walk(&self) -> Option<Walk<T>> {
        if let Way::Straight(straight) = &self.0 { Some(straight.walk) } else { None }
    }

    /// L and 1/L
    #[inline(always)]
    fn lengths(&self) -> (T, T) {
        match &self.0 {
            Way::Straight(straight) => (straight.length, straight.share),
            Way::Careful(care) => care.lengths(),
        }
    }

    /// It begins with nothing; a pass straight on writes over the state before, in which constants are what they always are.
    #[inline(always)]
    pub fn starts_anew(&self) -> bool {
        matches!(self.0, Way::Careful(_))
    }

    /// Where unknowns of a block are if nothing moves it: where they were, if they rested and so did and do all `inputs`. None if
    /// it has to be solved.
    #[inline]
    pub fn resting<const K: usize>(&self, found: &Coordinates<T, N>, inputs: &[usize], own: [usize; K]) -> Option<[T; K]> {
        match &self.0 {
            Way::Straight(straight) => straight.from.resting(found, inputs, own),
            Way::Careful(_) => None,
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
        let (length, share) = self.lengths();
        let columns = Scale::by_kind(length, share, &block.kinds).column.data.0[0];
        self.block(block, sizes, |place| {
            let (phi, values) = evaluate(place);
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
            Way::Straight(Straight { walk, .. }) => {
                walk.found = walk.found.and(residual.abs().at_most(bound(walk.condition, size)));
            }
            Way::Careful(care) => care.check(row, residual, size),
        }
    }

    #[inline(always)]
    fn block<L: Linear<T, K>, const K: usize>(
        &mut self,
        block: &Block<K>,
        sizes: [T; K],
        evaluate: impl Fn(&Place<T, K>) -> Linearized<T, L, K>,
    ) -> Result<Solved<T, L, K>, Stop<T>> {
        let Straight { from, length, share, walk } = match &mut self.0 {
            Way::Straight(straight) => straight,
            Way::Careful(care) => return care.solve_block(block, sizes, &evaluate),
        };
        let scene = Scene {
            unknowns: &block.unknowns,
            turns: &block.turns,
            share: &Scale::by_kind(*length, *share, &block.kinds).share,
            sizes: &SVector::from(sizes),
        };
        let name = block.unknowns.first().copied().unwrap_or(0);
        let Some(arrival) = from.solve(&scene, name, evaluate) else { return Err(Stop::Far) };
        walk.found = walk.found.and(arrival.found);
        walk.condition = walk.condition.max(arrival.condition);
        walk.iterations = walk.iterations.max(arrival.iterations);
        Ok(Solved { x: arrival.place.x.data.0[0], turn: arrival.place.turn, factors: arrival.factors })
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
