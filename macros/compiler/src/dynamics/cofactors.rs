//! Systems of up to three rows by Cramer's rule: one division, by the determinant.

use crate::expr::{Arena, Expr};

/// Systems of up to this many rows are solved by cofactors.
pub(super) const BY_COFACTORS: usize = 3;

/// Cofactors of a matrix A of up to three rows.
pub(super) struct Cofactors {
    /// det A
    pub(super) determinant: Expr,
    /// A⁻¹ det A, by column of A and row of A.
    adjugate: Vec<Vec<Expr>>,
    /// 1/det A
    inverse: Expr,
}

impl Cofactors {
    /// The cofactors of A, given row by row.
    pub(super) fn new(arena: &mut Arena, matrix: &[Vec<Expr>]) -> Cofactors {
        let count = matrix.len();
        let cofactor = |arena: &mut Arena, row: usize, column: usize| {
            let rest = |without: usize| (0..count).filter(move |k| *k != without).collect::<Vec<_>>();
            let minor = minor(arena, matrix, &rest(row), &rest(column));
            if (row + column).is_multiple_of(2) { minor } else { arena.neg(minor) }
        };
        let adjugate: Vec<Vec<Expr>> = (0..count).map(|column| (0..count).map(|row| cofactor(arena, row, column)).collect()).collect();
        let mut determinant = arena.integer(0);
        for (column, entry) in matrix[0].iter().enumerate() {
            let product = arena.mul(*entry, adjugate[column][0]);
            determinant = arena.add(determinant, product);
        }
        let one = arena.integer(1);
        let inverse = arena.div(one, determinant);
        Cofactors { determinant, adjugate, inverse }
    }

    /// A⁻¹ b
    pub(super) fn solve(&self, arena: &mut Arena, sides: &[Expr]) -> Vec<Expr> {
        self.adjugate.iter().map(|row| self.quotient(arena, row.iter().zip(sides))).collect()
    }

    /// bᵀ A⁻¹
    pub(super) fn solve_transposed(&self, arena: &mut Arena, sides: &[Expr]) -> Vec<Expr> {
        (0..sides.len()).map(|row| self.quotient(arena, self.adjugate.iter().map(|of_column| &of_column[row]).zip(sides))).collect()
    }

    /// A sum of products, over det A.
    fn quotient<'a>(&self, arena: &mut Arena, terms: impl Iterator<Item = (&'a Expr, &'a Expr)>) -> Expr {
        let mut sum = arena.integer(0);
        for (factor, side) in terms {
            let product = arena.mul(*factor, *side);
            sum = arena.add(sum, product);
        }
        arena.mul(sum, self.inverse)
    }
}

/// Determinant of up to two rows.
fn minor(arena: &mut Arena, matrix: &[Vec<Expr>], rows: &[usize], columns: &[usize]) -> Expr {
    match (rows, columns) {
        (&[row], &[column]) => matrix[row][column],
        (&[a, b], &[c, d]) => {
            let (left, right) = (arena.mul(matrix[a][c], matrix[b][d]), arena.mul(matrix[a][d], matrix[b][c]));
            arena.sub(left, right)
        }
        _ => arena.integer(1),
    }
}
