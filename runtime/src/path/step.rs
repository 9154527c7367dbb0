//! One warm step, the usual case of a sweep.

use nalgebra::SVector;

use super::branch::{comes_from, is_resolved};
use crate::newton::{ONE_CORRECTION, Predictor};
use crate::number::{Float, Mask};
use crate::solve::{Solver, SolverReal, Stages, StepReport};
use crate::state::{Coordinates, Moment, State, Step};

/// One warm step of the coordinates that may move; whether it succeeded.
///
/// * `state`: given, a solved state; returned, the state at `t` (s) if the step succeeded, else unchanged.
#[inline]
pub(crate) fn step<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(equations: &E, state: &mut State<T, N>, t: T) -> bool {
    equations.partial_step(state, t).unwrap_or_else(|| step_of_all(equations, state, t))
}

/// One warm step; whether it succeeded.
///
/// One function for each mechanism, so that its stages are inlined and their results stay in registers.
#[inline(never)]
fn step_of_all<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(equations: &E, state: &mut State<T, N>, t: T) -> bool {
    if state.parameter_hash != equations.parameter_hash() {
        return false;
    }
    // Every block keeps its sign, so that the branch is unchanged.
    let signs = state.branch;
    step_lanes(equations, state, &signs, t, true)
}

/// One warm step of the moving coordinates only; whether it succeeded.
///
/// * `part`: given, the moving part as a mechanism of its own.
/// * `held`: given, the indices of its coordinates in q.
/// * `parameter_hash`: given, the hash of the current parameters.
#[doc(hidden)]
pub fn step_in_part<T: Float, E: Stages<T, P>, const P: usize, const N: usize>(
    part: &E,
    state: &mut State<T, N>,
    held: &[usize; P],
    parameter_hash: u64,
    t: T,
) -> bool {
    // With other parameters the part at rest has moved.
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

/// One warm step in the lanes `moving`. Returns the lanes in which it succeeded; in these the state becomes that at `t`.
///
/// * `signs`: given, the signs of the determinants, each at the index of its block's first unknown.
#[inline(always)]
pub fn step_lanes<T: SolverReal, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    state: &mut State<T, N>,
    signs: &[T::Signs; N],
    t: T,
    moving: T::Mask,
) -> T::Mask {
    if E::IN_PLACE {
        return step_in_place(equations, state, signs, t, moving);
    }
    let h = t - state.t;
    let here = state.values.moment();
    let mut solver =
        Solver::warm(equations, Predictor::new((here, state.condition), &state.extrapolation, signs, h, moving, E::ITERATED.len()));
    let nowhere = T::Mask::of(false);
    // Borrowed, since moving it would copy all coordinates.
    let result = equations.stages(t, &mut solver);
    let Ok(there) = &result else { return nowhere };
    let Some(StepReport { found, condition, iterations }) = solver.report() else { return nowhere };
    let found = found.and(moving).and(is_resolved([E::LINKS, E::COMPUTED_ANGLES], here, &there.q, h));
    let mut found = found.and(is_surely_finite(sum(h, &there.qdd, E::ITERATED), there.moment(), E::MAY_BE_NON_FINITE));
    // A prediction that was right to half of its digits lies on the same branch; others are checked backwards.
    if iterations > ONE_CORRECTION {
        // Copies, so that the usual case can keep the originals in registers.
        let (here, there) = (state.values.moment(), Coordinates { q: there.q, qd: there.qd, qdd: there.qdd });
        found = found.and(returns(equations, here, h, there.moment(), condition.max(state.condition)));
    }
    if !found.not().all() {
        state.extrapolation.follow(h, found, state.values.moment(), there.moment(), E::ITERATED);
        state.follow_on(t, &Step { h, found, condition, iterations }, there);
    }
    found
}

/// The same in place, for many coordinates: they are copied once, and written back where the step failed.
#[inline(always)]
fn step_in_place<T: SolverReal, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    state: &mut State<T, N>,
    signs: &[T::Signs; N],
    t: T,
    moving: T::Mask,
) -> T::Mask {
    let h = t - state.t;
    let before = Coordinates::of(state);
    let State { values, extrapolation, .. } = state;
    let (here, condition) = (before.moment(), values.condition);
    let mut solver = Solver::warm(equations, Predictor::new((here, condition), extrapolation, signs, h, moving, E::ITERATED.len()));
    let is_found = equations.stages_in_place(t, &mut solver, values).is_ok();
    let Some(StepReport { found, condition, iterations }) = solver.report().filter(|_| is_found) else {
        values.put(before);
        return T::Mask::of(false);
    };
    let there = values.moment();
    let found = found.and(moving).and(is_resolved([E::LINKS, E::COMPUTED_ANGLES], here, there.q, h));
    // Coordinates are read only once.
    let accelerations = extrapolation.follow(h, found, here, there, E::ITERATED);
    let mut found = found.and(is_surely_finite(h + accelerations, there, E::MAY_BE_NON_FINITE));
    if iterations > ONE_CORRECTION {
        found = found.and(returns(equations, here, h, there, condition.max(values.condition)));
    }
    if !found.all() {
        values.put_back(found, &before);
        extrapolation.forget(found);
    }
    if !found.not().all() {
        state.accept(t, &Step { h, found, condition, iterations });
    }
    found
}

/// Whether the prediction backwards meets the state before, as [`comes_from`] defines it, and no computed angle has turned by more than half a
/// turn: what happened in between is left to a continuation.
#[cold]
#[inline(never)]
fn returns<T: SolverReal, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    here: Moment<'_, T, N>,
    h: T,
    there: Moment<'_, T, N>,
    condition: T,
) -> T::Mask {
    let mut returned = comes_from(equations.characteristic_length(), (E::ITERATED, E::COORDINATES), here, h, there, condition);
    for &i in E::COMPUTED_ANGLES {
        if i < N {
            returned = returned.and((there.q[i] - here.q[i]).abs().at_most(T::of(core::f64::consts::PI)));
        }
    }
    returned
}

/// The sum of a number and these entries.
#[inline(always)]
fn sum<T: SolverReal, const N: usize>(first: T, vector: &SVector<T, N>, indices: &[usize]) -> T {
    let mut sum = first;
    for &i in indices {
        if i < N {
            sum = sum + vector[i];
        }
    }
    sum
}

/// Whether all coordinates are finite: a sum is not finite if one of its terms is not. Rates enter by their squares, which
/// accelerations contain. Iterated coordinates are finite, and their rates are if their accelerations are.
///
/// * `sum`: given, the length of the step plus the accelerations of the iterated coordinates.
#[inline(always)]
fn is_surely_finite<T: SolverReal, const N: usize>(sum: T, there: Moment<'_, T, N>, indices: Option<&[usize]>) -> T::Mask {
    // Three independent sums, which shorten the chain of dependent additions; two of them begin with their first term, since rustc keeps a
    // sum with zero.
    let (mut of_q, mut others): (T, Option<[T; 2]>) = (sum, None);
    let mut add = |i: usize| {
        let here = [there.qdd[i], there.qd[i] * there.qd[i]];
        of_q = of_q + there.q[i];
        others = Some(others.map_or(here, |[a, b]| [a + here[0], b + here[1]]));
    };
    match indices {
        Some(indices) => indices.iter().filter(|i| **i < N).for_each(|i| add(*i)),
        None => (0..N).for_each(add),
    }
    let sum = others.map_or(of_q, |[a, b]| (of_q + a) + b);
    // 0 for a finite sum, NaN for ∞ and NaN.
    (T::of(0.0) * sum).at_most(T::of(0.0))
}
