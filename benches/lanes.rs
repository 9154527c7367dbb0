//! Time of one step of one mechanism, alone and as one of several in the lanes of a register, in one run:
//!
//! ```sh
//! cargo run --release -p reuleaux-benches --bin lanes
//! RUSTFLAGS="-C target-cpu=x86-64-v3" cargo run --release -p reuleaux-benches --bin lanes
//! ```
//!
//! 1000 steps of a turn, each lane a quarter or an eighth of a turn ahead of the one before; both contenders in turn in each of 60
//! rounds; medians of the rounds, and of their ratios.

use reuleaux::{Family, Mechanism, Stages};
use reuleaux_benches::workloads::{Chain10, FourBar, Jansen, SliderCrank};
use reuleaux_wide::{F32x8, F64x4, Lockstep, Wide};
use std::hint::black_box;
use std::time::Instant;

const STEPS: u32 = 1000;
const ROUNDS: usize = 60;

fn main() {
    println!("| workload | lanes | ns per step alone | ns per step in a lane | ratio |");
    println!("| --- | --- | ---: | ---: | ---: |");
    compare::<_, F64x4, 4, 9>("W1 four-bar", "4 × f64", FourBar::default());
    compare::<_, F64x4, 4, 9>("W2 slider-crank", "4 × f64", SliderCrank::default());
    compare::<_, F64x4, 4, 21>("W3 Jansen's leg", "4 × f64", Jansen::default());
    compare::<_, F64x4, 4, 63>("W4 chain of 10", "4 × f64", Chain10::default());
    compare::<_, F32x8, 8, 9>("W1 four-bar", "8 × f32", FourBar::<f32>::with_defaults());
    compare::<_, F32x8, 8, 21>("W3 Jansen's leg", "8 × f32", Jansen::<f32>::with_defaults());
}

/// The time of step `step` in each lane.
fn times<W: Wide<L>, const L: usize>(step: u32) -> [W::Lane; L] {
    use reuleaux::Real;
    core::array::from_fn(|lane| W::Lane::of(f64::from(step) / f64::from(STEPS) + lane as f64 / L as f64))
}

fn compare<M, W, const L: usize, const N: usize>(workload: &str, lanes: &str, mechanism: M)
where
    M: Family<W::Lane> + Mechanism<W::Lane, N> + Copy,
    M::Over<W>: Stages<W, N> + Clone,
    W: Wide<L>,
{
    let together = Lockstep::<M, W, L, N>::new([mechanism; L], times::<W, L>(0));
    let alone = together.lane(0).expect("an assembled mechanism");
    let moments: Vec<[W::Lane; L]> = (1..STEPS).map(times::<W, L>).collect();
    let (mut scalar, mut wide, mut ratios) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..ROUNDS {
        let mut state = alone.clone();
        let start = Instant::now();
        for moment in black_box(&moments) {
            mechanism.advance(&mut state, moment[0]).expect("a turn");
        }
        scalar.push(start.elapsed().as_secs_f64());
        black_box(&state);

        let mut group = together.clone();
        let start = Instant::now();
        for moment in black_box(&moments) {
            group.advance(*moment);
        }
        wide.push(start.elapsed().as_secs_f64() / L as f64);
        assert!((0..L).all(|lane| group.lane(lane).is_ok()));
        ratios.push(scalar[scalar.len() - 1] / wide[wide.len() - 1]);
    }
    let per_step = |seconds: Vec<f64>| median(seconds) * 1e9 / f64::from(STEPS - 1);
    println!("| {workload} | {lanes} | {:.0} | {:.1} | {:.2} |", per_step(scalar), per_step(wide), median(ratios));
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
