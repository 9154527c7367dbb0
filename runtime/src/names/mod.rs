//! Names and descriptions: of unknowns, equations and parameters, of a mechanism's plan, and of causes of failure.

mod cause;
mod coordinate;
mod description;
mod measure;
mod plan;

pub use cause::{BranchEnd, Cause, Culprit};
pub use coordinate::{Coordinate, CoordinateEntries, CoordinateKind, Row};
pub(crate) use coordinate::{coordinate, entries, row};
pub use description::{Description, ParameterOutOfRange};
pub(crate) use measure::Measure;
pub use plan::{Operations, Plan, PlanStage};
