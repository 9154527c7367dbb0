//! Laws of neutral, absorbing and equal operands.

use crate::expr::{Arena, Binary, Expr, Node, Unary};

/// Multiplication commutes bit for bit. Constants come first, other factors in the order of their creation.
pub(super) fn sort_factors(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Mul, a, b) = node else {
        return None;
    };
    let rank = |e: Expr| (arena.as_constant(e).is_none(), e);
    (rank(b) < rank(a)).then(|| arena.mul(b, a))
}

/// Addition commutes bit for bit. Constants come last, other terms in the order of their creation.
pub(super) fn sort_terms(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Add, a, b) = node else {
        return None;
    };
    let rank = |e: Expr| (arena.as_constant(e).is_some(), e);
    (rank(b) < rank(a)).then(|| arena.add(b, a))
}

pub(super) fn add_zero(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Add, x, zero) = node else {
        return None;
    };
    is_zero(arena, zero).then_some(x)
}

pub(super) fn subtract_zero(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Sub, x, zero) = node else {
        return None;
    };
    is_zero(arena, zero).then_some(x)
}

pub(super) fn subtract_from_zero(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Sub, zero, x) = node else {
        return None;
    };
    is_zero(arena, zero).then(|| arena.neg(x))
}

pub(super) fn subtract_itself(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Sub, a, b) = node else {
        return None;
    };
    (a == b).then(|| arena.integer(0))
}

/// Exact; the factor 2 can then be combined with other constants.
pub(super) fn add_itself(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Add, a, b) = node else {
        return None;
    };
    (a == b).then(|| arena.twice(a))
}

pub(super) fn multiply_by_one(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Mul, one, x) = node else {
        return None;
    };
    is_one(arena, one).then_some(x)
}

pub(super) fn divide_by_one(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Div, x, one) = node else {
        return None;
    };
    is_one(arena, one).then_some(x)
}

pub(super) fn multiply_by_zero(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Mul, zero, _) = node else {
        return None;
    };
    is_zero(arena, zero).then_some(zero)
}

/// 0/0 is not simplified, so that it still shows at run time.
pub(super) fn divide_zero(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Div, zero, x) = node else {
        return None;
    };
    (is_zero(arena, zero) && !is_zero(arena, x)).then_some(zero)
}

pub(super) fn equal_branches(_: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Select { then, otherwise, .. } = node else {
        return None;
    };
    (then == otherwise).then_some(then)
}

pub(super) fn equal_sides(_: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Select { lhs, rhs, otherwise, .. } = node else {
        return None;
    };
    (lhs == rhs).then_some(otherwise)
}

/// A length has no derivative where it vanishes, and its square has.
pub(super) fn square_root_of_squares(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Mul, a, b) = node else {
        return None;
    };
    let &Node::Unary(Unary::Sqrt, inner) = arena.node(a) else {
        return None;
    };
    (a == b && is_sum_of_squares(arena, inner)).then_some(inner)
}

fn is_sum_of_squares(arena: &Arena, expr: Expr) -> bool {
    match *arena.node(expr) {
        Node::Binary(Binary::Add, a, b) => is_sum_of_squares(arena, a) && is_sum_of_squares(arena, b),
        Node::Binary(Binary::Mul, a, b) => a == b,
        _ => false,
    }
}

fn is_zero(arena: &Arena, expr: Expr) -> bool {
    arena.as_constant(expr).is_some_and(|value| value.is_zero())
}

fn is_one(arena: &Arena, expr: Expr) -> bool {
    arena.as_constant(expr).is_some_and(|value| value.is_one())
}
