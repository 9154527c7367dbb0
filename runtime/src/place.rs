//! Where Newton's method stands: the unknowns, and sine and cosine of those that are angles.

use nalgebra::SVector;

use crate::Float;

/// Up to this length a correction turns sine and cosine instead of having them computed again.
const SMALL_TURN: f64 = 1.0 / 256.0;

/// Unknowns with the sines and cosines that the equations need of them.
#[derive(Clone, Copy, Debug)]
pub struct Place<T, const K: usize> {
    /// The unknowns, in m and rad.
    pub x: SVector<T, K>,
    /// (sine, cosine) of the unknowns that turn; without meaning for others.
    pub turn: [(T, T); K],
}

impl<T: Float, const K: usize> Place<T, K> {
    /// At x; `turns` says of which unknowns sine and cosine are needed.
    #[inline(always)]
    pub(crate) fn at(x: SVector<T, K>, turns: &[bool; K]) -> Self {
        let mut turn = [(T::of(0.0), T::of(1.0)); K];
        for k in 0..K {
            if turns[k] {
                turn[k] = x[k].turn();
            }
        }
        Self { x, turn }
    }

    /// At x + λ δ.
    #[inline(always)]
    pub(crate) fn moved(&self, lambda: T, correction: &SVector<T, K>, turns: &[bool; K]) -> Self {
        let mut there = *self;
        for k in 0..K {
            let by = lambda * correction[k];
            there.x[k] = self.x[k] + by;
            if turns[k] {
                there.turn[k] = if by.abs() <= T::of(SMALL_TURN) { turned(self.turn[k], by) } else { there.x[k].turn() };
            }
        }
        there
    }

    /// At x + δ with δ at most about √ε: its square does not show in sine and cosine.
    #[inline(always)]
    pub(crate) fn nudged(&self, correction: &SVector<T, K>, turns: &[bool; K]) -> Self {
        let mut there = *self;
        for k in 0..K {
            there.x[k] = self.x[k] + correction[k];
            if turns[k] {
                let (sine, cosine) = self.turn[k];
                there.turn[k] = (sine + cosine * correction[k], cosine - sine * correction[k]);
            }
        }
        there
    }
}

/// Sine and cosine of an angle that is larger by δ, |δ| ≤ 1/256.
///
/// sin δ = δ − δ³/6 + δ⁵/120 and cos δ − 1 = −δ²/2 + δ⁴/24 − δ⁶/720 leave out less than 3e-21 and 1e-24; the sum and the
/// products round once or twice each, as a sine computed anew does.
#[inline(always)]
fn turned<T: Float>((sine, cosine): (T, T), by: T) -> (T, T) {
    let square = by * by;
    let less = square * (T::of(0.5) - square * (T::of(1.0 / 24.0) - square * T::of(1.0 / 720.0)));
    let small = by - by * square * (T::of(1.0 / 6.0) - square * T::of(1.0 / 120.0));
    (sine + (cosine * small - sine * less), cosine - (sine * small + cosine * less))
}
