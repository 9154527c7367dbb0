//! Mechanisms in space.

mod arms;
mod declaration;
mod loads;
mod mechanisms;
mod objective;
mod states;
mod units;
