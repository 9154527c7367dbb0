//! Nonlinear least squares by the Levenberg-Marquardt method, for small dense problems.
//!
//! Reference: Moré (1978), The Levenberg-Marquardt algorithm: implementation and theory.

use crate::expr::{Evaluator, Values};
use crate::linear::dense::cholesky;
use std::cell::Cell;

/// min ½ ‖Φ(q)‖²; rows that cannot be evaluated are left out.
pub(crate) struct Problem<'a> {
    /// Number of rows.
    pub(crate) rows: usize,
    /// True for rows whose functions the compiler can all evaluate.
    pub(crate) is_known: Vec<bool>,
    /// Row and column of each derivative in the Jacobian.
    pub(crate) pattern: Vec<(usize, usize)>,
    /// Evaluates Φ, then the derivatives.
    pub(crate) evaluator: Evaluator,
    /// Natural size of each row: that of its derivatives in scaled unknowns.
    pub(crate) natural: Vec<f64>,
    /// Offset added to each row; empty: none.
    pub(crate) shift: Vec<f64>,
    /// Parameters and functions; the coordinates in it are replaced.
    pub(crate) known: Values<'a>,
    /// Indices of the unknowns in q.
    pub(crate) unknowns: Vec<usize>,
    /// All of q; the unknowns are overwritten.
    pub(crate) coordinates: Vec<f64>,
    /// Scale of each unknown, in m or rad.
    pub(crate) scales: Vec<f64>,
    /// Sum of squares below which the rows count as closed; at least [`CLOSED`].
    pub(crate) closed: f64,
    /// Counter of operations.
    pub(crate) effort: &'a Cell<u64>,
}

/// The rows count as closed when the sum of their squares, in scaled unknowns, is below this.
pub(crate) const CLOSED: f64 = 1e-20;

/// A row whose derivatives are below this fraction of its natural size touches zero, as the cosine of two axes that stay in line: they are nothing but
/// rounding, and the row is divided by this fraction of its natural size instead.
pub(crate) const TOUCHING: f64 = 1e-6;

/// A row that touches zero holds if its residual is below this fraction of its natural size.
const HOLDS: f64 = 1e-14;

/// Residuals and Jacobian at a configuration, in scaled unknowns.
#[derive(Clone)]
pub(crate) struct Linearization {
    pub(crate) phi: Vec<f64>,
    pub(crate) jacobian: Vec<Vec<f64>>,
}

impl Problem<'_> {
    /// Residuals and Jacobian without row scaling, in scaled unknowns.
    pub(crate) fn raw(&mut self, q: &[f64]) -> Linearization {
        let mut values = vec![0.0; self.rows + self.pattern.len()];
        for (unknown, value) in self.unknowns.iter().zip(q) {
            self.coordinates[*unknown] = *value;
        }
        self.evaluator.run(&Values { coordinates: &self.coordinates, ..self.known }, &mut values);
        self.effort.set(self.effort.get() + (self.evaluator.steps() + self.rows * q.len()) as u64);
        let (phi, entries) = values.split_at(self.rows);
        let mut linear = Linearization { phi: phi.to_vec(), jacobian: vec![vec![0.0; q.len()]; self.rows] };
        for ((row, column), entry) in self.pattern.iter().zip(entries) {
            linear.jacobian[*row][*column] = entry * self.scales[*column];
        }
        linear.phi.iter_mut().zip(&self.shift).for_each(|(value, shift)| *value += shift);
        linear
    }

    /// Residuals and Jacobian, each row divided by its largest entry, or by [`TOUCHING`] of its natural size if this is larger.
    fn linearize(&mut self, q: &[f64]) -> Linearization {
        let mut linear = self.raw(q);
        for (k, (value, row)) in linear.phi.iter_mut().zip(&mut linear.jacobian).enumerate() {
            let (natural, is_known) = (self.natural[k], self.is_known[k]);
            let size = row.iter().fold(0.0, |size: f64, entry| size.max(entry.abs()));
            if !value.is_finite() || !size.is_finite() || size == 0.0 && value.abs() > HOLDS * natural {
                // A row with an unknown function is left out. A row without a finite value or gradient at this configuration counts as
                // open.
                *value = f64::from(u8::from(is_known));
                row.fill(0.0);
                continue;
            }
            if size < TOUCHING * natural && value.abs() <= HOLDS * natural {
                *value = 0.0;
            }
            // A row that vanishes everywhere is not divided by zero.
            let size = size.max(TOUCHING * natural).max(f64::MIN_POSITIVE);
            *value /= size;
            row.iter_mut().for_each(|entry| *entry /= size);
        }
        linear
    }
}

/// Levenberg-Marquardt steps in the free unknowns until the rows vanish or no step reduces them; true if they vanish.
pub(crate) fn minimise(problem: &mut Problem, q: &mut [f64], free: &[bool]) -> bool {
    let columns: Vec<usize> = (0..q.len()).filter(|column| free[*column]).collect();
    let mut damping = 1e-3;
    let mut here = problem.linearize(q);
    let mut cost = square(&here.phi);
    for _ in 0..60 {
        if cost <= CLOSED {
            break;
        }
        let Some(step) = step(&here, &columns, damping) else { return false };
        let mut trial = q.to_vec();
        for (column, change) in columns.iter().zip(&step) {
            trial[*column] -= change * problem.scales[*column];
        }
        let there = problem.linearize(&trial);
        let new_cost = square(&there.phi);
        if new_cost < cost {
            let is_stuck = new_cost > 0.999_999 * cost && damping > 1e-8;
            q.copy_from_slice(&trial);
            (here, cost) = (there, new_cost);
            damping = (damping * 0.1).max(1e-15);
            if is_stuck {
                break;
            }
        } else {
            damping *= 10.0;
            if damping > 1e8 {
                break;
            }
        }
    }
    if cost > problem.closed {
        return false;
    }
    polish(problem, q, &columns, 2);
    true
}

/// Refines a closed configuration to rounding, even at a singular one, where every step only halves the error.
pub(crate) fn settle(problem: &mut Problem, q: &mut [f64]) {
    let columns: Vec<usize> = (0..q.len()).collect();
    polish(problem, q, &columns, 60);
}

/// Refines a nearly closed configuration by Gauss-Newton steps; two suffice at a regular one.
fn polish(problem: &mut Problem, q: &mut [f64], columns: &[usize], steps: usize) {
    for _ in 0..steps {
        let here = problem.linearize(q);
        let Some(step) = step(&here, columns, 1e-15) else { return };
        let mut trial = q.to_vec();
        for (column, change) in columns.iter().zip(&step) {
            trial[*column] -= change * problem.scales[*column];
        }
        let (before, after) = (square(&here.phi), square(&problem.linearize(&trial).phi));
        if after > before || (steps > 2 && after == before) {
            return;
        }
        q.copy_from_slice(&trial);
    }
}

fn square(values: &[f64]) -> f64 {
    values.iter().map(|value| value * value).sum()
}

/// Solves (JᵀJ + λ I) δ = JᵀΦ by Cholesky's method.
fn step(linear: &Linearization, columns: &[usize], damping: f64) -> Option<Vec<f64>> {
    let n = columns.len();
    let mut matrix = vec![vec![0.0; n]; n];
    let mut right = vec![0.0; n];
    for (value, row) in linear.phi.iter().zip(&linear.jacobian) {
        let entries: Vec<(usize, f64)> =
            columns.iter().enumerate().map(|(i, column)| (i, row[*column])).filter(|(_, entry)| *entry != 0.0).collect();
        for (i, a) in &entries {
            right[*i] += a * value;
            for (j, b) in &entries {
                matrix[*i][*j] += a * b;
            }
        }
    }
    for (i, row) in matrix.iter_mut().enumerate() {
        row[i] += damping;
    }
    cholesky(matrix, right)
}
