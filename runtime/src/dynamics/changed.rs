//! States that were changed, or whose parameters were: positions and speeds follow anew from those of the freedoms.

use nalgebra::SVector;

use super::accelerate::{lengths, singular};
use super::assemble::close_but_for;
use super::checks::{holds, unit_of};
use super::equations::{Constraints, Dynamics};
use super::places::{are_finite, picked};
use super::project::{Open, Reached, project, refresh};
use super::stopped::Stopped;
use crate::number::Scalar;
use crate::state::State;

/// Gives a state the accelerations that belong to it; if it was changed, or if parameters were, positions and speeds that fulfil the equations
/// before.
///
/// # Errors
/// Why there are none.
pub fn accelerate<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &mut State<T, N>,
) -> Result<(), Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    if !mechanism.is_current(state) {
        settle(mechanism, state)?;
    }
    refresh(mechanism, state)
}

/// Times ε: values and rates of freedoms that differ by less are the same.
const SAME: f64 = 1e4;

/// True if the same equations are missed by the same.
fn agree<T: Scalar, const R: usize>(one: &[SVector<T, R>; 2], two: &[SVector<T, R>; 2]) -> bool {
    let entries = one.iter().flatten().zip(two.iter().flatten());
    entries.into_iter().all(|(one, two)| (*one - *two).abs() <= T::of(SAME) * T::EPSILON * (T::of(1.0) + one.abs() + two.abs()))
}

/// True if all equations between integrated coordinates hold.
fn fulfils<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    q: &SVector<T, N>,
    qd: &SVector<T, N>,
    t: T,
) -> bool
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let (values, speeds, lengths) = (picked(q, &S::INTEGRATED), picked(qd, &S::INTEGRATED), lengths(mechanism));
    let mut here = Constraints::zero();
    mechanism.constraints(q, t, &mut here);
    let small = T::of(SAME) * T::EPSILON;
    (0..M).all(|row| {
        let (mut scale, mut rate, mut largest) = (T::ZERO, -here.nu[row], here.nu[row].abs());
        for k in 0..I {
            let (entry, term) = (here.jacobian[(row, k)], here.jacobian[(row, k)] * speeds[k]);
            scale = scale + entry.abs() * (values[k].abs() + lengths[k]);
            (rate, largest) = (rate + term, largest + term.abs());
        }
        here.phi[row].abs() <= small * scale && rate.abs() <= small * largest
    })
}

/// Positions and speeds of a state that was changed, or whose parameters were: freedoms keep their values and rates, all others follow.
///
/// # Errors
/// If there are none, or freedoms do not determine them there.
#[cold]
#[inline(never)]
pub fn settle<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &mut State<T, N>,
) -> Result<(), Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let t = state.t;
    let departures = mechanism.departures(&state.q, &state.qd, t);
    // Nothing is left to be solved where the integrated entries agree with the freedoms and fulfil the equations.
    let [q, qd, _] = mechanism.complete(&state.q, &state.qd, &state.qdd, t);
    if agree(&departures, &mechanism.departures(&q, &qd, t)) && fulfils(mechanism, &q, &qd, t) {
        (state.q, state.qd) = (q, qd);
        return Ok(());
    }
    let (mut q, mut qd) = (state.q, state.qd);
    let mut found = close_but_for(mechanism, (t, Some(&departures)), None, (&mut q, &mut qd), &mut Reached::empty());
    // Where a freedom is a bad coordinate, as a crank is at a dead point, others take its place, unless its rate may be the one that was changed.
    if matches!(found, Err(Open::Dependent(_))) && !state.was_changed() {
        (q, qd) = (state.q, state.qd);
        found = project(mechanism, None, (&mut q, &mut qd), t, &mut Reached::empty());
    }
    found.map_err(|open| match open {
        Open::Dependent(row) | Open::After(row, _) => singular::<T, S, N, I, M, R>(t, row),
        Open::Residual(_, residual) if !residual.is_finite() => Stopped::NotFinite { time: t },
        Open::Residual(row, residual) => {
            let joint = S::JOINTS.get(row).copied().unwrap_or_default();
            Stopped::StaysOpen { time: t, joint, residual, unit: unit_of::<T, S, N>(joint) }
        }
    })?;
    holds::<T, S, N, I, M, R>(mechanism, &q, t)?;
    let [q, qd, _] = mechanism.complete(&q, &qd, &state.qdd, t);
    if !(are_finite(q.as_slice()) && are_finite(qd.as_slice())) {
        return Err(Stopped::NotFinite { time: t });
    }
    (state.q, state.qd) = (q, qd);
    Ok(())
}
