//! What derivatives by parameters cost, beside a warm step. `cargo run --release -p reuleaux-benches --bin derivatives`

use std::hint::black_box;
use std::time::Instant;

use reuleaux::{Mechanism, mechanism};

mechanism! {
    /// A crank-rocker with seven parameters.
    pub mechanism CrankRocker {
        param speed: AngularVelocity = 60rpm;
        param ground_length: Length = 400mm;
        param crank_length: Length = 100mm;
        param coupler_length: Length = 350mm;
        param rocker_length: Length = 300mm;
        param along: Length = 175mm;
        param across: Length = 80mm;
        ground { point C = (ground_length, 0mm); }
        body crank   { point A = (crank_length, 0mm); }
        body coupler { point B = (coupler_length, 0mm);  point P = (along, across); }
        body rocker  { point B = (rocker_length, 0mm);  start angle = 70deg; }
        joint o = revolute(ground.position, crank.position);
        joint a = revolute(crank.A, coupler.position);
        joint b = revolute(coupler.B, rocker.B);
        joint c = revolute(rocker.position, ground.C);
        drive input = drive_angle(crank, speed * t);
        output tip = coupler.P;
    }
}

/// States of a turn.
const STEPS: u32 = 1000;

/// Turns for one measurement, and measurements, of which the median counts.
const TURNS: usize = 20;
const MEASUREMENTS: usize = 21;

/// Nanoseconds for each state of a turn.
fn measured(mut turn: impl FnMut()) -> f64 {
    let mut times: Vec<f64> = (0..MEASUREMENTS)
        .map(|_| {
            let begin = Instant::now();
            (0..TURNS).for_each(|_| turn());
            begin.elapsed().as_nanos() as f64 / (TURNS as f64 * f64::from(STEPS))
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[MEASUREMENTS / 2]
}

fn main() {
    let mechanism = CrankRocker::default();
    let times: Vec<f64> = (0..=STEPS).map(|step| f64::from(step) / f64::from(STEPS)).collect();
    let states: Vec<CrankRockerState> = mechanism.sweep(times.iter().copied()).map(|state| state.expect("a crank-rocker turns")).collect();
    let step = measured(|| {
        let mut state = states[0].clone();
        for &t in &times[1..] {
            mechanism.advance(&mut state, t).expect("a crank-rocker turns");
            black_box(mechanism.tip(&state));
        }
    });
    let of_one = measured(|| {
        for state in &states[1..] {
            let (varied, state) = mechanism.derivatives(state, |m| [&mut m.crank_length]).expect("a state");
            black_box(varied.tip(&CrankRockerState(state)));
        }
    });
    let of_seven = measured(|| {
        for state in &states[1..] {
            let all = mechanism.derivatives(state, |m| {
                let CrankRocker { speed, ground_length, crank_length, coupler_length, rocker_length, along, across } = m;
                [speed, ground_length, crank_length, coupler_length, rocker_length, along, across]
            });
            let (varied, state) = all.expect("a state");
            black_box(varied.tip(&CrankRockerState(state)));
        }
    });
    println!("warm step and output         {step:7.1} ns");
    println!("derivatives by 1 parameter   {of_one:7.1} ns   {:5.2} steps", of_one / step);
    println!("derivatives by 7 parameters  {of_seven:7.1} ns   {:5.2} steps, {:.2} for each", of_seven / step, of_seven / step / 7.0);
}
