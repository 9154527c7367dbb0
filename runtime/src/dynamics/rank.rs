//! Whether the equations stay independent over a step: the rank of J.

use nalgebra::{SMatrix, SVector};

use super::accelerate::{lengths, redundant, singular};
use super::equations::{Constraints, Dynamics};
use super::method::Method;
use super::partition::{Partition, Pivots, has_other_signs, weakest};
use super::places::picked;
use super::project::Reached;
use super::stopped::Stopped;
use crate::number::Scalar;
use crate::state::State;

/// Most steps of the search for an instant.
const SEARCH: usize = 60;

/// A row depends on the others if a smaller fraction of it is independent of them.
const LOST: f64 = 1e-4;

/// Checks that the equations stay independent over a step.
///
/// * `from`: given, the state before the step, and J there if it is known.
/// * `to`: given, the state after the step, and J there.
///
/// # Errors
/// The instant at which they become dependent, and a joint whose equations depend on those of others.
pub(super) fn keeps_rank<K: Method, T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    (from, before): (&State<T, N>, Option<&Reached<T, M, I>>),
    (to, there): (&State<T, N>, &Reached<T, M, I>),
) -> Result<(), Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    if before.is_some_and(|before| before.pivots.agree_with(&there.pivots)) {
        return Ok(());
    }
    let computed;
    let start = match before {
        Some(before) => &before.here.jacobian,
        None => {
            computed = jacobian_at(mechanism, &from.q, from.t);
            &computed
        }
    };
    let (end, pivots) = (&there.here.jacobian, &there.pivots);
    if !has_other_signs(start, end, pivots) || is_alike_by_turns(mechanism, (start, from), (end, to)) {
        return Ok(());
    }
    // Either these pivots are bad somewhere on the way, or all are.
    search::<K, T, S, N, I, M, R>(mechanism, (from, start), to.t, pivots)
}

/// True if both ends of a step have pivots of the same signs in an order that is good at its end, quaternions being counted by turns.
#[cold]
#[inline(never)]
fn is_alike_by_turns<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    (start, from): (&SMatrix<T, M, I>, &State<T, N>),
    (end, to): (&SMatrix<T, M, I>, &State<T, N>),
) -> bool
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let before = by_turns::<T, S, N, I, M, R>(start, &from.q);
    let after = by_turns::<T, S, N, I, M, R>(end, &to.q);
    let (mut parts, none) = (Partition::empty(), SVector::from_element(T::ZERO));
    let again = parts.pivot((&after, &none), &lengths(mechanism), &[true; M], &redundant(mechanism));
    again.is_ok() && !has_other_signs(&before, &after, &parts.pivots)
}

/// Finds the instant within a step at which a pivot changes its sign.
///
/// # Errors
/// If J is singular then: the instant, and a joint whose equations depend on those of others.
#[cold]
#[inline(never)]
fn search<K: Method, T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    (from, start): (&State<T, N>, &SMatrix<T, M, I>),
    end: T,
    pivots: &Pivots<T, M, I>,
) -> Result<(), Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let (mut low, mut high, mut last) = (T::ZERO, end - from.t, *start);
    for _ in 0..SEARCH {
        let h = (low + high) * T::of(0.5);
        // Near the instant a projection may lead to another branch: J is taken where the integration leads.
        let there = K::trial(mechanism, from, h).map(|trial| jacobian_at(mechanism, &trial.end[0], from.t + h));
        match there {
            Ok(there) if !has_other_signs(start, &there, pivots) => (low, last) = (h, there),
            _ => high = h,
        }
        if (high - low).abs() <= T::EPSILON * (from.t.abs() + high.abs()) {
            break;
        }
    }
    let (row, left) = weakest(&last, &assembled(mechanism), &lengths(mechanism), &[true; M], &redundant(mechanism));
    if left > T::of(LOST) {
        return Ok(());
    }
    Err(singular::<T, S, N, I, M, R>(from.t + high, row))
}

/// J at a place.
fn jacobian_at<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    q: &SVector<T, N>,
    t: T,
) -> SMatrix<T, M, I>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let mut found = Constraints::zero();
    mechanism.constraints(q, t, &mut found);
    found.jacobian
}

/// J at the declared start at t = 0. Where rank is lost, rows may vanish, even by a drive alone; they are compared with these.
fn assembled<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(mechanism: &S) -> SMatrix<T, M, I>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    jacobian_at(mechanism, &mechanism.start(), T::ZERO)
}

/// Below this fraction of the natural size of its row, a pivot may belong to dependent equations.
const SUSPECT: f64 = 1e-4;

/// Pivots that were chosen at a configuration close by are at most this many times better than those here.
const BETTER: f64 = 4.0;

/// Times √ε: if a smaller fraction of a row is independent of the others, rounding chooses the branch. Within √ε of a crossing of two branches
/// the motion may follow either.
const FLAT: f64 = 100.0;

/// If a smaller fraction p of a row is independent of the others, accelerations have lost most of their digits: positions are known to ε / p, speeds to
/// ε / p², accelerations to ε / p³.
const BLURRED: f64 = 4.8e-5;

/// Checks that no singular configuration is so near that rounding would choose the branch.
///
/// * `reached`: given, J at the configuration.
///
/// # Errors
/// A joint whose equations depend on those of others.
pub(super) fn is_regular<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    t: T,
    reached: &Reached<T, M, I>,
) -> Result<(), Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    are_independent(mechanism, t, reached, T::of(FLAT) * T::ROOT_EPSILON)
}

/// The same, so that accelerations keep digits too: for states that are handed out.
///
/// # Errors
/// A joint whose equations depend on those of others.
pub(super) fn is_sharp<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    t: T,
    reached: &Reached<T, M, I>,
) -> Result<(), Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    are_independent(mechanism, t, reached, T::of(BLURRED).max(T::of(FLAT) * T::ROOT_EPSILON))
}

/// [`is_sharp`] at a place where no equations are known yet.
///
/// # Errors
/// A joint whose equations depend on those of others.
#[inline(never)]
pub(super) fn is_sharp_at<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    q: &SVector<T, N>,
    t: T,
) -> Result<(), Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let (mut reached, mut parts) = (Reached::empty(), Partition::empty());
    mechanism.constraints(q, t, &mut reached.here);
    let rows = (&reached.here.jacobian, &reached.here.nu);
    parts.pivot(rows, &lengths(mechanism), &[true; M], &redundant(mechanism)).map_err(|row| singular::<T, S, N, I, M, R>(t, row))?;
    reached.pivots = parts.pivots;
    is_sharp(mechanism, t, &reached)
}

/// Checks that of each row more than this fraction is independent of the others.
fn are_independent<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    t: T,
    Reached { here, pivots }: &Reached<T, M, I>,
    least: T,
) -> Result<(), Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let (lengths, redundant) = (lengths(mechanism), redundant(mechanism));
    if pivots.smallest(&lengths, &redundant.sizes) > T::of(SUSPECT) && pivots.weakest > T::of(BETTER) * least {
        return Ok(());
    }
    // Compared at the same t: where a drive alone makes a row vanish, no branches cross, and the motion goes on until no step is short enough.
    let assembled_now = jacobian_at(mechanism, &mechanism.start(), t);
    let (row, left) = weakest(&here.jacobian, &assembled_now, &lengths, &[true; M], &redundant);
    if left > least { Ok(()) } else { Err(singular::<T, S, N, I, M, R>(t, row)) }
}

/// Why no step is short enough at a state: its equations depend on each other there, or the motion is not smooth.
pub(super) fn too_short<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &State<T, N>,
) -> Stopped<T>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let here = jacobian_at(mechanism, &state.q, state.t);
    let (row, left) = weakest(&here, &assembled(mechanism), &lengths(mechanism), &[true; M], &redundant(mechanism));
    if left > T::of(LOST) { Stopped::StepTooShort { time: state.t } } else { singular::<T, S, N, I, M, R>(state.t, row) }
}

/// The same rows by the length of each quaternion and the turns about the axes of its body: the components themselves change their signs as
/// the body turns.
fn by_turns<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    rows: &SMatrix<T, M, I>,
    q: &SVector<T, N>,
) -> SMatrix<T, M, I>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let (mut turned, components) = (*rows, picked(q, &S::INTEGRATED));
    for (first, unknown) in S::INTEGRATED.iter().enumerate() {
        if S::COORDINATES.get(*unknown).is_some_and(|coordinate| coordinate.name == "e0") {
            turn(&mut turned, &components, first);
        }
    }
    turned
}

/// The columns of a quaternion, which begin at a place, become those by e, e i, e j and e k.
fn turn<T: Scalar, const M: usize, const I: usize>(rows: &mut SMatrix<T, M, I>, components: &[T; I], first: usize) {
    let (Some(&[w, x, y, z]), Some([a, b, c, d])) =
        (components.get(first..).and_then(<[T]>::first_chunk), rows.data.0.get_mut(first..).and_then(<[_]>::first_chunk_mut))
    else {
        return;
    };
    for (((a, b), c), d) in a.iter_mut().zip(b).zip(c).zip(d) {
        (*a, *b, *c, *d) = (
            w * *a + x * *b + y * *c + z * *d,
            w * *b - x * *a + z * *c - y * *d,
            w * *c - y * *a - z * *b + x * *d,
            w * *d - z * *a + y * *b - x * *c,
        );
    }
}
