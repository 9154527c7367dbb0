//! Time and errors of one step of mechanisms in space, all bodies with velocities and accelerations, beside what one would write by hand:
//! `cargo run --release -p reuleaux-benches --bin space [rounds]`.
//!
//! Out: the table of `README.md` beside this folder. `… --bin space count` counts instructions of a step instead, for which it needs
//! `valgrind`. `data` and `turns` are for `peers/space_forces.py`: all mechanisms and their exact motion as JSON, and times of each
//! workload named on standard input.

mod arm;
mod chain;
mod follower;
mod measure;
mod rocker;
mod slider_crank;
mod stewart;
mod wishbone;

use std::error::Error;

use follower::Entry;
use reuleaux_benches::multibody::Model;

/// A mechanism and everything that follows it.
pub(crate) struct Workload {
    /// As data.
    pub(crate) model: Model,
    /// All contenders; ratios are to the first.
    pub(crate) contenders: fn() -> Vec<Entry>,
}

fn workloads() -> Vec<Workload> {
    let mut workloads = vec![slider_crank::workload(), rocker::workload(), stewart::workload(), arm::workload(), wishbone::workload()];
    workloads.extend(chain::workloads());
    workloads
}

/// How often all contenders have their turn, if nothing is said.
const ROUNDS: usize = 60;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => measure::print(&workloads(), ROUNDS),
        ["count"] => measure::count(&workloads())?,
        ["data"] => println!("{}", measure::data(&workloads())),
        ["turns"] => measure::serve(&workloads())?,
        ["steps", workload, contender, steps] => measure::follow(&workloads(), [workload, contender], steps.parse()?)?,
        [rounds] => measure::print(&workloads(), rounds.parse()?),
        _ => return Err("there is a number of rounds, `count`, `data` and `turns`".into()),
    }
    Ok(())
}
