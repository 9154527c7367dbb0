//! Guesses at the intent of a declaration, from the tree alone, without resolving names.
//!
//! In: expressions and items as written. Out: whether they are meant in space, lengths that were probably not meant in metres, and forms
//! that are often written in place of others. Not done here: reporting, which `resolve` does, as it knows the meaning of names.

mod ambient;
mod forms;
mod lengths;

pub(crate) use ambient::is_meant;
pub(crate) use forms::{cross_product, is_zero, point_of, unit_in_parts};
pub(crate) use lengths::Lengths;
