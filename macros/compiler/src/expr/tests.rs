//! Tests of expressions.

mod arena;
mod derivative;
mod eval;
mod exact;
mod formula;
mod frame;
mod gather;
mod jet;
mod precise;
pub(crate) mod random;
pub(crate) mod samples;
mod show;
mod simplify;

use super::{Arena, Expr, Values};
use formula::parse;

/// The expression of a formula in the language of [`formula`].
fn expr(arena: &mut Arena, text: &str) -> Expr {
    parse(text).build(arena)
}

/// Numbered functions of these tests: f₀(x) = x³, f₁(x) = 1/x, all others undefined.
fn functions(number: u32, x: f64) -> [f64; 3] {
    match number {
        0 => [x * x * x, 3.0 * x * x, 6.0 * x],
        1 => [1.0 / x, -1.0 / (x * x), 2.0 / (x * x * x)],
        _ => [f64::NAN; 3],
    }
}

/// Generic values of all leaves.
#[derive(Clone)]
struct Point {
    time: f64,
    parameters: [f64; 2],
    coordinates: [f64; 3],
    speeds: [f64; 3],
    accelerations: [f64; 3],
}

impl Point {
    /// All numbers drawn between 0.1 and 0.9, where every function is defined and smooth.
    fn random(random: &mut random::Random) -> Point {
        let mut draw = || random.between(0.1, 0.9);
        Point {
            time: draw(),
            parameters: [draw(), draw()],
            coordinates: [draw(), draw(), draw()],
            speeds: [draw(), draw(), draw()],
            accelerations: [draw(), draw(), draw()],
        }
    }

    /// The values after a time `s` at constant accelerations.
    fn later(&self, s: f64) -> Point {
        let mut point = self.clone();
        point.time += s;
        for i in 0..3 {
            point.coordinates[i] += s * (self.speeds[i] + 0.5 * s * self.accelerations[i]);
            point.speeds[i] += s * self.accelerations[i];
        }
        point
    }

    fn values(&self) -> Values<'_> {
        Values {
            time: self.time,
            parameters: &self.parameters,
            coordinates: &self.coordinates,
            speeds: &self.speeds,
            accelerations: &self.accelerations,
            functions: &functions,
        }
    }

    fn value_of(&self, arena: &Arena, root: Expr) -> f64 {
        super::evaluate(arena, &[root], &self.values())[0]
    }
}

/// Fails unless two numbers agree relative to their magnitude, or to 1 if they are smaller.
fn assert_close(found: f64, expected: f64, tolerance: f64, what: &str) {
    let scale = expected.abs().max(1.0);
    let difference = (found - expected).abs();
    assert!(difference <= tolerance * scale, "{what}: found {found}, expected {expected}");
}

/// Formulas in which every operation occurs, alone and composed.
const FORMULAS: &[&str] = &[
    "-(x*y)",
    "sqrt(x + y*y)",
    "sin(x*y)",
    "cos(x - 3*y)",
    "tan(x*y)",
    "asin(x*y)",
    "acos(x*y)",
    "atan(x/y)",
    "exp(x*y)",
    "ln(x + y)",
    "abs(x - 2*y - 3)",
    "sign(x - 2)*x",
    "x + y*x",
    "x*x - y",
    "x*y*z",
    "(x*y)*(x*y)",
    "x*x*x*t",
    "x/(y + t)",
    "1/(x*x)",
    "atan2(x*y, z)",
    "atan2(y - 2, x - 1)",
    "if(x, y + 2, x*sin(y), z)",
    "if(x + 2, y, z, y*cos(x))",
    "f(x*y)",
    "g(x + t*y)",
    "p*sin(t*t)*x",
    "sqrt((x - y)*(x - y) + (z - p)*(z - p) + 1) - t*q",
    "u*x + v*sin(y)",
    "u*u/(1 + v*x)",
    "atan2(sin(x)*u, cos(y) + v*t)",
];
