//! Sparsity pattern of Φ_q, with its pivots: the entries that are never zero.

use super::Equation;
use super::rows::coordinates_in;
use crate::expr::{Arena, Binary, Expr, Leaf, Node, Unary};
use crate::model::Model;
use crate::structure::{Entry, Pattern};
use crate::syntax::ast::Relation;
use std::collections::BTreeSet;

/// Sparsity pattern of these equations. Pivots are nonzero constants, and products of parameters that `validate` keeps nonzero.
pub(super) fn pattern(model: &Model, arena: &Arena, unknowns: usize, equations: &[Equation]) -> Pattern {
    let nonzero = nonzero_parameters(model, arena);
    let has_choices = has_choices(arena, equations);
    let row = |equation: &Equation| {
        let decides = if has_choices { equation.phi().map(|phi| deciding(arena, phi)).unwrap_or_default() } else { BTreeSet::new() };
        let entry = |(unknown, value): &(usize, Expr)| Entry {
            unknown: *unknown,
            is_pivot: !decides.contains(unknown) && is_pivot(arena, *value, &nonzero),
        };
        steady(equation.jacobian.iter().map(entry).collect(), &equation.jacobian, arena)
    };
    let read = equations.iter().map(|equation| equation.read.clone()).collect();
    Pattern { unknowns, rows: equations.iter().map(row).collect(), read }
}

/// True if an equation between positions contains a choice between values.
pub(crate) fn has_choices<'a>(arena: &Arena, equations: impl IntoIterator<Item = &'a Equation>) -> bool {
    let roots: Vec<Expr> = equations.into_iter().filter_map(Equation::phi).collect();
    let is_choice = |expr: Expr| matches!(arena.node(expr), Node::Select { .. } | Node::Unary(Unary::Sign, _));
    arena.reachable(&roots).into_iter().any(is_choice)
}

/// The coordinates on which choices in an expression depend: it is not linear in them, even if its derivatives are constant.
pub(crate) fn deciding(arena: &Arena, expr: Expr) -> BTreeSet<usize> {
    let mut operands = Vec::new();
    for expr in arena.reachable(&[expr]) {
        match *arena.node(expr) {
            Node::Select { lhs, rhs, .. } => operands.extend([lhs, rhs]),
            Node::Unary(Unary::Sign, one) => operands.push(one),
            _ => {}
        }
    }
    operands.into_iter().flat_map(|operand| coordinates_in(arena, operand)).collect()
}

/// A constant below this fraction of the largest one in its row is no pivot: dividing by it would amplify rounding errors.
const WEAK: f64 = 0.1;

/// Unmarks pivots that are weak constants within their row.
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

/// Parameters that joints require to be nonzero, by themselves or in a product; `validate` checks them.
fn nonzero_parameters(model: &Model, arena: &Arena) -> BTreeSet<u32> {
    let of_requirement = |requirement: &crate::model::Requirement| {
        let is_zero = arena.as_constant(requirement.rhs).is_some_and(|value| value.is_zero());
        let excludes_zero = matches!(requirement.relation, Relation::Different | Relation::Greater | Relation::Less);
        (is_zero && excludes_zero).then_some(requirement.lhs)
    };
    let mut pending: Vec<Expr> = model.requirements.iter().filter_map(of_requirement).collect();
    let mut nonzero = BTreeSet::new();
    while let Some(factor) = pending.pop() {
        match *arena.node(factor) {
            Node::Leaf(Leaf::Parameter(number)) => drop(nonzero.insert(number)),
            // Nothing is said of a denominator: a quotient by zero is not zero.
            Node::Unary(Unary::Neg, inner) | Node::Binary(Binary::Div, inner, _) => pending.push(inner),
            Node::Binary(Binary::Mul, one, two) => pending.extend([one, two]),
            _ => {}
        }
    }
    nonzero
}

/// True if the value is nonzero in every state: nonzero constants and parameters, their products and quotients.
fn is_pivot(arena: &Arena, value: Expr, nonzero: &BTreeSet<u32>) -> bool {
    let mut pivots = BTreeSet::new();
    let is_product = |node: &Node| matches!(node, Node::Unary(Unary::Neg, _) | Node::Binary(Binary::Mul | Binary::Div, ..));
    for expr in arena.reachable_above(&[value], |node| !is_product(node)) {
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
