//! A parameter study: two hundred engines, each with a longer rod, swept on all processors under a progress bar.
//!
//! The acceleration of a piston is largest at its outer dead centre, r ω² (1 + r/l), if the rod is longer than three cranks; each sweep
//! is checked against that. The bar is written to standard error and only shows on a terminal.

use std::error::Error;
use std::f64::consts::TAU;

use indicatif::ProgressBar;
use reuleaux::mechanism;
use reuleaux::parallel::each;
use reuleaux_examples::steps;

const CRANK: f64 = 0.05;
const SPEED: f64 = 50.0 * TAU;

mechanism! {
    /// An engine with a rod of any length.
    pub mechanism Engine {
        param rod_length: Length = 200mm;

        ground { point O = (0mm, 0mm);  axis cylinder = (1, 0); }
        body crank  { point O = (0mm, 0mm);  point A = (50mm, 0mm); }
        body rod    { point A = (0mm, 0mm);  point B = (rod_length, 0mm);  start angle = 0deg; }
        body piston { point B = (0mm, 0mm); }

        joint main = revolute(ground.O, crank.O);
        joint big_end = revolute(crank.A, rod.A);
        joint small_end = revolute(rod.B, piston.B);
        joint bore = translational(ground.cylinder, ground.O, piston.B);
        drive motor = drive_angle(crank, 3000rpm * t);
    }
}

fn main() -> Result<(), Box<dyn Error + Send + Sync>> {
    let engines: Vec<Engine> = steps(0.16, 0.36, 200).map(|rod_length| Engine { rod_length }).collect();
    let times: Vec<f64> = steps(0.0, TAU / SPEED, 720).collect();

    let bar = ProgressBar::new(engines.len() as u64);
    let peak = |engine: &Engine| {
        let mut peak: f64 = 0.0;
        for state in engine.sweep(&times) {
            peak = peak.max(state?.piston().acceleration.x.abs());
        }
        Ok::<f64, Box<dyn Error + Send + Sync>>(peak)
    };
    let peaks = each(&engines, peak, |progress| bar.set_position(progress.done as u64));
    bar.finish_and_clear();

    println!("rod (mm)   largest acceleration of the piston (m/s²)");
    for (engine, peak) in engines.iter().zip(peaks).step_by(40) {
        let peak = peak?;
        println!("{:8.0}   {peak:10.2}", engine.rod_length * 1e3);
        let expected = CRANK * SPEED * SPEED * (1.0 + CRANK / engine.rod_length);
        assert!((peak - expected).abs() <= 1e-12 * expected, "{peak} for {expected}");
    }
    Ok(())
}
