//! Time and error of one step, position, velocity and acceleration of every body, side by side with what one would write by
//! hand: `cargo run --release -p reuleaux-benches --features ezpz --bin run_time [rounds]`.
//!
//! In: nothing. Out: the table of `README.md` beside this folder.

mod measure;
mod table;

use measure::measure;
use reuleaux_benches::workloads;
use std::error::Error;
use table::table;

/// How often all contenders have their turn, if nothing is said.
const ROUNDS: usize = 60;

fn main() -> Result<(), Box<dyn Error>> {
    let rounds = std::env::args().nth(1).map_or(Ok(ROUNDS), |rounds| rounds.parse())?;
    let workloads = workloads::all();
    let measured: Vec<_> = workloads.iter().map(|workload| (workload.linkage.name, measure(workload, rounds))).collect();
    print!("{}", table(&measured));
    Ok(())
}
