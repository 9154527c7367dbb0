//! Magnitude of the terms of a residual, for any values of the unknown angles.
//!
//! A residual is a sum whose terms cancel, and its rounding error is a fraction of its terms. Where its gradient is small compared to
//! them, as at a dead point, the position is badly determined.

use crate::expr::{Arena, Binary, Expr, Leaf, Node, Unary};
use crate::quantity::Dim;
use crate::system::Coordinate;
use crate::system::pieces::in_pieces;
use std::collections::BTreeMap;

/// Approximate sum of the magnitudes of the terms of an expression, without the given unknowns: sines, cosines and unknown angles count
/// as 1. An unknown length counts as 0: where the residual vanishes, its other terms are as large. A constant counts as its value: its own
/// rounding error is the same in every state.
pub(crate) fn magnitude(arena: &mut Arena, root: Expr, unknowns: &[usize], all: &[Coordinate]) -> Expr {
    let Some((parts, square)) = distance(arena, root) else { return sum_of_terms(arena, root, unknowns, all) };
    let square = arena.unary(Unary::Abs, square);
    let length = arena.sqrt(square);
    let sizes: Vec<Expr> = parts.into_iter().map(|part| sum_of_terms(arena, part, unknowns, all)).collect();
    let sum = arena.sum(&sizes);
    let product = arena.mul(length, sum);
    let slopes = arena.twice(product);
    arena.add(slopes, square)
}

/// The parts d and the number c² of a residual d · d − c²: where it vanishes, no part is longer than c, so that an error of a part counts
/// 2 c times.
fn distance(arena: &Arena, root: Expr) -> Option<(Vec<Expr>, Expr)> {
    let Node::Binary(Binary::Sub, sum, square) = *arena.node(root) else { return None };
    if !arena.is_fixed(square) {
        return None;
    }
    let (mut parts, mut pending) = (Vec::new(), vec![sum]);
    while let Some(term) = pending.pop() {
        match *arena.node(term) {
            Node::Binary(Binary::Add, a, b) => pending.extend([b, a]),
            Node::Binary(Binary::Mul, a, b) if a == b => parts.push(a),
            Node::Constant(_) => {}
            _ => return None,
        }
    }
    (parts.len() > 1).then_some((parts, square))
}

/// Expressions with pieces have a better bound ([`in_pieces`]); they come here only if there are too many pieces.
fn sum_of_terms(arena: &mut Arena, root: Expr, unknowns: &[usize], all: &[Coordinate]) -> Expr {
    if let Some(size) = in_pieces(arena, root, unknowns, all) {
        return size;
    }
    let mut sizes: BTreeMap<Expr, Expr> = BTreeMap::new();
    let mut is_moving: BTreeMap<Expr, bool> = BTreeMap::new();
    let (zero, one) = (arena.integer(0), arena.integer(1));
    let is_length = |index: u32| all[index as usize].role.dim() == Dim::LENGTH;
    for expr in arena.reachable_to_values(&[root]) {
        let node = *arena.node(expr);
        if arena.value(expr).is_some() {
            is_moving.insert(expr, false);
            sizes.insert(expr, arena.unary(Unary::Abs, expr));
            continue;
        }
        let moves = match node {
            Node::Leaf(Leaf::Coordinate(index)) => unknowns.contains(&(index as usize)),
            _ => node.children().any(|child| is_moving[&child]),
        };
        is_moving.insert(expr, moves);
        let of = |child: Expr| sizes[&child];
        let size = match node {
            Node::Binary(Binary::Add | Binary::Sub, a, b) => {
                let (a, b) = (of(a), of(b));
                arena.add(a, b)
            }
            Node::Binary(Binary::Mul, a, b) => {
                let (a, b) = (of(a), of(b));
                arena.mul(a, b)
            }
            Node::Binary(Binary::Div, a, b) if !is_moving[&b] => {
                let (a, b) = (of(a), arena.unary(Unary::Abs, b));
                arena.div(a, b)
            }
            Node::Unary(Unary::Neg | Unary::Abs, a) => of(a),
            // A component of a vector may vanish; those that it is computed from do not.
            Node::Marked { value, .. } if unknowns.is_empty() => of(value),
            Node::Unary(Unary::Sqrt, a) => {
                let a = of(a);
                arena.sqrt(a)
            }
            Node::Unary(Unary::Sin | Unary::Cos, _) => one,
            Node::Select { then, otherwise, .. } => {
                let (then, otherwise) = (of(then), of(otherwise));
                arena.add(then, otherwise)
            }
            Node::Leaf(Leaf::Coordinate(index)) if moves && is_length(index) => zero,
            _ if moves => one,
            _ => arena.unary(Unary::Abs, expr),
        };
        sizes.insert(expr, size);
    }
    sizes[&root]
}
