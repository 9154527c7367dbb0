//! Elimination of the Jacobian of a large block: order of the pivots and fill-in.
//!
//! In: the pattern of the Jacobian, and its values at some poses. Out: an [`Elimination`]. The order is fixed in the compiler, so that the
//! elimination can be written as straight-line code; the run time monitors its accuracy at every pose. Not done here: printing.

mod order;
#[cfg(test)]
mod tests;

use super::routine::Cost;
use super::stage::{Elimination, Iteration};
use crate::assembly::Poses;
use crate::expr::{Arena, Expr};
use crate::system::System;
use order::{PivotCandidate, in_order};
use std::collections::BTreeSet;

/// Blocks of up to this many unknowns are solved in closed form.
pub(super) const CLOSED_FORM: usize = 3;

/// An elimination with more operations is done by a loop over tables: longer straight-line code slows rustc down noticeably.
const LONGEST: usize = 2000;

/// Chooses the elimination of a block.
pub(super) fn elimination(arena: &Arena, system: &System, block: &Iteration, poses: &Poses) -> Elimination {
    let size = block.unknowns.len();
    let zero = |expr: &Expr| arena.as_constant(*expr).is_some_and(|value| value.is_zero());
    let all = block.jacobian.iter().enumerate().flat_map(|(i, row)| row.iter().enumerate().map(move |(j, expr)| (i, j, *expr)));
    let stored: Vec<(usize, usize, Expr)> = all.filter(|(_, _, expr)| !zero(expr)).collect();
    let exprs: Vec<Expr> = stored.iter().map(|(_, _, expr)| *expr).collect();
    let values = poses.values(arena, &exprs);
    let weights: Vec<f64> = block.unknowns.iter().map(|unknown| system.coordinates[*unknown].role.scale(poses.size)).collect();
    let entry = |(number, (row, column, expr)): (usize, &(usize, usize, Expr))| PivotCandidate {
        place: (*row, *column),
        values: values.iter().map(|pose| pose[number] * weights[*column]).collect(),
        is_unit: arena.as_constant(*expr).is_some_and(|value| value.to_f64().abs() == 1.0),
    };
    let entries: Vec<PivotCandidate> = stored.iter().enumerate().map(entry).collect();
    Elimination::new(size, &entries)
}

impl Elimination {
    /// Elimination in an order chosen for sparsity and for accuracy at the known poses.
    fn new(size: usize, entries: &[PivotCandidate]) -> Elimination {
        let pivots = in_order(size, entries);
        let (rows, columns): (Vec<usize>, Vec<usize>) = pivots.iter().map(|pivot| pivot.place).unzip();
        let pattern: Vec<(usize, usize)> = entries.iter().map(|entry| entry.place).collect();
        let factors = filled(&pattern, &rows, &columns);
        let is_unit: Vec<bool> = pivots.iter().map(|pivot| pivot.is_unit).collect();
        let cost = cost(&factors, &is_unit);
        Elimination { pattern, rows, columns, factors, is_unit, cost }
    }

    /// Properties that blocks must share to be eliminated alike: for each entry, 0 if it is always zero, 1 if it is ±1, and 2 otherwise.
    pub(super) fn features(&self, arena: &Arena, jacobian: &[Vec<Expr>]) -> Vec<u32> {
        let feature = |entry: &Expr| match arena.as_constant(*entry).map(|value| value.to_f64()) {
            Some(0.0) => 0,
            Some(value) if value.abs() == 1.0 => 1,
            _ => 2,
        };
        jacobian.iter().flatten().map(feature).collect()
    }

    /// True if straight-line code is short enough.
    pub(crate) fn is_short(&self) -> bool {
        self.cost.flops <= LONGEST
    }

    /// Row and column in the factors of an entry of the Jacobian.
    pub(crate) fn place_of(&self, (row, column): (usize, usize)) -> Option<(usize, usize)> {
        let place = |list: &[usize], index: usize| list.iter().position(|entry| *entry == index);
        Some((place(&self.rows, row)?, place(&self.columns, column)?))
    }

    /// Columns of the entries of L in a row, or of the entries of U to the right of the diagonal.
    pub(crate) fn row(&self, i: usize, of_lower: bool) -> impl Iterator<Item = usize> {
        self.factors
            .iter()
            .filter(move |(row, column)| *row == i && if of_lower { *column < i } else { *column > i })
            .map(|(_, column)| *column)
    }
}

/// Pattern of L + U: that of the permuted matrix, with fill-in.
fn filled(pattern: &[(usize, usize)], rows: &[usize], columns: &[usize]) -> Vec<(usize, usize)> {
    let size = rows.len();
    let (mut row_of, mut column_of) = (vec![0; size], vec![0; size]);
    for (step, (row, column)) in rows.iter().zip(columns).enumerate() {
        (row_of[*row], column_of[*column]) = (step, step);
    }
    let mut lines: Vec<BTreeSet<usize>> = vec![BTreeSet::new(); size];
    for (row, column) in pattern {
        lines[row_of[*row]].insert(column_of[*column]);
    }
    for i in 0..size {
        for k in 0..i {
            if lines[i].contains(&k) {
                let right: Vec<usize> = lines[k].iter().copied().filter(|column| *column > k).collect();
                lines[i].extend(right);
            }
        }
        // The diagonal is included even if the matrix is structurally singular.
        lines[i].insert(i);
    }
    lines.iter().enumerate().flat_map(|(i, line)| line.iter().map(move |column| (i, *column))).collect()
}

/// Operation count: a product for each entry of L, a product and a difference for each entry that it updates, and a quotient for each pivot
/// that is not ±1.
fn cost(factors: &[(usize, usize)], is_unit: &[bool]) -> Cost {
    let mut right = vec![0; is_unit.len()];
    for (row, column) in factors {
        right[*row] += usize::from(column > row);
    }
    let lower = factors.iter().filter(|(row, column)| column < row);
    Cost {
        flops: lower.map(|(_, column)| 1 + 2 * right[*column]).sum(),
        divisions: is_unit.iter().filter(|unit| !**unit).count(),
        ..Cost::default()
    }
}
