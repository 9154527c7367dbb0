//! Motion that follows from forces: accelerations, initial states, and integration in time.
//!
//! ```text
//! M u̇ + Jᵀ λ = −f      f = M u̇ − Q at u̇ = 0
//! J u̇ = γ
//! ```
//!
//! 1. `equations`: what a mechanism provides.
//! 2. `partition`: dependent and independent speeds, chosen by the pivots of an elimination of J with complete pivoting.
//! 3. `accelerate`: accelerations, with a mass matrix of the size of the independent speeds.
//! 4. `project`: positions and speeds that fulfil the equations.
//! 5. `step`: one step of order 8 (`tableau`), followed by a projection, so that no joint drifts open; `rank`: whether the equations stay
//!    independent on the way. `stiff`: a step of order 4 by linear equations.
//! 6. `integrator`: the sizes of steps; `event`: instants within a step.
//! 7. `sweep`: states at given times, between the ends of steps by `dense`.

mod accelerate;
mod dense;
mod equations;
mod event;
mod integrator;
mod partition;
mod places;
mod project;
mod rank;
mod step;
mod stiff;
mod stopped;
mod sweep;
mod tableau;

pub use equations::{Balance, Constraints, Dynamics, Energy};
pub use integrator::Integrator;
pub use step::{Explicit, Method, Stiff};
pub use stopped::Stopped;
pub use sweep::MotionSweep;

/// What the methods of a mechanism with freedoms call.
#[doc(hidden)]
pub mod motion {
    pub use super::project::{initial_state, refresh};
    pub use super::step::fixed_step;
}
