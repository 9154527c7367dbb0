//! Straight-line code and its cost.

use crate::expr::{Expr, Leaf};
use std::collections::BTreeMap;

/// Straight-line code: steps in order, and results.
#[derive(Clone, Debug)]
pub struct Routine {
    /// Named steps.
    pub steps: Vec<Step>,
    /// Results. Each is written once, after the number of steps given by `after`.
    pub results: Vec<Expr>,
    /// Number of steps before each result.
    pub after: Vec<usize>,
    /// Names of nodes.
    pub names: BTreeMap<Expr, String>,
    /// Leaves that are read, with their nodes.
    pub leaves: Vec<(Expr, Leaf)>,
    /// Operation counts.
    pub cost: Cost,
}

/// One step.
#[derive(Clone, Debug)]
pub enum Step {
    /// A value that is used more than once.
    Value(Expr),
    /// Sine and cosine of an angle; the name of an unused value is missing.
    SineCosine {
        /// The angle.
        angle: Expr,
        /// Name of its sine.
        sine: Option<String>,
        /// Name of its cosine.
        cosine: Option<String>,
    },
    /// A function, by number, with its derivatives.
    Call {
        /// Its number.
        function: u32,
        /// Its argument.
        argument: Expr,
        /// Names of value, first and second derivative, if used.
        names: [Option<String>; 3],
    },
    /// Values of the branch that holds: the first one if `lhs < rhs`.
    Choice {
        /// Left side of the comparison.
        lhs: Expr,
        /// Its right side.
        rhs: Expr,
        /// The values.
        members: Vec<Expr>,
        /// Both branches.
        branches: [Branch; 2],
    },
}

/// Steps that are computed only where a branch holds.
#[derive(Clone, Debug)]
pub struct Branch {
    /// Named steps.
    pub steps: Vec<Step>,
    /// Its values.
    pub results: Vec<Expr>,
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
