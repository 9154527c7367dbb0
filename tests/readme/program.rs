//! The program of the README, as it stands there.

include!("crank_rocker.rs");
