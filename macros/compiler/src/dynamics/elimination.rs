//! Accelerations in closed form: the equations of motion, eliminated in an order that is good where the mechanism is assembled.
//!
//! ```text
//! J u̇ = γ              solved for dependent accelerations, pivot by pivot
//! u̇ = N a + p          (Nᵀ M N) a = −Nᵀ (f + M p), by L D Lᵀ
//! ```
//!
//! The pivots are compared with their rows while they are used: where one becomes too small, the runtime eliminates in another order.

use super::MotionRow;
use crate::expr::{Arena, Expr, Unary};
use std::collections::BTreeMap;

/// Accelerations, and by what their computation is judged.
#[derive(Clone, Debug)]
pub struct Accelerations {
    /// u̇, by integrated speed.
    pub values: Vec<Expr>,
    /// Pivots of J, each with the number that its size has to exceed.
    pub pivots: Vec<[Expr; 2]>,
    /// Pivots of the mass matrix, each with the number that it has to exceed.
    pub masses: Vec<[Expr; 2]>,
}

/// A pivot is trusted above one part in so many of the sum of its row. Orientations follow from nearly equal components: they need more.
const TRUSTED: i64 = 16;
const TRUSTED_OF_ORIENTATIONS: i64 = 8;

/// A pivot has at least this fraction of the largest entry in its row, so that it stays trusted for long.
const STEADY: f64 = 0.2;

/// Row and column of each pivot: among those that are large in their rows, as the runtime asks, those with the least fill-in.
///
/// * `rows`: given, the numbers of J where the mechanism is assembled, in comparable units.
/// * `is_zero`: given, true for an entry that always vanishes.
pub(super) fn order(rows: &[Vec<f64>], is_zero: impl Fn(usize, usize) -> bool) -> Option<Vec<(usize, usize)>> {
    let count = rows.first().map_or(0, Vec::len);
    let mut numbers = rows.to_vec();
    let mut filled: Vec<Vec<bool>> = (0..rows.len()).map(|row| (0..count).map(|column| !is_zero(row, column)).collect()).collect();
    let (mut open, mut free): (Vec<usize>, Vec<usize>) = ((0..rows.len()).collect(), (0..count).collect());
    let mut pivots = Vec::new();
    while !open.is_empty() {
        let in_column = |column: usize| open.iter().filter(|row| filled[**row][column]).count();
        let candidates = open.iter().flat_map(|row| {
            let largest = free.iter().map(|column| numbers[*row][*column].abs()).fold(0.0, f64::max);
            let in_row = free.iter().filter(|column| filled[*row][**column]).count();
            let steady = free.iter().filter(|column| numbers[*row][**column].abs() >= STEADY * largest && largest > 0.0);
            steady.map(|column| ((in_row - 1) * (in_column(*column) - 1), *row, *column)).collect::<Vec<_>>()
        });
        let (_, row, column) = candidates.min()?;
        open.retain(|other| *other != row);
        free.retain(|other| *other != column);
        for other in &open {
            if !filled[*other][column] {
                continue;
            }
            let factor = numbers[*other][column] / numbers[row][column];
            for entry in &free {
                if filled[row][*entry] {
                    filled[*other][*entry] = true;
                    numbers[*other][*entry] -= factor * numbers[row][*entry];
                }
            }
        }
        pivots.push((row, column));
    }
    Some(pivots)
}

/// Adds a product to a sum.
fn add_product(arena: &mut Arena, sum: &mut Expr, one: Expr, two: Expr) {
    let product = arena.mul(one, two);
    *sum = arena.add(*sum, product);
}

/// Sparse rows under elimination.
pub(super) struct SparseRows<'a> {
    arena: &'a mut Arena,
    entries: Vec<BTreeMap<usize, Expr>>,
    sides: Vec<Expr>,
    /// Row and column of each pivot, and one over it.
    pivots: Vec<(usize, usize, Expr)>,
    /// One part in so many of its row's sum is enough for a pivot.
    trusted: Expr,
    /// For each row what it must not vanish beside: a small part of its sum before elimination.
    least: Vec<Expr>,
}

/// A row of which less than one part in so many is left depends on the others.
const LEFT: i64 = 1 << 30;

/// Solves the equations of motion.
///
/// * `order`: given, rows and columns of the pivots of J.
/// * `lengths`: given, for each speed the number that makes it comparable with the others, as an expression.
/// * `has_orientations`: given, true if quaternions are integrated.
pub(super) fn accelerations(
    arena: &mut Arena,
    (rows, mass, forces): (&[MotionRow], &[Expr], &[Expr]),
    order: &[(usize, usize)],
    lengths: &[Expr],
    has_orientations: bool,
) -> Accelerations {
    let zero = arena.integer(0);
    let count = forces.len();
    let matrix: Vec<Vec<Expr>> = rows.iter().map(|row| row.jacobian.clone()).collect();
    let trusted = if has_orientations { TRUSTED_OF_ORIENTATIONS } else { TRUSTED };
    let mut work = SparseRows::new(arena, &matrix, rows.iter().map(|row| row.gamma).collect(), lengths, trusted);
    let pivots: Vec<[Expr; 2]> = order.iter().map(|(row, column)| work.eliminate(*row, *column, lengths)).collect();
    let is_dependent = |column: &usize| order.iter().any(|(_, dependent)| dependent == column);
    let independent: Vec<usize> = (0..count).filter(|column| !is_dependent(column)).collect();
    let particular = work.solution(None, count);
    let motions: Vec<Vec<Expr>> = independent.iter().map(|column| work.solution(Some(*column), count)).collect();
    let arena = work.arena;
    let momentum = |arena: &mut Arena, motion: &[Expr]| -> Vec<Expr> {
        let mut sums = vec![zero; count];
        for row in 0..count {
            for column in 0..=row {
                let entry = mass[row * (row + 1) / 2 + column];
                add_product(arena, &mut sums[row], entry, motion[column]);
                if row != column {
                    add_product(arena, &mut sums[column], entry, motion[row]);
                }
            }
        }
        sums
    };
    let rest = momentum(arena, &particular);
    let side: Vec<Expr> = rest.iter().zip(forces).map(|(rest, force)| arena.add(*rest, *force)).collect();
    let dot = |arena: &mut Arena, one: &[Expr], two: &[Expr]| {
        let mut sum = zero;
        one.iter().zip(two).for_each(|(one, two)| add_product(arena, &mut sum, *one, *two));
        sum
    };
    let momenta: Vec<Vec<Expr>> = motions.iter().map(|motion| momentum(arena, motion)).collect();
    let matrix = (0..motions.len()).map(|row| (0..=row).map(|column| dot(arena, &motions[column], &momenta[row])).collect());
    let matrix: Vec<Vec<Expr>> = matrix.collect();
    let right = motions.iter().map(|motion| {
        let work = dot(arena, motion, &side);
        arena.neg(work)
    });
    let right: Vec<Expr> = right.collect();
    let (factors, masses) = solved(arena, matrix, right);
    let mut values = particular;
    for (motion, factor) in motions.iter().zip(factors) {
        values.iter_mut().zip(motion).for_each(|(value, part)| add_product(arena, value, *part, factor));
    }
    Accelerations { values, pivots, masses }
}

impl<'a> SparseRows<'a> {
    /// Rows of a matrix with their right-hand sides.
    ///
    /// * `lengths`: given, for each column the number that makes it comparable with the others, as an expression.
    /// * `trusted`: given, a pivot has to exceed one part in so many of its row's sum.
    pub(super) fn new(arena: &'a mut Arena, matrix: &[Vec<Expr>], sides: Vec<Expr>, lengths: &[Expr], trusted: i64) -> SparseRows<'a> {
        let zero = arena.integer(0);
        let entries = |row: &Vec<Expr>| row.iter().copied().enumerate().filter(|(_, entry)| *entry != zero).collect();
        let entries = matrix.iter().map(entries).collect();
        let trusted = arena.integer(trusted);
        let mut work = SparseRows { arena, entries, sides, pivots: Vec::new(), trusted, least: Vec::new() };
        for row in 0..matrix.len() {
            let (sum, left) = (work.size(row, lengths), work.arena.integer(LEFT));
            let least = work.arena.div(sum, left);
            work.least.push(least);
        }
        work
    }

    /// Sum of the sizes of a row's entries.
    fn size(&mut self, row: usize, lengths: &[Expr]) -> Expr {
        let mut size = self.arena.integer(0);
        for (at, entry) in self.entries[row].clone() {
            let scaled = self.arena.mul(entry, lengths[at]);
            let scaled = self.arena.unary(Unary::Abs, scaled);
            size = self.arena.add(size, scaled);
        }
        size
    }

    /// Eliminates a column from the rows that are left; returns the pivot and the number that its size has to exceed.
    pub(super) fn eliminate(&mut self, row: usize, column: usize, lengths: &[Expr]) -> [Expr; 2] {
        let (one, size) = (self.arena.integer(1), self.size(row, lengths));
        let (own, side) = (self.entries[row].clone(), self.sides[row]);
        let pivot = own[&column];
        let scaled = self.arena.mul(pivot, lengths[column]);
        let inverse = self.arena.div(one, pivot);
        let done: Vec<usize> = self.pivots.iter().map(|(row, _, _)| *row).chain([row]).collect();
        for other in (0..self.entries.len()).filter(|other| !done.contains(other)) {
            let Some(entry) = self.entries[other].remove(&column) else { continue };
            let factor = self.arena.mul(entry, inverse);
            let factor = self.arena.neg(factor);
            for (at, entry) in own.iter().filter(|(at, _)| **at != column) {
                let zero = self.arena.integer(0);
                let sum = self.entries[other].entry(*at).or_insert(zero);
                add_product(self.arena, sum, factor, *entry);
            }
            add_product(self.arena, &mut self.sides[other], factor, side);
        }
        self.pivots.push((row, column, inverse));
        let steady = self.arena.div(size, self.trusted);
        [scaled, self.arena.add(steady, self.least[row])]
    }

    /// `None`: the unknowns for the right-hand sides, with independent ones zero; `Some(k)`: those without right-hand sides, u_k = 1.
    pub(super) fn solution(&mut self, unit: Option<usize>, count: usize) -> Vec<Expr> {
        let (zero, one) = (self.arena.integer(0), self.arena.integer(1));
        let mut unknowns = vec![zero; count];
        if let Some(unit) = unit {
            unknowns[unit] = one;
        }
        for (row, column, inverse) in self.pivots.clone().into_iter().rev() {
            let mut sum = if unit.is_none() { self.sides[row] } else { zero };
            for (at, entry) in self.entries[row].clone() {
                if at != column {
                    let entry = self.arena.neg(entry);
                    add_product(self.arena, &mut sum, entry, unknowns[at]);
                }
            }
            unknowns[column] = self.arena.mul(sum, inverse);
        }
        unknowns
    }
}

/// x of H x = b by L D Lᵀ, and each pivot with the diagonal entry that it comes from.
fn solved(arena: &mut Arena, mut matrix: Vec<Vec<Expr>>, mut right: Vec<Expr>) -> (Vec<Expr>, Vec<[Expr; 2]>) {
    let one = arena.integer(1);
    let mut pivots = Vec::new();
    let mut inverses = Vec::new();
    for k in 0..right.len() {
        // Light and heavy motions may well be coupled: here smaller pivots are trusted.
        let trusted = arena.integer(1 << 10);
        let before = arena.div(matrix[k][k], trusted);
        for j in 0..k {
            let factor = arena.mul(matrix[k][j], inverses[j]);
            let factor = arena.neg(factor);
            for row in &mut matrix[k..] {
                let (entry, mut sum) = (row[j], row[k]);
                add_product(arena, &mut sum, factor, entry);
                row[k] = sum;
            }
            let mut sum = right[k];
            add_product(arena, &mut sum, factor, right[j]);
            right[k] = sum;
        }
        pivots.push([matrix[k][k], before]);
        inverses.push(arena.div(one, matrix[k][k]));
    }
    for k in (0..right.len()).rev() {
        let mut sum = right[k];
        for i in k + 1..right.len() {
            let entry = arena.neg(matrix[i][k]);
            add_product(arena, &mut sum, entry, right[i]);
        }
        right[k] = arena.mul(sum, inverses[k]);
    }
    (right, pivots)
}
