//! A block with care: from a guess or from a prediction that may be bad, to a solution, or to the reason why there is none.
//!
//! Seldom run, so it is compiled once for each size of block and takes the equations through a pointer.

use core::cell::Cell;

use nalgebra::{SMatrix, SVector};

#[cfg(feature = "certify")]
use crate::enclosure::Wanted;
use crate::iterate;
use crate::lanes::Mask;
use crate::linear::{Linear, regular_part};
use crate::order::greater;
use crate::pass::{Solved, Stop, bound};
use crate::place::Place;
use crate::position::{self, Miss, Position, Refusal};
use crate::problem::{Block, Evaluate, Part, Problem};
use crate::scale::{Scale, length_of};
use crate::straight::LONGEST_PREDICTION;
use crate::{Cause, Coordinate, CoordinateKind, Culprit, Description, Float, Lanes, Orientation, Row, State, names};

/// What a careful pass sets out from and what it has found.
pub struct Care<'a, T: Lanes, const N: usize> {
    mode: Mode<'a, T, N>,
    /// L and 1/L.
    length: T,
    share: T,
    rows: &'static [Row],
    coordinates: &'static [Coordinate],
    found: Cell<Found<T, N>>,
}

impl<T: Lanes, const N: usize> Care<'_, T, N> {
    /// The positions that are given, if they are.
    pub(crate) fn given(&self) -> Option<&SVector<T, N>> {
        if let Mode::Inspect { q } = self.mode { Some(q) } else { None }
    }

    /// What the pass encloses, if it does.
    #[cfg(feature = "certify")]
    pub(crate) fn wanted(&self) -> Option<&Wanted<N>> {
        if let Mode::Enclose(wanted) = self.mode { Some(wanted) } else { None }
    }

    /// The name of a coordinate.
    pub(crate) fn coordinate(&self, index: usize) -> Coordinate {
        names::coordinate(self.coordinates, index)
    }

    /// The index in Φ of the equation that is off most, if any is.
    #[cfg(feature = "certify")]
    pub(crate) fn off(&self) -> Option<usize> {
        Some(self.found.get().off?.0)
    }

    /// L and 1/L.
    pub(crate) fn lengths(&self) -> (T, T) {
        (self.length, self.share)
    }

    /// Takes note of the residual of an equation that is not solved.
    pub(crate) fn check(&self, row: usize, residual: T, size: T) {
        let mut found = self.found.get();
        let bound = bound(found.condition, size);
        let holds = T::may_vanish(residual, bound).all();
        // What is not a number is off, and nothing is more off.
        let share = residual.abs() / bound;
        let is_known = found.off.is_some_and(|(_, _, most)| share.at_most(most).all() || !most.at_most(most).all());
        if !holds && !is_known && size.at_most(size).all() {
            found.off = Some((row, residual, share));
            self.found.set(found);
        }
    }
}

/// What a careful pass has found so far.
#[derive(Clone, Copy)]
pub(crate) struct Found<T, const N: usize> {
    pub(crate) branch: [Orientation; N],
    /// The worst condition of a block.
    pub(crate) condition: T,
    /// The most factorisations of a block.
    pub(crate) iterations: usize,
    /// The block nearest to singular, if that was asked for.
    pub(crate) worst: Option<Cause<T>>,
    /// Of the equations that are checked and do not hold, the one that is off by most of its bounds: its index in Φ, its residual,
    /// and the residual by the bound.
    pub(crate) off: Option<(usize, T, T)>,
}

/// What a block is solved from.
enum Mode<'a, T, const N: usize> {
    /// A prediction from this state, `h` seconds before; across a change point determinants may change their signs.
    Follow { here: &'a State<T, N>, h: T, is_across: bool },
    /// A rough guess of q.
    Close { guess: &'a SVector<T, N> },
    /// Nothing is solved: these are the positions, and the block that is nearest to singular is looked for.
    Inspect { q: &'a SVector<T, N> },
    /// These are the positions in whatever direction the equations hardly determine; in all others they are corrected.
    Settle { q: &'a SVector<T, N> },
    /// Solutions are enclosed next to a state, which only [`Enclosure`](crate::Enclosure) can do.
    #[cfg(feature = "certify")]
    Enclose(&'a Wanted<N>),
}

impl<'a, T: Lanes, const N: usize> Care<'a, T, N> {
    /// To enclose the solution next to a state.
    #[cfg(feature = "certify")]
    pub(crate) fn enclose<E: Description<T, N> + ?Sized>(equations: &E, wanted: &'a Wanted<N>) -> Self {
        Self::new(equations, Mode::Enclose(wanted), [Orientation::Positive; N])
    }

    /// At given positions.
    pub(crate) fn inspect<E: Description<T, N> + ?Sized>(equations: &E, q: &'a SVector<T, N>) -> Self {
        Self::new(equations, Mode::Inspect { q }, [Orientation::Positive; N])
    }

    fn new<E: Description<T, N> + ?Sized>(equations: &E, mode: Mode<'a, T, N>, branch: [Orientation; N]) -> Self {
        let length = length_of(equations.characteristic_length());
        let one = T::of(1.0);
        let found = Cell::new(Found { branch, condition: one, iterations: 0, worst: None, off: None });
        Self { mode, length, share: one / length, rows: E::ROWS, coordinates: E::COORDINATES, found }
    }
}

impl<'a, T: Float, const N: usize> Care<'a, T, N> {
    /// From a state, to a moment h later.
    pub(crate) fn follow<E: Description<T, N> + ?Sized>(equations: &E, here: &'a State<T, N>, h: T) -> Self {
        Self::new(equations, Mode::Follow { here, h, is_across: false }, here.branch)
    }

    /// From a state, to a moment h later on the other side of a change point.
    pub(crate) fn across<E: Description<T, N> + ?Sized>(equations: &E, here: &'a State<T, N>, h: T) -> Self {
        Self::new(equations, Mode::Follow { here, h, is_across: true }, here.branch)
    }

    /// From a rough guess.
    pub(crate) fn close<E: Description<T, N> + ?Sized>(equations: &E, guess: &'a SVector<T, N>) -> Self {
        Self::new(equations, Mode::Close { guess }, [Orientation::Positive; N])
    }

    /// At positions next to which branches cross.
    pub(crate) fn settle<E: Description<T, N> + ?Sized>(equations: &E, q: &'a SVector<T, N>) -> Self {
        Self::new(equations, Mode::Settle { q }, [Orientation::Positive; N])
    }

    /// The equation that is off most, if any is.
    pub(crate) fn contradiction(&self) -> Option<Cause<T>> {
        let (row, residual, _) = self.found.get().off?;
        Some(Cause::DoesNotHold { row: names::row(self.rows, row), residual })
    }

    /// What was found.
    pub(crate) fn found(&self) -> Found<T, N> {
        self.found.get()
    }
}

/// Solves a block, or looks at it where it is.
///
/// # Errors
/// Why the block has no solution near what the pass sets out from.
pub(crate) fn solve<T: Float, L: Linear<T, K>, const K: usize, const N: usize>(
    care: &Care<'_, T, N>,
    block: &Block<K>,
    sizes: [T; K],
    evaluate: &Evaluate<'_, T, L, K>,
) -> Result<Solved<T, L, K>, Stop<T>> {
    let mut part: Part<'_, T, L, K> = Part {
        evaluate,
        block,
        scale: Scale::by_kind(care.length, care.share, &block.kinds),
        sizes: SVector::from(sizes),
        rows: care.rows,
        coordinates: care.coordinates,
    };
    let first = block.unknowns.first().copied().unwrap_or(0);
    let picked = |q: &SVector<T, N>| Place::at(SVector::from_fn(|k, _| of(q, block.unknowns[k])), &block.turns);
    let mut found = care.found.get();
    let position = match &care.mode {
        Mode::Follow { here, h, is_across } => {
            part.scale = grown(part.scale, block, &here.q);
            let side = here.branch.get(first).copied().filter(|_| !is_across);
            let position = follow(&part, here, *h, &block.unknowns, side)?;
            if side.is_some_and(|before| before != position.factors.sides()) {
                return Err(Stop::Far);
            }
            position
        }
        Mode::Close { guess } => position::close(&part, &picked(guess)).map_err(|miss| open(&part, miss))?,
        Mode::Inspect { q } => {
            let place = picked(q);
            let (_, jacobian) = part.linearize(&place);
            let factors = L::factor(&jacobian).map_err(|row| Stop::NotFinite(Culprit::Row(part.row(row))))?;
            let condition = factors.condition(&part.sizes, &part.scale.share);
            if found.worst.is_none() || condition > found.condition {
                found.worst = Some(part.singular(&place));
            }
            Position { place, factors, condition, iterations: 0 }
        }
        Mode::Settle { q } => {
            let place = settled(&part, picked(q))?;
            let factors = L::factor(&part.linearize(&place).1).map_err(|row| Stop::NotFinite(Culprit::Row(part.row(row))))?;
            Position { place, factors, condition: T::of(1.0), iterations: SETTLING }
        }
        #[cfg(feature = "certify")]
        Mode::Enclose(_) => return Err(Stop::Far),
    };
    if let Some(orientation) = found.branch.get_mut(first) {
        *orientation = position.factors.sides();
    }
    found.condition = greater(found.condition, position.condition);
    found.iterations = found.iterations.max(position.iterations);
    care.found.set(found);
    Ok(Solved { x: position.place.x.data.0[0], turn: position.place.turn, factors: position.factors })
}

/// Corrections of a position between two crossing branches: in the directions in which it is corrected it is right to half of its
/// digits.
const SETTLING: usize = 2;

/// At a crossing residuals are so many roundings of their terms; where two branches only come near to each other, there is a gap.
const GAP: f64 = 8.0;

/// A place at which the equations hold to rounding, whatever is determined of it being corrected.
///
/// # Errors
/// If they do not.
fn settled<T: Float, P: Problem<T, K>, const K: usize>(problem: &P, mut place: Place<T, K>) -> Result<Place<T, K>, Stop<T>> {
    let column = &problem.scale().column;
    for _ in 0..SETTLING {
        let (phi, jacobian) = problem.linearize(&place);
        let (sizes, rows) = (iterate::sizes(problem, &jacobian), P::Factors::dense(&jacobian));
        let scaled = SMatrix::<T, K, K>::from_fn(|i, j| rows[(i, j)] * column[j] / sizes[i]);
        let residual = SVector::<T, K>::from_fn(|i, _| -phi[i] / sizes[i]);
        let correction = regular_part(&scaled, &residual).ok_or(Stop::Far)?;
        place = place.moved(T::of(1.0), &SVector::from_fn(|j, _| correction[j] * column[j]), problem.turns());
    }
    let (phi, jacobian) = problem.linearize(&place);
    let sizes = iterate::sizes(problem, &jacobian);
    let holds = phi.iter().zip(&sizes).all(|(residual, &size)| residual.abs() <= T::of(GAP) * T::EPSILON * size);
    if holds { Ok(place) } else { Err(Stop::Far) }
}

/// A length that has become larger than L is measured by itself.
fn grown<T: Float, const K: usize, const N: usize>(mut scale: Scale<T, K>, block: &Block<K>, q: &SVector<T, N>) -> Scale<T, K> {
    for k in 0..K {
        let size = of(q, block.unknowns[k]).abs();
        if block.kinds[k] == CoordinateKind::Length && size > scale.length {
            (scale.column[k], scale.share[k]) = (size, T::of(1.0) / size);
        }
    }
    scale
}

/// From q + h q̇ + h² q̈ / 2 to the solution next to it.
fn follow<T: Float, P: Problem<T, K>, const K: usize, const N: usize>(
    problem: &P,
    here: &State<T, N>,
    h: T,
    unknowns: &[usize; K],
    side: Option<Orientation>,
) -> Result<Position<T, P::Factors, K>, Stop<T>> {
    let mut x = SVector::from_element(T::of(0.0));
    let mut way = x;
    for k in 0..K {
        let i = unknowns[k];
        let (first, second) = (h * of(&here.qd, i), h * h * T::of(0.5) * of(&here.qdd, i));
        x[k] = of(&here.q, i) + (first + second);
        way[k] = first.abs() + second.abs();
    }
    // Angles repeat: a prediction that goes far may come to the solution of another turn.
    if problem.scale().norm(&way) > T::of(LONGEST_PREDICTION) {
        return Err(Stop::Far);
    }
    Ok(position::follow(problem, &Place::at(x, problem.turns()), side)?)
}

/// The entry of an unknown, whose index is in range.
fn of<T: Float, const N: usize>(vector: &SVector<T, N>, unknown: usize) -> T {
    vector.get(unknown).copied().unwrap_or(T::of(f64::NAN))
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
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::NotFinite(of) => Stop::NotFinite(of),
            Refusal::Singular | Refusal::Far => Stop::Far,
        }
    }
}
