//! The order in which the rows of J are eliminated.
//!
//! In: the numbers of J where the mechanism is assembled. Out: blocks of rows, each with as many columns that are solved for. The rows of
//! one joint are taken together, up to three: the determinant of such a block vanishes only where its bodies are in a singular pose, single
//! entries vanish in ordinary ones.

use super::cofactors::BY_COFACTORS;
use super::trust::Trust;
use crate::linear::dense;

/// A pivot or a determinant has at least this fraction of the largest one in its rows, so that it stays trusted for long.
const STEADY: f64 = 0.2;

/// Rows for one vector are taken together if there are no more.
const MOST_OF_TRIPLE: usize = 6;

/// Rows that are solved together for as many columns.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct PivotBlock {
    pub(super) rows: Vec<usize>,
    pub(super) columns: Vec<usize>,
}

/// Rank of a block; the least comes first.
///
/// 1. Single pivots are taken last, unless they are alone in their rows.
/// 2. Grouping of freedoms stay independent where possible: declared freedoms are those that determine the motion well.
/// 3. Fill-in.
/// 4. The number of rows.
type Rank = (bool, usize, usize, usize);

/// What is known of rows and columns.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grouping<'a> {
    /// Joint of each row.
    pub(super) joints: &'a [usize],
    /// Grouping that are better not solved for.
    pub(super) freedoms: &'a [usize],
    /// Speeds of a body's origin, or its angular velocity: rows for one such vector may be taken together.
    pub(super) triples: &'a [[usize; 3]],
}

/// Rows that are not eliminated yet.
pub(super) struct OpenRows<'a> {
    numbers: Vec<Vec<f64>>,
    /// True for entries that do not always vanish.
    filled: Vec<Vec<bool>>,
    columns: Grouping<'a>,
    trust: Trust,
    open: Vec<usize>,
    free: Vec<usize>,
}

impl<'a> OpenRows<'a> {
    /// All rows.
    ///
    /// * `numbers`: given, J where the mechanism is assembled, in comparable units.
    /// * `is_zero`: given, true for an entry that always vanishes.
    /// * `trust`: given, how small determinants may be at run time.
    pub(super) fn new(numbers: &[Vec<f64>], is_zero: impl Fn(usize, usize) -> bool, columns: Grouping<'a>, trust: Trust) -> OpenRows<'a> {
        let count = numbers.first().map_or(0, Vec::len);
        OpenRows {
            numbers: numbers.to_vec(),
            filled: (0..numbers.len()).map(|row| (0..count).map(|column| !is_zero(row, column)).collect()).collect(),
            columns,
            trust,
            open: (0..numbers.len()).collect(),
            free: (0..count).collect(),
        }
    }

    /// Blocks of all rows: among those that are steady the first by their ranks. `None` if rows depend on each other.
    pub(super) fn order(mut self) -> Option<Vec<PivotBlock>> {
        let mut blocks = Vec::new();
        while !self.open.is_empty() {
            let (_, block) = self.groups().iter().flat_map(|rows| self.candidates(rows)).min()?;
            self.eliminate(&block)?;
            blocks.push(block);
        }
        Some(blocks)
    }

    /// Rows that may be taken together.
    fn groups(&self) -> Vec<Vec<usize>> {
        let mut groups: Vec<Vec<usize>> = self.open.iter().map(|row| vec![*row]).collect();
        for (at, row) in self.open.iter().enumerate() {
            let is_of_joint = |other: &&usize| self.columns.joints[**other] == self.columns.joints[*row];
            if !self.open[..at].iter().any(|other| is_of_joint(&other)) {
                let rows: Vec<usize> = self.open.iter().filter(is_of_joint).copied().collect();
                if (2..=BY_COFACTORS).contains(&rows.len()) {
                    groups.push(rows);
                }
            }
        }
        for triple in self.columns.triples {
            let rows: Vec<usize> = self.open.iter().copied().filter(|row| triple.iter().any(|column| self.filled[*row][*column])).collect();
            if rows.len() <= MOST_OF_TRIPLE {
                groups.extend((2..=BY_COFACTORS).flat_map(|count| choices(&rows, count)));
            }
        }
        groups.sort_unstable();
        groups.dedup();
        groups
    }

    /// Grouping for which rows can be solved, with the rank of each choice.
    fn candidates(&self, rows: &[usize]) -> Vec<(Rank, PivotBlock)> {
        let held: Vec<usize> = self.free.iter().copied().filter(|column| rows.iter().any(|row| self.filled[*row][*column])).collect();
        let choices: Vec<(f64, Vec<usize>)> =
            choices(&held, rows.len()).into_iter().map(|columns| (self.determinant(rows, &columns).abs(), columns)).collect();
        let largest = choices.iter().map(|(size, _)| *size).fold(0.0, f64::max);
        let sum = |row: &usize| held.iter().map(|column| self.numbers[*row][*column].abs()).sum::<f64>();
        // Twice the bound: a smaller determinant would soon fall below it.
        let least = if rows.len() == 1 { 0.0 } else { 2.0 * rows.iter().map(sum).product::<f64>() / self.trust.of(rows.len()) as f64 };
        let is_steady = |size: f64| size >= STEADY * largest && size > least;
        let rank = |columns: &[usize]| {
            let takes = |row: &&usize| columns.iter().any(|column| self.filled[**row][*column]);
            let below = self.open.iter().filter(|row| !rows.contains(row)).filter(takes).count();
            let beside = held.len() - columns.len();
            let of_freedoms = columns.iter().filter(|column| self.columns.freedoms.contains(column)).count();
            (rows.len() == 1 && beside > 0, of_freedoms, beside * below, rows.len())
        };
        let steady = choices.into_iter().filter(|(size, _)| is_steady(*size));
        steady.map(|(_, columns)| (rank(&columns), PivotBlock { rows: rows.to_vec(), columns })).collect()
    }

    fn block(&self, rows: &[usize], columns: &[usize]) -> Vec<Vec<f64>> {
        rows.iter().map(|row| columns.iter().map(|column| self.numbers[*row][*column]).collect()).collect()
    }

    fn determinant(&self, rows: &[usize], columns: &[usize]) -> f64 {
        let Some((first, rest)) = rows.split_first() else { return 1.0 };
        let term = |at: usize| {
            let others: Vec<usize> = columns.iter().copied().filter(|column| *column != columns[at]).collect();
            let sign = if at.is_multiple_of(2) { 1.0 } else { -1.0 };
            sign * self.numbers[*first][columns[at]] * self.determinant(rest, &others)
        };
        (0..columns.len()).map(term).sum()
    }

    /// Eliminates the columns of a block from the rows that are left; `None` if the block is singular.
    fn eliminate(&mut self, block: &PivotBlock) -> Option<()> {
        let PivotBlock { rows, columns } = block;
        self.open.retain(|row| !rows.contains(row));
        self.free.retain(|column| !columns.contains(column));
        let matrix = self.block(rows, columns);
        let transposed: Vec<Vec<f64>> = (0..rows.len()).map(|k| matrix.iter().map(|row| row[k]).collect()).collect();
        let open = self.open.clone();
        for other in open.into_iter().filter(|other| columns.iter().any(|column| self.filled[*other][*column])).collect::<Vec<_>>() {
            let factors = dense::solve(transposed.clone(), &self.block(&[other], columns)[0])?;
            for column in &self.free {
                for (row, factor) in rows.iter().zip(&factors) {
                    self.filled[other][*column] |= self.filled[*row][*column];
                    self.numbers[other][*column] -= factor * self.numbers[*row][*column];
                }
            }
        }
        Some(())
    }
}

/// All ways to take so many of some columns, each in ascending order.
fn choices(columns: &[usize], count: usize) -> Vec<Vec<usize>> {
    if count == 0 {
        return vec![Vec::new()];
    }
    let with = |at: usize| {
        let rest = choices(&columns[at + 1..], count - 1);
        rest.into_iter().map(move |rest| [vec![columns[at]], rest].concat()).collect::<Vec<_>>()
    };
    (0..columns.len()).flat_map(with).collect()
}
