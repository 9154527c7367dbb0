//! Mechanisms that are measured or commanded: states with inputs.

mod jumps;
mod kinds;
mod motion;
