//! Partial derivatives of an expression by a leaf.
//!
//! All other leaves are held fixed, including the rates of the leaf. Inputs are functions of time: by time they have their rates. At a kink
//! (`abs` and `sign` at 0, the border of a `select`) the derivative is that of the branch that is evaluated there.

use super::lookup::Lookup;
use super::{Arena, Binary, Expr, Leaf, Mark, Node, Unary};

/// The partial derivative of `root` by one leaf.
pub fn derivative(arena: &mut Arena, root: Expr, by: Leaf) -> Expr {
    Derivatives::new(by).of(arena, root)
}

/// Partial derivatives by one leaf, stored so that many rows share their work. Belongs to one arena.
#[derive(Clone, Debug)]
pub struct Derivatives {
    by: Leaf,
    known: Lookup<Expr, Expr>,
}

impl Derivatives {
    /// Creates an empty cache of derivatives by `by`.
    #[must_use]
    pub fn new(by: Leaf) -> Self {
        Derivatives { by, known: Lookup::default() }
    }

    /// The derivative of `root`.
    pub fn of(&mut self, arena: &mut Arena, root: Expr) -> Expr {
        let is_turned = |expr: Expr| self.turns() && matches!(arena.node(expr), Node::Marked { mark: Mark::Turned { .. }, .. });
        let is_whole = |expr: Expr| arena.value(expr).is_some() || is_turned(expr);
        for expr in arena.reachable_down_to(&[root], |e| self.known.contains_key(&e), is_whole) {
            let slope = self.slope(arena, expr);
            self.known.insert(expr, slope);
        }
        self.known[&root]
    }

    /// True if the orientation of frames may depend on the leaf.
    fn turns(&self) -> bool {
        matches!(self.by, Leaf::Coordinate(_) | Leaf::Turn(_))
    }

    /// The derivative of one node whose operands have been differentiated.
    fn slope(&self, arena: &mut Arena, expr: Expr) -> Expr {
        let node = *arena.node(expr);
        let zero = arena.integer(0);
        let d = |operand: Expr| self.known[&operand];
        match node {
            Node::Leaf(leaf) if leaf == self.by => arena.integer(1),
            Node::Leaf(leaf @ Leaf::Input { .. }) if self.by == Leaf::Time => leaf.rate_of_input().map_or(zero, |rate| arena.leaf(rate)),
            Node::Marked { mark: Mark::Turned { vector, axis }, .. } if self.turns() => arena.turned_by(vector, axis, self.by),
            _ if arena.value(expr).is_some() => zero,
            Node::Marked { value, .. } => d(value),
            // Without this line, unused nodes would be built only to be multiplied by 0.
            _ if node.children().all(|operand| d(operand) == zero) => zero,
            Node::Constant(_) | Node::Leaf(_) => zero,
            Node::Unary(function, a) => of_unary(arena, function, expr, a, d(a)),
            Node::Binary(function, a, b) => of_binary(arena, function, expr, [a, b], [d(a), d(b)]),
            Node::Select { lhs, rhs, then, otherwise } => arena.select(lhs, rhs, d(then), d(otherwise)),
            Node::Call { function, order, argument } => {
                let outer = arena.call(function, order.saturating_add(1), argument);
                arena.mul(outer, d(argument))
            }
        }
    }
}

/// The derivative of v = f(a), given `da`.
fn of_unary(arena: &mut Arena, function: Unary, v: Expr, a: Expr, da: Expr) -> Expr {
    match function {
        Unary::Neg => arena.neg(da),
        Unary::Sqrt => {
            let twice = arena.twice(v);
            arena.div(da, twice)
        }
        Unary::Sin => {
            let cosine = arena.cos(a);
            arena.mul(cosine, da)
        }
        Unary::Cos => {
            let sine = arena.sin(a);
            let product = arena.mul(sine, da);
            arena.neg(product)
        }
        Unary::Tan => {
            let outer = one_plus_square(arena, v);
            arena.mul(outer, da)
        }
        Unary::Asin => {
            let root = cosine_of_arcsine(arena, a);
            arena.div(da, root)
        }
        Unary::Acos => {
            let root = cosine_of_arcsine(arena, a);
            let quotient = arena.div(da, root);
            arena.neg(quotient)
        }
        Unary::Atan => {
            let below = one_plus_square(arena, a);
            arena.div(da, below)
        }
        Unary::Exp => arena.mul(v, da),
        Unary::Ln => arena.div(da, a),
        Unary::Abs => {
            let sign = arena.unary(Unary::Sign, a);
            arena.mul(sign, da)
        }
        Unary::Sign => arena.integer(0),
    }
}

/// The derivative of v = f(a, b), given `da` and `db`.
fn of_binary(arena: &mut Arena, function: Binary, v: Expr, [a, b]: [Expr; 2], [da, db]: [Expr; 2]) -> Expr {
    match function {
        Binary::Add => arena.add(da, db),
        Binary::Sub => arena.sub(da, db),
        Binary::Mul if a == b => {
            let half = arena.mul(a, da);
            arena.twice(half)
        }
        Binary::Mul => {
            let left = arena.mul(da, b);
            let right = arena.mul(a, db);
            arena.add(left, right)
        }
        Binary::Div => {
            let drift = arena.mul(v, db);
            let above = arena.sub(da, drift);
            arena.div(above, b)
        }
        Binary::Atan2 => {
            let above = turning(arena, [a, b], [da, db]);
            let below = sum_of_squares(arena, a, b);
            arena.div(above, below)
        }
    }
}

/// 1 + a²
pub(super) fn one_plus_square(arena: &mut Arena, a: Expr) -> Expr {
    let one = arena.integer(1);
    let square = arena.square(a);
    arena.add(square, one)
}

/// √((1 − a)(1 + a)), which keeps its accuracy near a = ±1, unlike √(1 − a²).
pub(super) fn cosine_of_arcsine(arena: &mut Arena, a: Expr) -> Expr {
    let one = arena.integer(1);
    let minus = arena.sub(one, a);
    let plus = arena.add(a, one);
    let product = arena.mul(minus, plus);
    arena.sqrt(product)
}

/// a² + b²
pub(super) fn sum_of_squares(arena: &mut Arena, a: Expr, b: Expr) -> Expr {
    let left = arena.square(a);
    let right = arena.square(b);
    arena.add(left, right)
}

/// x ẏ − y ẋ: the rate of the angle of (x, y), times the square of the radius.
pub(super) fn turning(arena: &mut Arena, [y, x]: [Expr; 2], [dy, dx]: [Expr; 2]) -> Expr {
    let left = arena.mul(x, dy);
    let right = arena.mul(y, dx);
    arena.sub(left, right)
}
