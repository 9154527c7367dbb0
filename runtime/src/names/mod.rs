//! What a mechanism says of itself: the names of its unknowns and equations, and what may be said about them.

mod cause;
mod coordinate;
mod description;
mod plan;

pub use cause::{BranchEnd, Cause, Culprit};
pub use coordinate::{Coordinate, CoordinateKind, Row};
pub(crate) use coordinate::{coordinate, row};
pub use description::{Description, ParameterOutOfRange};
pub use plan::{Operations, Plan, PlanStage};
