//! Laws of functions at points where the exact value is known.

use crate::expr::{Arena, Exact, Expr, Node, Unary};

pub(super) fn sine(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let angle = constant_under(arena, node, Unary::Sin)?;
    let value = sine_of_parts(twenty_fourths(angle)?)?;
    Some(arena.constant(value))
}

/// cos α = sin(α + a quarter of a turn)
pub(super) fn cosine(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let angle = constant_under(arena, node, Unary::Cos)?;
    let value = sine_of_parts((twenty_fourths(angle)? + 6) % 24)?;
    Some(arena.constant(value))
}

pub(super) fn tangent(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let angle = constant_under(arena, node, Unary::Tan)?;
    let value = match twenty_fourths(angle)? % 12 {
        0 => 0,
        3 => 1,
        9 => -1,
        _ => return None,
    };
    Some(arena.integer(value))
}

pub(super) fn arcs(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Unary(function, a) = node else {
        return None;
    };
    let value = arena.as_constant(a)?;
    let halves = if value.pi_power() == 0 {
        value.checked_mul(Exact::integer(2))?
    } else {
        return None;
    };
    if halves.denominator() != 1 {
        return None;
    }
    let parts = match (function, halves.numerator()) {
        (Unary::Asin | Unary::Atan, 0) | (Unary::Acos, 2) => 0,
        (Unary::Asin, 1) => 2,
        (Unary::Atan, 2) => 3,
        (Unary::Acos, 1) => 4,
        (Unary::Asin, 2) | (Unary::Acos, 0) => 6,
        (Unary::Acos, -1) => 8,
        (Unary::Acos, -2) => 12,
        // Another law moves the sign of a negative operand out of an odd function.
        _ => return None,
    };
    let angle = Exact::ratio(parts, 12)?.checked_mul(Exact::PI)?;
    Some(arena.constant(angle))
}

pub(super) fn exponential(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let value = constant_under(arena, node, Unary::Exp)?;
    value.is_zero().then(|| arena.integer(1))
}

pub(super) fn logarithm(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let value = constant_under(arena, node, Unary::Ln)?;
    value.is_one().then(|| arena.integer(0))
}

pub(super) fn absolute(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Unary(Unary::Abs, a) = node else {
        return None;
    };
    matches!(arena.node(a), Node::Unary(Unary::Abs, _)).then_some(a)
}

fn constant_under(arena: &Arena, node: &Node, function: Unary) -> Option<Exact> {
    match *node {
        Node::Unary(own, a) if own == function => arena.as_constant(a),
        _ => None,
    }
}

/// The angle in 24ths of a turn, from 0 to 23; `None` unless it is a whole number of them.
fn twenty_fourths(angle: Exact) -> Option<i128> {
    if angle.is_zero() {
        return Some(0);
    }
    let whole = angle.pi_power() == 1 && 12 % angle.denominator() == 0;
    // The numerator is below 2¹²⁰, so that the product fits.
    whole.then(|| (angle.numerator() * (12 / angle.denominator())).rem_euclid(24))
}

/// The sine of an angle in 24ths of a turn; `None` if it is irrational.
fn sine_of_parts(parts: i128) -> Option<Exact> {
    match parts {
        0 | 12 => Some(Exact::ZERO),
        2 | 10 => Exact::ratio(1, 2),
        6 => Some(Exact::ONE),
        14 | 22 => Exact::ratio(-1, 2),
        18 => Some(Exact::ONE.neg()),
        _ => None,
    }
}
