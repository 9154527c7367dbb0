//! Blocks with a constant Jacobian: solved once, exactly, in the compiler.
//!
//! ```text
//! r(x) = J x + r(0) = 0      x = −J⁻¹ r(0)
//! ```
//!
//! An example is two gears that mesh through a third. Only a sum of products is left for run time.

use super::stage::Iteration;
use crate::expr::{Arena, Expr, Leaf, Substitution};
use crate::system::deciding;

/// Largest number of unknowns: an inverse is dense, and beyond this its products cost more than a factorisation.
const LARGEST: usize = 8;

/// Unknowns of a block in terms of upstream unknowns; `None` if its Jacobian is singular, too large or not constant.
pub(super) fn solution(arena: &mut Arena, system: &Iteration) -> Option<Vec<Expr>> {
    let (k, unknowns) = (system.unknowns.len(), system.unknowns.iter().copied().collect());
    let is_constant = system.jacobian.iter().flatten().all(|entry| arena.as_constant(*entry).is_some());
    if k > LARGEST || !is_constant || !system.quaternions.is_empty() {
        return None;
    }
    // Where a choice depends on unknowns, a constant Jacobian is that of one side.
    let is_chosen = |residual: &Expr| !deciding(arena, *residual).is_disjoint(&unknowns);
    if system.residuals.iter().any(is_chosen) {
        return None;
    }
    let inverse = inverse(arena, system.jacobian.clone())?;
    let zero = arena.integer(0);
    let mut at_zero = Substitution::new();
    for unknown in &system.unknowns {
        at_zero.replace(Leaf::Coordinate(*unknown as u32), zero);
    }
    let rest: Vec<Expr> = system.residuals.iter().map(|residual| at_zero.of(arena, *residual)).collect();
    let value = |row: Vec<Expr>| {
        let sum = row.into_iter().zip(&rest).fold(zero, |sum, (factor, rest)| {
            let product = arena.mul(factor, *rest);
            arena.add(sum, product)
        });
        arena.neg(sum)
    };
    Some(inverse.into_iter().map(value).collect())
}

/// Inverse of a constant matrix by Gauss-Jordan elimination in exact arithmetic; `None` if it is singular or a number does not fit.
fn inverse(arena: &mut Arena, mut matrix: Vec<Vec<Expr>>) -> Option<Vec<Vec<Expr>>> {
    let k = matrix.len();
    for (i, row) in matrix.iter_mut().enumerate() {
        row.extend((0..k).map(|j| arena.integer(i64::from(i == j))));
    }
    for column in 0..k {
        let pivot = (column..k).find(|row| arena.as_constant(matrix[*row][column]).is_some_and(|value| !value.is_zero()))?;
        matrix.swap(column, pivot);
        let divisor = matrix[column][column];
        for entry in &mut matrix[column] {
            *entry = arena.div(*entry, divisor);
        }
        let pivot = matrix[column].clone();
        for (row, entries) in matrix.iter_mut().enumerate() {
            let factor = entries[column];
            if row == column {
                continue;
            }
            for (entry, above) in entries.iter_mut().zip(&pivot) {
                let product = arena.mul(factor, *above);
                *entry = arena.sub(*entry, product);
            }
        }
    }
    let is_exact = matrix.iter().flatten().all(|entry| arena.as_constant(*entry).is_some());
    is_exact.then(|| matrix.into_iter().map(|row| row[k..].to_vec()).collect())
}
