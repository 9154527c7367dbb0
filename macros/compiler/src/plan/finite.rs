//! Unknowns that have to be tested for NaN and infinity.
//!
//! Results of Newton's method are finite, and so are their derivatives if the right-hand sides are. Sums, products, sines and cosines of
//! finite unknowns are finite as well. Everything else is a risk: parameters, which the user may set to any value, time, and functions with
//! poles or a limited domain. Of the unknowns with the same pole one is enough, if it cannot be finite where the pole is. Unknowns that depend
//! on values from outside are all tested, since sums and products of very large ones overflow.

#[cfg(test)]
mod tests;

use super::stage::Stage;
use crate::expr::{Arena, Binary, Expr, Leaf, Members, Node, Unary};
use std::collections::BTreeSet;

/// The unknowns of a stage that may not be finite, or whose derivatives may not be.
#[derive(Clone, Debug)]
pub struct Unsure {
    /// Indices in q.
    unknowns: Vec<usize>,
    /// Whether they depend on values from outside.
    is_given: bool,
    /// The divisors that may be zero, and the functions with poles or a limited domain, on which they depend.
    poles: BTreeSet<Expr>,
    /// Those of the poles that their values or derivatives show.
    shown: BTreeSet<Expr>,
}

/// The unknowns that may not be finite, by stage.
pub(super) fn unsure(arena: &Arena, stages: &[Stage]) -> Vec<Unsure> {
    let of_stage = |stage: &Stage| {
        let (results, shown) = match stage {
            Stage::Explicit { motion, .. } => (motion.to_vec(), shown(arena, motion)),
            // What a solution of equations shows depends on its matrix.
            Stage::Block(_) => (stage.results(), BTreeSet::new()),
            Stage::Check { .. } => return None,
        };
        let reached = arena.reachable_to_values(&results);
        let is_given = matches!(stage, Stage::Explicit { .. }) && reached.iter().any(|expr| is_given(arena, *expr));
        let poles: BTreeSet<Expr> = reached.iter().filter_map(|expr| pole(arena, *expr)).collect();
        (is_given || !poles.is_empty()).then(|| Unsure { unknowns: stage.unknowns().to_vec(), is_given, poles, shown })
    };
    stages.iter().filter_map(of_stage).collect()
}

/// As many of the unknowns that are `held` as show all poles of the others that are; by index in q.
pub(crate) fn tested(unsure: &[Unsure], held: impl Fn(usize) -> bool) -> Vec<usize> {
    let mut found = Vec::new();
    let mut all: BTreeSet<Expr> = BTreeSet::new();
    let (showing, silent): (Vec<&Unsure>, Vec<&Unsure>) = unsure.iter().partition(|unsure| !unsure.shown.is_empty());
    for Unsure { unknowns, is_given, poles, shown } in showing.into_iter().chain(silent) {
        let mut unknowns = unknowns.iter().copied().filter(|unknown| held(*unknown)).peekable();
        if unknowns.peek().is_some() && (*is_given || !poles.is_subset(&all)) {
            found.extend(unknowns);
            all.extend(shown);
        }
    }
    found
}

/// The divisor that may be zero, or the expression that may not be finite for every finite operand.
fn pole(arena: &Arena, expr: Expr) -> Option<Expr> {
    if let Some(value) = arena.value(expr) {
        return (!value.is_finite()).then_some(expr);
    }
    match *arena.node(expr) {
        Node::Binary(Binary::Div, _, divisor) => arena.as_constant(divisor).is_none().then_some(divisor),
        Node::Unary(Unary::Sqrt | Unary::Tan | Unary::Asin | Unary::Acos | Unary::Exp | Unary::Ln, _) | Node::Call { .. } => Some(expr),
        _ => None,
    }
}

/// Values from outside.
fn is_given(arena: &Arena, expr: Expr) -> bool {
    matches!(arena.node(expr), Node::Leaf(Leaf::Time | Leaf::Parameter(_) | Leaf::Input { .. } | Leaf::Datum(_)))
}

/// Poles at which one of these is not finite: NaN and infinity pass through sums, products, numerators and square roots, but not through
/// divisors or the choice between two values.
fn shown(arena: &Arena, roots: &[Expr]) -> BTreeSet<Expr> {
    let (mut found, mut seen) = (BTreeSet::new(), Members::default());
    let mut pending = roots.to_vec();
    while let Some(expr) = pending.pop() {
        if !seen.insert(expr) {
            continue;
        }
        found.extend(pole(arena, expr));
        if arena.value(expr).is_some() {
            continue;
        }
        match *arena.node(expr) {
            Node::Binary(Binary::Add | Binary::Sub | Binary::Mul, a, b) => pending.extend([a, b]),
            Node::Binary(Binary::Div, a, _) | Node::Unary(Unary::Neg | Unary::Abs | Unary::Sqrt, a) | Node::Marked { value: a, .. } => {
                pending.push(a)
            }
            _ => {}
        }
    }
    found
}
