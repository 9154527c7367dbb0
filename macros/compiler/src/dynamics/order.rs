//! The order in which the rows of J are eliminated.
//!
//! In: the numbers of J where the mechanism is assembled. Out: blocks of rows, each with as many columns that are solved for. The rows of
//! one joint are taken together, up to three: the determinant of such a block vanishes only where its bodies are in a singular pose, single
//! entries vanish in ordinary ones. Of bodies that are free to turn, blocks that are good in other orientations too come first.

use super::cofactors::BY_COFACTORS;
use super::trust::Trust;
use crate::linear::dense;
use std::collections::BTreeMap;

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
/// 2. Columns of freedoms stay independent where possible: declared freedoms are those that determine the motion well.
/// 3. Fill-in.
/// 4. The number of rows.
type Rank = (bool, usize, usize, usize);

/// What is known of rows and columns.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grouping<'a> {
    /// Joint of each row.
    pub(super) joints: &'a [usize],
    /// Columns that are better not solved for.
    pub(super) freedoms: &'a [usize],
    /// Speeds of a body's origin, or its angular velocity: rows for one such vector may be taken together.
    pub(super) triples: &'a [[usize; 3]],
}

/// Rows that are not eliminated yet.
pub(super) struct OpenRows<'a> {
    numbers: Vec<Vec<f64>>,
    /// J in other poses.
    elsewhere: Vec<Vec<Vec<f64>>>,
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
            elsewhere: Vec::new(),
            filled: (0..numbers.len()).map(|row| (0..count).map(|column| !is_zero(row, column)).collect()).collect(),
            columns,
            trust,
            open: (0..numbers.len()).collect(),
            free: (0..count).collect(),
        }
    }

    /// The same, preferring blocks that are steady in other poses, too.
    pub(super) fn also_in(self, elsewhere: Vec<Vec<Vec<f64>>>) -> OpenRows<'a> {
        OpenRows { elsewhere, ..self }
    }

    /// Blocks of all rows: among those that are steady the first by their ranks. `None` if rows depend on each other.
    pub(super) fn order(mut self) -> Option<Vec<PivotBlock>> {
        let mut blocks = Vec::new();
        while !self.open.is_empty() {
            let mut candidates: Vec<(Rank, PivotBlock)> = self.groups().iter().flat_map(|rows| self.candidates(rows)).collect();
            candidates.sort_unstable();
            // Columns that are steady in all other poses, by rows.
            let mut steady: BTreeMap<Vec<usize>, Vec<Vec<usize>>> = BTreeMap::new();
            let mut is_steady = |block: &PivotBlock| {
                let known = steady.entry(block.rows.clone()).or_insert_with(|| self.steady_elsewhere(&block.rows));
                known.contains(&block.columns)
            };
            let (_, block) = candidates.iter().find(|(_, block)| is_steady(block)).or_else(|| candidates.first())?.clone();
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

    /// Columns for which rows can be solved, with the rank of each choice.
    fn candidates(&self, rows: &[usize]) -> Vec<(Rank, PivotBlock)> {
        let held = self.held(rows);
        let rank = |columns: &[usize]| {
            let takes = |row: &&usize| columns.iter().any(|column| self.filled[**row][*column]);
            let below = self.open.iter().filter(|row| !rows.contains(row)).filter(takes).count();
            let beside = held.len() - columns.len();
            let of_freedoms = columns.iter().filter(|column| self.columns.freedoms.contains(column)).count();
            (rows.len() == 1 && beside > 0, of_freedoms, beside * below, rows.len())
        };
        let steady = self.steady(rows, &self.numbers).into_iter();
        steady.map(|columns| (rank(&columns), PivotBlock { rows: rows.to_vec(), columns })).collect()
    }

    /// Columns that rows hold.
    fn held(&self, rows: &[usize]) -> Vec<usize> {
        self.free.iter().copied().filter(|column| rows.iter().any(|row| self.filled[*row][*column])).collect()
    }

    /// Columns for which rows can be solved in a pose.
    fn steady(&self, rows: &[usize], numbers: &[Vec<f64>]) -> Vec<Vec<usize>> {
        let held = self.held(rows);
        let choices: Vec<(f64, Vec<usize>)> =
            choices(&held, rows.len()).into_iter().map(|columns| (determinant(numbers, rows, &columns).abs(), columns)).collect();
        let largest = choices.iter().map(|(size, _)| *size).fold(0.0, f64::max);
        let sum = |row: &usize| held.iter().map(|column| numbers[*row][*column].abs()).sum::<f64>();
        // Twice the bound: a smaller determinant would soon fall below it.
        let least = if rows.len() == 1 { 0.0 } else { 2.0 * rows.iter().map(sum).product::<f64>() / self.trust.of(rows.len()) as f64 };
        choices.into_iter().filter(|(size, _)| *size >= STEADY * largest && *size > least).map(|(_, columns)| columns).collect()
    }

    /// Columns for which rows can be solved in all other poses; all choices if there are no other poses.
    fn steady_elsewhere(&self, rows: &[usize]) -> Vec<Vec<usize>> {
        let all = choices(&self.held(rows), rows.len());
        self.elsewhere.iter().fold(all, |left, numbers| {
            let steady = self.steady(rows, numbers);
            left.into_iter().filter(|columns| steady.contains(columns)).collect()
        })
    }

    /// Eliminates the columns of a block from the rows that are left; `None` if the block is singular. Another pose in which it is singular is
    /// dropped.
    fn eliminate(&mut self, block: &PivotBlock) -> Option<()> {
        let PivotBlock { rows, columns } = block;
        self.open.retain(|row| !rows.contains(row));
        self.free.retain(|column| !columns.contains(column));
        let takes = |row: &usize| columns.iter().any(|column| self.filled[*row][*column]);
        let others: Vec<usize> = self.open.iter().copied().filter(takes).collect();
        reduce(&mut self.numbers, block, (&others, &self.free))?;
        self.elsewhere.retain_mut(|numbers| reduce(numbers, block, (&others, &self.free)).is_some());
        for other in others {
            for column in &self.free {
                self.filled[other][*column] |= rows.iter().any(|row| self.filled[*row][*column]);
            }
        }
        Some(())
    }
}

/// Subtracts multiples of the rows of a block from other rows, so that the columns of the block vanish from them.
fn reduce(numbers: &mut [Vec<f64>], PivotBlock { rows, columns }: &PivotBlock, (others, free): (&[usize], &[usize])) -> Option<()> {
    let transposed: Vec<Vec<f64>> = columns.iter().map(|column| rows.iter().map(|row| numbers[*row][*column]).collect()).collect();
    for other in others {
        let right: Vec<f64> = columns.iter().map(|column| numbers[*other][*column]).collect();
        let factors = dense::solve(transposed.clone(), &right)?;
        for column in free {
            for (row, factor) in rows.iter().zip(&factors) {
                numbers[*other][*column] -= factor * numbers[*row][*column];
            }
        }
    }
    Some(())
}

fn determinant(numbers: &[Vec<f64>], rows: &[usize], columns: &[usize]) -> f64 {
    let Some((first, rest)) = rows.split_first() else { return 1.0 };
    let term = |at: usize| {
        let others: Vec<usize> = columns.iter().copied().filter(|column| *column != columns[at]).collect();
        let sign = if at.is_multiple_of(2) { 1.0 } else { -1.0 };
        sign * numbers[*first][columns[at]] * determinant(numbers, rest, &others)
    };
    (0..columns.len()).map(term).sum()
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
