//! From state to state: along the branch in time, across change points, and from the declared defaults to other parameters.

mod assembly;
mod branch;
mod cold;
mod commanded;
mod continuation;
mod crossing;
mod step;

pub(crate) use assembly::{Unassembled, assemble, assemble_near};
pub(crate) use branch::jump;
pub(crate) use cold::{cold_state, inspect};
pub(crate) use commanded::lead;
pub(crate) use continuation::{Ended, advance_by_steps};
pub(crate) use step::step;
pub use step::{step_in_part, step_lanes};
