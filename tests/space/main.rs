//! Mechanisms in space.

mod declaration;
mod mechanisms;
mod states;
mod units;
