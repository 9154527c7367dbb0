//! Across a change point, where two branches cross. In: states before it. Out: the state behind it on the branch that goes on smoothly.
//!
//! ```text
//! κ = c / |t× − t|              condition on either side of the crossing at t×
//! t× = t + (t − t₀) κ₀ / (κ − κ₀)
//! ```
//!
//! Where two branches only come near to each other both turn away from a fold or from a bend, and to go straight on would be a jump. So the
//! crossing is approached from both sides as closely as rounding allows, and both ways must come to the same.

use crate::careful::Care;
use crate::continuation::{is_same_branch, reached};
use crate::stages::Stages;
use crate::{Float, State};

/// The least condition next to a crossing, as a share of 1 / √ε: two branches that do not meet are told apart before.
const CLOSE: f64 = 1.0 / 256.0;

/// Steps towards the crossing, each of half of what is left.
const MOST_STEPS: usize = 64;

/// The state behind a change point, no further from it than `waypoint`, on the branch that goes on smoothly; None if there is none.
///
/// * `waypoint`: given, a state before the change point, well conditioned.
/// * `here`: given, the last state before it.
/// * `t`: given, s, where the motion is to go: behind the change point.
pub(crate) fn cross<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    waypoint: &State<T, N>,
    here: &State<T, N>,
    t: T,
) -> Option<State<T, N>> {
    let close = T::of(CLOSE) / T::ROOT_EPSILON;
    if here.condition < close || waypoint.t == here.t {
        return None;
    }
    let crossing = here.t + (here.t - waypoint.t) * waypoint.condition / (here.condition - waypoint.condition);
    if (t - crossing) * (crossing - waypoint.t) <= T::of(0.0) {
        return None;
    }
    // From ever nearer places, until it is not too far across.
    let (mut before, mut beyond) = (waypoint.clone(), None);
    for _ in 0..MOST_STEPS {
        beyond = step(equations, &before, crossing + (crossing - before.t), true);
        if beyond.is_some() || before.condition >= close {
            break;
        }
        before = step(equations, &before, T::of(0.5) * (before.t + crossing), false)?;
    }
    let beyond = beyond?;
    let near = approach(equations, &before, crossing, close)?;
    let far = approach(equations, &beyond, crossing, close)?;
    let meets = step(equations, &near, far.t, true)?;
    (meets.branch == far.branch && far.branch != here.branch).then_some(beyond)
}

/// By steps of half of what is left, so close to the crossing that the condition is `close`.
fn approach<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    from: &State<T, N>,
    crossing: T,
    close: T,
) -> Option<State<T, N>> {
    let mut near = from.clone();
    for _ in 0..MOST_STEPS {
        if near.condition >= close {
            return Some(near);
        }
        near = step(equations, &near, T::of(0.5) * (near.t + crossing), false)?;
    }
    None
}

/// One step, across the crossing or on this side of it, if it is surely on the same branch.
fn step<T: Float, E: Stages<T, N> + ?Sized, const N: usize>(
    equations: &E,
    here: &State<T, N>,
    t: T,
    is_across: bool,
) -> Option<State<T, N>> {
    let h = t - here.t;
    let care = if is_across { Care::across(equations, here, h) } else { Care::follow(equations, here, h) };
    let (there, _) = reached(equations, t, care).ok()?;
    is_same_branch(equations, here, &there).then_some(there)
}
