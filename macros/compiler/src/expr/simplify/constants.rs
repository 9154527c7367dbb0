//! Laws that compute with exact constants.

use crate::expr::{Arena, Binary, Exact, Expr, Node, Unary};

pub(super) fn add(arena: &mut Arena, node: &Node) -> Option<Expr> {
    fold(arena, node, Binary::Add, Exact::checked_add)
}

pub(super) fn subtract(arena: &mut Arena, node: &Node) -> Option<Expr> {
    fold(arena, node, Binary::Sub, Exact::checked_sub)
}

pub(super) fn multiply(arena: &mut Arena, node: &Node) -> Option<Expr> {
    fold(arena, node, Binary::Mul, Exact::checked_mul)
}

pub(super) fn divide(arena: &mut Arena, node: &Node) -> Option<Expr> {
    fold(arena, node, Binary::Div, Exact::checked_div)
}

pub(super) fn negate(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Unary(Unary::Neg, a) = node else {
        return None;
    };
    let value = arena.as_constant(a)?;
    Some(arena.constant(value.neg()))
}

pub(super) fn take_root(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Unary(Unary::Sqrt, a) = node else {
        return None;
    };
    let root = arena.as_constant(a)?.checked_sqrt()?;
    Some(arena.constant(root))
}

pub(super) fn take_sign(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Unary(function, a) = node else {
        return None;
    };
    let value = arena.as_constant(a)?;
    match function {
        Unary::Abs => Some(arena.constant(value.abs())),
        Unary::Sign => Some(arena.integer(i64::from(value.signum()))),
        _ => None,
    }
}

pub(super) fn decide(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Select { lhs, rhs, then, otherwise } = node else {
        return None;
    };
    let difference = arena.as_constant(lhs)?.checked_sub(arena.as_constant(rhs)?)?;
    Some(if difference.signum() < 0 { then } else { otherwise })
}

pub(super) fn divide_by_power_of_two(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Div, a, b) = node else {
        return None;
    };
    let value = arena.as_constant(b)?;
    // Of the reduced numerator and denominator one is 1; both scalings are exact.
    let whole = |part: i128| part.unsigned_abs().is_power_of_two();
    if value.pi_power() != 0 || !whole(value.numerator()) || !whole(value.denominator()) {
        return None;
    }
    let inverse = Exact::ONE.checked_div(value)?;
    let factor = arena.constant(inverse);
    Some(arena.mul(factor, a))
}

pub(super) fn merge_factors(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Mul, a, b) = node else {
        return None;
    };
    let &Node::Binary(Binary::Mul, inner, x) = arena.node(b) else {
        return None;
    };
    let value = arena.as_constant(a)?.checked_mul(arena.as_constant(inner)?)?;
    let factor = arena.constant(value);
    Some(arena.mul(factor, x))
}

pub(super) fn merge_divisors(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Div, a, b) = node else {
        return None;
    };
    let &Node::Binary(Binary::Div, x, inner) = arena.node(a) else {
        return None;
    };
    let value = arena.as_constant(b)?.checked_mul(arena.as_constant(inner)?)?;
    // A division by 0 is not simplified, so that messages can mark it.
    if value.is_zero() {
        return None;
    }
    let divisor = arena.constant(value);
    Some(arena.div(x, divisor))
}

fn fold(arena: &mut Arena, node: &Node, function: Binary, exact: fn(Exact, Exact) -> Option<Exact>) -> Option<Expr> {
    let &Node::Binary(own, a, b) = node else {
        return None;
    };
    if own != function {
        return None;
    }
    let value = exact(arena.as_constant(a)?, arena.as_constant(b)?)?;
    Some(arena.constant(value))
}
