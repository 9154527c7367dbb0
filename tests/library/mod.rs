//! What the constraint types of the reference leave out: the library's other kinds, cams over functions of all sorts, and every
//! function of the language.

mod cams;
mod functions;
mod relations;

pub use cams::*;
pub use functions::*;
pub use relations::*;
