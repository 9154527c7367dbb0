//! Rows that follow from other rows or contradict them, whatever the configuration: found in exact arithmetic.
//!
//! A row is read as a sum of multiples of terms: coordinates, and whatever else stands in it as a whole, such as `r cos φ`. Terms
//! count as independent of one another, so that what depends here depends everywhere; what depends only because of sizes or shapes
//! is not seen here. Coefficients are exact, and where one does not fit its row is left alone: nothing is refused by rounding.
//!
//! Most rows have a term to themselves and cannot depend on others. They are peeled off first; what is left is small, and is
//! eliminated row by row.

use crate::expr::{Arena, Binary, Exact, Expr, Leaf, Node, Unary};
use std::collections::{BTreeMap, BTreeSet};

/// ExactElimination ends after as many sums: it is for loops of gears and the like, not for what fills up.
const MOST_SUMS: usize = 200_000;

/// Σ cᵢ termᵢ
type Terms = BTreeMap<Expr, Exact>;

/// A row as a sum.
#[derive(Clone, Debug)]
pub(super) struct Sum {
    /// Terms that depend on coordinates.
    pub(super) moving: Terms,
    /// Terms of parameters and time alone.
    pub(super) fixed: Terms,
    /// The rest; multiples of different powers of π are not added up, and make the sum unknown.
    pub(super) constant: Exact,
}

/// A row that is a combination of others, but for what is left over.
#[derive(Clone, Debug)]
pub(super) struct Dependent {
    pub(super) row: usize,
    /// The rows before it that it is a combination of.
    pub(super) others: BTreeSet<usize>,
    /// The row as it stands.
    pub(super) whole: Sum,
    /// What is left of it where the others hold; without moving terms.
    pub(super) left: Sum,
}

/// The rows that depend on rows before them. `rows`: given, residuals with their numbers, those that are to blame last.
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

/// Which expressions depend on coordinates.
fn moving(arena: &Arena) -> Vec<bool> {
    let mut is_moving: Vec<bool> = Vec::with_capacity(arena.len());
    for expr in arena.all() {
        let node = arena.node(expr);
        let moves = matches!(node, Node::Leaf(Leaf::Coordinate(_))) || node.children().any(|child| is_moving[child.index()]);
        is_moving.push(moves);
    }
    is_moving
}

/// The rows of which every term stands in another one too; the others cannot be part of a combination that vanishes.
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

/// A row while it is reduced.
struct ReducedRow {
    sum: Sum,
    /// The multiples of rows that it is the sum of.
    made_of: BTreeMap<usize, Exact>,
}

/// Rows that do not depend on each other, each with a term that no later one has.
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

    /// A row without the terms of those that are kept; none where a coefficient does not fit.
    fn reduced(&mut self, row: usize, sum: Sum) -> Option<ReducedRow> {
        let mut work = ReducedRow { sum, made_of: [(row, Exact::ONE)].into() };
        // A kept row has no terms of those before it: taken in their order, each is needed once.
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
    /// Reads an expression as a sum.
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

    /// Nothing but perhaps a constant.
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

/// sum + factor · other; none where a coefficient does not fit.
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
