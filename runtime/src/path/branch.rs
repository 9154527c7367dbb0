//! Whether a step stayed on its branch.

use nalgebra::SVector;

use crate::names::{self, Cause, CoordinateKind};
use crate::newton::{Scale, length_of};
use crate::number::{Float, Mask};
use crate::solve::{SolverReal, Stages};
use crate::state::{Coordinates, State};

/// How far an angle may be from its prediction, in rad.
const LARGEST_SURPRISE: f64 = 0.6;

/// A state and the one that the state after it expects behind it may be this share of 1 / condition apart: about so far away may
/// another assembly be.
pub(crate) const LARGEST_LAPSE: f64 = 0.2;

/// Every computed angle came to where it was expected: a drive that goes on after a rest may turn anything in one long step.
#[inline(always)]
pub(super) fn is_resolved<T: SolverReal, const N: usize>(here: &State<T, N>, q: &SVector<T, N>, h: T, angles: &[usize]) -> T::Mask {
    let mut resolved = T::Mask::of(true);
    for &i in angles {
        if i < N {
            let off = q[i] - (here.q[i] + h * (here.qd[i] + h * T::of(0.5) * here.qdd[i]));
            resolved = resolved.and(off.abs().at_most(T::of(LARGEST_SURPRISE)));
        }
    }
    resolved
}

/// A step came to where it was expected, and from where it began.
pub(crate) fn is_same_branch<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    here: &State<T, N>,
    there: &State<T, N>,
) -> bool {
    let h = there.t - here.t;
    let coordinates = Coordinates { q: there.q, qd: there.qd, qdd: there.qdd };
    is_resolved(here, &there.q, h, E::COMPUTED_ANGLES) && comes_from(equations, here, h, &coordinates, there.condition)
}

/// Rounding errors of positions, as a multiple of ε times their condition.
const ROUNDINGS: f64 = 4.0;

/// The state after a step expects behind it, at q − h q̇ + h² q̈ / 2, the state before, as far as another assembly may be away.
#[cold]
#[inline(never)]
pub(super) fn comes_from<T: SolverReal, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    here: &State<T, N>,
    h: T,
    there: &Coordinates<T, N>,
    condition: T,
) -> T::Mask {
    let length = length_of(equations.characteristic_length());
    let condition = condition.max(here.condition);
    // What rounding errors may make of two positions is no lapse.
    let nearest = T::of(LARGEST_LAPSE) / condition + T::of(ROUNDINGS) * T::EPSILON * condition;
    let mut comes = T::Mask::of(true);
    for &i in E::ITERATED {
        let Some(coordinate) = E::COORDINATES.get(i) else { continue };
        let lapse = (there.q[i] - here.q[i]) - h * (there.qd[i] - T::of(0.5) * (h * there.qdd[i]));
        // A length that is larger than L is measured by itself.
        let size = if coordinate.kind == CoordinateKind::Length { length.max(here.q[i].abs()) } else { T::of(1.0) };
        comes = comes.and(lapse.abs().at_most(nearest * size));
    }
    comes
}

/// The coordinate in which two positions differ most.
pub(crate) fn jump<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    from: &SVector<T, N>,
    to: &SVector<T, N>,
) -> Cause<T> {
    let scale = Scale::of(equations);
    let share = |i: usize| ((to[i] - from[i]) / scale.column[i]).abs();
    let most = (0..N).fold(0, |best, i| if share(i) > share(best) { i } else { best });
    let jump = to.get(most).zip(from.get(most)).map_or(T::of(f64::NAN), |(&to, &from)| to - from);
    Cause::BranchLost { coordinate: names::coordinate(E::COORDINATES, most), jump }
}
