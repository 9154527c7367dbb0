//! Passing a change point, where two branches cross. In: states before it. Out: the state behind it, or at it, on the smooth
//! continuation of the branch.
//!
//! ```text
//! κ = c / |t× − t|              condition on either side of the crossing at t×
//! t× = t + (t − t₀) κ₀ / (κ − κ₀)
//! ```
//!
//! Where two branches only come close to each other, both turn away, and passing straight on would be a jump from one to the other.
//! So the crossing is approached from both sides as closely as rounding allows, both approaches must meet, and no gap may remain at
//! the crossing itself: the equations must hold there to a few roundings of their terms, after correction in every direction that
//! they determine.

use super::branch::is_same_branch;
use super::cold::cold_state;
use crate::linear::difference;
use crate::names::{self, Coordinate, CoordinateEntries};
use crate::number::Float;
use crate::number::order::{greater, smaller};
use crate::solve::{ColdSolver, Followed};
use crate::state::{State, Values};

/// The least condition next to a crossing, as a fraction of 1 / √ε; two branches that do not meet are distinguished at a smaller
/// one.
const CLOSE: f64 = 1.0 / 256.0;

/// The least such limit, for single precision.
const LEAST_CLOSE: f64 = 64.0;

/// Largest number of steps towards the crossing, each half of the remaining time.
const MOST_STEPS: usize = 64;

/// Up to this condition, as a fraction of ε^(−1/4), a state is far enough from a change point to estimate where that is.
const CLEAR: f64 = 0.0625;

/// The least such limit, for single precision.
const LEAST_CLEAR: f64 = 16.0;

/// Between two states of this condition (a fraction of ε^(−1/4)), one on either side, a polynomial of fifth degree is as accurate
/// as the states.
const STRAIGHT: f64 = 1.0 / 32.0;

/// The least such limit, for single precision.
const LEAST_STRAIGHT: f64 = 16.0;

/// Where the extrapolation from states of one condition fails, the next one is from states whose condition is larger by this factor.
const CLOSER: f64 = 8.0;

/// Most trials of a step towards the crossing, each half as long as the one before.
const MOST_TRIALS: usize = 8;

/// States beside a change point: the first step, to see on which side the change point is, as a fraction of 1 / condition.
const BRIEF: f64 = 0.25;

/// The condition decreases to this fraction at least when its distance from a change point is doubled.
const LEAST_DECREASE: f64 = 0.75;

/// States found from both sides may differ by this multiple of the rounding errors of a state.
const LOST: f64 = 64.0;

/// Times within this multiple of the last state's distance from the crossing count as the crossing itself.
const REACH: f64 = 4.0;

/// The state behind a change point, no further from it than `waypoint`, on the smooth continuation of the branch; if `t` is the
/// change point itself, the state there. None if the branch has no smooth continuation.
///
/// * `waypoint`: given, a state before the change point, well conditioned unless the motion began next to it.
/// * `here`: given, the last state before it.
/// * `t`: given, s, the time to be reached: at the change point, or behind it.
pub(crate) fn cross<T: Float, const N: usize>(
    mechanism: &Followed<'_, T, N>,
    waypoint: &State<T, N>,
    here: &State<T, N>,
    t: T,
) -> Option<State<T, N>> {
    if !is_close(here) {
        return None;
    }
    let beyond = if is_clear(waypoint) { None } else { from_beside(mechanism, waypoint, t) };
    if beyond.is_some() {
        return beyond;
    }
    if waypoint.t == here.t { None } else { towards(mechanism, waypoint, here, crossing(waypoint, here), t) }
}

/// Whether a state is so near to a crossing that it may have been extrapolated.
pub(super) fn is_close<T: Float, const N: usize>(state: &State<T, N>) -> bool {
    state.condition >= close()
}

/// As [`cross`], for a motion that began next to the change point, at `first`: from a state farther away.
fn from_beside<T: Float, const N: usize>(mechanism: &Followed<'_, T, N>, first: &State<T, N>, t: T) -> Option<State<T, N>> {
    // The condition of a state that was extrapolated differs from that at its place.
    let other = neighbour(mechanism, first)?;
    let next = step(mechanism, &other, other.t + (other.t - first.t), false)?;
    let waypoint = away(mechanism, next, &other)?;
    let [last, closest] = approached(mechanism, &waypoint, &other)?;
    towards(mechanism, &waypoint, &closest, crossing(&last, &closest), t)
}

/// Whether a state is far enough from a crossing to estimate where that is.
pub(super) fn is_clear<T: Float, const N: usize>(state: &State<T, N>) -> bool {
    state.condition <= greater(T::of(CLEAR) / T::ROOT_EPSILON.sqrt(), T::of(LEAST_CLEAR))
}

/// As [`cross`], once it is known where the change point is.
fn towards<T: Float, const N: usize>(
    mechanism: &Followed<'_, T, N>,
    waypoint: &State<T, N>,
    here: &State<T, N>,
    crossing: T,
    t: T,
) -> Option<State<T, N>> {
    let is_there = (t - crossing).abs() <= T::of(REACH) * (crossing - here.t).abs();
    if !is_there && (t - crossing) * (crossing - waypoint.t) <= T::of(0.0) {
        return None;
    }
    through(mechanism, waypoint, here, (crossing, is_there), t)
}

/// The state behind a change point at `crossing`, no further from it than `waypoint`; if `is_there`, the state at `t`, next to it.
fn through<T: Float, const N: usize>(
    mechanism: &Followed<'_, T, N>,
    waypoint: &State<T, N>,
    here: &State<T, N>,
    (crossing, is_there): (T, bool),
    t: T,
) -> Option<State<T, N>> {
    let close = close();
    // From closer and closer to the crossing, until a step across it succeeds.
    let (mut before, mut beyond) = (waypoint.clone(), None);
    for _ in 0..MOST_STEPS {
        beyond = step(mechanism, &before, crossing + (crossing - before.t), true);
        if beyond.is_some() || before.condition >= close {
            break;
        }
        before = nearer(mechanism, &before, crossing)?;
    }
    let beyond = beyond?;
    let near = approach(mechanism, &before, crossing, close)?;
    let far = approach(mechanism, &beyond, crossing, close)?;
    let meets = step(mechanism, &near, far.t, true)?;
    // Two simultaneous crossings leave all signs unchanged; ordinary steps then reach states behind them.
    if meets.branch != far.branch || (far.branch == here.branch && !is_there) {
        return None;
    }
    let (mut between, place) = (between(), if is_there { t } else { crossing });
    // Where the mechanism turns fast, polynomials are accurate only next to the crossing.
    loop {
        if let Some(mut there) = at(mechanism, [&before, &beyond], crossing, place, between) {
            // What follows is told that a crossing is near.
            there.values.condition = greater(there.condition, close);
            return Some(if is_there { State { parameter_hash: mechanism.parameter_hash, ..there } } else { beyond });
        }
        if between >= close {
            return None;
        }
        between = smaller(between * T::of(CLOSER), close);
    }
}

/// The state at `t`, next to the crossing, from states on both sides whose condition is about `between`. None where the equations do not hold
/// there: between branches that only come close there is no solution.
fn at<T: Float, const N: usize>(
    mechanism: &Followed<'_, T, N>,
    [before, beyond]: [&State<T, N>; 2],
    crossing: T,
    t: T,
    between: T,
) -> Option<State<T, N>> {
    let [near, far] = [approach(mechanism, before, crossing, between)?, approach(mechanism, beyond, crossing, between)?];
    let mut there = extrapolated(mechanism, near, far, crossing, t)?;
    there.values.q = mechanism.solve(there.values.t, &ColdSolver::at_crossing(mechanism, &there.values.q)).ok()?.q;
    Some(there)
}

/// Improves a state that is next to a change point of the solved equations, where accelerations are lost first; all equations together, if some
/// are redundant, determine the motion there. If there is no change point, the state is unchanged.
///
/// ```text
/// errors of q, q̇, q̈ from the solved equations:  κ ε, κ² ε, κ³ ε          κ the condition
/// ```
///
/// The refined state may differ from the given one by no more than these.
#[cold]
#[inline(never)]
pub(crate) fn refine_beside<T: Float, const N: usize>(mechanism: &Followed<'_, T, N>, state: &mut State<T, N>) {
    if let Some(refined) = beside(mechanism, state) {
        *state = refined;
    }
}

/// The state next to a change point from states on both sides; None if there is none.
fn beside<T: Float, const N: usize>(mechanism: &Followed<'_, T, N>, here: &State<T, N>) -> Option<State<T, N>> {
    let scale = mechanism.scale();
    let speed = scale.norm(&here.qd);
    let other = neighbour(mechanism, here)?;
    let (waypoint, mut closest) = (away(mechanism, other, here)?, here.clone());
    let mut last = waypoint.clone();
    for _ in 0..MOST_STEPS {
        if closest.condition >= close() {
            break;
        }
        let crossing = crossing(&last, &closest);
        let next = nearer(mechanism, &closest, crossing)?;
        (last, closest) = (closest, next);
    }
    let mut there = through(mechanism, &waypoint, &closest, (crossing(&last, &closest), true), here.t)?;
    let lost = T::of(LOST) * T::EPSILON * here.condition;
    let rounded = [lost, lost * here.condition * speed, lost * here.condition * here.condition * speed * speed];
    let apart = [(&there.q, &here.q), (&there.qd, &here.qd), (&there.qdd, &here.qdd)];
    let apart = apart.map(|(there, here)| scale.norm(&difference(there, here)));
    let is_same = apart.iter().zip(&rounded).all(|(apart, rounded)| apart <= rounded);
    (there.values.branch, there.values.condition) = (here.branch, here.condition);
    is_same.then_some(there)
}

/// A state on either side of one next to a crossing, which is about 1 / condition away.
fn neighbour<T: Float, const N: usize>(mechanism: &Followed<'_, T, N>, here: &State<T, N>) -> Option<State<T, N>> {
    let speed = mechanism.scale().norm(&here.qd);
    let mut brief = T::of(BRIEF) / (here.condition * speed);
    for _ in 0..MOST_TRIALS {
        let at = |t: T| if t == here.t { None } else { step(mechanism, here, t, false) };
        let found = at(here.t - brief).or_else(|| at(here.t + brief));
        if found.is_some() || brief * speed >= T::of(BRIEF) / between() {
            return found;
        }
        brief = brief * T::of(CLOSER);
    }
    None
}

/// The last two of the states from `waypoint` towards the crossing next to `here`, until the condition is large.
fn approached<T: Float, const N: usize>(
    mechanism: &Followed<'_, T, N>,
    waypoint: &State<T, N>,
    here: &State<T, N>,
) -> Option<[State<T, N>; 2]> {
    let (mut last, mut closest) = (waypoint.clone(), nearer(mechanism, waypoint, crossing(waypoint, here))?);
    for _ in 0..MOST_STEPS {
        if closest.condition >= close() {
            break;
        }
        let next = nearer(mechanism, &closest, crossing(&last, &closest))?;
        (last, closest) = (closest, next);
    }
    Some([last, closest])
}

/// A well conditioned state on the line from `here`, which is next to a crossing, through `waypoint`; None if the condition does not decrease along it.
fn away<T: Float, const N: usize>(mechanism: &Followed<'_, T, N>, mut waypoint: State<T, N>, here: &State<T, N>) -> Option<State<T, N>> {
    for _ in 0..MOST_STEPS {
        if waypoint.condition <= between() {
            break;
        }
        let crossing = crossing(&waypoint, here);
        // Away from it the condition decreases as the distance grows.
        let next = step(mechanism, &waypoint, crossing + T::of(2.0) * (waypoint.t - crossing), false)?;
        if next.condition > T::of(LEAST_DECREASE) * waypoint.condition {
            return None;
        }
        waypoint = next;
    }
    Some(waypoint)
}

/// Where the condition would be infinite, from two states on one side.
fn crossing<T: Float, const N: usize>(waypoint: &State<T, N>, here: &State<T, N>) -> T {
    here.t + (here.t - waypoint.t) * waypoint.condition / (here.condition - waypoint.condition)
}

/// The least condition next to a crossing.
fn close<T: Float>() -> T {
    greater(T::of(CLOSE) / T::ROOT_EPSILON, T::of(LEAST_CLOSE))
}

/// The condition of the states between which a polynomial is accurate.
fn between<T: Float>() -> T {
    greater(T::of(STRAIGHT) / T::ROOT_EPSILON.sqrt(), T::of(LEAST_STRAIGHT))
}

/// The state at `t`, next to the crossing, by extrapolation of polynomials through states at ±h, ±2h and ±4h from it, as far as
/// these states exist.
///
/// ```text
/// error of q and q̇:                 a h⁶ + b h⁸ + …        (64 x_h − x_2h) / 63,    then (256 x_h − x_2h) / 255
/// error of q̈:                       a h⁴ + b h⁶ + …        (16 x_h − x_2h) / 15,    then (64 x_h − x_2h) / 63
/// error of ω and ω̇:                 the same
/// error of accelerations by themselves:  a h² + b h⁴ + …    (4 x_h − x_2h) / 3,      then (16 x_h − x_2h) / 15
/// ```
///
/// Stoer, Bulirsch: Introduction to Numerical Analysis, 3.4.
fn extrapolated<T: Float, const N: usize>(
    mechanism: &Followed<'_, T, N>,
    near: State<T, N>,
    far: State<T, N>,
    crossing: T,
    t: T,
) -> Option<State<T, N>> {
    let h = greater((crossing - near.t).abs(), (far.t - crossing).abs());
    let h = if far.t > near.t { h } else { -h };
    let between = |near: &State<T, N>, far: &State<T, N>, h: T| {
        let near = step(mechanism, near, crossing - h, false)?;
        let far = step(mechanism, far, crossing + h, false)?;
        let there = interpolated(&near, &far, t, mechanism.coordinates);
        Some((near, far, there))
    };
    let (near, far, mut there) = between(&near, &far, h)?;
    let Some((near, far, second)) = between(&near, &far, T::of(2.0) * h) else { return Some(there) };
    let shares = [T::of(1.0 / 63.0), T::of(1.0 / 15.0), T::of(1.0 / 3.0)];
    there = combined(there, &second, mechanism.coordinates, shares);
    if let Some((_, _, third)) = between(&near, &far, T::of(4.0) * h) {
        let coarse = combined(second, &third, mechanism.coordinates, shares);
        there = combined(there, &coarse, mechanism.coordinates, [T::of(1.0 / 255.0), T::of(1.0 / 63.0), T::of(1.0 / 15.0)]);
    }
    Some(there)
}

/// x_h + s (x_h − x_2h), with one weight s for q and q̇, one for q̈ and ω, and one for accelerations by themselves.
fn combined<T: Float, const N: usize>(
    mut fine: State<T, N>,
    coarse: &State<T, N>,
    coordinates: &[Coordinate],
    [share, of_accelerations, of_lone]: [T; 3],
) -> State<T, N> {
    let Values { q, qd, qdd, .. } = &mut fine.values;
    let add = |entry: &mut T, other: T, share: T| *entry = *entry + share * (*entry - other);
    for i in 0..N {
        let [of_rate, of_acceleration] = match names::entries(coordinates, i) {
            CoordinateEntries::Motion => [share, of_accelerations],
            CoordinateEntries::Velocity => [of_accelerations; 2],
            CoordinateEntries::Jerk => [share, of_lone],
        };
        add(&mut q[i], coarse.q[i], share);
        add(&mut qd[i], coarse.qd[i], of_rate);
        add(&mut qdd[i], coarse.qdd[i], of_acceleration);
    }
    fine
}

/// The state at `t` of the polynomial of fifth degree through two states, their rates and their accelerations, on the branch of the second;
/// ω and other velocities follow a polynomial of third degree through them and their rates, third derivatives of outputs a straight line.
///
/// Its accelerations have lost twice as many digits as those of the states.
fn interpolated<T: Float, const N: usize>(near: &State<T, N>, far: &State<T, N>, t: T, coordinates: &[Coordinate]) -> State<T, N> {
    let h = far.t - near.t;
    let s = (t - near.t) / h;
    let of = T::of;
    let [mut q, mut qd, mut qdd] = [near.q, near.qd, near.qdd];
    // q = q₀ + h q̇₀ s + h² q̈₀ s² / 2 + s³ (c₃ + s (c₄ + s c₅)), with the c from the remainders of q, q̇ and q̈ at s = 1.
    for i in 0..N {
        let (first, second) = (h * near.qd[i], h * h * near.qdd[i]);
        let value = ((far.q[i] - near.q[i]) - first) - of(0.5) * second;
        let rate = h * (far.qd[i] - near.qd[i]) - second;
        let acceleration = h * h * (far.qdd[i] - near.qdd[i]);
        let [c3, c4, c5] = match names::entries(coordinates, i) {
            CoordinateEntries::Motion => {
                let c3 = of(10.0) * value - of(4.0) * rate + of(0.5) * acceleration;
                let c4 = of(7.0) * rate - of(15.0) * value - acceleration;
                [c3, c4, of(6.0) * value - of(3.0) * rate + of(0.5) * acceleration]
            }
            // The integral of ω, without its value.
            CoordinateEntries::Velocity => [rate - acceleration / of(3.0), of(0.25) * acceleration - of(0.5) * rate, of(0.0)],
            CoordinateEntries::Jerk => {
                qdd[i] = near.qdd[i] + s * (far.qdd[i] - near.qdd[i]);
                continue;
            }
        };
        q[i] = near.q[i] + s * (first + s * (of(0.5) * second + s * (c3 + s * (c4 + s * c5))));
        qd[i] = (first + s * (second + s * (of(3.0) * c3 + s * (of(4.0) * c4 + s * of(5.0) * c5)))) / h;
        qdd[i] = (second + s * (of(6.0) * c3 + s * (of(12.0) * c4 + s * of(20.0) * c5))) / (h * h);
    }
    let condition = greater(near.condition * near.condition, far.condition * far.condition);
    State::solved(Values { t, q, qd, qdd, branch: far.branch, condition, iterations: far.iterations }, 0)
}

/// Approaches the crossing by steps of half of the remaining time, until the condition is `close`.
fn approach<T: Float, const N: usize>(mechanism: &Followed<'_, T, N>, from: &State<T, N>, crossing: T, close: T) -> Option<State<T, N>> {
    let mut near = from.clone();
    for _ in 0..MOST_STEPS {
        if near.condition >= close {
            return Some(near);
        }
        near = nearer(mechanism, &near, crossing)?;
    }
    None
}

/// The state halfway to the crossing, or less far where the mechanism turns so fast that no step leads there.
fn nearer<T: Float, const N: usize>(mechanism: &Followed<'_, T, N>, from: &State<T, N>, crossing: T) -> Option<State<T, N>> {
    let mut way = T::of(0.5) * (crossing - from.t);
    for _ in 0..MOST_TRIALS {
        let found = step(mechanism, from, from.t + way, false);
        if found.is_some() {
            return found;
        }
        way = T::of(0.5) * way;
    }
    None
}

/// One step, across the crossing or on this side of it, if it certainly stays on the branch.
#[inline(never)]
fn step<T: Float, const N: usize>(mechanism: &Followed<'_, T, N>, here: &State<T, N>, t: T, is_across: bool) -> Option<State<T, N>> {
    let h = t - here.t;
    let solver = if is_across { ColdSolver::across(mechanism, here, h) } else { ColdSolver::from_prediction(mechanism, here, h) };
    // Where a redundant equation does not hold, another branch was taken.
    let (there, _) = cold_state(mechanism, t, solver).ok().filter(|(_, off)| off.is_none())?;
    is_same_branch(mechanism, here, &there).then_some(there)
}
