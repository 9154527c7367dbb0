//! Newton's method on one square system: from a prediction, from the state before, or from a rough guess.

mod close;
mod damped;
mod iterate;
mod limits;
mod place;
mod position;
mod problem;
mod scale;
mod solved;
mod track;
mod warm;

pub(crate) use close::close;
pub(crate) use iterate::sizes;
pub(crate) use limits::{LONGEST_PREDICTION, SURE};
pub use place::Place;
pub(crate) use position::{Miss, Position};
pub use problem::Block;
pub(crate) use problem::{Evaluate, Linearized, Part, Problem};
pub(crate) use scale::{Scale, length_of};
pub use solved::{Solved, Stop};
pub(crate) use track::{Refusal, follow};
pub(crate) use warm::{Departure, Scene};
