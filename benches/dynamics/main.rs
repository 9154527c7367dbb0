//! Accelerations and loads that follow from forces, beside what one would write by hand:
//! `cargo run --release -p reuleaux-benches --bin dynamics [rounds]`.
//!
//! Out: the table of `README.md` beside this folder. `… --bin dynamics count` counts instructions instead, for which it needs `valgrind`.
//! `data` and `turns` are for `peers/space_forces.py`: problems with their states and exact accelerations as JSON, and times of each problem
//! named on standard input.

mod arm;
mod case;
mod chain;
mod falling;
mod four_bar;
mod gears;
mod measure;
mod slider_crank;
mod spatial;

use std::error::Error;

use case::Case;

/// All problems, each prepared when it is its turn: the longest chain takes more time than all others.
fn cases() -> impl Iterator<Item = Case> {
    let prepared: [fn() -> Vec<Case>; 9] = [
        four_bar::cases,
        || vec![four_bar::turning(), slider_crank::case()],
        || arm::cases().into(),
        || vec![spatial::case()],
        || falling::cases().into(),
        || gears::cases().into(),
        || vec![chain::of_2::case()],
        || vec![chain::of_10::case()],
        || vec![chain::of_40::case()],
    ];
    prepared.into_iter().flat_map(|prepare| prepare())
}

/// How often all contenders have their turn, if nothing is said.
const ROUNDS: usize = 60;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => measure::print(cases(), ROUNDS),
        ["count"] => measure::count(cases())?,
        ["data"] => println!("{}", measure::data(cases())),
        ["turns"] => measure::serve(cases())?,
        ["steps", case, contender, count] => measure::evaluate(cases(), [case, contender], count.parse()?)?,
        [rounds] => measure::print(cases(), rounds.parse()?),
        _ => return Err("there is a number of rounds, `count`, `data` and `turns`".into()),
    }
    Ok(())
}
