//! The end of a step: its projection onto the equations, and its error.

use nalgebra::SVector;

use super::accelerate::{lengths, redundant, singular};
use super::changed::accelerate;
use super::checks::holds;
use super::equations::Dynamics;
use super::explicit::Explicit;
use super::jump::no_speed_jumps;
use super::method::{Method, Trial};
use super::places::{are_finite, largest, largest_change, picked};
use super::project::{Reached, project, refresh};
use super::rank::{is_regular, keeps_rank, too_short};
use super::stopped::Stopped;
use crate::names::{Coordinate, CoordinateKind};
use crate::number::Scalar;
use crate::number::order::smaller;
use crate::state::State;

/// One step of fixed size, without an estimate of its error.
pub fn fixed_step<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &mut State<T, N>,
    h: T,
) -> Result<(), Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    // Parameters may have changed since the accelerations were computed.
    let mut start = state.clone();
    accelerate(mechanism, &mut start)?;
    let trial = Explicit::trial(mechanism, &start, h)?;
    let mut reached = Reached::empty();
    let next = land(mechanism, (&start, None), &trial, h, (T::of(COARSEST), T::ZERO), &mut reached)?;
    keeps_rank::<Explicit, T, S, N, I, M, R>(mechanism, (&start, None), (&next, &reached))?;
    no_speed_jumps(mechanism, &start, &next)?;
    *state = next;
    Ok(())
}

/// Largest violation of the equations after a step of fixed size, as a fraction of the lengths and speeds.
const COARSEST: f64 = 0.1;

/// Times ε: a tolerance is never stricter. A speed of so many rad/s or L/s counts as none.
const STRICTEST: f64 = 1e4;

/// Times ε, over the square of the smallest pivot: how far rounding moves speeds.
const ROUNDING: f64 = 10.0;

/// The state after a step, brought back to where the equations hold.
///
/// Where the equations are nearly dependent, this may move speeds by any amount; a step is refused if it moves them by more than its tolerance.
///
/// * `from`, `before`: given, the state before the step, and the equations there.
/// * `tolerance`, `fastest`: given, how far a state may be brought back relative to lengths and speeds, and the largest speed so far.
/// * `reached`: returned, the equations at the end of the step.
pub(super) fn land<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    (from, before): (&State<T, N>, Option<&Reached<T, M, I>>),
    trial: &Trial<T, N, I>,
    h: T,
    (tolerance, fastest): (T, T),
    reached: &mut Reached<T, M, I>,
) -> Result<State<T, N>, Stopped<T>>
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let ([mut q, mut qd], t) = (trial.end, from.t + h);
    if !(are_finite(q.as_slice()) && are_finite(qd.as_slice())) {
        return Err(Stopped::NotFinite { time: t });
    }
    let known = before.map(|before| &before.pivots);
    project(mechanism, known, (&mut q, &mut qd), t, reached).map_err(|open| singular::<T, S, N, I, M, R>(t, open.row()))?;
    holds::<T, S, N, I, M, R>(mechanism, &q, t)?;
    let fastest = fastest.max(speed(mechanism, &from.qd)).max(speed(mechanism, &trial.end[1]));
    // Positions are rounded to ε / p, p the smallest pivot, and speeds to that over p.
    let pivot = reached.pivots.smallest(&lengths(mechanism), &redundant(mechanism).sizes);
    let tolerance = tolerance.max(T::of(ROUNDING) * T::EPSILON / (pivot * pivot));
    // If drives determine all speeds, a speed may jump, since no momentum does. With derivatives it may not: that of the instant is unknown.
    let may_jump = M == I + S::REDUNDANT && is_instant(h, from.t) && !T::HAS_DERIVATIVES;
    let speeds = if may_jump { &qd } else { &trial.end[1] };
    if !is_near(mechanism, [&trial.end[0], speeds], [&q, &qd], (tolerance, fastest)) {
        return Err(too_short(mechanism, &State::new(t, q, qd, from.qdd)));
    }
    is_regular(mechanism, t, reached)?;
    let mut next = State::new(t, q, qd, from.qdd);
    refresh(mechanism, &mut next)?;
    if M > 0 && turns_unseen::<T, S, N, I, M, R>(from, &next, h) {
        return Err(too_short(mechanism, &next));
    }
    Ok(next)
}

/// True if an angle that is computed instead of integrated has turned by half a turn more than its rates and accelerations at both ends tell. A
/// drive that turns by a whole turn within a step would leave loops behind, which are closed after it as well as before.
#[inline(always)]
fn turns_unseen<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(from: &State<T, N>, to: &State<T, N>, h: T) -> bool
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let computed = const { computed_angles::<N, I>(S::COORDINATES, &S::INTEGRATED) };
    let (half, twelfth) = (T::of(0.5), T::of(1.0 / 12.0));
    for (i, is_computed) in computed.iter().enumerate() {
        if *is_computed {
            // Exact for a polynomial of the fourth degree.
            let told = half * h * (from.qd[i] + to.qd[i]) + twelfth * h * h * (from.qdd[i] - to.qdd[i]);
            if (to.q[i] - from.q[i] - told).abs() > T::of(core::f64::consts::PI) {
                return true;
            }
        }
    }
    false
}

/// For each coordinate, whether it is an angle that is not integrated.
const fn computed_angles<const N: usize, const I: usize>(coordinates: &[Coordinate], integrated: &[usize; I]) -> [bool; N] {
    let mut computed = [false; N];
    let mut number = 0;
    while number < N && number < coordinates.len() {
        computed[number] = matches!(coordinates[number].kind, CoordinateKind::Angle);
        number += 1;
    }
    number = 0;
    while number < I {
        if integrated[number] < N {
            computed[integrated[number]] = false;
        }
        number += 1;
    }
    computed
}

/// True if positions and speeds that were brought back to where the equations hold are near those before, by a tolerance relative to
/// lengths, angles and the largest speed.
pub(super) fn is_near<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    before: [&SVector<T, N>; 2],
    after: [&SVector<T, N>; 2],
    (tolerance, fastest): (T, T),
) -> bool
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let (lengths, none) = (lengths(mechanism), T::of(STRICTEST) * T::EPSILON);
    let tolerance = tolerance.max(none);
    let ([q, u], [q_there, u_there]) = (before, after);
    largest_change([q, q_there], &S::INTEGRATED, &lengths) <= tolerance * largest(&picked(q, &S::INTEGRATED), &lengths).max(T::of(1.0))
        && largest_change([u, u_there], &S::INTEGRATED, &lengths) <= none.max(tolerance * fastest)
}

/// The largest speed, in L/s and rad/s.
pub(super) fn speed<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(mechanism: &S, speeds: &SVector<T, N>) -> T
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    largest(&picked(speeds, &S::INTEGRATED), &lengths(mechanism))
}

/// A step in which no coordinate moves by more than a hundredth of its scale.
pub(super) fn first_step<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(mechanism: &S, state: &State<T, N>) -> T
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let lengths = lengths(mechanism);
    let speed = largest(&picked(&state.qd, &S::INTEGRATED), &lengths);
    let acceleration = largest(&picked(&state.qdd, &S::INTEGRATED), &lengths);
    let hundredth = T::of(0.01);
    let by_acceleration = (hundredth / acceleration.max(T::of(1e-8))).sqrt();
    smaller(hundredth / speed.max(T::of(1e-8)), by_acceleration)
}

/// A speed counts as none if it takes a thousand of the longest steps for a radian, or for L.
const SLOW: f64 = 1e-3;

/// Times ε t: the instant at which a force jumps is not known better.
pub(super) const INSTANT: f64 = 8.0;

/// Times ε t: the time is off by so much, and no speed is known better than at such a time. It counts where speeds grow without bound.
const ROUNDED: f64 = 0.1;

/// True for a step as short as the instant of a jump.
pub(super) fn is_instant<T: Scalar>(h: T, t: T) -> bool {
    h.abs() <= T::of(INSTANT) * T::EPSILON * t.abs()
}

/// Within an instant a speed may change by this fraction of the largest one.
const JUMP: f64 = 0.1;

/// Errors of steps add up: each may have this fraction of the tolerance.
const EACH: f64 = 0.02;

/// Times ε: steps shorter than this fraction of the time are not shortened further for the sake of derivatives.
const SHORT: f64 = 1e4;

/// Derivatives may have errors larger by this factor.
const LOOSER: f64 = 10.0;

/// Times ε: errors that derivatives may have by rounding, of values divided by the parameter. A derivative that cancels to zero is not
/// compared with itself.
const CANCELLED: f64 = 1e3;

/// Estimated error of a step, relative to the tolerance, and the largest speed so far.
///
/// * `longest`: given, the longest step so far, or the longest one tried if there is none.
/// * `may_jump`: given, true if a force may jump in this step: longer ones were tried, and the steps before were no instants.
pub(super) fn error<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &State<T, N>,
    trial: &Trial<T, N, I>,
    h: T,
    (tolerance, mut fastest): (T, T),
    (longest, may_jump): (T, bool),
) -> (T, T)
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let lengths = lengths(mechanism);
    let [end, moving] = &trial.end;
    fastest = fastest.max(speed(mechanism, &state.qd)).max(speed(mechanism, moving));
    let (before, after) = (picked(&state.q, &S::INTEGRATED), picked(end, &S::INTEGRATED));
    let allowed = T::of(EACH) * tolerance;
    let slowest = fastest.max(T::of(SLOW) / longest.max(h.abs()));
    let change = largest_change([&state.qd, moving], &S::INTEGRATED, &lengths);
    let jumped = if may_jump && is_instant(h, state.t) { smaller(change, T::of(JUMP) * slowest) } else { T::ZERO };
    let rounded = T::of(ROUNDED) * T::EPSILON * state.t.abs() * change / h.abs();
    let scale = slowest + (jumped + rounded) / allowed;
    let of_values = error_of_values([&before, &after], &trial.errors, &lengths, (allowed, scale), bends(mechanism, state, trial, h));
    if T::HAS_DERIVATIVES {
        let of_derivatives = error_of_derivatives(mechanism, state, trial, h, (tolerance, slowest));
        return (of_values.max(of_derivatives), fastest);
    }
    (of_values, fastest)
}

/// True if a force has a kink between the ends of a step, or jumps.
fn bends<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &State<T, N>,
    trial: &Trial<T, N, I>,
    h: T,
) -> bool
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    let [end, moving] = &trial.end;
    S::FORCES_HAVE_KINKS && mechanism.sides_of_forces(&state.q, &state.qd, state.t) != mechanism.sides_of_forces(end, moving, state.t + h)
}

/// Estimated error of a step in positions and speeds, relative to an error allowed.
fn error_of_values<T: Scalar, const I: usize>(
    [before, after]: [&[T; I]; 2],
    errors: &[[[T; 2]; I]; 2],
    lengths: &[T; I],
    (allowed, speed): (T, T),
    bends: bool,
) -> T {
    let (mut first, mut second) = (T::ZERO, T::ZERO);
    for k in 0..I {
        let value = (before[k] / lengths[k]).abs().max((after[k] / lengths[k]).abs()).max(T::of(1.0));
        for (errors, scale) in errors.iter().zip([value, speed]) {
            let size = allowed * scale * lengths[k];
            let (one, two) = (errors[k][0] / size, errors[k][1] / size);
            (first, second) = (first + one * one, second + two * two);
        }
    }
    if bends { whole::<T, I>(first, second) } else { combined::<T, I>(first, second) }
}

/// Estimated error of a step in the derivatives by parameters, relative to the tolerance and to the largest of them.
///
/// Where a force has a kink, values stay smooth enough for long steps, and their derivatives do not.
///
/// * `speed`: given, the largest speed so far, or the largest one that counts as none.
fn error_of_derivatives<T, S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &State<T, N>,
    trial: &Trial<T, N, I>,
    h: T,
    (tolerance, speed): (T, T),
) -> T
where
    T: Scalar,
    S: Dynamics<T, N, I, M, R>,
{
    if h.abs() <= T::of(SHORT) * T::EPSILON * (state.t.abs() + h.abs()) {
        return T::ZERO;
    }
    let [end, moving] = &trial.end;
    let values = [picked(&state.q, &S::INTEGRATED), picked(end, &S::INTEGRATED)];
    let rates = [picked(&state.qd, &S::INTEGRATED), picked(moving, &S::INTEGRATED)];
    let allowed = T::of(LOOSER * EACH) * tolerance;
    let parameter_size = |parameter: usize| mechanism.parameter_size(parameter);
    largest_error_of_derivatives((&values, &rates), &trial.errors, &lengths(mechanism), (allowed, h.abs(), speed), &parameter_size)
}

/// The error by the parameter by which it is largest.
fn largest_error_of_derivatives<T: Scalar, const I: usize>(
    (values, rates): (&[[T; I]; 2], &[[T; I]; 2]),
    errors: &[[[T; 2]; I]; 2],
    lengths: &[T; I],
    (allowed, h, speed): (T, T, T),
    parameter_size: &dyn Fn(usize) -> T,
) -> T {
    let largest_value = values.iter().fold(T::of(1.0), |most, values| most.max(largest(values, lengths).without_derivatives()));
    let mut worst = T::ZERO;
    for parameter in 0.. {
        if T::ZERO.derivative(parameter).is_none() {
            break;
        }
        let by = |number: T| number.derivative(parameter).unwrap_or(T::ZERO);
        let largest_by = |ends: &[[T; I]; 2]| ends.iter().fold(T::ZERO, |most, values| most.max(largest(&values.map(by), lengths)));
        let (of_values, of_rates) = (largest_by(values), largest_by(rates));
        let rounded = T::of(CANCELLED) * T::EPSILON / (allowed * parameter_size(parameter));
        let of_positions = of_values.max(of_rates * h).max(rounded * largest_value);
        let scales = [of_positions, of_rates.max(rounded * speed.without_derivatives())];
        let (mut first, mut second) = (T::ZERO, T::ZERO);
        for (errors, scale) in errors.iter().zip(scales).filter(|(_, scale)| *scale > T::ZERO) {
            for (errors, length) in errors.iter().zip(lengths) {
                let [one, two] = errors.map(|error| by(error) / (allowed * scale * *length));
                (first, second) = (first + one * one, second + two * two);
            }
        }
        worst = worst.max(combined::<T, I>(first, second));
    }
    worst
}

/// One error of two sums of squares where a force has a kink: either estimate may miss it, according to its place in the step.
fn whole<T: Scalar, const I: usize>(first: T, second: T) -> T {
    let count = T::of(2.0) * (0..I).fold(T::ZERO, |count, _| count + T::of(1.0));
    ((first + T::of(0.01) * second) / count).sqrt()
}

/// One error of two sums of squares, of which the second damps the first.
fn combined<T: Scalar, const I: usize>(first: T, second: T) -> T {
    if first == T::ZERO && second == T::ZERO {
        return T::ZERO;
    }
    let count = T::of(2.0) * (0..I).fold(T::ZERO, |count, _| count + T::of(1.0));
    let bound = first + T::of(0.01) * second;
    first / (bound * count).sqrt()
}
