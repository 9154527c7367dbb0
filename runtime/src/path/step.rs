//! One warm step, the usual case of a sweep.

use nalgebra::SVector;

use super::branch::{comes_from, is_resolved};
use crate::newton::{ONE_CORRECTION, Predictor};
use crate::number::{Float, Mask};
use crate::solve::{Solver, SolverReal, Stages, StepReport};
use crate::state::{Coordinates, State, Step};

/// One warm step, of those coordinates that may move; whether it was made.
///
/// * `state`: given, a solved state; returned, the state at `t` (s) if the step was made, else as it was.
#[inline]
pub(crate) fn step<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(equations: &E, state: &mut State<T, N>, t: T) -> bool {
    equations.partial_step(state, t).unwrap_or_else(|| step_of_all(equations, state, t))
}

/// One step straight on; whether it was made.
///
/// A function of its own for each mechanism, so that its stages are compiled into it and their results never leave the registers.
#[inline(never)]
fn step_of_all<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(equations: &E, state: &mut State<T, N>, t: T) -> bool {
    if state.parameter_hash != equations.parameter_hash() {
        return false;
    }
    // Every block keeps its sign: the branch's name stays.
    let signs = state.branch;
    step_lanes(equations, state, &signs, t, true)
}

/// One step straight on of those coordinates that move; whether it was made.
///
/// * `part`: given, what moves, as a mechanism of its own.
/// * `held`: given, the indices in q of its coordinates.
/// * `parameter_hash`: given, of the parameters.
#[doc(hidden)]
pub fn step_in_part<T: Float, E: Stages<T, P>, const P: usize, const N: usize>(
    part: &E,
    state: &mut State<T, N>,
    held: &[usize; P],
    parameter_hash: u64,
    t: T,
) -> bool {
    // With other parameters what rested does not rest.
    if state.parameter_hash != parameter_hash {
        return false;
    }
    let mut moving = state.part(held);
    let is_made = step_of_all(part, &mut moving, t);
    if is_made {
        state.take(held, &moving);
    }
    is_made
}

/// One step straight on, in the lanes that are `moving`; the lanes that made it. The state is then the one at `t` in these.
///
/// * `signs`: given, the branch: by block, at the index of its first unknown.
#[inline(always)]
pub fn step_lanes<T: SolverReal, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    state: &mut State<T, N>,
    signs: &[T::Signs; N],
    t: T,
    moving: T::Mask,
) -> T::Mask {
    let h = t - state.t;
    let mut solver = Solver::warm(equations, Predictor::new(state, signs, h, moving, E::ITERATED.len()));
    let nowhere = T::Mask::of(false);
    if E::IN_PLACE {
        let mut there = Coordinates::of(state);
        let is_found = equations.stages_in_place(t, &mut solver, &mut there).is_ok();
        let Some(report) = solver.report().filter(|_| is_found) else { return nowhere };
        make_step(equations, state, t, &there, report, moving)
    } else {
        let Ok(there) = equations.stages(t, &mut solver) else { return nowhere };
        let Some(report) = solver.report() else { return nowhere };
        make_step(equations, state, t, &there, report, moving)
    }
}

/// Makes the step to where a pass has led, in the lanes in which it led anywhere; which they are.
#[inline(always)]
fn make_step<T: SolverReal, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    state: &mut State<T, N>,
    t: T,
    there: &Coordinates<T, N>,
    report: StepReport<T>,
    moving: T::Mask,
) -> T::Mask {
    let h = t - state.t;
    let StepReport { found, condition, iterations } = report;
    let found = found.and(moving).and(is_resolved(state, &there.q, h, E::COMPUTED_ANGLES));
    // In memory what is iterated is looked at once only; what lies in registers is put there when it is sure.
    let accelerations = if E::IN_PLACE { state.extrapolate(h, found, there, E::ITERATED) } else { sum(&there.qdd, E::ITERATED) };
    let mut found = found.and(is_surely_finite(h + accelerations, there, E::MAY_BE_NON_FINITE));
    // A prediction that was right to half of its digits comes from the same branch.
    if iterations > ONE_CORRECTION {
        // A copy, so that the usual case need not have it in memory.
        let there = Coordinates { q: there.q, qd: there.qd, qdd: there.qdd };
        found = found.and(comes_from(equations, state, h, &there, condition));
    }
    if !found.not().all() {
        if !E::IN_PLACE {
            state.extrapolate(h, found, there, E::ITERATED);
        }
        state.follow_on(t, &Step { h, found, condition, iterations }, there);
    }
    if E::IN_PLACE && !found.all() {
        state.forget_extrapolation(found);
    }
    found
}

/// The sum of these entries.
#[inline(always)]
fn sum<T: SolverReal, const N: usize>(vector: &SVector<T, N>, indices: &[usize]) -> T {
    let mut sum = T::of(0.0);
    for &i in indices {
        if i < N {
            sum = sum + vector[i];
        }
    }
    sum
}

/// A sum is not finite if a term is not. Of rates the squares are looked at, which accelerations contain; what is iterated is finite, and
/// so are its rates if its accelerations are.
///
/// * `sum`: given, the time that the step takes and the accelerations of what is iterated.
#[inline(always)]
fn is_surely_finite<T: SolverReal, const N: usize>(sum: T, there: &Coordinates<T, N>, indices: Option<&[usize]>) -> T::Mask {
    // Three sums sign by sign, so that none has to wait long for the one before.
    let mut sums = [sum, T::of(0.0), T::of(0.0)];
    let mut add = |i: usize| {
        sums[0] = sums[0] + there.q[i];
        sums[1] = sums[1] + there.qdd[i];
        sums[2] = sums[2] + there.qd[i] * there.qd[i];
    };
    match indices {
        Some(indices) => indices.iter().filter(|i| **i < N).for_each(|i| add(*i)),
        None => (0..N).for_each(add),
    }
    let sum = (sums[0] + sums[1]) + sums[2];
    // Nothing is left of a number; ∞ and NaN stay NaN.
    (T::of(0.0) * sum).at_most(T::of(0.0))
}
