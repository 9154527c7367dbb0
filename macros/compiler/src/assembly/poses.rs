//! Sample configurations along the motion, for choices.
//!
//! In: an [`Assembly`]. Out: its configuration and some before and after it in time. Choices based on these samples must be correct at
//! every configuration; the samples only make them likely to be fast. Not done here: choosing.

use super::Assembly;
use crate::expr::{Arena, Evaluator, Expr, Values, evaluate};
use crate::linear::dense::solve;
use crate::model::{Model, tabulated};
use crate::numeric::Numeric;
use crate::numeric::least_squares;
use crate::system::System;

/// Distances of the poses from the start, as travel of the fastest coordinate, in rad or characteristic lengths.
const WAYS: [f64; 5] = [-0.9, -0.35, 0.35, 0.9, 1.7];

/// Above this number of coordinates the poses are not computed: only the start is used.
const LARGEST: usize = 90;

/// Configurations at the declared defaults, the start first.
pub(crate) struct Poses<'a> {
    model: &'a Model,
    parameters: Vec<f64>,
    /// L: length equivalent to one radian.
    pub(crate) size: f64,
    poses: Vec<ClosedPose>,
}

#[cfg_attr(not(feature = "picture"), allow(dead_code))]
struct ClosedPose {
    time: f64,
    q: Vec<f64>,
    /// True if the loops close there.
    is_closed: bool,
}

impl<'a> Poses<'a> {
    /// The start, and poses on the motion close to it.
    pub(crate) fn new(model: &'a Model, system: &System, assembly: &Assembly) -> Poses<'a> {
        let functions = |number: u32, x: f64| tabulated(&model.functions, number, x);
        let defaults: Vec<Expr> = model.parameters.iter().map(|parameter| parameter.default).collect();
        let nothing = Values { time: 0.0, parameters: &[], coordinates: &[], speeds: &[], accelerations: &[], functions: &functions };
        let parameters = evaluate(&system.arena, &defaults, &nothing);
        let known = Values { parameters: &parameters, ..nothing };
        let size = crate::numeric::size(system, &known);
        let mut poses = vec![ClosedPose { time: 0.0, q: assembly.start.clone(), is_closed: assembly.is_closed }];
        if assembly.is_closed
            && let Some(rates) = rates(system, &known, &assembly.start)
        {
            let scaled = |(rate, unknown): (&f64, &crate::system::Coordinate)| rate.abs() / unknown.role.scale(size);
            let fastest = rates.iter().zip(&system.coordinates).map(scaled).fold(0.0, f64::max);
            if fastest > 0.0 && fastest.is_finite() {
                let declared = vec![None; assembly.start.len()];
                let numeric = Numeric::new(model, system, known, declared);
                poses.extend(WAYS.map(|way| moved(&numeric, &assembly.start, &rates, way / fastest)));
            }
        }
        Poses { model, parameters, size, poses }
    }

    /// Times and configurations of the closed poses.
    #[cfg_attr(not(feature = "picture"), allow(dead_code))]
    pub(crate) fn closed(&self) -> impl Iterator<Item = (f64, &[f64])> {
        self.poses.iter().filter(|pose| pose.is_closed).map(|pose| (pose.time, pose.q.as_slice()))
    }

    /// Values of some expressions at each pose.
    pub(crate) fn values(&self, arena: &Arena, exprs: &[Expr]) -> Vec<Vec<f64>> {
        let functions = |number: u32, x: f64| tabulated(&self.model.functions, number, x);
        let mut evaluator = Evaluator::new(arena, exprs);
        let values = |pose: &ClosedPose| {
            let mut found = vec![f64::NAN; exprs.len()];
            let (time, parameters, coordinates) = (pose.time, self.parameters.as_slice(), pose.q.as_slice());
            evaluator.run(&Values { time, parameters, coordinates, speeds: &[], accelerations: &[], functions: &functions }, &mut found);
            found
        };
        self.poses.iter().map(values).collect()
    }
}

/// The pose at a time, predicted from the rates and corrected.
fn moved(numeric: &Numeric, start: &[f64], rates: &[f64], time: f64) -> ClosedPose {
    let predicted: Vec<f64> = start.iter().zip(rates).map(|(value, rate)| value + rate * time).collect();
    let mut q = predicted.clone();
    let mut problem = numeric.whole();
    problem.known.time = time;
    let is_closed = least_squares::minimise(&mut problem, &mut q, &vec![true; start.len()]);
    ClosedPose { time, q: if is_closed { q } else { predicted }, is_closed }
}

/// q̇ from Φ_q q̇ = ν at the start; `None` if the system is large, not square or singular, or not finite there.
fn rates(system: &System, known: &Values, start: &[f64]) -> Option<Vec<f64>> {
    let n = system.coordinates.len();
    let mut roots: Vec<Expr> = system.equations.iter().map(|equation| equation.nu).collect();
    roots.extend(system.equations.iter().flat_map(|equation| equation.jacobian.iter().map(|(_, entry)| *entry)));
    let values = evaluate(&system.arena, &roots, &Values { coordinates: start, ..*known });
    if n > LARGEST || system.equations.len() != n || values.iter().any(|value| !value.is_finite()) {
        return None;
    }
    let (nu, entries) = values.split_at(n);
    let mut entries = entries.iter();
    let row = |equation: &crate::system::Equation| {
        let mut row = vec![0.0; n];
        for (column, _) in &equation.jacobian {
            row[*column] = *entries.next()?;
        }
        Some(row)
    };
    let matrix: Option<Vec<Vec<f64>>> = system.equations.iter().map(row).collect();
    solve(matrix?, nu)
}
