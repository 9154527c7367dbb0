//! Rank over a step.

use super::accelerate::{lengths, redundant, singular};
use super::equations::Dynamics;
use super::method::Method;
use super::partition::{has_other_signs, weakest};
use super::step::Reached;
use super::stopped::Stopped;
use crate::number::Float;
use crate::state::State;

/// Most steps of the search for an instant.
const SEARCH: usize = 60;

/// Below this part of its row an equation depends on the others.
const LOST: f64 = 1e-4;

/// Checks that the equations stay independent over a step.
///
/// # Errors
/// When they do not, and a joint whose equations depend on the others there.
pub(super) fn keeps_rank<K: Method, T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    from: &State<T, N>,
    to: &State<T, N>,
    (jacobian, pivots): &Reached<T, M, I>,
) -> Result<(), Stopped<T>>
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    let lengths = lengths(mechanism);
    let start = mechanism.constraints(&from.q, from.t).jacobian;
    if !has_other_signs(&start, jacobian, pivots) {
        return Ok(());
    }
    // Either these pivots are bad somewhere on the way, or all are.
    let (mut low, mut high, mut last) = (T::ZERO, to.t - from.t, start);
    for _ in 0..SEARCH {
        let h = (low + high) * T::of(0.5);
        // Near the instant a projection may lead to another branch: these places are those integrated.
        let there = K::trial(mechanism, from, h).map(|trial| mechanism.constraints(&trial.end[0], from.t + h).jacobian);
        match there {
            Ok(there) if !has_other_signs(&start, &there, pivots) => (low, last) = (h, there),
            _ => high = h,
        }
        if (high - low).abs() <= T::EPSILON * (from.t.abs() + high.abs()) {
            break;
        }
    }
    // Where rank is lost rows may vanish: they are compared with the rows at the assembled configuration.
    let assembled = mechanism.constraints(&mechanism.start(), from.t).jacobian;
    let (row, left) = weakest(&last, &assembled, &lengths, &redundant(mechanism));
    if left > T::of(LOST) {
        return Ok(());
    }
    Err(singular::<T, S, N, I, M, R>(from.t + high, row))
}
