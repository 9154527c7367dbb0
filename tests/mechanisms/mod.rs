//! The six mechanisms of `reference/mechanisms`, declared as their files describe them.

mod four_bar_crank_rocker;
mod hydraulic_loader;
mod quick_return;
mod slider_crank;
mod theo_jansen_leg;
mod two_stage_gear_train;

pub use four_bar_crank_rocker::*;
pub use hydraulic_loader::*;
pub use quick_return::*;
pub use slider_crank::*;
pub use theo_jansen_leg::*;
pub use two_stage_gear_train::*;
