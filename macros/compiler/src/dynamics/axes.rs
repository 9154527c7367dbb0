//! Systems whose columns are the axes of a body in ground, each times a number: solved by the transpose, without a determinant.

use crate::expr::{Arena, Binary, Expr, Leaf, Node, Unary};
use crate::system::{COSINES, System, cosine};

/// The rotation matrices of bodies as a state holds them.
pub(super) struct Orientations {
    /// Number of the coordinate that is the first entry.
    first: usize,
    /// All entries, row by row: coordinates, and constants where they never change.
    entries: Vec<Expr>,
}

impl Orientations {
    /// Those of the bodies of a system in space.
    pub(super) fn of_state(arena: &mut Arena, system: &System) -> Orientations {
        let first = system.coordinates.len();
        let entry = |number: usize| {
            let value = arena.frame(system.frames[number / COSINES]).columns[number % 3][number % COSINES / 3];
            if arena.as_constant(value).is_some() { value } else { arena.leaf(Leaf::Coordinate((first + number) as u32)) }
        };
        let entries = (0..COSINES * system.frames.len()).map(entry).collect();
        Orientations { first, entries }
    }

    /// An expression as an entry times a number: the number, body, row and column.
    fn place(&self, arena: &mut Arena, expr: Expr) -> Option<(Expr, [usize; 3])> {
        let (factor, entry) = match *arena.node(expr) {
            Node::Unary(Unary::Neg, entry) => (arena.integer(-1), entry),
            Node::Binary(Binary::Mul, factor, entry) if arena.as_constant(factor).is_some_and(|value| !value.is_zero()) => (factor, entry),
            _ => (arena.integer(1), expr),
        };
        let Node::Leaf(Leaf::Coordinate(number)) = *arena.node(entry) else { return None };
        let number = (number as usize).checked_sub(self.first).filter(|number| *number < self.entries.len())?;
        Some((factor, [number / COSINES, number % COSINES / 3, number % 3]))
    }
}

/// True if the numbers are 0, 1 and 2.
fn is_every(numbers: [usize; 3]) -> bool {
    [0, 1, 2].iter().all(|number| numbers.contains(number))
}

/// Axes of a body, as columns of a matrix.
pub(super) struct AxesOfBody {
    /// The number and the axis of each column.
    columns: Vec<(Expr, Vec<Expr>)>,
}

impl AxesOfBody {
    /// The columns of a matrix, if they are axes: all three of a body, or the two across one that has the direction of an axis of ground.
    pub(super) fn find(arena: &mut Arena, matrix: &[Vec<Expr>], known: &Orientations) -> Option<AxesOfBody> {
        let place = |arena: &mut Arena, entry: &Expr| known.place(arena, *entry);
        let places: Vec<Vec<_>> = matrix.iter().map(|row| row.iter().map(|entry| place(arena, entry)).collect()).collect();
        let (_, [body, ..]) = places.iter().flatten().flatten().copied().next()?;
        let rows: Option<Vec<usize>> = places.iter().map(|row| row.iter().flatten().map(|(_, [_, row, _])| *row).next()).collect();
        let column = |column: usize| places.iter().find_map(|row| row[column]).map(|(factor, [.., axis])| (factor, axis));
        let columns: Option<Vec<(Expr, usize)>> = (0..matrix.len()).map(column).collect();
        let (rows, columns) = (rows?, columns?);
        let axes: Vec<usize> = columns.iter().map(|(_, axis)| *axis).collect();
        let entry = |row: usize, axis: usize| known.entries[cosine(body, row, axis)];
        let are_all = match [rows.as_slice(), axes.as_slice()] {
            [[i, j, k], [l, m, n]] => is_every([*i, *j, *k]) && is_every([*l, *m, *n]),
            [[i, j], [l, m]] if i != j && l != m => {
                let rest = entry(3 - i - j, 3 - l - m);
                arena.as_constant(rest).is_some_and(|value| value.to_f64().abs() == 1.0)
            }
            _ => false,
        };
        let columns = columns.into_iter().map(|(factor, axis)| (factor, rows.iter().map(|row| entry(*row, axis)).collect::<Vec<Expr>>()));
        let columns: Vec<(Expr, Vec<Expr>)> = columns.collect();
        let mut fits = |row: usize, column: usize| {
            let (factor, axis) = &columns[column];
            arena.mul(*factor, axis[row]) == matrix[row][column]
        };
        let are_axes = are_all && (0..rows.len()).all(|row| (0..rows.len()).all(|column| fits(row, column)));
        are_axes.then_some(AxesOfBody { columns })
    }

    /// A⁻¹ b
    pub(super) fn solve(&self, arena: &mut Arena, sides: &[Expr]) -> Vec<Expr> {
        let zero = arena.integer(0);
        let along = |(factor, axis): &(Expr, Vec<Expr>)| {
            let products = axis.iter().zip(sides).map(|(part, side)| arena.mul(*part, *side));
            let products: Vec<Expr> = products.filter(|product| *product != zero).collect();
            let along = arena.sum(&products);
            arena.div(along, *factor)
        };
        self.columns.iter().map(along).collect()
    }
}
