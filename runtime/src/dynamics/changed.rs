//! States that were changed, or whose parameters were: positions and speeds follow anew from those of the freedoms.

use nalgebra::SVector;

use super::accelerate::{lengths, redundant, singular};
use super::assemble::close_but_for;
use super::checks::{holds, unit_of};
use super::equations::{Constraints, Dynamics};
use super::partition::Partition;
use super::places::{are_finite, largest, picked, put};
use super::project::{Open, Reached, gap, levels, project, refresh};
use super::rank::is_sharp_at;
use super::stopped::Stopped;
use crate::linear;
use crate::number::Scalar;
use crate::number::order::smaller;
use crate::state::State;

/// Gives a state the accelerations that belong to it; a state that was changed, or whose parameters were, first gets positions and speeds that
/// fulfil the equations.
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

/// Positions and speeds of a state that was changed, or whose parameters were: freedoms keep their values and rates, all others follow.
///
/// Positions that fulfil the equations stay as they are, to the last bit: an event is zero in them still.
///
/// # Errors
/// If there are none, or freedoms do not determine them there, and if a parameter is out of its range.
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
    mechanism.validate().map_err(Stopped::ParameterOutOfRange)?;
    let t = state.t;
    let departures = mechanism.departures(&state.q, &state.qd, t);
    let are_numbers = departures.iter().all(|level| are_finite(level.as_slice()));
    if !(are_numbers && are_finite(state.q.as_slice()) && are_finite(state.qd.as_slice()) && t.is_finite()) {
        return Err(Stopped::NotFinite { time: t });
    }
    let [mut q, mut qd, _] = mechanism.complete(&state.q, &state.qd, &state.qdd, t);
    let [are_placed, are_moved] = agree(mechanism, &departures, (&q, &qd), t);
    if !are_placed {
        (q, qd) = (state.q, state.qd);
        let mut found = close_but_for(mechanism, (t, Some(&departures)), None, (&mut q, &mut qd), &mut Reached::empty());
        // Where a freedom is a bad coordinate others take its place, unless its rate may be the one that was changed.
        if matches!(found, Err(Open::Dependent(_))) && !state.was_changed() {
            (q, qd) = (state.q, state.qd);
            found = project(mechanism, None, (&mut q, &mut qd), t, &mut Reached::empty());
        }
        found.map_err(|open| stopped(mechanism, open, (&q, &departures[0]), t))?;
    } else if !are_moved {
        let mut here = Constraints::zero();
        mechanism.initial(&q, t, &mut here);
        here.nu = linear::moved(&here.nu, T::of(1.0), &departures[1]);
        let [_, of_speeds] = levels(&S::LEVELS);
        let mut parts = Partition::empty();
        parts
            .solve((&here.jacobian, &here.nu), None, &lengths(mechanism), &of_speeds, &redundant(mechanism))
            .map_err(|row| singular::<T, S, N, I, M, R>(t, row))?;
        let before = picked(&qd, &S::INTEGRATED);
        put(&mut qd, &S::INTEGRATED, &parts.unknowns(&parts.independent_of(&before)));
    }
    holds::<T, S, N, I, M, R>(mechanism, &q, t)?;
    is_sharp_at(mechanism, &q, t)?;
    let [q, qd, _] = mechanism.complete(&q, &qd, &state.qdd, t);
    if !(are_finite(q.as_slice()) && are_finite(qd.as_slice())) {
        return Err(Stopped::NotFinite { time: t });
    }
    (state.values.q, state.values.qd) = (q, qd);
    Ok(())
}

/// Times ε: equations that are missed by less hold.
const SAME: f64 = 256.0;

/// Whether positions, and whether speeds that follow from the integrated entries fulfil the equations, and leave freedoms the values and the
/// rates that a state has.
fn agree<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    departures: &[SVector<T, R>; 2],
    (q, qd): (&SVector<T, N>, &SVector<T, N>),
    t: T,
) -> [bool; 2]
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    // Derivatives by parameters may differ where values do not.
    if T::HAS_DERIVATIVES {
        return [false; 2];
    }
    let (values, speeds, lengths) = (picked(q, &S::INTEGRATED), picked(qd, &S::INTEGRATED), lengths(mechanism));
    let (small, unit) = (T::of(SAME) * T::EPSILON, smaller(T::of(1.0), mechanism.characteristic_length()));
    let sizes = [unit, unit * largest(&speeds, &lengths)];
    let there = mechanism.departures(q, qd, t);
    let mut agree = [true; 2];
    for (agree, ((one, two), size)) in agree.iter_mut().zip(departures.iter().zip(&there).zip(sizes)) {
        *agree = one.iter().zip(two).all(|(one, two)| (*one - *two).abs() <= small * (size + one.abs() + two.abs()));
    }
    let mut here = Constraints::zero();
    mechanism.constraints(q, t, &mut here);
    for row in 0..M {
        let (mut scale, mut rate, mut terms) = (T::ZERO, -here.nu[row], here.nu[row].abs());
        for k in 0..I {
            let (entry, term) = (here.jacobian[(row, k)], here.jacobian[(row, k)] * speeds[k]);
            scale = scale + entry.abs() * (values[k].abs() + lengths[k]);
            (rate, terms) = (rate + term, terms + term.abs());
        }
        agree[0] &= here.phi[row].abs() <= small * scale;
        agree[1] &= rate.abs() <= small * terms;
    }
    agree
}

/// Why a state cannot be settled.
///
/// * `q`, `kept`: given, the place that was reached, and Φ of the freedoms that they keep.
fn stopped<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    open: Open<T>,
    (q, kept): (&SVector<T, N>, &SVector<T, R>),
    t: T,
) -> Stopped<T>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let mut here: Constraints<T, R, I> = Constraints::zero();
    mechanism.initial(q, t, &mut here);
    here.phi = linear::moved(&here.phi, T::of(-1.0), kept);
    let [of_positions, _] = levels(&S::LEVELS);
    // Positions that come no nearer to each other depend on each other as well.
    let (row, residual) = gap(&here, &of_positions);
    if residual > T::ROOT_EPSILON * smaller(T::of(1.0), mechanism.characteristic_length()) {
        let joint = S::JOINTS.get(row).copied().unwrap_or_default();
        return Stopped::StaysOpen { time: t, joint, residual, unit: unit_of::<T, S, N>(joint) };
    }
    if residual.is_finite() { singular::<T, S, N, I, M, R>(t, open.row()) } else { Stopped::NotFinite { time: t } }
}
