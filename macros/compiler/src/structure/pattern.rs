//! Sparsity pattern of a Jacobian.

use std::collections::BTreeSet;

/// Sparsity pattern of Φ_q, by rows.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Pattern {
    /// Number of unknowns.
    pub unknowns: usize,
    /// The entries of each row.
    pub rows: Vec<Vec<Entry>>,
    /// By row, unknowns on which the equation depends without having a derivative by them, as in a condition.
    pub read: Vec<Vec<usize>>,
}

/// One entry of Φ_q that is not identically zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Column.
    pub unknown: usize,
    /// True if the entry is nonzero in every configuration: the equation can be solved for the unknown.
    pub is_pivot: bool,
}

impl Pattern {
    /// The same rows in another order.
    pub(crate) fn in_order(&self, order: &[usize]) -> Pattern {
        let rows = order.iter().map(|row| self.rows[*row].clone()).collect();
        Pattern { unknowns: self.unknowns, rows, read: order.iter().map(|row| self.read_by(*row).to_vec()).collect() }
    }

    /// The pattern with some rows left empty.
    pub(crate) fn without(&self, rows: &BTreeSet<usize>) -> Pattern {
        let row = |(number, row): (usize, &Vec<Entry>)| if rows.contains(&number) { Vec::new() } else { row.clone() };
        let read = |number: usize| if rows.contains(&number) { Vec::new() } else { self.read_by(number).to_vec() };
        Pattern {
            unknowns: self.unknowns,
            rows: self.rows.iter().enumerate().map(row).collect(),
            read: (0..self.read.len()).map(read).collect(),
        }
    }

    /// All unknowns that have to be known or iterated where an equation is evaluated; those without a derivative are no pivots.
    pub(super) fn needed(&self, row: usize) -> impl Iterator<Item = Entry> + '_ {
        let read = self.read_by(row).iter().map(|unknown| Entry { unknown: *unknown, is_pivot: false });
        self.rows.get(row).into_iter().flatten().copied().chain(read)
    }

    fn read_by(&self, row: usize) -> &[usize] {
        self.read.get(row).map_or(&[], Vec::as_slice)
    }
}
