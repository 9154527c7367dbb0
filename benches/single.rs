//! Sine, cosine, tangent and arc sine at every `f32` there is, against those of `f64`:
//! `cargo run --release -p reuleaux-benches --bin single`, a minute or two on two processors.
//!
//! Out: the largest relative error of each, in ε of `f32`, and where. It fails where one is above the bound that is promised.

use std::error::Error;
use std::thread;

use reuleaux::Real;

/// Names, and bounds in ε.
const ROWS: [(&str, f64); 4] = [("sine", 1.25), ("cosine", 1.25), ("tangent", 3.0), ("arc sine", 2.0)];

/// The largest error in ε, and where.
type Worst = [(f64, f32); ROWS.len()];

fn main() -> Result<(), Box<dyn Error>> {
    let threads = thread::available_parallelism()?.get() as u32;
    let all = thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|first| scope.spawn(move || worst(first, threads))).collect();
        workers.into_iter().map(|worker| worker.join()).collect::<Result<Vec<Worst>, _>>()
    });
    let all = all.map_err(|_| "a zero, an infinity or a sign is wrong")?;
    let mut missed = Vec::new();
    for (k, (name, bound)) in ROWS.iter().enumerate() {
        let (error, x) = all.iter().map(|worst| worst[k]).fold((0.0, 0.0), |most, next| if next.0 > most.0 { next } else { most });
        println!("{name}: at most {error:.4} ε, at {x:e}; promised {bound}");
        if error > *bound {
            missed.push(*name);
        }
    }
    if missed.is_empty() { Ok(()) } else { Err(format!("above the bound: {}", missed.join(", ")).into()) }
}

/// Over every number from zero on whose bits are `first` and so many more; numbers below zero are the same with the other sign.
fn worst(first: u32, step: u32) -> Worst {
    let mut worst = [(0.0, 0.0); ROWS.len()];
    for bits in (first..=f32::NAN.to_bits()).step_by(step as usize) {
        let x = f32::from_bits(bits);
        let (sine, cosine) = x.sin_cos();
        let (other_sine, other_cosine) = (-x).sin_cos();
        assert!(x.is_finite() || (sine.is_nan() && cosine.is_nan()));
        assert!(!x.is_finite() || (other_sine.to_bits() == (-sine).to_bits() && other_cosine.to_bits() == cosine.to_bits()));
        let (exact_sine, exact_cosine) = libm::sincos(f64::from(x));
        let tangent = (Real::tan(x), exact_sine / exact_cosine);
        let arc = if x <= 1.0 { (Real::asin(x), libm::asin(f64::from(x))) } else { (0.0, 0.0) };
        let pairs = [(sine, exact_sine), (cosine, exact_cosine), tangent, arc];
        for (worst, (found, exact)) in worst.iter_mut().zip(pairs) {
            // Below the normal numbers what counts is the distance between two of them.
            let unit = f64::from(f32::EPSILON) * exact.abs().max(f64::from(f32::MIN_POSITIVE));
            let error = (f64::from(found) - exact).abs() / unit;
            if error > worst.0 {
                *worst = (error, x);
            }
        }
    }
    worst
}
