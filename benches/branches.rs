//! Random steps of random sizes on loops with many assemblies, each judged by continuation with proof.
//!
//! ```sh
//! cargo run --release -p reuleaux-benches --bin branches                 # 100,000 steps
//! cargo run --release -p reuleaux-benches --bin branches -- 4000 7       # so many, of another seed
//! ```

use std::process::ExitCode;
use std::time::Instant;

use fastrand::Rng;
use reuleaux_tests::branches::families::{Cylinders, Family, Fourth, Platform, Stephenson};
use reuleaux_tests::branches::{Tally, try_steps};

/// One in so many steps may be refused though there is a way.
const REFUSED: usize = 1000;

/// So many of a kind are printed.
const SHOWN: usize = 10;

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1).map(|argument| argument.parse::<u64>().expect("a whole number"));
    let steps = arguments.next().unwrap_or(100_000);
    let seed = arguments.next().unwrap_or(0);
    let steps = usize::try_from(steps / 4).expect("a number of steps");
    println!("| mechanisms | steps | right | no way | unclear | jumps | wrong digits | refused, though there is a way | µs a step |");
    println!("| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |");
    let tallies = [
        of::<Cylinders, 3>(steps, seed),
        of::<Platform, 21>(steps, seed),
        of::<Stephenson, 15>(steps, seed),
        of::<Fourth, 18>(steps, seed),
    ];
    let mut is_good = true;
    for tally in tallies {
        for (kind, cases) in [("jump", &tally.jumps), ("wrong digits", &tally.off), ("refused", &tally.refused)] {
            cases.iter().take(SHOWN).for_each(|case| println!("{kind}: {case}"));
        }
        is_good &= tally.is_good(REFUSED);
    }
    if is_good { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn of<M: Family<N>, const N: usize>(steps: usize, seed: u64) -> Tally {
    let begun = Instant::now();
    let mut tally = Tally::default();
    try_steps::<M, N>(&mut Rng::with_seed(seed), steps, &mut tally);
    let time = begun.elapsed().as_secs_f64() / tally.steps as f64 * 1e6;
    let Tally { mechanisms, steps, right, ended, unclear, jumps, off, refused, .. } = &tally;
    println!(
        "| {mechanisms} × {} | {steps} | {right} | {ended} | {unclear} | {} | {} | {} | {time:.0} |",
        M::TITLE,
        jumps.len(),
        off.len(),
        refused.len()
    );
    tally
}
