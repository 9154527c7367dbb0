//! Comparison with reference numbers computed elsewhere, with 60 digits.

mod at_rest;
mod blocks;
mod branches;
mod choices;
mod components;
mod converged;
mod crossings;
mod files;
mod finite;
mod kites;
mod limits;
mod loads;
mod long_ways;
mod mechanisms;
mod parameters;
mod plates;
mod prepared;
mod redundant;
mod shapes;
mod stress;
mod sweeps;
mod times;
mod turns;
mod twofold;
mod unit_constraints;
