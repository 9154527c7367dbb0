//! Time and error of one step, position, velocity and acceleration of every body, side by side with what one would write by
//! hand: `cargo run --release -p reuleaux-benches --features ezpz --bin run_time [rounds]`.
//!
//! In: `peers/results.json`. Out: the table of `README.md` beside this folder, and its picture `plot.svg`.

mod measure;
mod peers;
mod plot;
mod table;

use std::error::Error;
use std::path::Path;

use measure::measure;
use reuleaux_benches::workloads;

/// How often all contenders have their turn, if nothing is said.
const ROUNDS: usize = 60;

fn main() -> Result<(), Box<dyn Error>> {
    let rounds = std::env::args().nth(1).map_or(Ok(ROUNDS), |rounds| rounds.parse())?;
    let workloads = workloads::all();
    let mut measured: Vec<_> = workloads.iter().map(|workload| (workload.linkage.name, measure(workload, rounds))).collect();
    peers::add(&mut measured)?;
    print!("{}", table::table(&measured));
    let picture = Path::new(env!("CARGO_MANIFEST_DIR")).join("plot.svg");
    plot::plot(&picture.display().to_string(), &measured)
}
