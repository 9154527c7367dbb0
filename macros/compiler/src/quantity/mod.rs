//! Quantities: dimensions, units, moments of inertia, and the roles of coordinates.
//!
//! Nothing here depends on mechanisms.

mod dimension;
mod inertia;
mod role;
mod unit;

pub use dimension::Dim;
pub(crate) use dimension::InferredDim;
pub(crate) use inertia::is_inertia;
pub use role::{Ambient, Axis, Correction, Role, SpeedRole};
pub(crate) use unit::{lookup as unit, names as units};
