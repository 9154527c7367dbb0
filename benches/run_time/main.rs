//! Time and error of one step, position, velocity and acceleration of every body, side by side with what one would write by
//! hand: `cargo run --release -p reuleaux-benches --bin run_time`.
//!
//! 1000 steps of a turn; all contenders in turn in each of 60 rounds; medians of the rounds and of their ratios.

mod hand;
mod mechanisms;

use hand::{Angles, Point, absolute_9, absolute_21, crank, dyad, fixed};
use mechanisms::{Chain, FourBar, Jansen, SliderCrank};
use reuleaux::nalgebra::Vector2;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::hint::black_box;
use std::time::Instant;

const STEPS: usize = 1000;
const ROUNDS: usize = 60;

type Run<'a> = Box<dyn FnMut() -> f64 + 'a>;

fn main() {
    println!("| workload | contender | ns per step | ratio to closed form | largest position error |");
    println!("| --- | --- | ---: | ---: | ---: |");
    four_bar();
    slider_crank();
    jansen();
    chain();
}

fn times() -> impl Iterator<Item = f64> {
    (1..STEPS).map(|k| k as f64 / STEPS as f64)
}

/// A turn of a crank: angle, rate, acceleration.
fn turning(t: f64) -> [f64; 3] {
    [TAU * t, TAU, 0.0]
}

/// Runs a closed form over a turn; the sum keeps it from being removed.
fn closed(point: impl Fn(f64) -> Point) -> f64 {
    times().map(|t| point(black_box(t)).a.x).sum()
}

macro_rules! follow {
    ($mechanism:ident, $output:ident, $exact:expr) => {{
        let origin = $mechanism.solve(0.0).expect("an assembled mechanism");
        let mut state = origin.clone();
        let mut error: f64 = 0.0;
        for t in times() {
            $mechanism.advance(&mut state, t).expect("a turn");
            error = error.max(($mechanism.$output(&state).value - $exact(t).p).amax());
        }
        (origin, error)
    }};
}

/// Our contender: a state is taken along; the acceleration read at the end keeps it from being removed.
macro_rules! ours {
    ($mechanism:ident, $origin:ident, $coordinate:literal) => {
        (
            "reuleaux",
            Box::new(|| {
                let mut state = $origin.clone();
                times().for_each(|t| $mechanism.advance(&mut state, black_box(t)).expect("a turn"));
                state.qdd[$coordinate]
            }),
        )
    };
}

/// Newton's method on all coordinates, with or without a predictor.
macro_rules! absolute {
    ($name:literal, $solve:ident, $mechanism:ident, $origin:ident, $has_predictor:literal, $coordinate:literal) => {
        (
            $name,
            Box::new(|| {
                let mut state = $origin.0.clone();
                times().for_each(|t| $solve(&$mechanism, &mut state, black_box(t), $has_predictor));
                state.qdd[$coordinate]
            }),
        )
    };
}

fn four_bar() {
    let mechanism = FourBar::default();
    let exact = |t: f64| dyad(&crank(1.0, turning(t)), 3.5, &fixed(4.0, 0.0), 3.0, 1.0);
    let (origin, error) = follow!(mechanism, pin, exact);
    let angles = Angles { q: [origin.coupler().angle, origin.rocker().angle], ..Angles::default() };
    let mut warm = angles;
    warm.step(0.0, 0.0);
    let runs: Vec<(&str, Run)> = vec![
        ("closed form of the tracked point", Box::new(|| closed(exact))),
        (
            "Newton on the two angles",
            Box::new(|| {
                let mut at = warm;
                times().for_each(|t| at.step(black_box(t), 1.0 / STEPS as f64));
                at.q[1]
            }),
        ),
        ours!(mechanism, origin, 8),
        absolute!("absolute coordinates, LU, predictor", absolute_9, mechanism, origin, true, 8),
        absolute!("absolute coordinates, LU", absolute_9, mechanism, origin, false, 8),
    ];
    report("W1 four-bar", runs, error);
}

fn slider_crank() {
    let mechanism = SliderCrank::default();
    let exact = |t: f64| {
        let a = crank(1.0, turning(t));
        let root = (9.0 - a.p.y * a.p.y).sqrt();
        let rate = -a.p.y * a.v.y / root;
        let second = -(a.v.y * a.v.y + a.p.y * a.a.y + rate * rate) / root;
        Point { p: Vector2::new(a.p.x + root, 0.0), v: Vector2::new(a.v.x + rate, 0.0), a: Vector2::new(a.a.x + second, 0.0) }
    };
    let (origin, error) = follow!(mechanism, pin, exact);
    let runs: Vec<(&str, Run)> = vec![
        ("closed form of the tracked point", Box::new(|| closed(exact))),
        ours!(mechanism, origin, 6),
        absolute!("absolute coordinates, LU, predictor", absolute_9, mechanism, origin, true, 6),
    ];
    report("W2 slider-crank", runs, error);
}

fn jansen() {
    let mechanism = Jansen::default();
    let exact = |t: f64| {
        let (x, v) = (crank(1.5, turning(t)), fixed(-3.8, -0.78));
        let u = dyad(&x, 5.0, &v, 4.15, -1.0);
        let w = dyad(&v, 4.01, &u, 5.58, 1.0);
        let c = dyad(&x, 6.19, &v, 3.93, 1.0);
        let f = dyad(&w, 3.94, &c, 3.67, -1.0);
        dyad(&f, 6.57, &c, 4.90, -1.0)
    };
    let (origin, error) = follow!(mechanism, toe, exact);
    let runs: Vec<(&str, Run)> = vec![
        ("closed form of the tracked point", Box::new(|| closed(exact))),
        ours!(mechanism, origin, 20),
        absolute!("absolute coordinates, LU, predictor", absolute_21, mechanism, origin, true, 20),
    ];
    report("W3 Jansen's leg", runs, error);
}

fn chain() {
    let mechanism = Chain::default();
    let exact = |t: f64| {
        let (sine, cosine) = libm::sincos(TAU * t);
        let mut tip = crank(1.0, [FRAC_PI_2 + 0.8 * sine, 0.8 * TAU * cosine, -0.8 * TAU * TAU * sine]);
        for pivot in 1..=10 {
            tip = dyad(&tip, 1.0, &fixed(f64::from(pivot), 0.0), 1.0, 1.0);
        }
        tip
    };
    let (origin, error) = follow!(mechanism, tip, exact);
    let runs: Vec<(&str, Run)> = vec![("closed form of the tracked point", Box::new(|| closed(exact))), ours!(mechanism, origin, 32)];
    report("W4 chain of 10", runs, error);
}

fn report(workload: &str, mut runs: Vec<(&str, Run)>, error: f64) {
    let mut nanoseconds: Vec<Vec<f64>> = vec![Vec::new(); runs.len()];
    let mut sum = 0.0;
    for _ in 0..ROUNDS {
        for ((_, run), times) in runs.iter_mut().zip(&mut nanoseconds) {
            let start = Instant::now();
            sum += run();
            times.push(start.elapsed().as_secs_f64() * 1e9 / (STEPS - 1) as f64);
        }
    }
    black_box(sum);
    let first = nanoseconds[0].clone();
    for ((contender, _), times) in runs.iter().zip(&nanoseconds) {
        let ratios: Vec<f64> = times.iter().zip(&first).map(|(time, first)| time / first).collect();
        let error = if *contender == "reuleaux" { format!("{error:.1e}") } else { String::new() };
        println!("| {workload} | {contender} | {:.0} | {:.2} | {error} |", median(times.clone()), median(ratios));
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
