//! The first state: on the branch of the declared start, whatever the parameters.
//!
//! At the declared defaults the start is an assembled configuration. Parameters that differ are changed step by step on the
//! straight way from the defaults, as time is in `continuation`: a step is accepted if in every block Newton's method has a short
//! way and the determinant keeps its sign. Where the branch ends on the way, at a fold, there may still be an assembly of the same
//! branch at the parameters themselves: it is taken if every determinant has the sign that it has at the defaults, and it is a
//! failure to find only another.

use nalgebra::SVector;

use crate::careful::Care;
use crate::continuation;
use crate::stages::Stages;
use crate::verdict;
use crate::{BranchEnd, Cause, Failure, Float, Mechanism, State};

/// Steps from the defaults to the parameters, accepted or not.
const MOST_STEPS: usize = 2000;

/// The state at t = 0 on the branch of the declared start.
///
/// # Errors
/// Why there is none: at these parameters, or on the way to them.
pub(crate) fn assemble<T: Float, E: Stages<T, N>, const N: usize>(equations: &E) -> Result<State<T, N>, Failure<T, N>> {
    let zero = T::of(0.0);
    let near = |guess: &SVector<T, N>| equations.solve_near(zero, guess);
    let start = equations.start();
    let Some(defaults) = equations.toward(zero) else { return near(&start) };
    // Defaults may be placeholders that close nowhere; then the start is only a guess.
    let Ok(origin) = defaults.solve_near(zero, &defaults.start()) else { return near(&start) };
    if equations.validate().is_err() {
        return near(&start);
    }
    let (share, here) = match follow(equations, &origin) {
        Ok((state, None)) => return Ok(state),
        Ok((_, Some(cause))) => return Err(Failure { mechanism: E::NAME, cause, time: zero, end: None, last: None }),
        Err(end) => end,
    };
    let mut cause = None;
    for found in [near(&here.q), near(&start)] {
        cause = Some(match found {
            Ok(state) if state.branch == origin.branch => return Ok(state),
            Ok(mirrored) => verdict::jump(equations, &here.q, &mirrored.q),
            Err(failure) => less_open(cause, failure.cause),
        });
    }
    let Some(cause) = cause else { return near(&start) };
    let end = end(equations, share, &here);
    Err(Failure { mechanism: E::NAME, cause, time: zero, end, last: Some(here) })
}

/// Of two loops that stay open the one that is nearer to closing; else the cause that was found before.
fn less_open<T: Float>(before: Option<Cause<T>>, now: Cause<T>) -> Cause<T> {
    match (before, now) {
        (Some(Cause::DoesNotClose { gap: one, .. }), Cause::DoesNotClose { gap: two, .. }) if two < one => now,
        (Some(before), _) => before,
        (None, now) => now,
    }
}

/// From the assembly at the defaults to that at the parameters, with the redundant joint that does not fit there, or to where the
/// branch ends: the share of the way, and the last state.
#[allow(clippy::type_complexity)]
fn follow<T: Float, E: Stages<T, N>, const N: usize>(
    equations: &E,
    origin: &State<T, N>,
) -> Result<(State<T, N>, Option<Cause<T>>), (T, State<T, N>)> {
    let (zero, one) = (T::of(0.0), T::of(1.0));
    let (mut here, mut reached, mut step) = (origin.clone(), zero, one);
    for _ in 0..MOST_STEPS {
        let next = if reached + step < one { reached + step } else { one };
        let stage = if next < one { equations.toward(next) } else { None };
        let followed = match &stage {
            Some(between) => continuation::reached(between, zero, Care::follow(between, &here, zero)),
            None => continuation::reached(equations, zero, Care::follow(equations, &here, zero)),
        };
        match followed {
            // On the way redundant joints need not fit.
            Ok((state, _)) if next < one => (here, reached, step) = (state, next, step + step),
            Ok(found) => return Ok(found),
            Err(_) => step = T::of(0.5) * (next - reached),
        }
        // Rounding errors of the parameters move a fold by about as much.
        if step < T::ROOT_EPSILON {
            break;
        }
    }
    Err((reached, here))
}

/// The block that is nearest to singular where a branch ends.
fn end<T: Float, E: Stages<T, N>, const N: usize>(equations: &E, share: T, here: &State<T, N>) -> Option<BranchEnd<T>> {
    let there = equations.toward(share)?;
    let care = Care::inspect(&there, &here.q);
    // Only what the pass saw is wanted, not the rates it ends with.
    let _ = continuation::pass(&there, here.t, &care);
    match care.found().worst? {
        Cause::Singular { row, coordinate, .. } => Some(BranchEnd { share, row, coordinate }),
        _ => None,
    }
}
