//! Newton's method on one square system: from a prediction, from the state before, or from a rough guess.

mod damped;
mod guess;
mod iterate;
mod limits;
mod newton_step;
mod position;
mod problem;
mod scale;
mod solved;
mod track;
mod warm;

pub(crate) use guess::{refined, solve_from_guess};
pub use iterate::Iterate;
pub(crate) use limits::{BLURRED, LONGEST_PREDICTION, ONE_CORRECTION};
pub(crate) use newton_step::sizes;
pub(crate) use position::{NewtonError, Position};
pub use problem::Block;
pub(crate) use problem::{Evaluate, Linearized, Part, Problem};
pub(crate) use scale::{Scale, length_of};
pub use solved::{Solved, SolvedInPlace, StepError};
pub(crate) use track::{TrackError, track};
pub(crate) use warm::{BlockData, Predictor};
