//! Speeds that jump within a step.
//!
//! In: the states at both ends of a step. Out: the instant at which a speed jumps so that the momentum of a motion that is left free jumps as well. There
//! an impulse acts, which no integration of forces gives.
//!
//! Not looked for here: rows between integrated coordinates. Where they jump, the projection moves the integrated speeds.

use nalgebra::SVector;

use super::accelerate::{lengths, redundant};
use super::equations::{Constraints, Dynamics};
use super::event::between;
use super::partition::Partition;
use super::places::{moved, picked, put};
use super::stopped::Stopped;
use crate::number::Scalar;
use crate::state::State;

/// Parts of a step in which a jump is looked for.
const PARTS: usize = 8;

/// The difference of speeds from the trapezoidal rule falls to an eighth in each half of an interval; where it does not fall below this part, a
/// speed may jump.
const SMOOTH: f64 = 0.25;

/// Times ε: parts of the speeds that are rounding, and the shortest interval relative to the time.
const ROUNDED: f64 = 256.0;

/// Refuses a step within which momenta jump. In a step that begins a motion at t = 0 what happens at its very beginning does not count: the
/// initial values are those after it.
pub(super) fn no_speed_jumps<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    from: &State<T, N>,
    to: &State<T, N>,
) -> Result<(), Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    if !S::MAY_JUMP {
        return Ok(());
    }
    let at = |part: T| (part, between(mechanism, from, to, part));
    let mut before = at(T::ZERO);
    let scale = largest(&from.qd).max(largest(&to.qd)).max(largest(&before.1.qd));
    for number in 1..=PARTS {
        let after = at(T::of(number as f64 / PARTS as f64));
        if let Some((low, high)) = narrowed([&before, &after], scale, at) {
            let is_beginning = from.t == T::ZERO && low.0 == T::ZERO;
            if !is_beginning && momenta_jump(mechanism, [&low.1, &high.1]) {
                let (mut most, mut owner, mut coordinate) = (T::ZERO, "", "");
                for ((one, other), name) in low.1.qd.iter().zip(&high.1.qd).zip(S::COORDINATES) {
                    let jump = (*other - *one).abs();
                    if jump > most {
                        (most, owner, coordinate) = (jump, name.body, name.name);
                    }
                }
                return Err(Stopped::SpeedJumps { time: high.1.t, owner, coordinate });
            }
        }
        before = after;
    }
    Ok(())
}

/// Part of a step, and the state there.
type Place<T, const N: usize> = (T, State<T, N>);

/// The ends of a shortest interval across which a speed jumps, if there seems to be one.
fn narrowed<T: Scalar, const N: usize>(
    [low, high]: [&Place<T, N>; 2],
    scale: T,
    at: impl Fn(T) -> Place<T, N>,
) -> Option<(Place<T, N>, Place<T, N>)> {
    let (mut low, mut high) = (low.clone(), high.clone());
    let mut off = off(&low.1, &high.1);
    loop {
        if !(off > T::of(ROUNDED) * T::EPSILON * scale) {
            return None;
        }
        let width = (high.1.t - low.1.t).abs();
        if width <= T::of(ROUNDED) * T::EPSILON * high.1.t.abs().max(width) {
            return Some((low, high));
        }
        let middle = at((low.0 + high.0) * T::of(0.5));
        if middle.0 == low.0 || middle.0 == high.0 {
            return Some((low, high));
        }
        let halves = [self::off(&low.1, &middle.1), self::off(&middle.1, &high.1)];
        if halves[0].max(halves[1]) <= T::of(SMOOTH) * off {
            return None;
        }
        off = halves[0].max(halves[1]);
        if halves[0] > halves[1] {
            high = middle;
        } else {
            low = middle;
        }
    }
}

/// How far the speeds of two states differ from what the accelerations between them give by the trapezoidal rule.
fn off<T: Scalar, const N: usize>(from: &State<T, N>, to: &State<T, N>) -> T {
    let half = T::of(0.5) * (to.t - from.t);
    let speeds = from.qd.iter().zip(&to.qd).map(|(one, other)| *other - *one);
    let accelerations = from.qdd.iter().zip(&to.qdd).map(|(one, other)| (*one + *other) * half);
    speeds.zip(accelerations).fold(T::ZERO, |off, (change, by_accelerations)| off.max((change - by_accelerations).abs()))
}

fn largest<T: Scalar, const N: usize>(vector: &SVector<T, N>) -> T {
    vector.iter().fold(T::ZERO, |largest, value| largest.max(value.abs()))
}

/// True if the momentum ∂T/∂u along a motion that the equations leave differs between two states of the same instant.
#[inline(never)]
fn momenta_jump<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(mechanism: &S, states: [&State<T, N>; 2]) -> bool
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let [before, after] = states;
    let (mut here, mut parts) = (Constraints::zero(), Partition::empty());
    mechanism.constraints(&after.q, after.t, &mut here);
    if parts.solve((&mut here.jacobian, &mut here.nu), None, &lengths(mechanism), &[true; M], &redundant(mechanism)).is_err() {
        return false;
    }
    let speeds = picked(&before.qd, &S::INTEGRATED);
    let fastest = speeds.into_iter().fold(T::ZERO, |fastest, speed| fastest.max(speed.abs()));
    let step = if fastest > T::ZERO { fastest } else { T::of(1.0) };
    (0..parts.independent()).any(|place| {
        let motion = parts.unit(place);
        // T is a quadratic function of u.
        let kinetic = |state: &State<T, N>, change: T| {
            let mut speeds = state.qd;
            put(&mut speeds, &S::INTEGRATED, &moved(&picked(&state.qd, &S::INTEGRATED), change, &motion));
            let [q, speeds, _] = mechanism.complete(&state.q, &speeds, &state.qdd, state.t);
            mechanism.energy(&q, &speeds, state.t).kinetic
        };
        let [before, after] = states.map(|state| [kinetic(state, step), kinetic(state, T::ZERO - step)]);
        let [one, two] = [before, after].map(|[more, less]| more - less);
        let size = before.iter().chain(&after).fold(T::ZERO, |size, kinetic| size.max(kinetic.abs()));
        (two - one).abs() > T::ROOT_EPSILON * size
    })
}
