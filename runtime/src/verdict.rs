//! What to say when there is no solution. In: how a pass or the continuation ended. Out: a [`Cause`].

use nalgebra::SVector;

use crate::careful::Care;
use crate::continuation;
use crate::pass::Stop;
use crate::scale::Scale;
use crate::stages::Stages;
use crate::{Cause, CoordinateKind, Float, State, names};

/// A branch that ends at a state with a condition above ε to the power −1/4 ends at a dead point: approaching one up to
/// the rounding of t gives a condition of about ε to the power −1/2.
fn is_dead_point<T: Float, const N: usize>(state: &State<T, N>) -> bool {
    state.condition * T::ROOT_EPSILON.sqrt() > T::of(1.0)
}

/// A motion that ends with a length of more than this many L, growing, diverges.
const FAR: f64 = 100.0;

/// Why the mechanism could not be assembled.
pub(crate) fn open<T: Float>(stop: Stop<T>) -> Cause<T> {
    match stop {
        Stop::NotFinite(of) => Cause::NotFinite { of },
        Stop::Open(cause) => cause,
        Stop::Far => Cause::NoConvergence { correction: T::of(f64::NAN), iterations: 0 },
    }
}

/// Why the branch could not be followed from `here` to `next`, a moment later.
pub(crate) fn end_of_branch<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    next: T,
    here: &State<T, N>,
    stop: Stop<T>,
) -> Cause<T> {
    if let Stop::NotFinite(of) = stop {
        return Cause::NotFinite { of };
    }
    if is_dead_point(here) {
        let care = Care::inspect(equations, &here.q);
        // Only what the pass saw is wanted, not the rates it ends with.
        let _ = continuation::pass(equations, here.t, &care);
        if let Some(cause) = care.found().worst {
            return cause;
        }
    }
    match continuation::reached(equations, next, Care::close(equations, &here.predict(next))) {
        Ok((other, _)) => jump(equations, &here.q, &other.q),
        Err(stop) => open(stop),
    }
}

/// Where the motion ends because a length grows beyond all bounds: which, and about when.
///
/// ```text
/// x = c / (t∞ − t)      t∞ = t + x / ẋ
/// ```
///
/// * `next`: given, s, a moment after `here`.
pub(crate) fn diverging<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    here: &State<T, N>,
    next: T,
) -> Option<(Cause<T>, T)> {
    let scale = Scale::of(equations);
    let named = |i: usize| names::coordinate(E::COORDINATES, i);
    let all = here.q.iter().zip(here.qd.iter()).enumerate().map(|(i, (&place, &rate))| (named(i), place, rate));
    let lengths = all.filter(|(coordinate, ..)| coordinate.kind == CoordinateKind::Length);
    let (coordinate, value, rate) = lengths.reduce(|best, next| if next.1.abs() > best.1.abs() { next } else { best })?;
    let grows = value * rate * (next - here.t) > T::of(0.0);
    let is_far = value.abs() / scale.length > T::of(FAR);
    (is_far && grows).then(|| (Cause::Diverges { coordinate, value }, here.t + value / rate))
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
