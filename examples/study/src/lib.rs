//! A study of tolerances by the method of Monte Carlo: millions of linkages with lengths that vary, and the paths of their tips.
//!
//! ```text
//! numbers of sets ─set─▶ Linkage ─tally─▶ Tally ─Run::on─▶ Tally, Checkpoint ─report─▶ text
//! ```
//!
//! The result depends on the seed and on the number of sets, and on nothing else. Set n has a stream of random numbers of its own, so that
//! it can be solved again, alone. A [`Tally`] contains whole numbers only, so that its sums are the same in any order: on one thread or many,
//! in one process or in the [`Ranks`] of a cluster, in one go or continued from a [`Checkpoint`].
//!
//! [`linear`] is the analysis that handbooks recommend instead, from the derivatives by the lengths that the library generates.

mod checkpoint;
mod linear;
mod linkage;
mod report;
mod run;
mod sample;
mod tally;
#[cfg(test)]
mod tests;

pub use checkpoint::Checkpoint;
pub use linear::{Spread, linear};
pub use linkage::{Lengths, Linkage, LinkageFailure, LinkageState, POSITIONS, lengths, linkage, positions};
pub use run::{Alone, Ranks, Run};
pub use sample::Study;
pub use tally::{Moments, Tally};
