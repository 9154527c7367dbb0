//! A block with care: from a guess or from a prediction that may be bad, to a solution, or to the reason why there is none.
//!
//! Seldom run, so it is compiled once for each size of block and takes the equations through a pointer.

use nalgebra::SVector;

use crate::linear::Linear;
use crate::order::greater;
use crate::pass::{Mode, Pass, Solved, Stop};
use crate::place::Place;
use crate::position::{self, Miss, Position, Refusal};
use crate::problem::{Block, Evaluate, Part, Problem};
use crate::scale::Scale;
use crate::straight::LONGEST_PREDICTION;
use crate::{Culprit, Float, State};

/// Solves a block, or looks at it where it is.
///
/// # Errors
/// Why the block has no solution near what the pass sets out from.
pub(crate) fn solve<T: Float, L: Linear<T, K>, const K: usize, const N: usize>(
    pass: &mut Pass<'_, T, N>,
    block: &Block<K>,
    sizes: [T; K],
    evaluate: &Evaluate<'_, T, L, K>,
) -> Result<Solved<T, L, K>, Stop<T>> {
    let part: Part<'_, T, L, K> = Part {
        evaluate,
        block,
        scale: Scale::by_kind(pass.length, pass.share, &block.kinds),
        sizes: SVector::from(sizes),
        rows: pass.rows,
        coordinates: pass.coordinates,
    };
    let first = block.unknowns.first().copied().unwrap_or(0);
    let picked = |q: &SVector<T, N>| Place::at(SVector::from_fn(|k, _| q[block.unknowns[k]]), &block.turns);
    let position = match &mut pass.mode {
        Mode::Straight { .. } => return Err(Stop::Far),
        Mode::Follow { here, h } => {
            let position = follow(&part, here, *h, &block.unknowns)?;
            if here.branch.get(first).is_some_and(|before| *before != position.factors.sides()) {
                return Err(Stop::Far);
            }
            position
        }
        Mode::Close { guess } => position::close(&part, &picked(guess)).map_err(|miss| open(&part, miss))?,
        Mode::Inspect { q, worst } => {
            let place = picked(q);
            let (_, jacobian) = part.linearize(&place);
            let factors = L::factor(&jacobian).map_err(|row| Stop::NotFinite(Culprit::Row(part.row(row))))?;
            let condition = factors.condition(&part.sizes, &part.scale.share);
            if worst.is_none() || condition > pass.condition {
                *worst = Some(part.singular(&place));
            }
            Position { place, factors, condition, iterations: 0 }
        }
    };
    if let Some(orientation) = pass.branch.get_mut(first) {
        *orientation = position.factors.sides();
    }
    pass.condition = greater(pass.condition, position.condition);
    pass.iterations = pass.iterations.max(position.iterations);
    Ok(Solved { x: position.place.x.data.0[0], turn: position.place.turn, factors: position.factors })
}

/// From q + h q̇ + h² q̈ / 2 to the solution next to it.
fn follow<T: Float, P: Problem<T, K>, const K: usize, const N: usize>(
    problem: &P,
    here: &State<T, N>,
    h: T,
    unknowns: &[usize; K],
) -> Result<Position<T, P::Factors, K>, Stop<T>> {
    let mut x = SVector::from_element(T::of(0.0));
    let mut way = x;
    for k in 0..K {
        let i = unknowns[k];
        let (first, second) = (h * here.qd[i], h * h * T::of(0.5) * here.qdd[i]);
        x[k] = here.q[i] + (first + second);
        way[k] = first.abs() + second.abs();
    }
    // Angles repeat: a prediction that goes far may come to the solution of another turn.
    if problem.scale().norm(&way) > T::of(LONGEST_PREDICTION) {
        return Err(Stop::Far);
    }
    Ok(position::follow(problem, &Place::at(x, problem.turns()))?)
}

/// Why a block could not be closed.
fn open<T: Float, P: Problem<T, K>, const K: usize>(problem: &P, miss: Miss<T, K>) -> Stop<T> {
    match miss {
        Miss::NotFinite(of) => Stop::NotFinite(of),
        Miss::Singular(place) | Miss::Stuck(place) => Stop::Open(problem.widest_gap(&place).unwrap_or_else(|| problem.singular(&place))),
        Miss::NoConvergence { correction, iterations } => Stop::Open(crate::Cause::NoConvergence { correction, iterations }),
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
