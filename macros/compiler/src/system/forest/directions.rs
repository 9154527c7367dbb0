//! Components of ω along directions that are fixed in the axes of a spin: x · ω is a sum of speeds times numbers.

use super::Forest;
use crate::expr::{Arena, Binary, Expr, Leaf, Lookup, Mark, Node, Spin, SpinAxes, Unary, dot};
use crate::model::{DECLARED, declared_angular};
use crate::quantity::{Ambient, SpeedRole};

/// x₁ L₁ + x₂ L₂ + x₃ L₃ with a vector x fixed in a body and L = Σ ± ω of bodies.
struct AlongDirection {
    vector: u32,
    /// Each body with true for plus.
    spins: Vec<(usize, bool)>,
}

impl Forest<'_> {
    /// A declared expression with the components of ω along directions by the speeds that are components of ω.
    pub(super) fn by_spins(&mut self, root: Expr) -> Expr {
        let whole = |node: &Node| matches!(node, Node::Marked { mark: Mark::Turned { .. } | Mark::OfJoint(_), .. });
        let mut known: Lookup<Expr, Expr> = Lookup::default();
        for expr in self.arena.reachable_above(&[root], whole) {
            let new = match AlongDirection::find(self.arena, expr) {
                Some(found) => self.along(&found),
                None if whole(self.arena.node(expr)) => expr,
                None => {
                    let children: Vec<Expr> = self.arena.node(expr).children().map(|child| known[&child]).collect();
                    self.arena.with_children(expr, &children)
                }
            };
            known.insert(expr, new);
        }
        known[&root]
    }

    fn along(&mut self, AlongDirection { vector, spins }: &AlongDirection) -> Expr {
        let mut sum = self.arena.integer(0);
        for (body, is_plus) in spins {
            let part = self.component(*vector, *body);
            sum = if *is_plus { self.arena.add(sum, part) } else { self.arena.sub(sum, part) };
        }
        sum
    }

    /// x · ω of a body.
    fn component(&mut self, vector: u32, body: usize) -> Expr {
        let (holder, local) = self.arena.vector(vector);
        if let Some(Spin { first, axes }) = self.frames[body].and_then(|frame| self.arena.spin(frame)) {
            let held = match axes {
                SpinAxes::Own => self.frames[body],
                SpinAxes::Of(frame) => Some(frame),
                SpinAxes::Ground => None,
            };
            if held.is_some() && held == self.frames[holder] {
                let speeds = [0, 1, 2].map(|k| self.arena.leaf(Leaf::Speed(first + k)));
                return dot(self.arena, local, speeds);
            }
        }
        let direction = self.arena.turned(holder, local);
        let spin = declared_angular(body).map(|number| self.arena.leaf(Leaf::Speed(number)));
        dot(self.arena, direction, spin)
    }
}

impl AlongDirection {
    fn find(arena: &Arena, expr: Expr) -> Option<AlongDirection> {
        let Node::Binary(Binary::Add, one, two) = *arena.node(expr) else { return None };
        let pair = |expr: Expr| match *arena.node(expr) {
            Node::Binary(Binary::Add, first, second) => Some([first, second]),
            _ => None,
        };
        let products = match (pair(one), pair(two)) {
            (Some([first, second]), None) => [first, second, two],
            (None, Some([first, second])) => [one, first, second],
            _ => return None,
        };
        let mut found: Option<AlongDirection> = None;
        let mut axes = [false; 3];
        for product in products {
            let Node::Binary(Binary::Mul, a, b) = *arena.node(product) else { return None };
            let ((vector, axis), rest) = turned(arena, a).map(|mark| (mark, b)).or_else(|| turned(arena, b).map(|mark| (mark, a)))?;
            let mut spins = Vec::new();
            collect(arena, (rest, true), axis, &mut spins)?;
            spins.sort_unstable();
            let is_same = found.as_ref().is_none_or(|found| found.vector == vector && found.spins == spins);
            if !is_same || std::mem::replace(&mut axes[usize::from(axis)], true) {
                return None;
            }
            found = Some(AlongDirection { vector, spins });
        }
        found
    }
}

/// Vector and axis of a component.
fn turned(arena: &Arena, expr: Expr) -> Option<(u32, u8)> {
    match *arena.node(expr) {
        Node::Marked { mark: Mark::Turned { vector, axis }, .. } => Some((vector, axis)),
        _ => None,
    }
}

/// The terms of a sum of components of ω along an axis of ground; `None` if there are others.
fn collect(arena: &Arena, (expr, is_plus): (Expr, bool), axis: u8, spins: &mut Vec<(usize, bool)>) -> Option<()> {
    match *arena.node(expr) {
        Node::Unary(Unary::Neg, a) => collect(arena, (a, !is_plus), axis, spins),
        Node::Binary(sign @ (Binary::Add | Binary::Sub), a, b) => {
            collect(arena, (a, is_plus), axis, spins)?;
            collect(arena, (b, is_plus == (sign == Binary::Add)), axis, spins)
        }
        Node::Leaf(Leaf::Speed(number)) => {
            let (body, own) = turning_of(number)?;
            (own == axis).then(|| spins.push((body, is_plus)))
        }
        _ => None,
    }
}

/// The body and the axis of ground of a declared angular speed.
fn turning_of(number: u32) -> Option<(usize, u8)> {
    let speed = number.checked_sub(DECLARED)? as usize;
    let body = Ambient::Space.body_of(speed);
    let axis = SpeedRole::angular(body).iter().position(|other| *other == speed)?;
    Some((body, axis as u8))
}
