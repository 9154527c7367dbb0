//! Symbols: build, simplify, differentiate, evaluate, print.
//!
//! What comes in: leaves (time, parameters, coordinates and their rates) and exact constants.
//! What goes out: expressions in one hash-consed [`Arena`], always in simplified form, together
//! with their partial derivatives ([`Derivatives`]) and their rates along the motion ([`Jets`]).
//!
//! Not done here: dimensions, names and spans. An expression knows its leaves by number only.
//!
//! Three things are true everywhere in this room.
//!
//! - Children have smaller indices than their parents, so that every pass is a loop over
//!   ascending ids, and a deep expression cannot overflow the stack.
//! - Constants are exact. An operation whose exact result does not fit stays an operation.
//! - A rewriting never loses accuracy: no expanding, no reassociation of sums, no cancelling
//!   of factors.

mod arena;
mod derivative;
mod eval;
mod exact;
mod jet;
mod node;
mod show;
mod simplify;
mod substitute;

pub use arena::Arena;
pub use derivative::{Derivatives, derivative};
pub(crate) use eval::magnitudes;
pub use eval::{Evaluator, Values, evaluate};
pub use exact::Exact;
pub use jet::{Jets, Rate, Seed};
pub use node::{Binary, Expr, Leaf, Node, Unary};
pub use show::show;
pub use simplify::{RULES, Rewrite, Rule};
pub use substitute::Substitution;

#[cfg(test)]
pub(crate) mod tests;
