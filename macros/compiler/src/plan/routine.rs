//! Straight lines, and what they cost.

use crate::expr::{Expr, Leaf};
use std::collections::BTreeMap;

/// Straight lines: steps in order, then results.
#[derive(Clone, Debug)]
pub struct Routine {
    /// What is named on the way.
    pub steps: Vec<Step>,
    /// What is computed. Each is written once, after the steps with a smaller or equal index.
    pub results: Vec<Expr>,
    /// How many steps stand before each result.
    pub after: Vec<usize>,
    /// Names of the nodes that have one.
    pub names: BTreeMap<Expr, String>,
    /// The leaves it reads, with their place in the arena.
    pub leaves: Vec<(Expr, Leaf)>,
    /// How often each kind of operation is done.
    pub cost: Cost,
}

/// One step.
#[derive(Clone, Debug)]
pub enum Step {
    /// A value that is used more than once.
    Value(Expr),
    /// Sine and cosine of an angle; a name is missing where the value is not needed.
    SineCosine {
        /// The angle.
        angle: Expr,
        /// Name of its sine.
        sine: Option<String>,
        /// Name of its cosine.
        cosine: Option<String>,
    },
    /// A function known by number, with its derivatives.
    Call {
        /// Its number.
        function: u32,
        /// Its argument.
        argument: Expr,
        /// Names of value, first and second derivative, where needed.
        names: [Option<String>; 3],
    },
}

impl std::ops::Add for Cost {
    type Output = Cost;
    fn add(self, other: Cost) -> Cost {
        Cost {
            flops: self.flops + other.flops,
            divisions: self.divisions + other.divisions,
            sines: self.sines + other.sines,
            calls: self.calls + other.calls,
        }
    }
}

impl std::ops::Mul<usize> for Cost {
    type Output = Cost;
    fn mul(self, times: usize) -> Cost {
        let Cost { flops, divisions, sines, calls } = self;
        Cost { flops: times * flops, divisions: times * divisions, sines: times * sines, calls: times * calls }
    }
}

/// Operation counts of a routine.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Additions, subtractions and multiplications.
    pub flops: usize,
    /// Divisions and square roots.
    pub divisions: usize,
    /// Pairs of sine and cosine.
    pub sines: usize,
    /// Other functions.
    pub calls: usize,
}
