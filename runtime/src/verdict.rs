//! What to say when there is no solution. In: how Newton's method or the continuation ended. Out: a [`Cause`].

use nalgebra::SVector;

use crate::linear::{Factors, weakest};
use crate::position::{self, Miss, Refusal};
use crate::scale::Scale;
use crate::{Cause, Coordinate, Equations, Float, State, names};

/// A gap of √ε L times this is closed: at a dead point, where rounding errors in Φ move q by about √ε.
const CLOSED: f64 = 16.0;

/// A branch that ends at a state with a condition above ε to the power −1/4 ends at a dead point: approaching one up to
/// the rounding of t gives a condition of about ε to the power −1/2.
fn is_dead_point<T: Float, const N: usize>(state: &State<T, N>) -> bool {
    state.condition * T::EPSILON.sqrt().sqrt() > T::of(1.0)
}

/// Why the mechanism could not be assembled at `t`.
pub(crate) fn open<T: Float, E: Equations<T, N, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    miss: Miss<T, N>,
    scale: &Scale<T, N>,
) -> Cause<T> {
    match miss {
        Miss::NotFinite(of) => Cause::NotFinite { of },
        Miss::Singular(q) => singular(equations, t, &q, scale),
        Miss::Stuck(q) => widest_gap(equations, t, &q, scale).unwrap_or_else(|| singular(equations, t, &q, scale)),
        Miss::NoConvergence { correction, iterations } => Cause::NoConvergence { correction, iterations },
    }
}

/// Why the branch could not be followed from `here` to `next`, a moment later.
pub(crate) fn end_of_branch<T: Float, E: Equations<T, N, N> + ?Sized, const N: usize>(
    equations: &E,
    next: T,
    here: &State<T, N>,
    refusal: Refusal,
    scale: &Scale<T, N>,
) -> Cause<T> {
    if let Refusal::NotFinite(of) = refusal {
        return Cause::NotFinite { of };
    }
    if is_dead_point(here) {
        return singular(equations, here.t, &here.q, scale);
    }
    match position::close(equations, next, &here.predict(next), scale) {
        Ok(other) => jump(&here.q, &other.q, E::COORDINATES, scale),
        Err(miss) => open(equations, next, miss, scale),
    }
}

/// Which row depends on the others at q, and which coordinate they leave free.
fn singular<T: Float, E: Equations<T, N, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    q: &SVector<T, N>,
    scale: &Scale<T, N>,
) -> Cause<T> {
    let jacobian = equations.jacobian(q, t);
    let (row, coordinate) = weakest(&jacobian, &scale.column).unwrap_or((0, 0));
    let condition = Factors::new(&jacobian).map_or(T::of(f64::NAN), |factors| factors.condition());
    Cause::Singular { row: names::row(E::ROWS, row), coordinate: names::coordinate(E::COORDINATES, coordinate), condition }
}

/// Which row stays open furthest at q; None if all are closed.
fn widest_gap<T: Float, E: Equations<T, N, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    q: &SVector<T, N>,
    scale: &Scale<T, N>,
) -> Option<Cause<T>> {
    let (phi, jacobian) = equations.linearize(q, t);
    let closed = T::of(CLOSED) * T::EPSILON.sqrt() * scale.length;
    let (mut widest, mut cause) = (closed, None);
    for (row, &residual) in phi.iter().enumerate() {
        let gap = scale.gap(row, residual, &jacobian);
        if gap > widest {
            widest = gap;
            cause = Some(Cause::DoesNotClose { row: names::row(E::ROWS, row), residual, gap });
        }
    }
    cause
}

/// The coordinate in which two positions differ most.
fn jump<T: Float, const N: usize>(from: &SVector<T, N>, to: &SVector<T, N>, coordinates: &[Coordinate], scale: &Scale<T, N>) -> Cause<T> {
    let share = |i: usize| ((to[i] - from[i]) / scale.column[i]).abs();
    let most = (0..N).fold(0, |best, i| if share(i) > share(best) { i } else { best });
    let jump = to.get(most).zip(from.get(most)).map_or(T::of(f64::NAN), |(&to, &from)| to - from);
    Cause::BranchLost { coordinate: names::coordinate(coordinates, most), jump }
}
