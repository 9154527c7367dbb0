//! Blocks whose Jacobian is a constant matrix: solved in the compiler, once and exactly.
//!
//! ```text
//! r(x) = J x + r(0) = 0      x = −J⁻¹ r(0)
//! ```
//!
//! Two gears that mesh through a third and the like. What is left for run time is a sum of products.

use super::stage::Iteration;
use crate::expr::{Arena, Expr, Leaf, Substitution};

/// An inverse is full: beyond this size its products cost more than a factorisation.
const LARGEST: usize = 8;

/// The unknowns of a block as functions of what is known before it; none if its Jacobian is not constant, or singular.
pub(super) fn solution(arena: &mut Arena, system: &Iteration) -> Option<Vec<Expr>> {
    let k = system.unknowns.len();
    let is_constant = system.jacobian.iter().flatten().all(|entry| arena.as_constant(*entry).is_some());
    if k > LARGEST || !is_constant {
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

/// The inverse of a matrix of constants by the method of Gauss and Jordan, in exact arithmetic; none if it is singular or a
/// number gets too long.
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
