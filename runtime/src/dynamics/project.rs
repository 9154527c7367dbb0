//! Positions and speeds that fulfil the equations.

use nalgebra::{SMatrix, SVector};

use super::accelerate::{accelerations, lengths};
use super::equations::{Constraints, Dynamics};
use super::partition::{Partition, Pivots};
use super::stopped::Stopped;
use crate::number::Float;
use crate::state::State;

/// Most corrections of positions.
const CORRECTIONS: usize = 50;

/// Most halvings of a correction.
const HALVINGS: usize = 12;

/// A correction below this, relative to 1 rad and L, is the last one.
const LAST: f64 = 1e-9;

/// Moves the integrated coordinates of a state so that `equations` hold, and sets their speeds; independent ones stay. Returns J there, with an order
/// of its elimination.
///
/// * `levels`: given, for each row whether it counts between positions, and whether between speeds.
///
/// # Errors
/// The number of the row at fault, and its residual.
pub(super) fn project<T, S, const N: usize, const I: usize, const M: usize, const R: usize, const K: usize>(
    mechanism: &S,
    state: (&mut SVector<T, N>, &mut SVector<T, N>),
    equations: impl Fn(&SVector<T, N>) -> Constraints<T, K, I>,
    levels: impl Fn(usize) -> [bool; 2],
) -> Result<(SMatrix<T, K, I>, Pivots<T, K, I>), (usize, T)>
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    let (q, qd) = state;
    let lengths = lengths(mechanism);
    let is_of_positions = |row: usize| levels(row)[0];
    let mut here = equations(q);
    let mut open = gap(&here, is_of_positions);
    for _ in 0..CORRECTIONS {
        let parts = Partition::new(&here.jacobian, &-here.phi, &lengths, is_of_positions).map_err(|row| (row, here.phi[row]))?;
        let correction = parts.unknowns(|_| T::ZERO);
        let size = (0..I).fold(T::ZERO, |size, k| size.max((correction[k] / lengths[k]).abs()));
        let mut factor = T::of(1.0);
        let start = *q;
        for halving in 0..=HALVINGS {
            for (k, &place) in S::INTEGRATED.iter().enumerate() {
                q[place] = start[place] + factor * correction[k];
            }
            here = equations(q);
            let left = gap(&here, is_of_positions);
            if left.1 < open.1 || size < T::of(LAST) || halving == HALVINGS {
                open = left;
                break;
            }
            factor = factor * T::of(0.5);
        }
        if size < T::of(LAST) {
            // Where the same rows count, the same pivots are good.
            let are_same = (0..K).all(|row| levels(row) == [true, true]);
            let known = if are_same { Partition::along(&here.jacobian, &here.nu, &parts.pivots) } else { None };
            let speeds = match known {
                Some(speeds) => speeds,
                None => Partition::new(&here.jacobian, &here.nu, &lengths, |row| levels(row)[1]).map_err(|row| (row, T::ZERO))?,
            };
            let independent: [T; I] = core::array::from_fn(|k| qd[S::INTEGRATED[k]]);
            let found = speeds.unknowns(|place| independent[speeds.independent_at(place)]);
            for (k, &place) in S::INTEGRATED.iter().enumerate() {
                qd[place] = found[k];
            }
            return Ok((here.jacobian, parts.pivots));
        }
    }
    Err(open)
}

/// The row that is open furthest, and its residual.
fn gap<T: Float, const K: usize, const I: usize>(here: &Constraints<T, K, I>, counts: impl Fn(usize) -> bool) -> (usize, T) {
    let mut gap = (0, T::ZERO);
    for row in (0..K).filter(|row| counts(*row)) {
        let size = here.phi[row].abs();
        let is_smaller = size <= gap.1;
        // What is not a number is open.
        if !is_smaller {
            gap = (row, size);
        }
    }
    gap
}

/// The state at t = 0, at the initial values of the freedoms.
pub(super) fn initial_state<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
) -> Result<State<T, N>, Stopped<T>>
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    mechanism.validate().map_err(Stopped::ParameterOutOfRange)?;
    let zero = SVector::from_element(T::ZERO);
    let (mut q, mut qd) = (mechanism.start(), zero);
    project(mechanism, (&mut q, &mut qd), |q| mechanism.initial(q, T::ZERO), |row| S::LEVELS[row])
        .map_err(|(row, residual)| Stopped::NotAssembled { joint: S::JOINTS.get(row).copied().unwrap_or_default(), residual })?;
    let mut state = State::new(T::ZERO, q, qd, zero);
    refresh(mechanism, &mut state)?;
    Ok(state)
}

/// Sets the accelerations of a state, and all its entries that follow from the integrated ones.
pub(super) fn refresh<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &mut State<T, N>,
) -> Result<(), Stopped<T>>
where
    T: Float,
    S: Dynamics<T, N, I, M, R>,
{
    let found = accelerations(mechanism, (&state.q, &state.qd), state.t, &mut None)?;
    let mut qdd = state.qdd;
    for (k, &place) in S::INTEGRATED.iter().enumerate() {
        qdd[place] = found[k];
    }
    let [q, qd, qdd] = mechanism.complete(&state.q, &state.qd, &qdd, state.t);
    let is_finite = |vector: &SVector<T, N>| vector.iter().all(|value| value.is_finite());
    if !(is_finite(&q) && is_finite(&qd) && is_finite(&qdd)) {
        return Err(Stopped::NotFinite { time: state.t });
    }
    (state.q, state.qd, state.qdd) = (q, qd, qdd);
    Ok(())
}
