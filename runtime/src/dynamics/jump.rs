//! Speeds that jump within a step.
//!
//! In: the states at both ends of a step. Out: the first instant at which an equation has a kink, a speed jumps, and the momentum of a motion that
//! is left free jumps with it. There an impulse acts, which no integration of forces gives.
//!
//! Not looked for here: kinks of rows between integrated coordinates, where the projection moves the integrated speeds, and of functions in Rust,
//! and places that jump.

use nalgebra::SVector;

use super::accelerate::{lengths, redundant};
use super::equations::{Constraints, Dynamics};
use super::partition::Partition;
use super::places::{moved, picked, put};
use super::quintic::{between, interpolated};
use super::stopped::Stopped;
use crate::number::Scalar;
use crate::state::State;

/// Parts of a step at whose ends kinks are looked at.
const PARTS: usize = 8;

/// Times ε: the shortest interval relative to the time and to the step.
const SHORTEST: f64 = 8.0;

/// Times ε: relative difference of speeds below which they do not jump.
const ROUNDED: f64 = 256.0;

/// Part of a step, and the sides of all kinks there.
type Look<T> = (T, u64);

/// Refuses a step within which momenta jump. In a step from t = 0 what happens at its very beginning does not count: the initial values are those
/// after it.
pub(super) fn no_speed_jumps<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    from: &State<T, N>,
    to: &State<T, N>,
) -> Result<(), Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    if !S::HAS_KINKS {
        return Ok(());
    }
    let look = |part: T| {
        let ([q, ..], t) = interpolated(&S::INTEGRATED, from, to, part);
        (part, mechanism.sides(&q, t))
    };
    let mut before = look(T::ZERO);
    for number in 1..=PARTS {
        let after = look(T::of(number as f64 / PARTS as f64));
        between_looks(mechanism, [from, to], [before, after], &look)?;
        before = after;
    }
    Ok(())
}

/// Refuses the kinks between two looks, the earlier ones first.
fn between_looks<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    step: [&State<T, N>; 2],
    [low, high]: [Look<T>; 2],
    look: &impl Fn(T) -> Look<T>,
) -> Result<(), Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    if low.1 == high.1 {
        return Ok(());
    }
    let [from, to] = step;
    let (h, middle) = ((to.t - from.t).abs(), (low.0 + high.0) * T::of(0.5));
    let shortest = T::of(SHORTEST) * T::EPSILON * from.t.abs().max(to.t.abs()).max(h);
    if (high.0 - low.0) * h > shortest && middle > low.0 && middle < high.0 {
        let middle = look(middle);
        between_looks(mechanism, step, [low, middle], look)?;
        return between_looks(mechanism, step, [middle, high], look);
    }
    if from.t == T::ZERO && low.0 == T::ZERO {
        return Ok(());
    }
    no_momentum_jumps(mechanism, [low, high].map(|look| between(mechanism, from, to, look.0)))
}

/// Refuses a jump of the momentum ∂T/∂u along a motion that the equations leave, between two states of nearly the same instant.
#[inline(never)]
fn no_momentum_jumps<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    [before, after]: [State<T, N>; 2],
) -> Result<(), Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let Some((place, jump)) = largest_jump(&before, &after) else { return Ok(()) };
    let (mut here, mut parts) = (Constraints::zero(), Partition::empty());
    mechanism.constraints(&after.q, after.t, &mut here);
    if parts.solve((&mut here.jacobian, &mut here.nu), None, &lengths(mechanism), &[true; M], &redundant(mechanism)).is_err() {
        // Where joints lose rank the motion stops for that reason.
        return Ok(());
    }
    let change = picked(&before.qd, &S::INTEGRATED).into_iter().fold(jump, |fastest, speed| fastest.max(speed.abs()));
    let is_struck = (0..parts.independent()).any(|free| {
        let motion = parts.unit(free);
        // T is a quadratic function of u: T(u + s) − T(u − s) = 2 s p, T(u + s) + T(u − s) − 2 T(u) = s² m.
        let kinetic = |state: &State<T, N>, change: T| {
            let mut speeds = state.qd;
            put(&mut speeds, &S::INTEGRATED, &moved(&picked(&state.qd, &S::INTEGRATED), change, &motion));
            let [q, speeds, _] = mechanism.complete(&state.q, &speeds, &state.qdd, state.t);
            mechanism.energy(&q, &speeds, state.t).kinetic
        };
        let momentum = |state: &State<T, N>| {
            let [more, here, less] = [change, T::ZERO, T::ZERO - change].map(|change| kinetic(state, change));
            let rounded = T::of(ROUNDED) * T::EPSILON * here.abs().max(more.abs()).max(less.abs()) / change;
            [(more - less) / (T::of(2.0) * change), (more + less - here - here) / (change * change), rounded]
        };
        let [[one, mass, first], [two, other, second]] = [momentum(&before), momentum(&after)];
        let size = one.abs() + two.abs() + mass.abs().max(other.abs()) * jump;
        (two - one).abs() > T::ROOT_EPSILON * size + first + second
    });
    if !is_struck {
        return Ok(());
    }
    let (owner, coordinate) = S::COORDINATES.get(place).map_or(("", ""), |coordinate| (coordinate.body, coordinate.name));
    Err(Stopped::SpeedJumps { time: after.t, owner, coordinate })
}

/// The coordinate whose speed jumps most, and by how much: by more than the accelerations on both sides and rounding change it.
fn largest_jump<T: Scalar, const N: usize>(before: &State<T, N>, after: &State<T, N>) -> Option<(usize, T)> {
    let width = T::of(2.0) * (after.t - before.t).abs();
    let jump = |place: usize| {
        let of = |vector: &SVector<T, N>| vector.get(place).copied().unwrap_or(T::ZERO);
        let [one, two] = [of(&before.qd), of(&after.qd)];
        let allowed = (of(&before.qdd).abs() + of(&after.qdd).abs()) * width;
        let jump = (two - one).abs();
        (jump > allowed + T::of(ROUNDED) * T::EPSILON * one.abs().max(two.abs())).then_some((place, jump))
    };
    (0..N).filter_map(jump).reduce(|most, next| if next.1 > most.1 { next } else { most })
}
