//! Why there is no state, in the words of the declaration.

mod failure;
#[cfg(feature = "serde")]
mod serial;
pub(crate) mod verdict;

pub use failure::Failure;
