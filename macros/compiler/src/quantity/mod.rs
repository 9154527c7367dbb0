//! Dimensions of numbers, and the units in which they are written.
//!
//! Nothing here knows of mechanisms.

mod dimension;
mod unit;

pub use dimension::Dim;
pub(crate) use dimension::InferredDim;
pub(crate) use unit::{lookup as unit, names as units};
