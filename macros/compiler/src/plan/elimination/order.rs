//! Order of pivots: among those that are large enough, entries ±1 first, then those with the least fill-in.
//!
//! Reference: Duff, Erisman, Reid, Direct Methods for Sparse Matrices, 7.2 (Markowitz count) and 7.8 (threshold pivoting). The threshold
//! applies to the quantity that the run time monitors: the growth of each row of |L| |U| relative to the row of the matrix.

use std::collections::BTreeSet;

/// An entry that is not always zero.
#[derive(Clone, Debug)]
pub(super) struct PivotCandidate {
    /// Row and column.
    pub(super) place: (usize, usize),
    /// Its value at each pose, multiplied by the scale of the unknown; NaN if unknown.
    pub(super) values: Vec<f64>,
    /// True if it is the constant 1 or −1.
    pub(super) is_unit: bool,
}

/// One step of elimination.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Pivot {
    /// Row and column.
    pub(super) place: (usize, usize),
    /// True if it is still 1 or −1 when it is used.
    pub(super) is_unit: bool,
}

/// Classes of growth: pivots in one class count as equally accurate. Growth above the last limit is bad, but better than no pivot.
const GROWTHS: [f64; 3] = [8.0, 64.0, 1024.0];

/// Chooses a pivot for each row and column.
pub(super) fn in_order(size: usize, entries: &[PivotCandidate]) -> Vec<Pivot> {
    let mut work = RemainingMatrix::new(size, entries);
    (0..size).map(|_| work.step()).collect()
}

/// A candidate for the next pivot.
struct Candidate {
    /// Class of growth, true unless a unit, Markowitz count: the least is the best.
    rank: (usize, bool, usize),
    growth: f64,
    place: (usize, usize),
}

impl Candidate {
    /// Ties are broken by growth, then by position in the matrix.
    fn is_better_than(&self, other: &Self) -> bool {
        self.rank.cmp(&other.rank).then(self.growth.total_cmp(&other.growth)).then(self.place.cmp(&other.place)).is_lt()
    }
}

struct RemainingMatrix {
    /// Rows not yet eliminated.
    rows: BTreeSet<usize>,
    columns: BTreeSet<usize>,
    /// Entries by row and column; `None`: zero.
    entries: Vec<Vec<Option<PivotCandidate>>>,
    /// Sum of magnitudes of each row of the original matrix, by pose.
    sizes: Vec<Vec<f64>>,
}

impl RemainingMatrix {
    fn new(size: usize, entries: &[PivotCandidate]) -> RemainingMatrix {
        let poses = entries.iter().map(|entry| entry.values.len()).max().unwrap_or(0);
        let mut work = RemainingMatrix {
            rows: (0..size).collect(),
            columns: (0..size).collect(),
            entries: vec![vec![None; size]; size],
            sizes: vec![vec![0.0; poses]; size],
        };
        for entry in entries {
            let (row, column) = entry.place;
            work.sizes[row].iter_mut().zip(&entry.values).for_each(|(sum, value)| *sum += value.abs());
            work.entries[row][column] = Some(entry.clone());
        }
        work
    }

    /// Chooses the next pivot and eliminates its column.
    fn step(&mut self) -> Pivot {
        let place = self.best().unwrap_or_else(|| {
            // The remaining matrix is zero: the block is singular at every pose, which is reported elsewhere.
            (self.rows.first().copied().unwrap_or(0), self.columns.first().copied().unwrap_or(0))
        });
        let is_unit = self.entries[place.0][place.1].as_ref().is_some_and(|entry| entry.is_unit);
        self.rows.remove(&place.0);
        self.columns.remove(&place.1);
        self.eliminate(place);
        Pivot { place, is_unit }
    }

    fn best(&self) -> Option<(usize, usize)> {
        let count = |row: usize| self.columns.iter().filter(|column| self.entries[row][**column].is_some()).count();
        let of_row: Vec<usize> = (0..self.entries.len()).map(count).collect();
        let mut best: Option<Candidate> = None;
        for &column in &self.columns {
            let holders: Vec<usize> = self.rows.iter().copied().filter(|row| self.entries[*row][column].is_some()).collect();
            for &row in &holders {
                let growth = self.growth(row, column, &holders);
                let class = GROWTHS.iter().position(|limit| growth <= *limit).unwrap_or(GROWTHS.len());
                let is_unit = self.entries[row][column].as_ref().is_some_and(|entry| entry.is_unit);
                let fill = (of_row[row] - 1) * (holders.len() - 1);
                let candidate = Candidate { rank: (class, !is_unit, fill), growth, place: (row, column) };
                if best.as_ref().is_none_or(|best| candidate.is_better_than(best)) {
                    best = Some(candidate);
                }
            }
        }
        best.map(|best| best.place)
    }

    /// Growth of the worst row of |L| |U| by this pivot, relative to its row sum, at the worst pose.
    fn growth(&self, row: usize, column: usize, holders: &[usize]) -> f64 {
        let Some(pivot) = &self.entries[row][column] else { return f64::INFINITY };
        let mut worst: f64 = 1.0;
        for (pose, value) in pivot.values.iter().enumerate() {
            let of_pose = |column: &usize| self.entries[row][*column].as_ref().map_or(0.0, |entry| entry.values[pose].abs());
            let length: f64 = self.columns.iter().map(of_pose).sum();
            for other in holders.iter().filter(|other| **other != row) {
                let Some(entry) = &self.entries[*other][column] else { continue };
                let growth = (entry.values[pose] / value).abs() * length / self.sizes[*other][pose];
                // NaN, from an unknown pivot or a zero row, is ignored.
                if growth > worst {
                    worst = growth;
                }
            }
        }
        worst
    }

    fn eliminate(&mut self, (row, column): (usize, usize)) {
        let Some(pivot) = self.entries[row][column].clone() else { return };
        let above: Vec<PivotCandidate> = self.columns.iter().filter_map(|column| self.entries[row][*column].clone()).collect();
        for &other in &self.rows {
            let Some(below) = self.entries[other][column].clone() else { continue };
            for source in &above {
                let entry = &mut self.entries[other][source.place.1];
                let old = entry.take().map(|entry| entry.values);
                let change = |pose: usize| below.values[pose] / pivot.values[pose] * source.values[pose];
                let value = |pose: usize| old.as_ref().map_or(0.0, |values| values[pose]) - change(pose);
                *entry = Some(PivotCandidate {
                    place: (other, source.place.1),
                    values: (0..source.values.len()).map(value).collect(),
                    is_unit: false,
                });
            }
        }
    }
}
