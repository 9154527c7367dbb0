//! Straight lines, or where they repeat, loops.
//!
//! In: what is to be computed, joint by joint. Out: [`Code`]: one routine if it is short, else one for each shape of joint.
//! Not done here: printing.

use super::routine::{Cost, Routine};
use super::schedule;
use super::shape::{Column, Piece, Shape, Tracer};
use super::words::Words;
use crate::expr::{Arena, Expr};

/// Up to this many operations, and as many results, straight lines are as quick to compile as loops, and read better.
pub(super) const STRAIGHT: usize = 1500;

/// How some results are computed.
#[derive(Clone, Debug)]
pub enum Code {
    /// All at once.
    Straight(Routine),
    /// Group by group; what is in no group is zero.
    Grouped(Vec<Group>),
}

/// Joints of the same shape.
#[derive(Clone, Debug)]
pub struct Group {
    /// What they have in common.
    pub shape: Shape,
    /// How one of them is computed.
    pub routine: Routine,
    /// Where each result goes.
    pub targets: Vec<Target<Column<u32>>>,
}

/// Where a result goes.
#[derive(Clone, Copy, Debug)]
pub enum Target<I> {
    /// To a place in a list.
    Row(I),
    /// To a row and a column of a matrix.
    Entry(I, I),
}

/// Results that belong together, each with its target.
pub(super) type Cell = Vec<(Target<u32>, Expr)>;

impl Code {
    /// The operations of all results.
    #[must_use]
    pub fn cost(&self) -> Cost {
        match self {
            Code::Straight(routine) => routine.cost,
            Code::Grouped(groups) => groups.iter().fold(Cost::default(), |sum, group| sum + group.routine.cost * group.shape.count),
        }
    }
}

/// Decides how some results are computed.
pub(super) fn code(arena: &Arena, tracer: &Tracer, cells: Vec<Cell>, words: &Words) -> Code {
    let results: Vec<Expr> = cells.iter().flatten().map(|(_, result)| *result).collect();
    if results.len() <= STRAIGHT && arena.reachable(&results).len() <= STRAIGHT {
        return Code::Straight(schedule::routine(arena, results, words));
    }
    let is_zero = |result: &Expr| arena.as_constant(*result).is_some_and(|value| value.is_zero());
    let cells: Vec<Cell> = cells
        .into_iter()
        .map(|cell| cell.into_iter().filter(|(_, result)| !is_zero(result)).collect())
        .filter(|cell: &Cell| !cell.is_empty())
        .collect();
    let pieces: Vec<Piece> = cells.iter().map(piece).collect();
    let (shapes, of_piece) = tracer.shapes(&pieces);
    let members = |number: usize| cells.iter().zip(&of_piece).filter(move |(_, of)| **of == number).map(|(cell, _)| cell);
    let group = |(number, shape): (usize, Shape)| {
        let routine = schedule::routine(&shape.arena, shape.results.clone(), &words.of_shape(&shape));
        let count = shape.results.len();
        Group { shape, routine, targets: (0..count).map(|result| target(members(number), result)).collect() }
    };
    Code::Grouped(shapes.into_iter().enumerate().map(group).collect())
}

fn piece(cell: &Cell) -> Piece {
    let tag = cell.iter().map(|(target, _)| u32::from(matches!(target, Target::Entry(..)))).collect();
    Piece { tag, first: Vec::new(), results: cell.iter().map(|(_, result)| *result).collect() }
}

/// Where the result of this number goes in each of some cells of the same shape.
fn target<'a>(cells: impl Iterator<Item = &'a Cell>, result: usize) -> Target<Column<u32>> {
    let targets: Vec<Target<u32>> = cells.map(|cell| cell[result].0).collect();
    let (first, second): (Vec<u32>, Vec<u32>) = targets
        .iter()
        .map(|target| match *target {
            Target::Row(row) => (row, 0),
            Target::Entry(row, column) => (row, column),
        })
        .unzip();
    match targets.first() {
        Some(Target::Entry(..)) => Target::Entry(Column::of(first), Column::of(second)),
        _ => Target::Row(Column::of(first)),
    }
}
