//! Test for singular blocks: singular at one configuration, or everywhere.
//!
//! In: a closed configuration. Out: a measure of the block's reduced Jacobian:
//!
//! ```text
//! R = J_ri + J_re · de/di        r residuals, i iterated and e explicit unknowns, de/di by the explicit equations
//! ```
//!
//! Each entry is divided by the scale of its row and by the largest effect of its unknown. The measure is 1 if the iterated unknowns are
//! well determined and 0 if they are not determined. At a dead point of a four-bar it is the sine of the angle between coupler and rocker.

use super::assemblies::strays;
use super::reduced::Reduced;
use crate::expr::{Evaluator, Expr, Values};
use crate::linear::dense::Factors;
use crate::numeric::Numeric;
use crate::numeric::least_squares::{Problem, minimise, settle};
use crate::structure::Block;

/// A block is regular if rounding errors change its reduced Jacobian by less than this relative norm; the run time asks the same, since it
/// bounds the relative error of velocities. Close to a dead point this holds for condition numbers below about 1/√ε.
const SHARE: f64 = 0.25;

/// Factor on the bound of rounding errors. At a double root Newton's method may stop at the rounding error of the residual and of its own
/// step, where these change the Jacobian by as little as a quarter.
const ROUNDINGS: f64 = 2.0;

/// A block with a larger measure is certainly regular.
const REGULAR: f64 = 1e-4;

/// Largest number of Newton steps until only rounding errors are left.
const STEPS: usize = 60;

/// Distance of a nearby configuration, in characteristic lengths or rad.
const NEAR: f64 = 0.1;

/// Perturbations of the right-hand side to test whether the block is singular elsewhere too, in characteristic lengths or rad.
const SHIFTS: [f64; 3] = [1e-2, 1e-3, 1e-4];

impl Numeric<'_> {
    /// True if a block is singular at a closed configuration, and regular near it.
    ///
    /// To tell a singular point from a singular block, the right-hand side is perturbed: near a singular point the perturbed equations have
    /// a regular solution in some direction; in a singular block their only solutions, if any, are singular too.
    pub(super) fn is_singular_here(&self, block: &Block, start: &[f64]) -> bool {
        let mut problem = self.block_problem(block, start);
        let sizes = self.row_sizes(block, start);
        let mut q: Vec<f64> = problem.unknowns.iter().map(|unknown| start[*unknown]).collect();
        // The usual case: clearly regular.
        if measure(&mut problem, block, &sizes, &q) > REGULAR {
            return false;
        }
        settle(&mut problem, &mut q);
        if self.is_resolved(block, start, &mut q) {
            return false;
        }
        (0..24_u32).any(|attempt| {
            let shift = SHIFTS[attempt as usize / 8];
            let way = |index: usize| 2.0 * (f64::from(attempt % 8 + 1) * (index as f64 + 1.0) * 0.618_033_988_749_895).fract() - 1.0;
            problem.shift = sizes.iter().enumerate().map(|(row, size)| shift * size * way(row)).collect();
            // Perturb the guess as well: exactly in line, a step has no preferred side.
            let mut near: Vec<f64> =
                q.iter().zip(&problem.scales).enumerate().map(|(index, (value, scale))| value + shift * scale * way(index + 7)).collect();
            let everything = vec![true; near.len()];
            minimise(&mut problem, &mut near, &everything) && measure(&mut problem, block, &sizes, &near) > REGULAR
        })
    }

    /// True if rounding errors do not change the Jacobian of a block significantly.
    fn is_resolved(&self, block: &Block, start: &[f64], q: &mut Vec<f64>) -> bool {
        let mut reduced = Reduced::new(self, block);
        reduced.set_out_from(start);
        for _ in 0..STEPS {
            let Some(here) = reduced.linearize(q) else { return false };
            let (Some(off), Some(step)) = (reduced.rounding(&here), here.newton()) else { return false };
            // At a double root each Newton step halves the error, until only rounding errors are left.
            if length(&step) > length(&off) {
                *q = reduced.moved(q, &here, &step);
                continue;
            }
            return [ROUNDINGS, -ROUNDINGS].into_iter().all(|times| {
                let step: Vec<f64> = off.iter().map(|off| times * off).collect();
                let there = reduced.moved(q, &here, &step);
                let there = reduced.linearize(&there);
                there.and_then(|there| strays(&here.r, &there.r)).is_some_and(|share| share <= SHARE)
            });
        }
        false
    }

    /// Scale of each row of a block: its largest entry by any unknown of the mechanism, at this configuration or a nearby one, in scaled
    /// unknowns; 1 if that is 0 or not finite.
    ///
    /// Entries by the block's own unknowns alone may be small because the block is singular, and entries at this configuration alone
    /// because the row is the square of an expression that vanishes here.
    pub(super) fn row_sizes(&self, block: &Block, start: &[f64]) -> Vec<f64> {
        let near: Vec<f64> = start.iter().enumerate().map(|(unknown, value)| value + NEAR * self.scale(unknown)).collect();
        let size = |equation: &usize| {
            let row = &self.system.equations[*equation].jacobian;
            let entries: Vec<Expr> = row.iter().map(|(_, entry)| *entry).collect();
            let (mut evaluator, mut values) = (Evaluator::new(&self.system.arena, &entries), vec![0.0; entries.len()]);
            let mut largest = |coordinates: &[f64]| {
                evaluator.run(&Values { coordinates, ..self.known }, &mut values);
                row.iter().zip(&values).fold(0.0, |size: f64, ((unknown, _), value)| size.max((value * self.scale(*unknown)).abs()))
            };
            largest(start).max(largest(&near))
        };
        block.parts().1.iter().map(size).map(|size| if size > 0.0 && size.is_finite() { size } else { 1.0 }).collect()
    }
}

/// Smallest pivot of the scaled reduced Jacobian, at most 1; 1 for a block that is not iterated.
///
/// Unknowns and rows of the problem are those of the block, iterated and residual ones first.
fn measure(problem: &mut Problem, block: &Block, sizes: &[f64], q: &[f64]) -> f64 {
    let (linear, k) = (problem.raw(q), block.iterated.len());
    let row = |index: usize| linear.jacobian[index].iter().map(|entry| entry / sizes[index]).collect::<Vec<f64>>();
    let rows: Vec<Vec<f64>> = (0..linear.jacobian.len()).map(row).collect();
    if rows.len() != block.residuals.len() + block.explicit.len() || rows.iter().flatten().any(|entry| !entry.is_finite()) {
        // A velocity-level row, or a row that is not finite: no statement is possible.
        return 1.0;
    }
    // If an unknown's column vanishes here, take its scale at a nearby configuration.
    let near: Vec<f64> = q.iter().zip(&problem.scales).map(|(value, scale)| value + NEAR * scale).collect();
    let elsewhere = problem.raw(&near);
    let mut reduced = vec![vec![0.0; k]; k];
    for column in 0..k {
        // Derivatives of all unknowns by this one.
        let mut moves = vec![0.0; q.len()];
        moves[column] = 1.0;
        let others = elsewhere.jacobian.iter().zip(sizes).map(|(row, size)| row[column] / size).filter(|entry| entry.is_finite());
        let mut largest = rows.iter().map(|row| row[column]).chain(others).fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
        for place in 0..block.explicit.len() {
            let (row, own) = (&rows[k + place], k + place);
            let along: f64 = row.iter().zip(&moves).enumerate().filter(|(other, _)| *other != own).map(|(_, (entry, by))| entry * by).sum();
            moves[own] = -along / row[own];
            largest = largest.max(moves[own].abs());
        }
        for (residual, reduced) in reduced.iter_mut().enumerate() {
            let entry: f64 = rows[residual].iter().zip(&moves).map(|(entry, by)| entry * by).sum();
            reduced[column] = if largest > 0.0 { entry / largest } else { 0.0 };
        }
    }
    // After scaling, entries are at most about 1.
    Factors::new(reduced).map_or(0.0, |factors| factors.smallest_pivot.min(1.0))
}

fn length(vector: &[f64]) -> f64 {
    vector.iter().map(|entry| entry * entry).sum::<f64>().sqrt()
}
