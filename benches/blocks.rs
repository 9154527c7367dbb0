//! Time of one step by the size of the largest block: `cargo run --release -p reuleaux-benches --bin blocks`.
//!
//! 1000 steps of a turn; each mechanism block by block, and the same with all its coordinates as one dense system, in turn in each of
//! 30 rounds; medians of the rounds and of their ratios.

use reuleaux::nalgebra::SVector;
use reuleaux::{Coordinate, Coordinates, Description, Equations, Mechanism, ParameterOutOfRange, Row, Solver, Stages, StepError};
use reuleaux_tests::blocks::{DoubleTriad, FourPlates, Loop, Plate, SixPlates, TenPlates, ThreePlates, Triad, TwoPlates};
use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::Instant;

const STEPS: usize = 1000;
const ROUNDS: usize = 30;

/// A mechanism that is not taken apart: a pivoted factorisation of the whole Φ_q.
struct AtOnce<M>(M);

impl<M: Equations<f64, N, N>, const N: usize> Description<f64, N> for AtOnce<M> {
    const NAME: &'static str = M::NAME;
    const COORDINATES: &'static [Coordinate] = M::COORDINATES;
    const ROWS: &'static [Row] = M::ROWS;

    fn start(&self) -> SVector<f64, N> {
        self.0.start()
    }
    fn characteristic_length(&self) -> f64 {
        self.0.characteristic_length()
    }
    fn validate(&self) -> Result<(), ParameterOutOfRange<f64>> {
        self.0.validate()
    }
}

impl<M: Equations<f64, N, N>, const N: usize> Stages<f64, N> for AtOnce<M> {
    fn stages(&self, t: f64, pass: &mut Solver<'_, f64, N>) -> Result<Coordinates<f64, N>, StepError<f64>> {
        reuleaux::at_once(&self.0, t, pass)
    }
}

/// Nanoseconds of a step; the acceleration read at the end keeps it from being removed.
fn turn<M: Mechanism<f64, N>, const N: usize>(mechanism: &M) -> f64 {
    let mut state = mechanism.solve(0.0).expect("an assembled mechanism");
    let begin = Instant::now();
    for k in 1..STEPS {
        mechanism.advance(&mut state, black_box(TAU * k as f64 / STEPS as f64)).expect("a turn");
    }
    let time = begin.elapsed().as_secs_f64() * 1e9 / (STEPS - 1) as f64;
    black_box(state.qdd);
    time
}

fn report<M: Equations<f64, N, N> + Mechanism<f64, N> + Default, const N: usize>(name: &str, unknowns: Option<usize>) {
    let (apart, at_once) = (M::default(), AtOnce(M::default()));
    let (mut times, mut ratios) = (Vec::new(), Vec::new());
    for _ in 0..ROUNDS {
        let time = turn(&apart);
        times.push(time);
        ratios.push(turn(&at_once) / time);
    }
    println!("| {name} | {N} | {} | {:.0} | {:.1} |", unknowns.unwrap_or(0), median(times), median(ratios));
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn main() {
    println!("| mechanism | coordinates | largest block | ns per step | as one dense system, ratio |");
    println!("| --- | ---: | ---: | ---: | ---: |");
    macro_rules! report {
        ($($name:ident: $words:literal)*) => { $(report::<$name, { $name::<f64>::COORDINATES }>($words, $name::<f64>::PLAN.blocks().max());)* };
    }
    report! {
        Loop: "four-bar"
        Plate: "plate on 3 rods"
        Triad: "plate on 3 bars"
        TwoPlates: "2 plates on 4 rods"
        ThreePlates: "3 plates on 5 rods"
        DoubleTriad: "2 plates on 4 bars"
        FourPlates: "4 plates on 6 rods"
        SixPlates: "6 plates on 8 rods"
        TenPlates: "10 plates on 12 rods"
    }
}
