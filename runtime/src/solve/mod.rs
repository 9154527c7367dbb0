//! One solution of a mechanism at one time: block by block, by warm steps or from a cold start.

mod at_once;
mod cold;
mod equations;
mod family;
mod real;
mod solver;
mod stages;

pub use at_once::{at_once, improved_at_once, improved_by};
pub(crate) use cold::{ColdReport, ColdSolver};

pub use equations::Equations;
pub use family::Family;
pub(crate) use real::lengths_of;
pub use real::{ColdStart, NoColdStart, SolverReal};
pub use solver::Pass;
pub(crate) use solver::Walk;
pub use stages::{Stages, mark_of};
