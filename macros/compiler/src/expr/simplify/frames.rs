//! The law of vectors that are fixed in one frame.

use crate::expr::frame::dot as dot_of;
use crate::expr::{Arena, Binary, Expr, Mark, Node};

/// A product of components of two vectors along one axis of ground.
#[derive(Clone, Copy)]
struct Product {
    /// In ascending order.
    vectors: [u32; 2],
    axis: u8,
}

/// A product of two constant components is a number, so that only two marked products are left; the number is subtracted from s · t. Frames of
/// binary links are orthogonal only where the row of their length holds.
pub(super) fn dot(arena: &mut Arena, node: &Node) -> Option<Expr> {
    let &Node::Binary(Binary::Add, one, two) = node else {
        return None;
    };
    let (Product { vectors, axis }, rest) = match (product(arena, one), product(arena, two)) {
        (Some(found), _) => (found, two),
        (_, Some(found)) => (found, one),
        _ => return None,
    };
    let along = |arena: &Arena, expr: Expr| product(arena, expr).filter(|other| other.vectors == vectors).map(|other| other.axis);
    let (rest, number) = match *arena.node(rest) {
        Node::Binary(Binary::Add, first, number) if arena.as_constant(number).is_some() => (first, number),
        _ => (rest, arena.integer(0)),
    };
    let (others, missing) = match *arena.node(rest) {
        Node::Binary(Binary::Add, first, second) => ([along(arena, first)?, along(arena, second)?], arena.integer(0)),
        _ => {
            let other = along(arena, rest)?;
            let third = [0, 1, 2].into_iter().find(|third| *third != axis && *third != other)?;
            let [a, b] = vectors.map(|vector| arena.constant_component(vector, third));
            ([other, third], arena.mul(a?, b?))
        }
    };
    let are_all = [0, 1, 2].iter().all(|wanted| *wanted == axis || others.contains(wanted));
    let [(frame, s), (other, t)] = vectors.map(|vector| arena.vector(vector));
    if !are_all || frame != other {
        return None;
    }
    let dot = dot_of(arena, s, t);
    let dot = arena.sub(dot, missing);
    Some(arena.add(dot, number))
}

fn product(arena: &Arena, expr: Expr) -> Option<Product> {
    let Node::Binary(Binary::Mul, a, b) = *arena.node(expr) else { return None };
    let component = |expr: Expr| match *arena.node(expr) {
        Node::Marked { mark: Mark::Turned { vector, axis }, .. } => Some((vector, axis)),
        _ => None,
    };
    let ((one, axis), (two, other)) = (component(a)?, component(b)?);
    (axis == other).then(|| Product { vectors: [one.min(two), one.max(two)], axis })
}
