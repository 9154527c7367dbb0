//! A block as equations for its iterated unknowns alone: what is explicit follows from them.
//!
//! ```text
//! δe = −J_ee⁻¹ (Φ_e + J_ei δi)        explicit equations, by forward substitution
//! R  = J_ri + J_re de/di              r residuals, i iterated and e explicit unknowns
//! g  = Φ_r − J_re J_ee⁻¹ Φ_e          the residuals as they are once what is explicit has followed
//! ```
//!
//! In: a block and where its unknowns stand. Out: an assembly of the block near by, to the rounding limit, by the method of Levenberg
//! and Marquardt on g and then by Newton's. Not done here: choosing guesses and assemblies.

use crate::expr::{Evaluator, Expr, Values, magnitudes};
use crate::numeric::dense::{cholesky, solve};
use crate::numeric::least_squares::CLOSED;
use crate::numeric::{Numeric, place};
use crate::structure::Block;

/// Limited steps of Newton's method from a guess.
const LIMITED_STEPS: usize = 40;

/// Damped steps from where these lead.
const DAMPED_STEPS: usize = 25;

/// The damping of steps that are not damped, so that a singular matrix does no harm.
const HARDLY: f64 = 1e-13;

/// Newton's steps from where the residuals vanish to the rounding limit.
const LAST_STEPS: usize = 40;

/// A last step is no longer than this, in rad and sizes.
const FAR: f64 = 1e-3;

/// Residuals whose squares sum up to less may be rounding errors.
const NEARLY: f64 = 1e-22;

/// So many roundings of its terms may be left of a residual.
const ROUNDINGS: f64 = 16.0;

/// Steps below this that hardly become shorter are rounding errors.
const STALLED: f64 = 1e-9;

/// Residuals whose squares sum up to less are rounding errors.
const ROUNDED: f64 = 1e-28;

/// Longest step of an iterated unknown, in rad and sizes.
const LONGEST: f64 = 0.6;

/// A block made ready to be solved often.
pub(super) struct Reduced<'a> {
    numeric: &'a Numeric<'a>,
    /// Iterated unknowns, then explicit ones.
    pub(super) unknowns: Vec<usize>,
    scales: Vec<f64>,
    /// How many are iterated.
    pub(super) iterated: usize,
    /// Residuals, then explicit equations: where the entries of each row stand among the values, and their columns.
    rows: Vec<Vec<(usize, usize)>>,
    /// Φ of each row, for what rounding does to it.
    roots: Vec<Expr>,
    evaluator: Evaluator,
    values: Vec<f64>,
    /// What residuals are shares of: what an entry of the row can be, by any unknown of the mechanism.
    sizes: Vec<f64>,
    /// All of q, of which the unknowns of the block are replaced.
    coordinates: Vec<f64>,
}

/// A block at a place.
pub(super) struct LinearizedBlock {
    /// The residuals once what is explicit has followed, in shares of the rows' sizes.
    pub(super) g: Vec<f64>,
    /// Their derivatives by scaled iterated unknowns.
    pub(super) r: Vec<Vec<f64>>,
    /// How far each explicit unknown has to go to follow, scaled.
    follows: Vec<f64>,
    /// How far each goes for each iterated unknown.
    moves: Vec<Vec<f64>>,
    /// By how much the rows are open, the sum of the squares of steps that would close each.
    open: f64,
}

impl LinearizedBlock {
    fn cost(&self) -> f64 {
        square(&self.g)
    }

    /// Newton's step of the iterated unknowns; None where they are not determined.
    pub(super) fn newton(&self) -> Option<Vec<f64>> {
        solve(self.r.clone(), &self.g.iter().map(|g| -g).collect::<Vec<f64>>())
    }

    /// Steps as long as rounding errors would close it.
    fn is_closed(&self) -> bool {
        self.open + square(&self.follows) <= CLOSED
    }

    /// It is open by so little that this may be rounding errors, though a step that closes it may be long.
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

    /// Makes another q known, of which what lies before the block counts.
    pub(super) fn set_out_from(&mut self, q: &[f64]) {
        self.coordinates = q.to_vec();
    }

    /// The block linearised where its unknowns are `x`; None where it is not defined.
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
        // Explicit equations first, each of which adds one unknown to those that are known.
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
                // Without a slope it is open.
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

    /// Moves the unknowns by a step of those that are iterated, in scaled unknowns; the others follow.
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

    /// Makes the residuals as small as they become from a guess; whether they vanish, to the rounding limit if they do.
    pub(super) fn close(&mut self, x: &mut Vec<f64>) -> bool {
        let still = vec![0.0; self.iterated];
        // What is explicit is brought to where it belongs first; twice, for what is not linear in it.
        for _ in 0..2 {
            let Some(linear) = self.linearize(x) else { return false };
            *x = self.moved(x, &linear, &still);
        }
        let Some(mut here) = self.linearize(x) else { return false };
        // Limited steps that may cross singular positions, as from rough guesses they often must.
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

    /// The residuals vanish, to rounding.
    fn is_closed(&self, linear: &LinearizedBlock) -> bool {
        if linear.is_closed() || !linear.is_nearly_closed() {
            return linear.is_closed();
        }
        let floors = self.floors();
        linear.g.iter().zip(&floors).all(|(g, floor)| g.abs() <= ROUNDINGS * floor)
    }

    /// What rounding errors of each row may amount to, in shares of its size.
    fn floors(&self) -> Vec<f64> {
        let known = Values { coordinates: &self.coordinates, ..self.numeric.known };
        let floors = magnitudes(&self.numeric.system.arena, &self.roots, &known);
        floors.iter().zip(&self.sizes).map(|(floor, size)| f64::EPSILON * floor / size).collect()
    }

    /// Newton's method from where the residuals vanish to the rounding limit; false where they are not defined.
    pub(super) fn settle(&mut self, x: &mut Vec<f64>) -> bool {
        let Some(mut here) = self.linearize(x) else { return false };
        let mut last = f64::INFINITY;
        for _ in 0..LAST_STEPS {
            let Some(step) = here.newton() else { return true };
            let length = step.iter().chain(&here.follows).fold(0.0, |length: f64, step| length.max(step.abs()));
            let trial = self.moved(x, &here, &step);
            // Where it is singular a step may lead anywhere.
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

    /// How far an assembly may be off by rounding, in scaled iterated unknowns: where the worst of the residuals' rounding errors leads,
    /// as far as all of them together may. None where the block is singular.
    pub(super) fn rounding(&self, linear: &LinearizedBlock) -> Option<Vec<f64>> {
        let (floors, k) = (self.floors(), self.iterated);
        // Rounding errors of what is explicit come to the residuals by way of its own equations.
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

/// (RᵀR + λ r² I) δ = −Rᵀg with the longest column r, and no entry of δ longer than `longest`.
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
