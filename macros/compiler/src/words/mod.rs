//! Words of other programs, of other languages and of workshops, with their equivalents here, and suggestions for mistyped names.

mod elsewhere;
mod functions;
mod home;
mod suggest;

pub(crate) use elsewhere::equivalent;
pub(crate) use functions::foreign;
pub use home::Home;
pub(crate) use home::{home, is_command};
pub(crate) use suggest::{is_synonym, nearest, nearest_unit, stem, usual_dimension};
