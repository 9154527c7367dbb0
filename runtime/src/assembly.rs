//! The first state: on the branch of the declared start, whatever the parameters.
//!
//! At the declared defaults the start is an assembled configuration. Parameters that differ are changed step by step, as time is in
//! `continuation`: a step is accepted if in every block Newton's method has a short way and the determinant keeps its sign.

use crate::careful::Care;
use crate::continuation;
use crate::stages::Stages;
use crate::verdict;
use crate::{Failure, Float, Mechanism, State};

/// The shortest step, as a share of the way from the defaults to the parameters.
const SHORTEST_STEP: f64 = 1.0 / 1024.0;

/// The state at t = 0 on the branch of the declared start.
///
/// # Errors
/// Why there is none: at these parameters, or on the way to them.
pub(crate) fn assemble<T: Float, E: Stages<T, N>, const N: usize>(equations: &E) -> Result<State<T, N>, Failure<T, N>> {
    let (zero, one) = (T::of(0.0), T::of(1.0));
    let near_start = || equations.solve_near(zero, &equations.start());
    let Some(defaults) = equations.toward(zero) else { return near_start() };
    // Defaults may be placeholders that close nowhere; then the start is only a guess.
    let Ok(origin) = defaults.solve_near(zero, &defaults.start()) else { return near_start() };
    equations.validate().or_else(|_| near_start().map(|_| ()))?;
    let (mut here, mut reached, mut step) = (origin.clone(), zero, one);
    while reached < one {
        let next = if reached + step < one { reached + step } else { one };
        let stage = if next < one { equations.toward(next) } else { None };
        let followed = match &stage {
            Some(between) => continuation::reached(between, zero, Care::follow(between, &here, zero)),
            None => continuation::reached(equations, zero, Care::follow(equations, &here, zero)),
        };
        match followed {
            // On the way redundant joints need not fit.
            Ok((_, Some(cause))) if stage.is_none() => return Err(Failure { mechanism: E::NAME, cause, time: zero, last: None }),
            Ok((state, _)) => (here, reached, step) = (state, next, step + step),
            Err(_) => step = T::of(0.5) * (next - reached),
        }
        if step < T::of(SHORTEST_STEP) {
            // No way leads there from the defaults; what is near the start may still be of the same branch.
            let found = near_start()?;
            return if found.branch == origin.branch { Ok(found) } else { Err(lost(equations, &here, &found)) };
        }
    }
    Ok(here)
}

/// The failure that only a mirrored assembly was found.
fn lost<T: Float, E: Stages<T, N>, const N: usize>(equations: &E, here: &State<T, N>, found: &State<T, N>) -> Failure<T, N> {
    let cause = verdict::jump(equations, &here.q, &found.q);
    Failure { mechanism: E::NAME, cause, time: T::of(0.0), last: Some(here.clone()) }
}
