//! Which equation contains which unknown, and how.

use crate::expr::{Arena, Binary, Expr, Leaf, Node, Unary};
use crate::model::Model;
use crate::syntax::ast::Relation;
use crate::system::System;
use std::collections::BTreeSet;

/// The pattern of Φ_q by rows.
#[derive(Clone, Debug, Default)]
pub(super) struct Incidence {
    /// Number of unknowns.
    pub(super) unknowns: usize,
    /// The entries of each row.
    pub(super) rows: Vec<Vec<Entry>>,
}

/// One entry of Φ_q that is not identically zero.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry {
    pub(super) unknown: usize,
    /// A constant, or a product of parameters that are checked not to be zero.
    pub(super) is_pivot: bool,
}

impl Incidence {
    pub(super) fn new(model: &Model, system: &System) -> Incidence {
        let nonzero = nonzero_parameters(model, &system.arena);
        let entry = |(unknown, value): &(usize, Expr)| Entry { unknown: *unknown, is_pivot: is_pivot(&system.arena, *value, &nonzero) };
        let rows = system
            .equations
            .iter()
            .map(|equation| steady(equation.jacobian.iter().map(entry).collect(), &equation.jacobian, &system.arena));
        Incidence { unknowns: system.unknowns.len(), rows: rows.collect() }
    }

    /// The same rows in another order.
    pub(super) fn in_order(&self, order: &[usize]) -> Incidence {
        Incidence { unknowns: self.unknowns, rows: order.iter().map(|row| self.rows[*row].clone()).collect() }
    }

    /// The pattern with some rows set aside: nothing stands in them.
    pub(super) fn without(mut self, rows: &BTreeSet<usize>) -> Incidence {
        for row in rows {
            self.rows[*row].clear();
        }
        self
    }
}

/// A constant much smaller than the largest of its row would blow up rounding errors.
const WEAK: f64 = 0.1;

/// Takes the rank of a pivot from constants that are weak within their row.
fn steady(mut entries: Vec<Entry>, values: &[(usize, Expr)], arena: &Arena) -> Vec<Entry> {
    let size = |value: &Expr| arena.as_constant(*value).map_or(0.0, |value| value.to_f64().abs());
    let largest = values.iter().map(|(_, value)| size(value)).fold(0.0, f64::max);
    for (entry, (_, value)) in entries.iter_mut().zip(values) {
        if arena.as_constant(*value).is_some() && size(value) < WEAK * largest {
            entry.is_pivot = false;
        }
    }
    entries
}

/// Parameters of which a joint demands that they are not zero; `validate` checks them.
fn nonzero_parameters(model: &Model, arena: &Arena) -> BTreeSet<u32> {
    let of_requirement = |requirement: &crate::model::Requirement| {
        let Node::Leaf(Leaf::Parameter(number)) = arena.node(requirement.lhs) else { return None };
        let is_zero = arena.as_constant(requirement.rhs).is_some_and(|value| value.is_zero());
        let excludes_zero = matches!(requirement.relation, Relation::Different | Relation::Greater | Relation::Less);
        (is_zero && excludes_zero).then_some(*number)
    };
    model.requirements.iter().filter_map(of_requirement).collect()
}

/// Never zero, whatever the state: constants other than zero, such parameters, and their products.
fn is_pivot(arena: &Arena, value: Expr, nonzero: &BTreeSet<u32>) -> bool {
    let mut pivots = BTreeSet::new();
    for expr in arena.reachable(&[value]) {
        let holds = match arena.node(expr) {
            Node::Constant(value) => !value.is_zero(),
            Node::Leaf(Leaf::Parameter(number)) => nonzero.contains(number),
            Node::Unary(Unary::Neg, inner) => pivots.contains(inner),
            Node::Binary(Binary::Mul | Binary::Div, one, two) => pivots.contains(one) && pivots.contains(two),
            _ => false,
        };
        if holds {
            pivots.insert(expr);
        }
    }
    pivots.contains(&value)
}
