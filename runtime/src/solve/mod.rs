//! One solution of a mechanism at one time: block by block, by warm steps or from a cold start.

mod at_once;
mod block;
mod cold;
mod commanded;
mod equations;
mod family;
mod followed;
mod once;
mod real;
mod solver;
mod stages;

pub use at_once::{at_once, refined_guess_at_once, refined_guess_by_rows};
pub(crate) use cold::{ColdReport, ColdSolver};

pub use commanded::{Commanded, later};
pub use equations::Equations;
pub use family::Family;
pub(crate) use followed::Followed;
pub(crate) use real::lengths_of;
pub use real::{ColdStart, NoColdStart, SolverReal};
pub use solver::Solver;
pub(crate) use solver::{StepReport, largest_alone};
pub use stages::{Stages, parameter_hash, parameter_hash_of};
