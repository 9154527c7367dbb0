//! Whether a step stayed on its branch.

use nalgebra::SVector;

use crate::names::{self, Cause, Coordinate, CoordinateKind};
use crate::newton::length_of;
use crate::number::{Float, Mask};
use crate::solve::{Followed, SolverReal};
use crate::state::{Moment, State};

/// Largest distance of a computed angle from its prediction, in rad.
const LARGEST_SURPRISE: f64 = 0.6;

/// Largest distance between a state and its prediction backwards from the next state, as a fraction of 1 / condition: another
/// assembly may be about 1 / condition away.
pub(crate) const LARGEST_LAPSE: f64 = 0.2;

/// Whether every binary link has turned by less than 120°: where its cross folds, it would turn by 180° about its line.
#[inline(always)]
pub(super) fn keeps_sides<T: SolverReal, const N: usize>(links: &[usize], here: &SVector<T, N>, there: &SVector<T, N>) -> T::Mask {
    let mut kept = T::Mask::of(true);
    for &first in links {
        // The trace of A₀ᵀ A is 1 + 2 cos φ.
        let mut trace = T::of(0.0);
        for i in (0..9).map(|k| first.wrapping_add(k)) {
            if i < N {
                trace = trace + here[i] * there[i];
            }
        }
        kept = kept.and(T::of(0.0).at_most(trace));
    }
    kept
}

/// Whether every computed angle is close to its prediction, and every binary link has kept its side. A drive that resumes after a dwell
/// may turn by any angle in one long step.
#[inline(always)]
pub(super) fn is_resolved<T: SolverReal, const N: usize>(
    [links, computed_angles]: [&[usize]; 2],
    here: Moment<'_, T, N>,
    q: &SVector<T, N>,
    h: T,
) -> T::Mask {
    let mut resolved = keeps_sides(links, here.q, q);
    for &i in computed_angles {
        if i < N {
            let off = q[i] - (here.q[i] + h * (here.qd[i] + h * T::of(0.5) * here.qdd[i]));
            resolved = resolved.and(off.abs().at_most(T::of(LARGEST_SURPRISE)));
        }
    }
    resolved
}

/// Whether a step stayed on the branch, seen forwards and backwards.
pub(crate) fn is_same_branch<T: Float, const N: usize>(mechanism: &Followed<'_, T, N>, here: &State<T, N>, there: &State<T, N>) -> bool {
    let Followed { length, iterated, coordinates, links, computed_angles, .. } = *mechanism;
    let h = there.t - here.t;
    let (from, to) = (here.values.moment(), there.values.moment());
    let condition = here.condition.max(there.condition);
    is_resolved([links, computed_angles], from, to.q, h) && comes_from(length, (iterated, coordinates), from, h, to, condition)
}

/// Whether a computed angle has turned by more than half a turn, so that unknowns to be iterated may be left behind.
pub(super) fn turns_on<T: Float, const N: usize>(mechanism: &Followed<'_, T, N>, here: &SVector<T, N>, there: &SVector<T, N>) -> bool {
    let way = |i: usize| there.get(i).zip(here.get(i)).map_or(T::of(0.0), |(&to, &from)| (to - from).abs());
    !mechanism.iterated.is_empty() && mechanism.computed_angles.iter().any(|&i| way(i) > T::of(core::f64::consts::PI))
}

/// Rounding errors of positions, as a multiple of ε times their condition.
const ROUNDINGS: f64 = 4.0;

/// Whether the prediction backwards from the new state, q − h q̇ + h² q̈ / 2, meets the old state, to the distance at which another
/// assembly may be.
///
/// * `length`: given, the characteristic length in m.
/// * `condition`: given, the larger one of both states.
#[inline]
pub(super) fn comes_from<T: SolverReal, const N: usize>(
    length: T,
    (iterated, coordinates): (&[usize], &[Coordinate]),
    here: Moment<'_, T, N>,
    h: T,
    there: Moment<'_, T, N>,
    condition: T,
) -> T::Mask {
    let length = length_of(length);
    // Rounding errors of the two positions are allowed for.
    let nearest = T::of(LARGEST_LAPSE) / condition + T::of(ROUNDINGS) * T::EPSILON * condition;
    let mut comes = T::Mask::of(true);
    for &i in iterated {
        let Some(coordinate) = coordinates.get(i).filter(|_| i < N) else { continue };
        let lapse = (there.q[i] - here.q[i]) - h * (there.qd[i] - T::of(0.5) * (h * there.qdd[i]));
        // A length larger than L is scaled by its own value.
        let size = if coordinate.kind == CoordinateKind::Length { length.max(here.q[i].abs()) } else { T::of(1.0) };
        comes = comes.and(lapse.abs().at_most(nearest * size));
    }
    comes
}

/// The jump between two positions, by the unknown in which they differ most: in a slice outputs are no unknowns.
pub(crate) fn jump<T: Float, const N: usize>(mechanism: &Followed<'_, T, N>, from: &SVector<T, N>, to: &SVector<T, N>) -> Cause<T> {
    let scale = mechanism.scale();
    let share = |i: usize| ((to[i] - from[i]) / scale.column[i]).abs();
    let unknowns = mechanism.iterated.iter().copied().filter(|&i| i < N);
    let most = unknowns.reduce(|best, i| if share(i) > share(best) { i } else { best }).unwrap_or(0);
    let jump = to.get(most).zip(from.get(most)).map_or(T::of(f64::NAN), |(&to, &from)| to - from);
    Cause::BranchLost { coordinate: names::coordinate(mechanism.coordinates, most), jump }
}
