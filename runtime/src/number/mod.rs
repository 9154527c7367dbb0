//! Number types: those over which equations are evaluated, and those that the solver compares.

mod det_sign;
mod float;
pub(crate) mod order;
mod real;
pub(crate) mod row;
mod scalar;
mod simd;
pub(crate) mod sin_cos;
mod single;
mod table;
mod times;

pub use det_sign::DetSign;
pub use float::Float;
pub use real::Real;
pub use scalar::Scalar;
pub use simd::{Mask, SimdReal};
pub use table::{Ends, Single, Table};
pub use times::{Time, Times};
