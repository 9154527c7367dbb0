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
//! 5. `integrator`: steps of order 8, each followed by a projection, so that no joint drifts open.

mod accelerate;
mod equations;
mod integrator;
mod partition;
mod places;
mod project;
mod stopped;
mod tableau;

pub use equations::{Balance, Constraints, Dynamics, Energy};
pub use integrator::Integrator;
pub use stopped::Stopped;
