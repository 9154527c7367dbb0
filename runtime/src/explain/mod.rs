//! Why there is no state, in the words of the declaration.

mod failure;
pub(crate) mod verdict;

pub use failure::Failure;
