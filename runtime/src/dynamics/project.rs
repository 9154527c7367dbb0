//! Positions and speeds that fulfil the equations.

use nalgebra::{SMatrix, SVector};

use super::accelerate::{eliminated, lengths, redundant, singular};
use super::checks::{holds, unit_of};
use super::equations::{Constraints, Dynamics};
use super::integrator::least;
use super::partition::{ABOUT_AS_GOOD, Partition, Pivots, WORSE};
use super::places::{is_finite, largest, picked, put};
use super::stopped::Stopped;
use crate::number::Scalar;
use crate::state::State;

/// Most corrections of positions.
const CORRECTIONS: usize = 50;

/// Most halvings of a correction.
const HALVINGS: usize = 12;

/// Moves dependent coordinates of a state until `equations` hold, and sets their speeds; independent ones keep their values. Returns J
/// there, with an order of its elimination.
///
/// * `known`: given, pivots at a state close by.
/// * `levels`: given, for each row whether it counts between positions, and whether between speeds.
///
/// # Errors
/// The number of the row at fault, and its residual.
pub(super) fn project<T, S, const N: usize, const I: usize, const M: usize, const R: usize, const K: usize>(
    mechanism: &S,
    known: Option<&Pivots<T, K, I>>,
    state: (&mut SVector<T, N>, &mut SVector<T, N>),
    equations: impl Fn(&SVector<T, N>) -> Constraints<T, K, I>,
    levels: impl Fn(usize) -> [bool; 2],
) -> Result<(SMatrix<T, K, I>, Pivots<T, K, I>), Open<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let (q, qd) = state;
    let (lengths, redundant) = (lengths(mechanism), redundant(mechanism));
    let is_of_positions = |row: usize| levels(row)[0];
    // Where the same rows count between positions and between speeds, the same pivots are good.
    let are_same = (0..K).all(|row| levels(row) == [true, true]);
    let mut kept = known.filter(|_| are_same && S::REDUNDANT == 0).copied();
    let fraction = T::of(if S::REDUNDANT == 0 { ABOUT_AS_GOOD } else { WORSE });
    let mut here = equations(q);
    let mut open = gap(&here, is_of_positions);
    for _ in 0..CORRECTIONS {
        let side = here.phi.map(|phi| -phi);
        let again = kept.as_ref().and_then(|pivots| Partition::along(&here.jacobian, &side, pivots, fraction));
        let parts = match again {
            Some(parts) => parts,
            None => Partition::new(&here.jacobian, &side, &lengths, is_of_positions, &redundant).map_err(Open::Dependent)?,
        };
        let counts = |row: usize| is_of_positions(row) && (S::REDUNDANT == 0 || parts.pivots.have(row));
        if S::REDUNDANT > 0 {
            // Those that do not fit would not settle if others were chosen at each correction.
            (kept, open) = (Some(parts.pivots), gap(&here, counts));
        }
        let correction = parts.unknowns(|_| T::ZERO);
        let size = largest(&correction, &lengths);
        if !correction.iter().all(|correction| correction.is_finite()) {
            break;
        }
        // Corrections are squared from one to the next.
        let is_last = size < T::ROOT_EPSILON;
        let mut factor = T::of(1.0);
        let start = picked(q, &S::INTEGRATED);
        for halving in 0..=HALVINGS {
            put(q, &S::INTEGRATED, &core::array::from_fn(|k| start[k] + factor * correction[k]));
            here = equations(q);
            let left = gap(&here, counts);
            if left.1 < open.1 || is_last || halving == HALVINGS {
                open = left;
                break;
            }
            factor = factor * T::of(0.5);
        }
        if is_last {
            let along = if are_same { Partition::along(&here.jacobian, &here.nu, &parts.pivots, T::of(WORSE)) } else { None };
            let speeds = match along {
                Some(speeds) => speeds,
                None => Partition::new(&here.jacobian, &here.nu, &lengths, |row| levels(row)[1], &redundant).map_err(Open::Dependent)?,
            };
            let before = picked(qd, &S::INTEGRATED);
            let found = speeds.unknowns(|place| before.get(speeds.independent_at(place)).copied().unwrap_or(T::ZERO));
            put(qd, &S::INTEGRATED, &found);
            return Ok((here.jacobian, speeds.pivots));
        }
    }
    Err(Open::Residual(open.0, open.1))
}

/// Why equations do not hold.
pub(super) enum Open<T> {
    /// A row stays open by its residual.
    Residual(usize, T),
    /// A row depends on the others.
    Dependent(usize),
}

impl<T> Open<T> {
    /// The row.
    pub(super) fn row(&self) -> usize {
        match *self {
            Open::Residual(row, _) | Open::Dependent(row) => row,
        }
    }
}

/// The row that is open furthest, and its residual; the first one whose residual is not a number.
fn gap<T: Scalar, const K: usize, const I: usize>(here: &Constraints<T, K, I>, counts: impl Fn(usize) -> bool) -> (usize, T) {
    let mut gap = (0, T::ZERO);
    for (row, phi) in here.phi.iter().enumerate().filter(|(row, _)| counts(*row)) {
        let size = phi.abs();
        if !size.is_finite() {
            return (row, size);
        }
        gap = if size > gap.1 { (row, size) } else { gap };
    }
    gap
}

/// Whether an equation counts between positions, and whether between speeds.
pub(super) fn levels<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(row: usize) -> [bool; 2]
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    S::LEVELS.get(row).copied().unwrap_or([false; 2])
}

/// A step on the way to the initial values is short enough if no coordinate moves farther, in rad or lengths.
const FAR: f64 = 0.25;

/// Parts of the way to the initial values: none is shorter than one by this.
const SHORTEST: f64 = 1.0 / 4096.0;

/// Moves a place from the declared start to the initial values. Where that is far, the residuals are taken away in parts, so that the
/// assembly is the one to which the declared start leads; where they cannot be, at once.
fn assemble<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    (q, qd): (&mut SVector<T, N>, &mut SVector<T, N>),
) -> Result<(), Open<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let lengths = lengths(mechanism);
    let (declared, open) = (*q, mechanism.initial(q, T::ZERO).phi);
    let (mut done, mut part) = (T::ZERO, T::of(1.0));
    while done < T::of(1.0) && part >= T::of(SHORTEST) {
        let next = least(done + part, T::of(1.0));
        let left = |q: &SVector<T, N>| {
            let here = mechanism.initial(q, T::ZERO);
            Constraints { phi: SVector::from_fn(|row, _| here.phi[row] - (T::of(1.0) - next) * open[row]), ..here }
        };
        let (mut place, mut speeds) = (*q, *qd);
        let found = project(mechanism, None, (&mut place, &mut speeds), left, levels::<T, S, N, I, M, R>);
        let [before, after] = [&*q, &place].map(|place| picked(place, &S::INTEGRATED));
        let moved: [T; I] = core::array::from_fn(|k| after[k] - before[k]);
        if found.is_ok() && largest(&moved, &lengths) <= T::of(FAR) {
            (*q, *qd, done, part) = (place, speeds, next, part * T::of(2.0));
        } else {
            part = part * T::of(0.5);
        }
    }
    if done == T::of(1.0) {
        return Ok(());
    }
    *q = declared;
    project(mechanism, None, (q, qd), |q| mechanism.initial(q, T::ZERO), levels::<T, S, N, I, M, R>).map(|_| ())
}

/// The state at t = 0, at the initial values of the freedoms.
pub fn initial_state<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(mechanism: &S) -> Result<State<T, N>, Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    mechanism.validate().map_err(Stopped::ParameterOutOfRange)?;
    let zero = SVector::from_element(T::ZERO);
    let (mut q, mut qd) = (mechanism.start(), zero);
    assemble(mechanism, (&mut q, &mut qd)).map_err(|open| match open {
        Open::Dependent(row) => singular::<T, S, N, I, M, R>(T::ZERO, row),
        Open::Residual(row, residual) => {
            let joint = S::JOINTS.get(row).copied().unwrap_or_default();
            Stopped::NotAssembled { joint, residual, unit: unit_of::<T, S, N>(joint) }
        }
    })?;
    holds::<T, S, N, I, M, R>(mechanism, &q, T::ZERO)?;
    let mut state = State::new(T::ZERO, q, qd, zero);
    refresh(mechanism, &mut state)?;
    Ok(state)
}

/// Sets the accelerations of a state, and all its entries that follow from the integrated ones.
pub fn refresh<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &mut State<T, N>,
) -> Result<(), Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    refresh_inlined(mechanism, state)
}

/// The same, compiled into its caller, which shares sines and determinants with it.
#[inline(always)]
pub fn refresh_inlined<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &mut State<T, N>,
) -> Result<(), Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let found = match mechanism.accelerations(&state.q, &state.qd, state.t) {
        Some(found) => found.data.0[0],
        None => eliminated(mechanism, (&state.q, &state.qd), state.t, &mut None)?,
    };
    let mut qdd = state.qdd;
    put(&mut qdd, &S::INTEGRATED, &found);
    let completed = mechanism.complete(&state.q, &state.qd, &qdd, state.t);
    enter(mechanism, state, completed)
}

/// Gives a state completed entries: positions, speeds, and accelerations that follow from them.
#[inline(always)]
pub fn enter<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &mut State<T, N>,
    [q, qd, qdd]: [SVector<T, N>; 3],
) -> Result<(), Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    if !(is_finite(&q) && is_finite(&qd) && is_finite(&qdd)) {
        return Err(Stopped::NotFinite { time: state.t });
    }
    (state.q, state.qd, state.qdd) = (q, qd, qdd);
    state.parameter_hash = mechanism.parameter_hash();
    Ok(())
}
