//! Mechanisms in space.

mod declaration;
mod loads;
mod mechanisms;
mod states;
mod units;
