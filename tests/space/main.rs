//! Mechanisms in space.

mod declaration;
mod loads;
mod mechanisms;
mod objective;
mod states;
mod units;
