//! Closed rings of 4 to 30 bars, solved together in one block.
//!
//! The angles are chosen first and the last bar is ground, so that an assembly exists. Every second bar is held relative to the one two
//! positions before it, θ_{i+2} = θ_i + c_i, so that no bar can be positioned before all others:
//!
//! ```text
//! Σ L_i (cos θ_i, sin θ_i) = G      i = 1 … n − 1,  θ_1 and θ_2 unknown
//! ```

use super::{compiled, shown};
use fastrand::Rng;
use reuleaux_tests::samples;
use std::f64::consts::PI;
use std::fmt::Write as _;
use std::num::NonZero;
use std::thread;

/// Smallest length of each of the two chains, in m, and smallest sine of the angle between them.
const MARGIN: f64 = 0.25;

struct Ring {
    lengths: Vec<f64>,
    /// Angles of the chosen assembly.
    angles: Vec<f64>,
}

impl Ring {
    /// Random bars in random directions, well away from a dead point.
    fn random(rng: &mut Rng, bars: usize) -> Ring {
        loop {
            let mut between = |low: f64, high: f64| low + (high - low) * rng.f64();
            let lengths: Vec<f64> = (0..bars).map(|_| (1e3 * between(0.1, 0.5)).round() / 1e3).collect();
            let angles: Vec<f64> = (0..bars).map(|_| between(-PI, PI)).collect();
            let ring = Ring { lengths, angles };
            let [odd, even] = [ring.chain(0), ring.chain(1)];
            let [a, b] = [odd[0].hypot(odd[1]), even[0].hypot(even[1])];
            let sine = (odd[0] * even[1] - odd[1] * even[0]).abs() / (a * b);
            if a > MARGIN && b > MARGIN && sine > MARGIN {
                return ring;
            }
        }
    }

    /// Vector from end to end of every second bar.
    fn chain(&self, first: usize) -> [f64; 2] {
        self.sum((first..self.lengths.len()).step_by(2), &self.angles)
    }

    fn sum(&self, bars: impl Iterator<Item = usize>, angles: &[f64]) -> [f64; 2] {
        bars.fold([0.0; 2], |[x, y], bar| {
            let (sine, cosine) = angles[bar].sin_cos();
            [x + self.lengths[bar] * cosine, y + self.lengths[bar] * sine]
        })
    }

    fn end(&self, angles: &[f64]) -> [f64; 2] {
        self.sum(0..self.lengths.len(), angles)
    }

    fn declaration(&self, declared: Option<usize>) -> String {
        let [x, y] = self.end(&self.angles);
        let mut text = format!("mechanism Ring {{ ground {{ point O = (0m, 0m); point G = ({x:?}m, {y:?}m); }}");
        for (bar, length) in self.lengths.iter().enumerate() {
            let start = if declared == Some(bar) { format!("start angle = {:.3}rad;", self.angles[bar]) } else { String::new() };
            let _ = write!(text, " body bar_{bar} {{ point end = ({length:?}m, 0m); {start} }}");
            let before = if bar == 0 { "ground.O".to_owned() } else { format!("bar_{}.end", bar - 1) };
            let _ = write!(text, " joint pin_{bar} = revolute({before}, bar_{bar}.position);");
        }
        let last = self.lengths.len() - 1;
        let _ = write!(text, " joint closes = revolute(bar_{last}.end, ground.G);");
        for bar in 2..self.lengths.len() {
            let apart = self.angles[bar] - self.angles[bar - 2];
            let _ = write!(text, " drive turn_{bar} = drive_relative_angle(bar_{}, bar_{bar}, {apart:?}rad);", bar - 2);
        }
        text + " }"
    }

    fn is_assembled(&self, declared: Option<usize>) {
        let source = self.declaration(declared);
        let compiled = compiled(&source).unwrap_or_else(|refusals| panic!("{}\nin\n{source}", shown(&refusals, &source)));
        assert!(compiled.assembly.is_closed, "{source}");
        let iterated = compiled.structure.blocks.iter().filter(|block| !block.iterated.is_empty());
        let unknowns: Vec<usize> = iterated.map(|block| block.iterated.len() + block.explicit.len()).collect();
        assert!(matches!(unknowns.as_slice(), [one] if *one >= self.lengths.len()), "{unknowns:?} in\n{source}");
        let angles: Vec<f64> = compiled.assembly.start.chunks(3).map(|place| place[2]).collect();
        let ([x, y], [gx, gy]) = (self.end(&angles), self.end(&self.angles));
        assert!((x - gx).hypot(y - gy) < 1e-13 * self.lengths.len() as f64, "open by {} in\n{source}", (x - gx).hypot(y - gy));
        for bar in 2..angles.len() {
            let off = (angles[bar] - angles[bar - 2]) - (self.angles[bar] - self.angles[bar - 2]);
            assert!(off.abs() < 1e-13, "bar {bar} is off by {off} in\n{source}");
        }
        // Of the two assemblies, the declared one is found.
        if let Some(bar) = declared {
            let turns = (angles[bar] - self.angles[bar]) / (2.0 * PI);
            assert!((turns - turns.round()).abs() < 1e-3, "bar {bar} is at {} instead of {} in\n{source}", angles[bar], self.angles[bar]);
        }
    }
}

#[test]
fn rings_of_any_number_of_bars_are_assembled() {
    let threads = thread::available_parallelism().map_or(1, NonZero::get);
    let all: Vec<(usize, u64)> = (3..30).flat_map(|bars| (0..samples(1, 6) as u64).map(move |seed| (bars, seed))).collect();
    thread::scope(|scope| {
        for first in 0..threads {
            let all = &all;
            scope.spawn(move || {
                for (bars, seed) in all.iter().skip(first).step_by(threads) {
                    let mut rng = Rng::with_seed(1_000 * *bars as u64 + seed);
                    let ring = Ring::random(&mut rng, *bars);
                    ring.is_assembled(None);
                    ring.is_assembled(Some(rng.usize(..*bars)));
                }
            });
        }
    });
}
