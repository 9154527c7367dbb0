//! Mechanisms in space.

mod arms;
mod declaration;
mod limits;
mod loads;
mod mechanisms;
mod objective;
mod states;
mod units;
