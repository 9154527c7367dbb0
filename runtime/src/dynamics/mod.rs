//! Motion that follows from forces: accelerations, initial states, and integration in time.
//!
//! ```text
//! M u̇ + Jᵀ λ = −f      f = M u̇ − Q at u̇ = 0
//! J u̇ = γ
//! ```
//!
//! 1. `equations`: functions that a mechanism provides.
//! 2. `partition`: dependent and independent speeds, chosen by the pivots of an elimination of J with complete pivoting.
//! 3. `accelerate`: accelerations, with a mass matrix of the size of the independent speeds.
//! 4. `project`: positions and speeds that fulfil the equations; `assemble`: initial ones.
//!    `checks`: whether redundant equations hold as well.
//! 5. `method`: how a step is tried, `explicit` with order 8 (`tableau`), or `stiff` with order 4 by linear equations.
//!    `step`: its end, where a projection lets no joint drift open, and its error; `rank`: whether the equations stay independent on the way.
//! 6. `integrator`: the sizes of steps; `event`: instants within a step; `jump`: speeds that jump there; `quintic`: states in between.
//!    `switch`: how instants at which forces jump depend on parameters.
//! 7. `sweep`: states at given times, between the ends of steps by `dense`.

mod accelerate;
mod assemble;
mod changed;
mod checks;
mod dense;
mod equations;
mod event;
mod explicit;
mod integrator;
mod jump;
mod looks;
mod method;
mod partition;
mod places;
mod project;
mod quintic;
mod rank;
mod step;
mod stiff;
mod stopped;
mod sweep;
mod switch;
mod tableau;

pub use equations::{Balance, Constraints, Driven, Dynamics, Energy};
pub use explicit::Explicit;
pub use integrator::Integrator;
pub use method::Method;
pub use stiff::Stiff;
pub use stopped::Stopped;
pub use sweep::MotionSweep;

/// Functions behind the methods of a mechanism with freedoms.
#[doc(hidden)]
pub mod motion {
    pub use super::assemble::initial_state;
    pub use super::changed::{accelerate, settle};
    pub use super::checks::misfit;
    pub use super::project::enter;
    pub use super::step::fixed_step;
}
