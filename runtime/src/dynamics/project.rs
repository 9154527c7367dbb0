//! Positions and speeds that fulfil the equations.

use nalgebra::SVector;

use super::accelerate::{eliminated, lengths, redundant};
use super::equations::{Constraints, Dynamics};
use super::partition::{ABOUT_AS_GOOD, Partition, Pivots, WORSE};
use super::places::{are_finite, largest, moved, picked, put};
use super::stopped::Stopped;
use crate::linear::scaled;
use crate::number::Scalar;
use crate::state::State;

/// Most corrections of positions.
const CORRECTIONS: usize = 50;

/// Most halvings of a correction.
const HALVINGS: usize = 12;

/// Equations at a place where they hold, and an order of the elimination of J.
#[derive(Clone, Copy)]
pub(super) struct Reached<T, const K: usize, const I: usize> {
    /// Φ, J and ν.
    pub(super) here: Constraints<T, K, I>,
    /// The order.
    pub(super) pivots: Pivots<T, K, I>,
}

impl<T: Scalar, const K: usize, const I: usize> Reached<T, K, I> {
    /// Zeros, to be filled by a projection.
    #[inline(always)]
    pub(super) fn empty() -> Self {
        Self { here: Constraints::zero(), pivots: Pivots::none() }
    }
}

/// Moves dependent coordinates of a state until its equations hold at `t`, and sets their speeds; independent ones keep their values.
///
/// * `known`: given, pivots at a state close by.
/// * `reached`: returned, the equations there.
///
/// # Errors
/// The number of the row at fault, and its residual.
pub(super) fn project<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    known: Option<&Pivots<T, M, I>>,
    state: (&mut SVector<T, N>, &mut SVector<T, N>),
    t: T,
    reached: &mut Reached<T, M, I>,
) -> Result<(), Open<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    // Which rows are redundant may have changed.
    project_onto(mechanism, known.filter(|_| S::REDUNDANT == 0), state, |q, found| mechanism.constraints(q, t, found), reached)
}

/// The same for given equations. Known pivots are taken as they are, also of redundant rows.
pub(super) fn project_onto<T, S, const N: usize, const I: usize, const M: usize, const R: usize, const K: usize>(
    mechanism: &S,
    known: Option<&Pivots<T, K, I>>,
    state: (&mut SVector<T, N>, &mut SVector<T, N>),
    equations: impl Fn(&SVector<T, N>, &mut Constraints<T, K, I>),
    reached: &mut Reached<T, K, I>,
) -> Result<(), Open<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let (q, qd) = state;
    let (lengths, redundant) = (lengths(mechanism), redundant(mechanism));
    let [of_positions, of_speeds] = levels(&S::LEVELS);
    // If the same rows count for positions and for speeds, the same pivots are good for both.
    let are_same = of_positions == [true; K] && of_speeds == [true; K];
    let mut kept = known.filter(|_| are_same).copied();
    let fraction = T::of(if S::REDUNDANT == 0 { ABOUT_AS_GOOD } else { WORSE });
    let Reached { here, pivots } = reached;
    equations(q, here);
    let mut open = gap(here, &of_positions);
    let mut parts = Partition::empty();
    for _ in 0..CORRECTIONS {
        let side = scaled(&here.phi, T::of(-1.0));
        let known = kept.as_ref().map(|pivots| (pivots, fraction));
        parts.solve((&here.jacobian, &side), known, &lengths, &of_positions, &redundant).map_err(Open::Dependent)?;
        let mut counts = of_positions;
        if S::REDUNDANT > 0 {
            counts = parts.pivots.among(&of_positions);
            // The same rows from now on: if each correction chose others, redundant joints that do not fit would never settle.
            (kept, open) = (Some(parts.pivots), gap(here, &counts));
        }
        let correction = parts.unknowns(&[T::ZERO; I]);
        let size = largest(&correction, &lengths);
        if !are_finite(&correction) {
            break;
        }
        // Newton's method converges quadratically.
        let is_last = size < T::ROOT_EPSILON;
        let mut factor = T::of(1.0);
        let start = picked(q, &S::INTEGRATED);
        for halving in 0..=HALVINGS {
            put(q, &S::INTEGRATED, &moved(&start, factor, &correction));
            equations(q, here);
            let left = gap(here, &counts);
            if left.1 < open.1 || is_last || halving == HALVINGS {
                open = left;
                break;
            }
            factor = factor * T::of(0.5);
        }
        if is_last {
            *pivots = parts.pivots;
            let known = are_same.then_some((&*pivots, T::of(WORSE)));
            parts.solve((&here.jacobian, &here.nu), known, &lengths, &of_speeds, &redundant).map_err(Open::Dependent)?;
            let before = picked(qd, &S::INTEGRATED);
            put(qd, &S::INTEGRATED, &parts.unknowns(&parts.independent_of(&before)));
            *pivots = parts.pivots;
            return Ok(());
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
    /// A row depends on the others after this fraction of the way to other parameters.
    After(usize, T),
}

impl<T> Open<T> {
    /// The row.
    pub(super) fn row(&self) -> usize {
        match *self {
            Open::Residual(row, _) | Open::Dependent(row) | Open::After(row, _) => row,
        }
    }
}

/// The row that is open furthest, and its residual; the first one whose residual is not a number.
pub(super) fn gap<T: Scalar, const K: usize, const I: usize>(here: &Constraints<T, K, I>, counts: &[bool; K]) -> (usize, T) {
    let mut gap = (0, T::ZERO);
    for (row, (phi, counts)) in here.phi.iter().zip(counts).enumerate() {
        if !counts {
            continue;
        }
        let size = phi.abs();
        if !size.is_finite() {
            return (row, size);
        }
        gap = if size > gap.1 { (row, size) } else { gap };
    }
    gap
}

/// For each of the first equations whether it counts between positions, and for each whether it counts between speeds.
pub(super) fn levels<const R: usize, const K: usize>(levels: &[[bool; 2]; R]) -> [[bool; K]; 2] {
    let (mut of_positions, mut of_speeds) = ([false; K], [false; K]);
    for ((of_positions, of_speeds), levels) in of_positions.iter_mut().zip(&mut of_speeds).zip(levels) {
        [*of_positions, *of_speeds] = *levels;
    }
    [of_positions, of_speeds]
}

/// Sets the accelerations of a state, and all its entries that follow from the integrated ones.
pub(super) fn refresh<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
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
    complete(mechanism, state, &qdd)
}

/// Sets all entries of a state that follow from the integrated ones with these accelerations.
pub(super) fn complete<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &mut State<T, N>,
    qdd: &SVector<T, N>,
) -> Result<(), Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let [q, qd, qdd] = mechanism.complete(&state.q, &state.qd, qdd, state.t);
    if !(are_finite(q.as_slice()) && are_finite(qd.as_slice()) && are_finite(qdd.as_slice())) {
        return Err(Stopped::NotFinite { time: state.t });
    }
    (state.q, state.qd, state.qdd) = (q, qd, qdd);
    state.parameter_hash = mechanism.parameter_hash();
    Ok(())
}

/// Gives a state the accelerations that follow from its positions and speeds.
#[inline(always)]
pub fn enter<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &mut State<T, N>,
    qdd: SVector<T, N>,
) -> Result<(), Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    if !are_finite(qdd.as_slice()) {
        return Err(Stopped::NotFinite { time: state.t });
    }
    state.qdd = qdd;
    state.parameter_hash = mechanism.parameter_hash();
    Ok(())
}
