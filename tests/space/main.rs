//! Mechanisms in space.

mod arms;
mod couplings;
mod crosses;
mod declaration;
mod further_angles;
mod limits;
mod links;
mod loads;
mod mechanisms;
mod objective;
mod opposed;
mod orientation;
mod redundant;
mod relations;
mod starts;
mod states;
mod units;
