//! Time of one step of a scene in which one mechanism moves, beside that mechanism alone:
//! `cargo run --release -p reuleaux-benches --bin scene`.
//!
//! In: nothing. Out: a table: 1000 steps of a turn, all in turn in each of 60 rounds, medians of the rounds and of their ratios.
//! It fails if a scene of a hundred of which one is driven takes more than twice as long as one.

use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

use reuleaux::Mechanism;

const STEPS: u32 = 1000;
const ROUNDS: usize = 60;

/// The longest time that a scene may take, in times of the one that moves.
const LIMIT: f64 = 2.0;

macro_rules! four_bars {
    ($(#[$doc:meta])* $name:ident { $($items:tt)* }) => {
        reuleaux::mechanism! {
            $(#[$doc])*
            mechanism $name {
                component FourBar(O: Point, C: Point) {
                    body crank { point A = (100mm, 0mm); }
                    body coupler { point B = (350mm, 0mm); start angle = 30deg; }
                    body rocker { point B = (300mm, 0mm); start angle = 70deg; }
                    joint o = revolute(O, crank.position);
                    joint a = revolute(crank.A, coupler.position);
                    joint b = revolute(coupler.B, rocker.B);
                    joint c = revolute(rocker.position, C);
                }
                ground { for i in 0..100 { point O[i] = (i * 1m, 0m); point C[i] = (i * 1m + 400mm, 0m); } }
                $($items)*
            }
        }
    };
}
four_bars! {
    /// One that turns.
    Alone {
        part bar = FourBar(ground.O[99], ground.C[99]);
        drive input = drive_angle(bar.crank, 60rpm * t);
    }
}
four_bars! {
    /// A hundred, of which 99 are held.
    Held {
        param angle: Angle = 50deg;
        for i in 0..100 { part bar[i] = FourBar(ground.O[i], ground.C[i]); }
        for i in 0..99 { drive hold[i] = drive_angle(bar[i].crank, angle); }
        drive input = drive_angle(bar[99].crank, 60rpm * t);
    }
}
four_bars! {
    /// A hundred, of which 99 wait for a time that does not come.
    Waiting {
        for i in 0..100 { part bar[i] = FourBar(ground.O[i], ground.C[i]); }
        for i in 0..99 { drive wait[i] = drive_angle(bar[i].crank, 50deg + 20deg * polynomial_345((t - 10s) / 1s)); }
        drive input = drive_angle(bar[99].crank, 60rpm * t);
    }
}
four_bars! {
    /// A hundred that all turn.
    Turning {
        for i in 0..100 {
            part bar[i] = FourBar(ground.O[i], ground.C[i]);
            drive input[i] = drive_angle(bar[i].crank, 60rpm * t);
        }
    }
}

/// ns per step of a turn.
fn turn<M: Mechanism<f64, N>, const N: usize>(mechanism: &M) -> f64 {
    let mut state = mechanism.solve(0.0).expect("an assembled mechanism");
    let start = Instant::now();
    for step in 1..STEPS {
        mechanism.advance(&mut state, black_box(f64::from(step) / f64::from(STEPS))).expect("a turn");
    }
    let time = start.elapsed().as_secs_f64() * 1e9 / f64::from(STEPS - 1);
    black_box(&state);
    time
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn main() -> Result<(), Box<dyn Error>> {
    let (alone, held, waiting, turning) = (Alone::default(), Held::default(), Waiting::default(), Turning::default());
    let round = |_| [turn(&alone), turn(&held), turn(&waiting), turn(&turning)];
    let rounds: Vec<[f64; 4]> = (0..ROUNDS).map(round).collect();
    println!("| scene | ns per step | ratio |\n| --- | ---: | ---: |");
    let names = ["one four-bar that turns", "99 held", "99 that wait, by drives that depend on time", "all hundred turn"];
    let mut ratios = Vec::new();
    for (index, name) in names.into_iter().enumerate() {
        let (time, ratio) = (median(rounds.iter().map(|times| times[index])), median(rounds.iter().map(|times| times[index] / times[0])));
        println!("| {name} | {time:.0} | {ratio:.2} |");
        ratios.push(ratio);
    }
    if ratios[1] <= LIMIT { Ok(()) } else { Err("what is held costs time".into()) }
}
