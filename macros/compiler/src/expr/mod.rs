//! Symbols: build, simplify, differentiate, evaluate, print.
//!
//! In: leaves (time, parameters, coordinates and their rates) and exact constants. Out: expressions in one hash-consed [`Arena`],
//! always simplified, with their partial derivatives ([`Derivatives`]) and their rates along the motion ([`Jets`]).
//!
//! Not done here: dimensions, names and spans. An expression knows its leaves by number only.
//!
//! Three invariants hold in this module.
//!
//! - Children have smaller indices than their parents, so that every pass is a loop over
//!   ascending ids, and a deep expression cannot overflow the stack.
//! - Constants are exact. An operation whose exact result does not fit stays an operation.
//! - Rules of simplification never lose accuracy: no expanding, no reassociation of sums, no cancelling of factors. Only gathering
//!   vectors of one frame, which is asked for by name, reassociates sums.

mod arena;
mod derivative;
mod eval;
mod exact;
mod frame;
mod gather;
mod jet;
mod lookup;
mod node;
mod power;
mod precise;
mod reached;
mod show;
mod simplify;
pub mod spline;
mod substitute;

pub use arena::Arena;
pub use derivative::{Derivatives, derivative};
pub(crate) use eval::magnitudes;
pub use eval::{Evaluator, Values, evaluate};
pub use exact::Exact;
pub use frame::{Frame, Spin, SpinAxes, Triple, combination, cross, dot, unit};
pub use jet::{Jets, Seed};
pub(crate) use lookup::{Lookup, Members};
pub use node::{Binary, Expr, Leaf, Mark, Node, Unary};
pub use show::show;
pub use simplify::{RULES, Rewrite, Rule};
pub use substitute::Substitution;

#[cfg(test)]
pub(crate) mod tests;
