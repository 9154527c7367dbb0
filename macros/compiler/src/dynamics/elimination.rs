//! Accelerations in closed form: the equations of motion, eliminated in an order that is good where the mechanism is assembled.
//!
//! ```text
//! J u̇ = γ              solved for dependent accelerations, block by block
//! u̇ = N a + p          (Nᵀ M N) a = −Nᵀ (f + M p), by L D Lᵀ
//! ```
//!
//! The determinants of the blocks are compared with their rows while they are used: where one becomes too small, the runtime eliminates in
//! another order.

use super::MotionRow;
use super::cofactors::Cofactors;
use super::order::PivotBlock;
use super::trust::Trust;
use crate::expr::{Arena, Expr, Unary};
use std::collections::BTreeMap;

/// Accelerations, and the checks of their computation.
#[derive(Clone, Debug)]
pub struct Accelerations {
    /// u̇, by integrated speed.
    pub values: Vec<Expr>,
    /// Sizes of pivots and determinants of J, then pivots of the mass matrix, each with the number that it has to exceed.
    pub checks: Vec<[Expr; 2]>,
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
    pivots: Vec<(PivotBlock, Cofactors)>,
    trust: Trust,
    /// Sum of the sizes of each row's entries before elimination.
    before: Vec<Expr>,
    /// If joints are redundant: the natural size of each row. A row may vanish on the way, so that its own size is no measure.
    in_general: Vec<Expr>,
}

/// A row of which less than one part in so many is left depends on the others.
const LEFT: i64 = 1 << 30;

/// Solves the equations of motion.
///
/// * `order`: given, blocks of rows of J and of the columns that they are solved for.
/// * `lengths`: given, for each speed the number that makes it comparable with the others, as an expression.
/// * `trust`: given, how small pivots may be.
/// * `in_general`: given, if joints are redundant, the natural size of each row.
pub(super) fn accelerations(
    arena: &mut Arena,
    (rows, mass, forces): (&[MotionRow], &[Expr], &[Expr]),
    order: &[PivotBlock],
    lengths: &[Expr],
    (trust, in_general): (Trust, Vec<Expr>),
) -> Accelerations {
    let zero = arena.integer(0);
    let count = forces.len();
    let matrix: Vec<Vec<Expr>> = rows.iter().map(|row| row.jacobian.clone()).collect();
    let mut work = SparseRows::new(arena, &matrix, rows.iter().map(|row| row.gamma).collect(), lengths, trust);
    work.in_general = in_general;
    let pivots: Vec<[Expr; 2]> = order.iter().flat_map(|block| work.eliminate(block, lengths)).collect();
    let is_dependent = |column: &usize| order.iter().any(|block| block.columns.contains(column));
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
    let mut checks: Vec<[Expr; 2]> = pivots.into_iter().map(|[pivot, least]| [arena.unary(Unary::Abs, pivot), least]).collect();
    checks.extend(masses);
    Accelerations { values, checks }
}

impl<'a> SparseRows<'a> {
    /// Rows of a matrix with their right-hand sides.
    ///
    /// * `lengths`: given, for each column the number that makes it comparable with the others, as an expression.
    /// * `trust`: given, how small pivots may be.
    pub(super) fn new(arena: &'a mut Arena, matrix: &[Vec<Expr>], sides: Vec<Expr>, lengths: &[Expr], trust: Trust) -> SparseRows<'a> {
        let zero = arena.integer(0);
        let entries = |row: &Vec<Expr>| row.iter().copied().enumerate().filter(|(_, entry)| *entry != zero).collect();
        let entries = matrix.iter().map(entries).collect();
        let mut work = SparseRows { arena, entries, sides, pivots: Vec::new(), trust, before: Vec::new(), in_general: Vec::new() };
        work.before = (0..matrix.len()).map(|row| work.size(row, lengths)).collect();
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

    /// The sum of a row's sizes, and a small part of the sum before elimination, beside which it must not vanish.
    fn judged(&mut self, row: usize, lengths: &[Expr]) -> Expr {
        let (size, before) = (self.size(row, lengths), self.before[row]);
        if let Some(in_general) = self.in_general.get(row) {
            return self.arena.add(size, *in_general);
        }
        if size == before {
            return size;
        }
        let left = self.arena.integer(LEFT / self.trust.first);
        let least = self.arena.div(before, left);
        self.arena.add(size, least)
    }

    /// Eliminates the columns of a block from the rows that are left. Returns the checked numbers, each with the number that its size has to
    /// exceed: the determinant, or the entries themselves if each row and column has only one. A constant block whose columns occur in no other
    /// row that is left needs no check.
    pub(super) fn eliminate(&mut self, block: &PivotBlock, lengths: &[Expr]) -> Vec<[Expr; 2]> {
        let PivotBlock { rows, columns } = block;
        let zero = self.arena.integer(0);
        let entry = |row: &usize, column: &usize| self.entries[*row].get(column).copied().unwrap_or(zero);
        let matrix: Vec<Vec<Expr>> = rows.iter().map(|row| columns.iter().map(|column| entry(row, column)).collect()).collect();
        let cofactors = Cofactors::new(self.arena, &matrix);
        let is_left = |row: &usize| !rows.contains(row) && !self.pivots.iter().any(|(done, _)| done.rows.contains(row));
        let is_alone =
            !(0..self.entries.len()).filter(is_left).any(|row| columns.iter().any(|column| self.entries[row].contains_key(column)));
        let is_constant = matrix.iter().flatten().all(|entry| self.arena.as_constant(*entry).is_some());
        let checks = match single_entries(&matrix, zero) {
            _ if is_alone && is_constant => Vec::new(),
            Some(places) => {
                let pivot =
                    |(at, place): (usize, usize)| self.checked(matrix[at][place], (&rows[at..=at], &columns[place..=place]), lengths);
                places.into_iter().enumerate().map(pivot).collect()
            }
            None => vec![self.checked(cofactors.determinant, (rows, columns), lengths)],
        };
        self.pivots.push((block.clone(), cofactors));
        for other in 0..self.entries.len() {
            if !self.pivots.iter().any(|(done, _)| done.rows.contains(&other)) {
                self.reduce(other);
            }
        }
        checks
    }

    /// The determinant of some rows and columns in comparable units, and the number that its size has to exceed.
    fn checked(&mut self, determinant: Expr, (rows, columns): (&[usize], &[usize]), lengths: &[Expr]) -> [Expr; 2] {
        let (mut scaled, mut least) = (determinant, self.arena.integer(1));
        for (row, column) in rows.iter().zip(columns) {
            scaled = self.arena.mul(scaled, lengths[*column]);
            let size = self.judged(*row, lengths);
            least = self.arena.mul(least, size);
        }
        let trusted = self.arena.integer(self.trust.of(rows.len()));
        [scaled, self.arena.div(least, trusted)]
    }

    /// Subtracts multiples of the rows of the last block from a row, so that the columns of the block vanish from it.
    fn reduce(&mut self, other: usize) {
        let Some((PivotBlock { rows, columns }, cofactors)) = self.pivots.last() else { return };
        let zero = self.arena.integer(0);
        let entries: Vec<Option<Expr>> = columns.iter().map(|column| self.entries[other].remove(column)).collect();
        if entries.iter().all(Option::is_none) {
            return;
        }
        let entries: Vec<Expr> = entries.into_iter().map(|entry| entry.unwrap_or(zero)).collect();
        let factors = cofactors.solve_transposed(self.arena, &entries);
        for (row, factor) in rows.iter().zip(factors) {
            let factor = self.arena.neg(factor);
            let own: Vec<(usize, Expr)> = self.entries[*row].iter().map(|(at, entry)| (*at, *entry)).collect();
            for (at, entry) in own.into_iter().filter(|(at, _)| !columns.contains(at)) {
                let sum = self.entries[other].entry(at).or_insert(zero);
                add_product(self.arena, sum, factor, entry);
            }
            let side = self.sides[*row];
            add_product(self.arena, &mut self.sides[other], factor, side);
        }
    }

    /// `None`: the unknowns for the right-hand sides, with independent ones zero; `Some(k)`: those without right-hand sides, u_k = 1.
    pub(super) fn solution(&mut self, unit: Option<usize>, count: usize) -> Vec<Expr> {
        let (zero, one) = (self.arena.integer(0), self.arena.integer(1));
        let mut unknowns = vec![zero; count];
        if let Some(unit) = unit {
            unknowns[unit] = one;
        }
        for (PivotBlock { rows, columns }, cofactors) in self.pivots.iter().rev() {
            let mut sides = Vec::new();
            for row in rows {
                let mut sum = if unit.is_none() { self.sides[*row] } else { zero };
                for (at, entry) in self.entries[*row].iter().filter(|(at, _)| !columns.contains(at)) {
                    let entry = self.arena.neg(*entry);
                    add_product(self.arena, &mut sum, entry, unknowns[*at]);
                }
                sides.push(sum);
            }
            let found = cofactors.solve(self.arena, &sides);
            columns.iter().zip(found).for_each(|(column, value)| unknowns[*column] = value);
        }
        unknowns
    }
}

/// The column of the only entry in each row, if each column has one, too.
fn single_entries(matrix: &[Vec<Expr>], zero: Expr) -> Option<Vec<usize>> {
    let mut places = Vec::new();
    for row in matrix {
        let mut filled = (0..row.len()).filter(|column| row[*column] != zero);
        let place = filled.next().filter(|place| !places.contains(place))?;
        places.push(place);
        if filled.next().is_some() {
            return None;
        }
    }
    Some(places)
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
