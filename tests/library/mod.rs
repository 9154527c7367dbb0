//! Constraints that the reference lacks: the library's other kinds, cams over functions of all sorts, and every function of the language.

mod cams;
mod functions;
mod relations;

pub use cams::*;
pub use functions::*;
pub use relations::*;
