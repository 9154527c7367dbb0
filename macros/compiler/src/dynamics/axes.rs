//! Systems whose columns are the axes of a body in ground, each times a number: solved by the transpose, without a determinant.

use crate::expr::{Arena, Binary, Expr, Leaf, Node, Triple, Unary, dot};

/// The three axes of a body, as columns of a matrix.
pub(super) struct AxesOfBody {
    /// The number and the axis of each column.
    columns: [(Expr, Triple); 3],
}

/// An entry of a rotation matrix, its number among all of them, and its factor.
#[derive(Clone, Copy)]
struct Cosine {
    factor: Expr,
    entry: Expr,
    number: usize,
}

impl AxesOfBody {
    /// The columns of a matrix, if they are axes.
    ///
    /// * `first`: given, the number of the coordinate that is the first entry of the first rotation matrix.
    pub(super) fn find(arena: &mut Arena, matrix: &[Vec<Expr>], first: usize) -> Option<AxesOfBody> {
        let cosines: Option<Vec<Cosine>> = matrix.iter().flatten().map(|entry| cosine(arena, *entry, first)).collect();
        let cosines: [Cosine; 9] = cosines?.try_into().ok()?;
        let rows = [0, 1, 2].map(|row| cosines[3 * row].number / 3);
        let columns = [0, 1, 2].map(|column| cosines[column].number % 3);
        let fits = |(place, cosine): (usize, &Cosine)| {
            let (row, column) = (place / 3, place % 3);
            cosine.number == 3 * rows[row] + columns[column] && cosine.factor == cosines[column].factor
        };
        let is_every = |numbers: [usize; 3]| [0, 1, 2].iter().all(|number| numbers.contains(number));
        let is_of_one_body = rows.iter().all(|row| row / 3 == rows[0] / 3);
        let are_axes = is_of_one_body && is_every(rows.map(|row| row % 3)) && is_every(columns) && cosines.iter().enumerate().all(fits);
        let column = |column: usize| (cosines[column].factor, [0, 1, 2].map(|row| cosines[3 * row + column].entry));
        are_axes.then(|| AxesOfBody { columns: [0, 1, 2].map(column) })
    }

    /// A⁻¹ b
    pub(super) fn solve(&self, arena: &mut Arena, sides: &[Expr]) -> Vec<Expr> {
        let along = |(factor, axis): &(Expr, Triple)| {
            let along = dot(arena, *axis, [sides[0], sides[1], sides[2]]);
            arena.div(along, *factor)
        };
        self.columns.iter().map(along).collect()
    }
}

/// An expression as an entry of a rotation matrix times a number.
fn cosine(arena: &mut Arena, expr: Expr, first: usize) -> Option<Cosine> {
    let (factor, entry) = match *arena.node(expr) {
        Node::Unary(Unary::Neg, entry) => (arena.integer(-1), entry),
        Node::Binary(Binary::Mul, factor, entry) if arena.as_constant(factor).is_some_and(|value| !value.is_zero()) => (factor, entry),
        _ => (arena.integer(1), expr),
    };
    let Node::Leaf(Leaf::Coordinate(number)) = *arena.node(entry) else { return None };
    Some(Cosine { factor, entry, number: (number as usize).checked_sub(first)? })
}
