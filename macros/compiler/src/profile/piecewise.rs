//! Expressions that consist of pieces, each from its beginning to that of the next one.

use super::Valuer;
use crate::expr::{Binary, Exact, Expr};

/// The piece that begins last before x. The first one needs no beginning.
pub(super) fn piecewise(work: &mut impl Valuer, x: Expr, pieces: &[(Expr, Expr)]) -> Expr {
    let (early, late) = pieces.split_at(pieces.len() / 2);
    match (early, late) {
        ([], late) => late.first().map_or(x, |(_, only)| *only),
        (early, late) => {
            let (before, after) = (piecewise(work, x, early), piecewise(work, x, late));
            work.arena().select(x, late[0].0, before, after)
        }
    }
}

/// x brought between 0 and the period P: x itself where it is from 0 to a period, and the same a period later. `is_turn` says that P is 2π.
///
/// ```text
///   w = P/2 + P/2π atan2(−sin(2πx/P), −cos(2πx/P))
/// ```
pub(super) fn wrapped(work: &mut impl Valuer, x: Expr, period: Expr, is_turn: bool) -> Expr {
    let (turn, half) = (turn(work), work.arena().constant(Exact::PI));
    let arena = work.arena();
    let angle = match is_turn {
        true => x,
        false => {
            let share = arena.div(x, period);
            arena.mul(turn, share)
        }
    };
    let (sine, cosine) = (arena.sin(angle), arena.cos(angle));
    let (sine, cosine) = (arena.neg(sine), arena.neg(cosine));
    let from_middle = arena.binary(Binary::Atan2, sine, cosine);
    let wrapped = arena.add(half, from_middle);
    match is_turn {
        true => wrapped,
        false => {
            let share = arena.div(wrapped, turn);
            arena.mul(share, period)
        }
    }
}

/// 2π
pub(super) fn turn(work: &mut impl Valuer) -> Expr {
    let half = work.arena().constant(Exact::PI);
    work.arena().twice(half)
}
