//! The interface of a mechanism: states, sweeps, derivatives.

mod gradient;
mod mechanism;
#[cfg(feature = "rayon")]
pub mod parallel;
mod sweep;

pub use gradient::Gradient;
pub use mechanism::Mechanism;
pub use sweep::{Sweep, sweep};
