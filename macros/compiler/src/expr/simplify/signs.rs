//! Laws of minus signs. They move outward, and combine with others or become a subtraction.

use crate::expr::{Arena, Binary, Expr, Node, Unary};

pub(super) fn negate_negation(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Unary(Unary::Neg, a) = node else {
        return None;
    };
    without_minus(arena, a)
}

pub(super) fn negate_difference(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Unary(Unary::Neg, inner) = node else {
        return None;
    };
    let &Node::Binary(Binary::Sub, a, b) = arena.node(inner) else {
        return None;
    };
    Some(arena.sub(b, a))
}

pub(super) fn add_negation(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Add, a, b) = node else {
        return None;
    };
    let b = without_minus(arena, b)?;
    Some(arena.sub(a, b))
}

pub(super) fn add_to_negation(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Add, a, b) = node else {
        return None;
    };
    let a = without_minus(arena, a)?;
    Some(arena.sub(b, a))
}

pub(super) fn subtract_negation(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Sub, a, b) = node else {
        return None;
    };
    let b = without_minus(arena, b)?;
    Some(arena.add(a, b))
}

pub(super) fn subtract_from_negation(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Sub, a, b) = node else {
        return None;
    };
    let a = without_minus(arena, a)?;
    let sum = arena.add(a, b);
    Some(arena.neg(sum))
}

pub(super) fn left_factor(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Mul, a, b) = node else {
        return None;
    };
    let a = without_minus(arena, a)?;
    let product = arena.mul(a, b);
    Some(arena.neg(product))
}

pub(super) fn right_factor(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Mul, a, b) = node else {
        return None;
    };
    let b = without_minus(arena, b)?;
    let product = arena.mul(a, b);
    Some(arena.neg(product))
}

pub(super) fn dividend(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Div, a, b) = node else {
        return None;
    };
    let a = without_minus(arena, a)?;
    let quotient = arena.div(a, b);
    Some(arena.neg(quotient))
}

pub(super) fn divisor(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Div, a, b) = node else {
        return None;
    };
    let b = without_minus(arena, b)?;
    let quotient = arena.div(a, b);
    Some(arena.neg(quotient))
}

pub(super) fn odd_function(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Unary(function, a) = node else {
        return None;
    };
    let odd = [Unary::Sin, Unary::Tan, Unary::Asin, Unary::Atan, Unary::Sign].contains(&function);
    let a = if odd {
        without_minus(arena, a)?
    } else {
        return None;
    };
    let value = arena.unary(function, a);
    Some(arena.neg(value))
}

pub(super) fn even_function(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Unary(function @ (Unary::Cos | Unary::Abs), a) = node else {
        return None;
    };
    let a = without_minus(arena, a)?;
    Some(arena.unary(function, a))
}

/// x if the expression is −x; c if it is the constant −c < 0.
fn without_minus(arena: &mut Arena, expr: Expr) -> Option<Expr> {
    match *arena.node(expr) {
        Node::Unary(Unary::Neg, x) => Some(x),
        Node::Constant(value) if value.signum() < 0 => Some(arena.constant(value.neg())),
        _ => None,
    }
}
