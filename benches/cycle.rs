//! Time of one cycle of a control loop: `cargo run --release -p reuleaux-benches --bin cycle`.
//!
//! In: nothing. Out: a table of ns per cycle: the median of a million cycles at 1 kHz, in which the crank of a press is read to 16 bits of a turn, and
//! the time within which 99 % of them are done. Every cycle is timed alone, less the time of reading the clock. It fails if `advance_once` does not
//! lead through all of them.

use std::hint::black_box;
use std::time::Instant;

use reuleaux::{Motion, Real, mechanism};

const CYCLES: u32 = 1_000_000;

mechanism! {
    /// A slide on a connecting rod, with an encoder on the crank.
    mechanism Press {
        input theta: Angle = 30deg;
        gravity = (0, -9.81m_s2);
        body crank { point A = (50mm, 0mm);  mass = 2kg; }
        body rod   { point B = (200mm, 0mm);  mass = 1kg;  center = (100mm, 0mm);  inertia = rod(200mm); }
        body ram   { mass = 5kg; }
        joint main = revolute(ground.position, crank.position);
        joint big_end = revolute(crank.A, rod.position);
        joint small_end = revolute(rod.B, ram.position);
        joint guide = translational((1, 0), ground.position, ram.position);
        drive motor = drive_angle(crank, theta);
        output stroke = ram.position.x;
    }
}

/// The input of a cycle: a crank that swings by 2 rad, read in steps of its encoder.
fn theta<T: Real>(cycle: u32) -> Motion<T> {
    let (sine, cosine) = (1e-2 * f64::from(cycle)).sin_cos();
    let step = core::f64::consts::TAU / 65536.0;
    let angle = (2.0 * sine / step).floor() * step;
    Motion::new(T::of(angle), T::of(20.0 * cosine), T::of(-200.0 * sine))
}

/// ns of each cycle, in order of size.
fn timed<T: Real>(mut cycle: impl FnMut(T, Motion<T>)) -> Vec<f64> {
    let reading = (0..1000).map(|_| Instant::now().elapsed().as_nanos()).min().unwrap_or(0) as f64;
    let one = |number: u32| {
        let (t, theta) = black_box((T::of(1e-3 * f64::from(number)), theta(number)));
        let start = Instant::now();
        cycle(t, theta);
        (start.elapsed().as_nanos() as f64 - reading).max(0.0)
    };
    let mut times: Vec<f64> = (1..=CYCLES).map(one).collect();
    times.sort_by(f64::total_cmp);
    times
}

fn row<T: Real>(name: &str, cycle: impl FnMut(T, Motion<T>)) {
    let times = timed(cycle);
    let at = |share: f64| times[(share * (times.len() - 1) as f64) as usize];
    println!("| {name} | {:.0} | {:.0} |", at(0.5), at(0.99));
}

macro_rules! loops {
    ($number:ident) => {
        let press = Press::<$number>::with_defaults();
        let start = || press.solve(0.0, PressInputs { theta: theta(0) }).expect("an assembly");
        let mut state = start();
        row(concat!("`advance`, `", stringify!($number), "`"), |t: $number, theta| {
            press.advance(&mut state, t, PressInputs { theta }).expect("a turn");
            black_box(press.stroke(&state));
        });
        let mut state = start();
        row(concat!("`advance_once`, `", stringify!($number), "`"), |t: $number, theta| {
            assert!(press.advance_once(&mut state, t, PressInputs { theta }), "one step leads there");
            black_box(press.stroke(&state));
        });
        let mut state = start();
        row(concat!("`advance` and all loads, `", stringify!($number), "`"), |t: $number, theta| {
            press.advance(&mut state, t, PressInputs { theta }).expect("a turn");
            black_box((press.stroke(&state), press.loads(&state)));
        });
    };
}

fn main() {
    println!("| one cycle of the press, ns | median | 99 % of cycles within |\n| --- | ---: | ---: |");
    loops!(f64);
    loops!(f32);
}
