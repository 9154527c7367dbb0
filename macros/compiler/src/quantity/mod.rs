//! What numbers measure: dimensions, the units in which they are written, and the roles of coordinates.
//!
//! Nothing here knows of mechanisms.

mod dimension;
mod role;
mod unit;

pub use dimension::Dim;
pub(crate) use dimension::InferredDim;
pub use role::{Axis, Correction, Role, SpeedRole};
pub(crate) use unit::{lookup as unit, names as units};
