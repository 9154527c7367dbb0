//! Rows that depend on other rows or contradict them at every configuration, found in exact arithmetic.
//!
//! A row is read as a linear combination of terms: coordinates, and nonlinear terms such as `r cos φ` as a whole. Terms count as
//! independent of one another, so that a dependence found here holds everywhere; one that holds only for certain dimensions or shapes is
//! not found here. Coefficients are exact; a row with a coefficient that does not fit is skipped, so that rounding never refuses a row.
//!
//! Most rows have a term of their own and cannot depend on others. They are removed first; the few that remain are eliminated row by row.

use crate::expr::{Arena, Binary, Exact, Expr, Leaf, Node, Unary};
use std::collections::{BTreeMap, BTreeSet};

/// Limit on the number of additions: elimination is meant for loops of gears and the like, not for systems with much fill-in.
const MOST_SUMS: usize = 200_000;

/// Σ cᵢ termᵢ
type Terms = BTreeMap<Expr, Exact>;

/// A row as a linear combination.
#[derive(Clone, Debug)]
pub(super) struct Sum {
    /// Terms that depend on coordinates.
    pub(super) moving: Terms,
    /// Terms in parameters and time only.
    pub(super) fixed: Terms,
    /// Constant term. Constants with different powers of π cannot be added exactly; such a row is skipped.
    pub(super) constant: Exact,
}

/// A row that is a combination of others, up to a remainder.
#[derive(Clone, Debug)]
pub(super) struct Dependent {
    pub(super) row: usize,
    /// Earlier rows of which it is a combination.
    pub(super) others: BTreeSet<usize>,
    /// The original row.
    pub(super) whole: Sum,
    /// Remainder when the other rows hold; has no moving terms.
    pub(super) left: Sum,
}

/// Finds rows that depend on earlier rows. `rows`: given, residuals with their numbers, in the order of preference, so that the last are
/// blamed.
pub(super) fn dependent(arena: &Arena, rows: &[(usize, Expr)]) -> Vec<Dependent> {
    let is_moving = moving(arena);
    let sums = rows.iter().filter_map(|(row, phi)| Some((*row, Sum::of(arena, *phi, &is_moving)?)));
    let mut elimination = ExactElimination::default();
    let mut dependent = Vec::new();
    for (row, whole) in entangled(sums.collect()) {
        let Some(ReducedRow { sum: left, mut made_of }) = elimination.reduced(row, whole.clone()) else { continue };
        match left.moving.keys().next_back() {
            Some(term) => elimination.keep(*term, ReducedRow { sum: left, made_of }),
            None => {
                made_of.remove(&row);
                dependent.push(Dependent { row, others: made_of.into_keys().collect(), whole, left });
            }
        }
    }
    dependent
}

/// True for expressions that depend on coordinates.
fn moving(arena: &Arena) -> Vec<bool> {
    let mut is_moving: Vec<bool> = Vec::with_capacity(arena.len());
    for expr in arena.all() {
        let node = arena.node(expr);
        let moves = matches!(node, Node::Leaf(Leaf::Coordinate(_))) || node.children().any(|child| is_moving[child.index()]);
        is_moving.push(moves);
    }
    is_moving
}

/// Removes rows with a term that no other row has, repeatedly: they cannot be part of a vanishing combination.
fn entangled(rows: Vec<(usize, Sum)>) -> Vec<(usize, Sum)> {
    let mut holders: BTreeMap<Expr, BTreeSet<usize>> = BTreeMap::new();
    for (index, (_, sum)) in rows.iter().enumerate() {
        for term in sum.moving.keys() {
            holders.entry(*term).or_default().insert(index);
        }
    }
    let mut is_out = vec![false; rows.len()];
    let alone = |held: &BTreeSet<usize>| held.first().copied().filter(|_| held.len() == 1);
    let mut open: Vec<usize> = holders.values().filter_map(alone).collect();
    while let Some(index) = open.pop() {
        if std::mem::replace(&mut is_out[index], true) {
            continue;
        }
        for term in rows[index].1.moving.keys() {
            if let Some(held) = holders.get_mut(term) {
                held.remove(&index);
                open.extend(alone(held));
            }
        }
    }
    rows.into_iter().zip(is_out).filter(|(_, is_out)| !is_out).map(|(row, _)| row).collect()
}

/// A row during reduction.
struct ReducedRow {
    sum: Sum,
    /// Coefficients of the original rows of which it is the sum.
    made_of: BTreeMap<usize, Exact>,
}

/// Independent rows in echelon form: each has a pivot term that no later row contains.
#[derive(Default)]
struct ExactElimination {
    kept: Vec<(Expr, ReducedRow)>,
    of_term: BTreeMap<Expr, usize>,
    sums: usize,
}

impl ExactElimination {
    fn keep(&mut self, term: Expr, work: ReducedRow) {
        self.of_term.insert(term, self.kept.len());
        self.kept.push((term, work));
    }

    /// Eliminates the pivot terms of all kept rows from a row; `None` if a coefficient does not fit or the limit is reached.
    fn reduced(&mut self, row: usize, sum: Sum) -> Option<ReducedRow> {
        let mut work = ReducedRow { sum, made_of: [(row, Exact::ONE)].into() };
        // A kept row has no pivot terms of earlier rows: taken in this order, each is used at most once.
        while let Some(next) = work.sum.moving.keys().filter_map(|term| self.of_term.get(term)).min() {
            let (term, kept) = &self.kept[*next];
            let factor = work.sum.moving.get(term)?.checked_div(*kept.sum.moving.get(term)?)?.neg();
            self.sums += kept.sum.moving.len() + kept.made_of.len();
            if self.sums > MOST_SUMS {
                return None;
            }
            work.sum.add(&kept.sum, factor)?;
            add(&mut work.made_of, &kept.made_of, factor)?;
        }
        Some(work)
    }
}

impl Sum {
    /// Reads an expression as a linear combination; `None` if a coefficient does not fit.
    fn of(arena: &Arena, phi: Expr, is_moving: &[bool]) -> Option<Sum> {
        let mut sum = Sum { moving: Terms::new(), fixed: Terms::new(), constant: Exact::ZERO };
        let mut open = vec![(phi, Exact::ONE)];
        while let Some((expr, factor)) = open.pop() {
            let constant = |expr: Expr| arena.as_constant(expr);
            match *arena.node(expr) {
                Node::Constant(value) => sum.constant = sum.constant.checked_add(value.checked_mul(factor)?)?,
                Node::Unary(Unary::Neg, inner) => open.push((inner, factor.neg())),
                Node::Binary(Binary::Add, one, two) => open.extend([(one, factor), (two, factor)]),
                Node::Binary(Binary::Sub, one, two) => open.extend([(one, factor), (two, factor.neg())]),
                Node::Binary(Binary::Mul, one, two) if constant(one).is_some() => open.push((two, factor.checked_mul(constant(one)?)?)),
                Node::Binary(Binary::Mul, one, two) if constant(two).is_some() => open.push((one, factor.checked_mul(constant(two)?)?)),
                Node::Binary(Binary::Div, one, two) if constant(two).is_some() => open.push((one, factor.checked_div(constant(two)?)?)),
                _ => {
                    let terms = if is_moving[expr.index()] { &mut sum.moving } else { &mut sum.fixed };
                    add(terms, &[(expr, Exact::ONE)].into(), factor)?;
                }
            }
        }
        Some(sum)
    }

    /// True if the sum has no terms but a constant.
    pub(super) fn is_constant(&self) -> bool {
        self.moving.is_empty() && self.fixed.is_empty()
    }

    /// self + factor · other
    fn add(&mut self, other: &Sum, factor: Exact) -> Option<()> {
        add(&mut self.moving, &other.moving, factor)?;
        add(&mut self.fixed, &other.fixed, factor)?;
        self.constant = self.constant.checked_add(other.constant.checked_mul(factor)?)?;
        Some(())
    }
}

/// sum + factor · other; `None` if a coefficient does not fit.
fn add<K: Ord + Copy>(sum: &mut BTreeMap<K, Exact>, other: &BTreeMap<K, Exact>, factor: Exact) -> Option<()> {
    for (term, coefficient) in other {
        let before = sum.get(term).copied().unwrap_or(Exact::ZERO);
        let after = before.checked_add(coefficient.checked_mul(factor)?)?;
        if after.is_zero() {
            sum.remove(term)
        } else {
            sum.insert(*term, after)
        };
    }
    Some(())
}

#[cfg(test)]
mod tests;
