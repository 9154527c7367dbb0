//! Sparsity pattern of a Jacobian.

use std::collections::BTreeSet;

/// Sparsity pattern of Φ_q, by rows.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Pattern {
    /// Number of unknowns.
    pub unknowns: usize,
    /// The entries of each row.
    pub rows: Vec<Vec<Entry>>,
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
        Pattern { unknowns: self.unknowns, rows: order.iter().map(|row| self.rows[*row].clone()).collect() }
    }

    /// The pattern with some rows left empty.
    pub(crate) fn without(&self, rows: &BTreeSet<usize>) -> Pattern {
        let row = |(number, row): (usize, &Vec<Entry>)| if rows.contains(&number) { Vec::new() } else { row.clone() };
        Pattern { unknowns: self.unknowns, rows: self.rows.iter().enumerate().map(row).collect() }
    }
}
