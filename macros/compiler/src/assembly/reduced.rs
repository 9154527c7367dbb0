//! A block reduced to equations in its iterated unknowns; explicit unknowns follow from these.
//!
//! ```text
//! δe = −J_ee⁻¹ (Φ_e + J_ei δi)        explicit equations, by forward substitution
//! R  = J_ri + J_re de/di              r residuals, i iterated and e explicit unknowns
//! g  = Φ_r − J_re J_ee⁻¹ Φ_e          residuals after the explicit unknowns have followed
//! ```
//!
//! In: a block and values of its unknowns. Out: a nearby assembly of the block, refined to rounding: by limited and damped Gauss-Newton
//! steps on g, then by Newton's method. Not done here: choosing guesses and assemblies.

use crate::expr::{Evaluator, Expr, Values, magnitudes};
use crate::linear::dense::{cholesky, solve};
use crate::numeric::least_squares::CLOSED;
use crate::numeric::{Numeric, place};
use crate::structure::Block;

/// Largest number of Newton steps of limited length from a guess.
const LIMITED_STEPS: usize = 40;

/// Largest number of damped steps after these.
const DAMPED_STEPS: usize = 25;

/// Minimum damping, so that a singular matrix can be factorised.
const HARDLY: f64 = 1e-13;

/// Largest number of Newton steps that refine a solution to rounding.
const LAST_STEPS: usize = 40;

/// Longest refining step, in rad and characteristic lengths.
const FAR: f64 = 1e-3;

/// Residuals with a smaller sum of squares may be rounding errors.
const NEARLY: f64 = 1e-22;

/// Residuals up to this many rounding errors of their terms are closed.
const ROUNDINGS: f64 = 16.0;

/// Steps below this that hardly decrease are rounding errors.
const STALLED: f64 = 1e-9;

/// Residuals with a smaller sum of squares are rounding errors.
const ROUNDED: f64 = 1e-28;

/// Longest step of an iterated unknown, in rad and characteristic lengths.
const LONGEST: f64 = 0.6;

/// A block prepared to be solved repeatedly.
pub(super) struct Reduced<'a> {
    numeric: &'a Numeric<'a>,
    /// Iterated unknowns, then explicit ones.
    pub(super) unknowns: Vec<usize>,
    scales: Vec<f64>,
    /// Number of iterated unknowns.
    pub(super) iterated: usize,
    /// For each row, residuals first, then explicit equations: index of each entry in `values`, and its column.
    rows: Vec<Vec<(usize, usize)>>,
    /// Φ of each row, to bound its rounding error.
    roots: Vec<Expr>,
    evaluator: Evaluator,
    values: Vec<f64>,
    /// Row scales: the largest entry that a row can have, by any unknown of the mechanism.
    sizes: Vec<f64>,
    /// All of q; the unknowns of the block are overwritten.
    coordinates: Vec<f64>,
}

/// A block linearised at a configuration.
pub(super) struct LinearizedBlock {
    /// Residuals after the explicit unknowns have followed, divided by the row scales.
    pub(super) g: Vec<f64>,
    /// Derivatives of g by the scaled iterated unknowns.
    pub(super) r: Vec<Vec<f64>>,
    /// Corrections of the explicit unknowns, scaled.
    follows: Vec<f64>,
    /// Derivatives of the explicit unknowns by the iterated ones, scaled.
    moves: Vec<Vec<f64>>,
    /// Sum of the squares of the steps that would close each residual.
    open: f64,
}

impl LinearizedBlock {
    fn cost(&self) -> f64 {
        square(&self.g)
    }

    /// Newton step of the iterated unknowns; `None` if the Jacobian is singular.
    pub(super) fn newton(&self) -> Option<Vec<f64>> {
        solve(self.r.clone(), &self.g.iter().map(|g| -g).collect::<Vec<f64>>())
    }

    /// True if the steps that would close the block are of the order of rounding errors.
    fn is_closed(&self) -> bool {
        self.open + square(&self.follows) <= CLOSED
    }

    /// True if the residual may be rounding, although the step that closes it may be long.
    fn is_nearly_closed(&self) -> bool {
        self.cost() + square(&self.follows) <= NEARLY
    }
}

impl<'a> Reduced<'a> {
    pub(super) fn new(numeric: &'a Numeric<'a>, block: &Block) -> Reduced<'a> {
        let (unknowns, equations) = block.parts();
        let column = |unknown: usize| place(&unknowns, unknown);
        let sizes = if block.iterated.is_empty() { vec![1.0; equations.len()] } else { numeric.row_sizes(block, &numeric.unassembled()) };
        let mut roots: Vec<Expr> = equations.iter().filter_map(|equation| numeric.system.equations[*equation].phi()).collect();
        let phi = roots.clone();
        let mut rows = Vec::new();
        for equation in &equations {
            let mut row = Vec::new();
            for (unknown, entry) in &numeric.system.equations[*equation].jacobian {
                if let Some(column) = column(*unknown) {
                    row.push((roots.len(), column));
                    roots.push(*entry);
                }
            }
            rows.push(row);
        }
        Reduced {
            scales: unknowns.iter().map(|unknown| numeric.scale(*unknown)).collect(),
            iterated: block.iterated.len(),
            rows,
            roots: phi,
            evaluator: Evaluator::new(&numeric.system.arena, &roots),
            values: vec![0.0; roots.len()],
            sizes,
            coordinates: Vec::new(),
            numeric,
            unknowns,
        }
    }

    /// Sets q; the coordinates upstream of the block are taken from it.
    pub(super) fn set_out_from(&mut self, q: &[f64]) {
        self.coordinates = q.to_vec();
    }

    /// Linearises the block at the unknowns `x`; `None` if it is not finite there.
    pub(super) fn linearize(&mut self, x: &[f64]) -> Option<LinearizedBlock> {
        for (unknown, value) in self.unknowns.iter().zip(x) {
            self.coordinates[*unknown] = *value;
        }
        self.evaluator.run(&Values { coordinates: &self.coordinates, ..self.numeric.known }, &mut self.values);
        let k = self.iterated;
        let explicit = self.unknowns.len() - k;
        let (mut g, mut r) = (Vec::with_capacity(k), Vec::with_capacity(k));
        let (mut follows, mut moves) = (Vec::with_capacity(explicit), Vec::with_capacity(explicit));
        let mut open = 0.0;
        // Explicit equations first: each determines one further unknown.
        for index in (k..self.rows.len()).chain(0..k) {
            let entries = self.rows[index].iter().map(|(place, column)| (*column, self.values[*place] * self.scales[*column]));
            let (mut rest, mut along, mut pivot, mut size) = (self.values[index], vec![0.0; k], f64::NAN, 0.0_f64);
            for (column, entry) in entries {
                size = size.max(entry.abs());
                if column < k {
                    along[column] += entry;
                } else if column == index {
                    pivot = entry;
                } else {
                    let (follows, moves): (&Vec<f64>, &Vec<Vec<f64>>) = (&follows, &moves);
                    rest += entry * follows.get(column - k)?;
                    along.iter_mut().zip(&moves[column - k]).for_each(|(along, moves)| *along += entry * moves);
                }
            }
            if index >= k {
                follows.push(-rest / pivot);
                moves.push(along.into_iter().map(|along| -along / pivot).collect());
            } else {
                // A row with zero gradient counts as open.
                open += if size > 0.0 { (rest / size).powi(2) } else { 1.0 };
                g.push(rest / self.sizes[index]);
                r.push(along.into_iter().map(|along| along / self.sizes[index]).collect());
            }
        }
        let linear = LinearizedBlock { g, r, follows, moves, open };
        let is_finite =
            linear.cost().is_finite() && square(&linear.follows).is_finite() && linear.r.iter().all(|row| square(row).is_finite());
        is_finite.then_some(linear)
    }

    /// Moves the iterated unknowns by a step, in scaled unknowns; the explicit ones follow.
    pub(super) fn moved(&self, x: &[f64], linear: &LinearizedBlock, step: &[f64]) -> Vec<f64> {
        let k = self.iterated;
        let mut there = x.to_vec();
        for (index, value) in there.iter_mut().enumerate() {
            let by = if index < k {
                step[index]
            } else {
                linear.follows[index - k] + linear.moves[index - k].iter().zip(step).map(|(moves, step)| moves * step).sum::<f64>()
            };
            *value += by * self.scales[index];
        }
        there
    }

    /// Closes the block from a guess; true if the residuals vanish, and then refined to rounding.
    pub(super) fn close(&mut self, x: &mut Vec<f64>) -> bool {
        let still = vec![0.0; self.iterated];
        // Compute the explicit unknowns first; twice, since their equations may be nonlinear in them.
        for _ in 0..2 {
            let Some(linear) = self.linearize(x) else { return false };
            *x = self.moved(x, &linear, &still);
        }
        let Some(mut here) = self.linearize(x) else { return false };
        // Limited steps may cross singular configurations, as steps from rough guesses often must.
        for _ in 0..LIMITED_STEPS {
            if self.is_closed(&here) {
                return self.settle(x);
            }
            let Some(step) = damped(&here, HARDLY, LONGEST) else { break };
            let trial = self.moved(x, &here, &step);
            let Some(there) = self.linearize(&trial) else { break };
            (*x, here) = (trial, there);
        }
        let mut damping = 1e-3;
        for _ in 0..DAMPED_STEPS {
            if self.is_closed(&here) {
                return self.settle(x);
            }
            let Some(step) = damped(&here, damping, f64::INFINITY) else { return false };
            let trial = self.moved(x, &here, &step);
            match self.linearize(&trial) {
                Some(there) if there.cost() < here.cost() || self.is_closed(&there) => {
                    (*x, here) = (trial, there);
                    damping = (damping * 0.1).max(HARDLY);
                }
                _ => damping *= 10.0,
            }
            if damping > 1e8 {
                return false;
            }
        }
        false
    }

    /// True if the residuals vanish to rounding.
    fn is_closed(&self, linear: &LinearizedBlock) -> bool {
        if linear.is_closed() || !linear.is_nearly_closed() {
            return linear.is_closed();
        }
        let floors = self.floors();
        linear.g.iter().zip(&floors).all(|(g, floor)| g.abs() <= ROUNDINGS * floor)
    }

    /// Bound of the rounding error of each row, divided by its scale.
    fn floors(&self) -> Vec<f64> {
        let known = Values { coordinates: &self.coordinates, ..self.numeric.known };
        let floors = magnitudes(&self.numeric.system.arena, &self.roots, &known);
        floors.iter().zip(&self.sizes).map(|(floor, size)| f64::EPSILON * floor / size).collect()
    }

    /// Refines a solution to rounding by Newton's method; false if the block is not finite there.
    pub(super) fn settle(&mut self, x: &mut Vec<f64>) -> bool {
        let Some(mut here) = self.linearize(x) else { return false };
        let mut last = f64::INFINITY;
        for _ in 0..LAST_STEPS {
            let Some(step) = here.newton() else { return true };
            let length = step.iter().chain(&here.follows).fold(0.0, |length: f64, step| length.max(step.abs()));
            let trial = self.moved(x, &here, &step);
            // At a singular configuration a step may be arbitrarily long.
            let Some(there) = self.linearize(&trial).filter(|there| length < FAR && there.cost() <= here.cost().max(ROUNDED)) else {
                return true;
            };
            (*x, here) = (trial, there);
            if length <= f64::EPSILON || (length < STALLED && length > 0.6 * last) {
                break;
            }
            last = length;
        }
        true
    }

    /// Estimated rounding error of an assembly, in scaled iterated unknowns: it has the direction of the largest effect of a single
    /// residual's rounding error, and the summed length of all effects. `None` if the block is singular.
    pub(super) fn rounding(&self, linear: &LinearizedBlock) -> Option<Vec<f64>> {
        let (floors, k) = (self.floors(), self.iterated);
        // Rounding errors of explicit equations propagate to the residuals.
        let through: f64 = floors[k..].iter().sum();
        let (mut worst, mut longest, mut total) = (vec![0.0; k], 0.0, 0.0);
        for row in 0..k {
            let mut error = vec![0.0; k];
            error[row] = floors[row] + through;
            let way = solve(linear.r.clone(), &error)?;
            let length = square(&way).sqrt();
            total += length;
            if length > longest {
                (worst, longest) = (way, length);
            }
        }
        if longest > 0.0 {
            worst.iter_mut().for_each(|way| *way *= total / longest);
        }
        Some(worst)
    }
}

fn square(values: &[f64]) -> f64 {
    values.iter().map(|value| value * value).sum()
}

/// (RᵀR + λ r² I) δ = −Rᵀg, where r is the norm of the longest column; δ is scaled so that no entry exceeds `longest`.
fn damped(linear: &LinearizedBlock, damping: f64, longest: f64) -> Option<Vec<f64>> {
    let k = linear.r.first().map_or(0, Vec::len);
    let (mut matrix, mut right) = (vec![vec![0.0; k]; k], vec![0.0; k]);
    for (g, row) in linear.g.iter().zip(&linear.r) {
        for i in 0..k {
            right[i] -= row[i] * g;
            (0..=i).for_each(|j| matrix[i][j] += row[i] * row[j]);
        }
    }
    let largest = (0..k).fold(f64::MIN_POSITIVE, |largest: f64, i| largest.max(matrix[i][i]));
    matrix.iter_mut().enumerate().for_each(|(i, row)| row[i] += damping * largest);
    let mut step = cholesky(matrix, right)?;
    let length = step.iter().fold(longest, |length: f64, step| length.max(step.abs()));
    if length > longest {
        step.iter_mut().for_each(|step| *step *= longest / length);
    }
    Some(step)
}
