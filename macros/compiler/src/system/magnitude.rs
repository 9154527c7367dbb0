//! How large the terms of a residual are, whatever the angles that are looked for.
//!
//! A residual is a sum that cancels; its rounding errors are a share of its terms. Where its gradient is small against them a
//! position is badly determined: at a dead point.

use crate::expr::{Arena, Binary, Expr, Leaf, Node, Unary};
use crate::system::Coordinate;
use std::collections::BTreeMap;

/// About the sum of the magnitudes of an expression's terms, without the given unknowns: sines and cosines count as 1, and so do
/// unknown angles. An unknown length counts as nothing: where the residual vanishes, its other terms are as large.
pub(crate) fn magnitude(arena: &mut Arena, root: Expr, unknowns: &[usize], all: &[Coordinate]) -> Expr {
    let mut sizes: BTreeMap<Expr, Expr> = BTreeMap::new();
    let mut is_moving: BTreeMap<Expr, bool> = BTreeMap::new();
    let (zero, one) = (arena.integer(0), arena.integer(1));
    let is_length = |index: u32| all[index as usize].role.is_position();
    for expr in arena.reachable(&[root]) {
        let node = *arena.node(expr);
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
