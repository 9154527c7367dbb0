//! Released mechanisms as declarations, as data, and some as hand-written equations for the same integrator.

pub mod andrews;
pub mod bricard;
pub mod chain;
pub mod four_bar;
pub mod top;

use reuleaux::{Dynamics, Integrator, State};

/// Goes to `t` (s).
///
/// # Panics
/// If the motion stops before.
pub fn follow<S, const N: usize, const I: usize, const M: usize, const R: usize>(
    mechanism: &S,
    state: &mut State<f64, N>,
    t: f64,
    integrator: &mut Integrator,
) where
    S: Dynamics<f64, N, I, M, R>,
{
    let reached = integrator.advance_while(mechanism, state, t, |_| true);
    assert!(matches!(reached, Ok(true)), "{reached:?}");
}
