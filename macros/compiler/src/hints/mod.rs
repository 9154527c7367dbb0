//! What a declaration probably means, read from the tree without resolving a name.
//!
//! In: expressions and items as written. Out: whether they mean space, lengths that were hardly meant in metres, and forms that are often
//! written for others. Not done here: saying so, which is up to `resolve`, that knows what names stand for.

mod ambient;
mod forms;
mod lengths;

pub(crate) use ambient::is_meant;
pub(crate) use forms::{cross_product, is_zero, point_of, unit_in_parts};
pub(crate) use lengths::Lengths;
