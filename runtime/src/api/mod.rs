//! The interface of a mechanism: states, sweeps, derivatives.

#[cfg(feature = "std")]
pub mod csv;
#[cfg(feature = "picture")]
mod drawable;
mod forces;
mod generated;
mod gradient;
mod inputs;
mod loads;
mod mechanism;
mod outputs;
#[cfg(feature = "rayon")]
pub mod parallel;
mod prepared;
#[cfg(feature = "serde")]
pub mod serial;
mod slice;
mod sweep;

#[cfg(feature = "picture")]
pub use drawable::{Drawable, Sketch};
pub use forces::{PlanarForce, SpatialForce};
pub use generated::{Matrix, Named, Relation, Vector, between, finite, parameter_size, require, varied, within};
pub use gradient::{Differentiable, Gradient};
pub use inputs::{advance_once_with_inputs, advance_with_inputs, solve_with_inputs, sweep_with_inputs};
pub use loads::{DriveLoad, Loads, Opposed, PlanarLoad, SpatialLoad};
pub use mechanism::Mechanism;
pub use outputs::{Output, OutputName, OutputNames, Outputs, listed};
pub use prepared::{Prepare, Prepared};
pub use slice::{HasOutput, Slice, SliceState, Sliced};
pub use sweep::{Sweep, sweep};
