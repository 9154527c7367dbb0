//! Mechanisms in space.

mod declaration;
mod limits;
mod loads;
mod mechanisms;
mod objective;
mod states;
mod units;
