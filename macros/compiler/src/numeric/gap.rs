//! Smallest gap at one joint of a loop when all other joints of the loop are closed.
//!
//! ```text
//! min ‖w Φ_g(q)‖   so that   Φ_o(q) = 0        g the rows of one joint, o the other rows of the block
//! ```
//!
//! A least-squares fit would spread the gap over all joints of the loop, in arbitrary proportions; with the loop opened at one joint, the
//! gap is the distance that a fitter would measure there. The constraint Φ_o = 0 is enforced by a penalty of growing weight. The objective
//! is ½ ‖W Φ‖², minimised by Newton's method with the full Hessian JᵀW²J + Σ (W²Φ)_k ∇²Φ_k: at a gap the curvature of the rows matters,
//! since a fully stretched loop has a singular J.
//!
//! Reference: Nocedal and Wright, Numerical Optimization, sections 10.3 and 17.1.

use super::Numeric;
use super::least_squares::{Linearization, Problem, minimise};
use crate::diag::Gap;
use crate::expr::{Expr, Values, evaluate};
use crate::linear::dense::cholesky;
use crate::model::Relationship;
use crate::quantity::Dim;
use crate::system::Equation;

/// Successive penalty weights of the rows that must hold.
const PENALTIES: [f64; 4] = [1.0, 1e2, 1e4, 1e5];

/// A row holds if its weighted residual is below this, in characteristic lengths or rad.
const HOLDS: f64 = 1e-7;

/// Number of initial guesses, and number of the best of them from which the gap is minimised.
const GUESSES: usize = 24;
const BEST: usize = 4;

/// Result of opening a loop at one joint.
pub(crate) enum Opened {
    /// The joint cannot be closed: smallest gap, and the configuration where it occurs.
    Open { gap: Gap, q: Vec<f64> },
    /// The joint can be closed after all: values of the block's unknowns.
    Closed(Vec<f64>),
    /// The other joints cannot be closed either.
    Others,
}

impl Numeric<'_> {
    /// Smallest gap of a joint when all other joints of a loop, given by its unknowns and equations, are closed.
    pub(crate) fn least_gap(&self, unknowns: &[usize], equations: &[usize], start: &[f64], joint: usize) -> Opened {
        let (own, others): (Vec<usize>, Vec<usize>) =
            equations.iter().partition(|equation| self.system.equations[**equation].joint == joint);
        let mut without = self.problem(&others, unknowns.to_vec(), start.to_vec());
        let mut all = self.problem(&[own.as_slice(), &others].concat(), unknowns.to_vec(), start.to_vec());
        let weights = weights(self, &mut all, &[own.as_slice(), &others].concat(), start);
        // Start from every configuration at which the other joints close.
        let mut places: Vec<(f64, Vec<f64>)> = Vec::new();
        for attempt in 0..GUESSES {
            let mut q = self.guessed(&without, start, attempt);
            let everything = vec![true; q.len()];
            if minimise(&mut without, &mut q, &everything) {
                places.push((open_by(&all.raw(&q), &weights, own.len()), q));
            }
        }
        places.retain(|(gap, _)| gap.is_finite());
        places.sort_by(|one, other| one.0.total_cmp(&other.0));
        let mut best: Option<(f64, Vec<f64>)> = None;
        for (_, mut q) in places.into_iter().take(BEST) {
            for penalty in PENALTIES {
                descend(&mut all, &mut q, &weights, own.len(), penalty);
            }
            let linear = all.raw(&q);
            let held = linear.phi[own.len()..].iter().zip(&weights[own.len()..]).all(|(value, weight)| (value * weight).abs() < HOLDS);
            let gap = open_by(&linear, &weights, own.len());
            if held && best.as_ref().is_none_or(|(least, _)| gap < *least) {
                best = Some((gap, q));
            }
        }
        let Some((gap, mut q)) = best else { return Opened::Others };
        if gap < 10.0 * HOLDS {
            let (mut closed, everything) = (q.clone(), vec![true; q.len()]);
            if minimise(&mut all, &mut closed, &everything) {
                return Opened::Closed(closed);
            }
            // A gap this small is accurate only if the other joints are closed to rounding.
            minimise(&mut without, &mut q, &everything);
        }
        let mut coordinates = start.to_vec();
        unknowns.iter().zip(q).for_each(|(unknown, value)| coordinates[*unknown] = value);
        Opened::Open { gap: self.gap(&own, &coordinates), q: coordinates }
    }

    /// The first guess is the result of the search; the others are spread over a whole turn around it.
    fn guessed(&self, problem: &Problem, start: &[f64], attempt: usize) -> Vec<f64> {
        let value = |(unknown, scale): (&usize, &f64)| {
            let turn = (attempt as f64 * (*unknown as f64 + 1.0) * 0.618_033_988_749_895).fract() - 0.5;
            start[*unknown] + if attempt == 0 { 0.0 } else { turn * core::f64::consts::TAU * scale }
        };
        problem.unknowns.iter().zip(&problem.scales).map(value).collect()
    }

    /// Residual of a joint in m and rad, at given values of all unknowns.
    fn gap(&self, rows: &[usize], coordinates: &[f64]) -> Gap {
        let mut gap = Gap { length: 0.0, angle: 0.0, other: None };
        // Rows of unit vectors: together the sine of the angle that is missing.
        let mut sine = 0.0_f64;
        for equation in rows.iter().map(|equation| &self.system.equations[*equation]) {
            let Some(phi) = equation.phi() else { continue };
            let roots: Vec<Expr> = std::iter::once(phi).chain(equation.jacobian.iter().map(|(_, entry)| *entry)).collect();
            let values = evaluate(&self.system.arena, &roots, &Values { coordinates, ..self.known });
            let (phi, slopes) = (values[0], &values[1..]);
            match equation.dim {
                dim if dim == Dim::LENGTH => gap.length = gap.length.hypot(phi),
                dim if dim == Dim::ANGLE => gap.angle = gap.angle.hypot(phi),
                dim if dim == Dim::NUMBER && self.is_of_directions(equation) => sine = sine.hypot(phi),
                dim if dim == Dim::LENGTH.times(Dim::LENGTH) && self.is_placed(equation) => {
                    // Φ = |h|² − c²; its derivative by the position of the first body is 2 h.
                    let body = equation.jacobian.iter().map(|(unknown, _)| self.system.coordinates[*unknown].body).min();
                    let of_body = equation
                        .jacobian
                        .iter()
                        .zip(slopes)
                        .filter(|((unknown, _), _)| self.is_position(*unknown) && Some(self.system.coordinates[*unknown].body) == body);
                    let h = of_body.map(|(_, slope)| (slope / 2.0).powi(2)).sum::<f64>().sqrt();
                    match h * h - phi {
                        square if square >= 0.0 => gap.length = gap.length.hypot(h - square.sqrt()),
                        // The row is not a distance.
                        _ => gap.other = Some((phi.abs().max(gap.other.map_or(0.0, |(most, _)| most)), dim.unit())),
                    }
                }
                dim if phi.abs() > gap.other.as_ref().map_or(0.0, |(most, _)| *most) => gap.other = Some((phi.abs(), dim.unit())),
                _ => {}
            }
        }
        gap.angle = gap.angle.hypot(sine.min(1.0).asin());
        gap
    }

    /// True if an equation relates directions of axes.
    fn is_of_directions(&self, equation: &Equation) -> bool {
        self.model.space.relations.iter().any(|(joint, row, relation)| {
            let is_of_it = *joint == equation.joint && (*row..*row + relation.rows()).contains(&equation.row);
            is_of_it && !matches!(relation, Relationship::Coincident(..) | Relationship::OnLine(..) | Relationship::Equal(..))
        })
    }

    /// True if an equation contains a position, not only angles.
    fn is_placed(&self, equation: &Equation) -> bool {
        equation.jacobian.iter().any(|(unknown, _)| self.is_position(*unknown))
    }
}

/// ‖w Φ_g‖
fn open_by(linear: &Linearization, weights: &[f64], own: usize) -> f64 {
    linear.phi.iter().zip(weights).take(own).map(|(value, weight)| (value * weight).powi(2)).sum::<f64>().sqrt()
}

/// Row weights: lengths and their squares in characteristic lengths, angles in rad, other rows by the largest derivative at the start.
fn weights(numeric: &Numeric, problem: &mut Problem, rows: &[usize], start: &[f64]) -> Vec<f64> {
    let q: Vec<f64> = problem.unknowns.iter().map(|unknown| start[*unknown]).collect();
    let linear = problem.raw(&q);
    let weight = |(equation, row): (&usize, &Vec<f64>)| match numeric.system.equations[*equation].dim {
        dim if dim == Dim::LENGTH => 1.0 / numeric.size,
        dim if dim == Dim::ANGLE => 1.0,
        dim if dim == Dim::LENGTH.times(Dim::LENGTH) => 1.0 / (numeric.size * numeric.size),
        _ => {
            let largest = row.iter().fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
            if largest > 0.0 && largest.is_finite() { 1.0 / largest } else { 1.0 }
        }
    };
    rows.iter().zip(&linear.jacobian).map(weight).collect()
}

/// Minimises ½ ‖W Φ‖² from q. W is `weights`; all but the first `own` rows are multiplied by `penalty`.
fn descend(problem: &mut Problem, q: &mut [f64], weights: &[f64], own: usize, penalty: f64) {
    let squares: Vec<f64> =
        weights.iter().enumerate().map(|(row, weight)| if row < own { weight * weight } else { (weight * penalty).powi(2) }).collect();
    let value = |linear: &Linearization| linear.phi.iter().zip(&squares).map(|(phi, square)| phi * phi * square).sum::<f64>();
    let mut here = problem.raw(q);
    let mut damping = 1e-6;
    for _ in 0..40 {
        let (gradient, hessian) = second_order(problem, q, &here, &squares);
        let mut is_lower = false;
        while damping < 1e12 {
            let shifted = |i: usize| (0..q.len()).map(|j| hessian[i][j] + if i == j { damping } else { 0.0 }).collect::<Vec<f64>>();
            let step = cholesky((0..q.len()).map(shifted).collect(), gradient.clone());
            if let Some(step) = step {
                let trial: Vec<f64> = q.iter().zip(&step).zip(&problem.scales).map(|((q, step), scale)| q - step * scale).collect();
                let there: Linearization = problem.raw(&trial);
                if value(&there) < value(&here) {
                    is_lower = value(&there) < value(&here) * (1.0 - 1e-13);
                    q.copy_from_slice(&trial);
                    here = there;
                    damping = (damping * 0.03).max(1e-14);
                    break;
                }
            }
            damping *= 10.0;
        }
        if !is_lower {
            return;
        }
    }
}

/// Gradient JᵀW²Φ and Hessian JᵀW²J + Σ (W²Φ)_k ∇²Φ_k in scaled unknowns; the curvature by central differences of J.
fn second_order(problem: &mut Problem, q: &[f64], here: &Linearization, squares: &[f64]) -> (Vec<f64>, Vec<Vec<f64>>) {
    // The cube root of ε balances rounding and truncation.
    const STEP: f64 = 1e-5;
    let n = q.len();
    let pull: Vec<f64> = here.phi.iter().zip(squares).map(|(phi, square)| phi * square).collect();
    let times = |linear: &Linearization| -> Vec<f64> {
        (0..n).map(|column| linear.jacobian.iter().zip(&pull).map(|(row, pull)| row[column] * pull).sum()).collect()
    };
    let gradient = times(here);
    let mut hessian = vec![vec![0.0; n]; n];
    for (row, square) in here.jacobian.iter().zip(squares) {
        for i in (0..n).filter(|i| row[*i] != 0.0) {
            (0..n).for_each(|j| hessian[i][j] += square * row[i] * row[j]);
        }
    }
    for i in 0..n {
        let mut moved = q.to_vec();
        moved[i] = q[i] + STEP * problem.scales[i];
        let after = times(&problem.raw(&moved));
        moved[i] = q[i] - STEP * problem.scales[i];
        let before = times(&problem.raw(&moved));
        for j in 0..n {
            let curvature = (after[j] - before[j]) / (4.0 * STEP);
            // Half of the value to each of two entries keeps the Hessian symmetric.
            hessian[i][j] += curvature;
            hessian[j][i] += curvature;
        }
    }
    (gradient, hessian)
}
