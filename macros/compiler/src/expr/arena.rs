//! Storage of expressions: nodes by index. Equal expressions have equal indices.

use super::lookup::{Lookup, Members};
use std::collections::BTreeSet;

use super::frame::Frames;
use super::precise::ConstantValue;
use super::reached::Reached;
use super::{Binary, Exact, Expr, Leaf, Node, RULES, Unary};

/// A hash-consed store of simplified expressions.
///
/// Every [`Expr`] handed to a method must come from the same arena.
#[derive(Clone, Debug, Default)]
pub struct Arena {
    nodes: Vec<Node>,
    // Only looked up, never iterated, so that its order cannot reach the output.
    places: Lookup<Node, Expr>,
    /// Value of each node that depends on constants only.
    pub(super) constants: Vec<Option<ConstantValue>>,
    /// Frames that turn in space, and vectors fixed in them.
    pub(super) frames: Frames,
}

impl Arena {
    /// Creates an empty arena.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The node of an expression.
    #[must_use]
    pub fn node(&self, expr: Expr) -> &Node {
        &self.nodes[expr.index()]
    }

    /// Number of nodes.
    #[must_use]
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// All nodes, children before parents.
    pub(crate) fn all(&self) -> impl Iterator<Item = Expr> + use<> {
        (0..self.nodes.len() as u32).map(Expr)
    }

    /// True if there are no nodes.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// Builds a node, simplified by [`RULES`]; equal nodes get the same index.
    ///
    /// Operands are simplified already, so that a stored node needs no rule.
    pub fn build(&mut self, node: Node) -> Expr {
        if let Some(&place) = self.places.get(&node) {
            return place;
        }
        for rule in RULES {
            if let Some(simpler) = (rule.rewrite)(self, &node) {
                return simpler;
            }
        }
        self.place(node)
    }

    /// Stores a node without simplification: a copy of one that another arena has simplified already, with operands in the same order.
    pub(crate) fn place(&mut self, node: Node) -> Expr {
        let (nodes, constants) = (&mut self.nodes, &mut self.constants);
        *self.places.entry(node).or_insert_with(|| {
            nodes.push(node);
            constants.push(ConstantValue::of(&node, |operand| constants[operand.index()]));
            Expr(u32::try_from(nodes.len() - 1).unwrap_or(u32::MAX))
        })
    }

    /// An exact number.
    pub fn constant(&mut self, value: Exact) -> Expr {
        self.build(Node::Constant(value))
    }

    /// A whole number.
    pub fn integer(&mut self, value: i64) -> Expr {
        self.constant(Exact::integer(value))
    }

    /// A variable: time, a parameter, a coordinate or the like.
    pub fn leaf(&mut self, leaf: Leaf) -> Expr {
        self.build(Node::Leaf(leaf))
    }

    /// A function of one operand.
    pub(crate) fn unary(&mut self, function: Unary, a: Expr) -> Expr {
        self.build(Node::Unary(function, a))
    }

    /// A function of two operands.
    pub fn binary(&mut self, function: Binary, a: Expr, b: Expr) -> Expr {
        self.build(Node::Binary(function, a, b))
    }

    /// −a
    pub fn neg(&mut self, a: Expr) -> Expr {
        self.unary(Unary::Neg, a)
    }

    /// a₁ + a₂ + …, from the left; 0 for no terms.
    pub fn sum(&mut self, terms: &[Expr]) -> Expr {
        let mut terms = terms.iter().copied();
        let first = terms.next().unwrap_or_else(|| self.integer(0));
        terms.fold(first, |sum, term| self.add(sum, term))
    }

    /// a + b
    pub fn add(&mut self, a: Expr, b: Expr) -> Expr {
        self.binary(Binary::Add, a, b)
    }

    /// a − b
    pub fn sub(&mut self, a: Expr, b: Expr) -> Expr {
        self.binary(Binary::Sub, a, b)
    }

    /// a · b
    pub fn mul(&mut self, a: Expr, b: Expr) -> Expr {
        self.binary(Binary::Mul, a, b)
    }

    /// a / b
    pub fn div(&mut self, a: Expr, b: Expr) -> Expr {
        self.binary(Binary::Div, a, b)
    }

    /// √a
    pub fn sqrt(&mut self, a: Expr) -> Expr {
        self.unary(Unary::Sqrt, a)
    }

    /// sin a
    pub fn sin(&mut self, a: Expr) -> Expr {
        self.unary(Unary::Sin, a)
    }

    /// cos a
    pub fn cos(&mut self, a: Expr) -> Expr {
        self.unary(Unary::Cos, a)
    }

    /// a²
    pub fn square(&mut self, a: Expr) -> Expr {
        self.mul(a, a)
    }

    /// 2 a
    pub fn twice(&mut self, a: Expr) -> Expr {
        let two = self.integer(2);
        self.mul(two, a)
    }

    /// `baseⁿ` by repeated squaring; 1 for n = 0, and 1/base⁻ⁿ for a negative n.
    pub fn power(&mut self, base: Expr, exponent: i32) -> Expr {
        let one = self.integer(1);
        let mut product = one;
        let mut square = base;
        let mut rest = exponent.unsigned_abs();
        while rest > 0 {
            if rest & 1 == 1 {
                product = self.mul(product, square);
            }
            rest >>= 1;
            if rest > 0 {
                square = self.mul(square, square);
            }
        }
        if exponent < 0 { self.div(one, product) } else { product }
    }

    /// `if lhs < rhs { then } else { otherwise }`
    pub fn select(&mut self, lhs: Expr, rhs: Expr, then: Expr, otherwise: Expr) -> Expr {
        self.build(Node::Select { lhs, rhs, then, otherwise })
    }

    /// The derivative of the given order of a numbered function, at `argument`.
    pub fn call(&mut self, function: u32, order: u8, argument: Expr) -> Expr {
        self.build(Node::Call { function, order, argument })
    }

    /// The value of a constant; `None` for any other node.
    #[must_use]
    pub(crate) fn as_constant(&self, expr: Expr) -> Option<Exact> {
        match *self.node(expr) {
            Node::Constant(value) => Some(value),
            _ => None,
        }
    }

    /// Whether two whole numbers are equal; `None` of other numbers.
    pub(crate) fn are_equal_wholes(&self, pair: [Expr; 2]) -> Option<bool> {
        let whole = |expr: Expr| self.as_constant(expr).filter(|value| value.to_f64().fract() == 0.0);
        Some(whole(pair[0])? == whole(pair[1])?)
    }

    /// The value of an expression of constants; `None` for one that depends on anything else. It is rounded once, unless a function other
    /// than sine, cosine and square root occurs.
    #[must_use]
    pub fn value(&self, expr: Expr) -> Option<f64> {
        self.constants[expr.index()].map(|constant| constant.value)
    }

    /// True if a term or a factor of the expression is a constant that is not finite, such as √−1.
    pub(crate) fn is_never_finite(&self, root: Expr) -> bool {
        let mut seen = Members::default();
        let mut open = vec![root];
        while let Some(expr) = open.pop() {
            if self.value(expr).is_some_and(|value| !value.is_finite()) {
                return true;
            }
            if !seen.insert(expr) {
                continue;
            }
            match *self.node(expr) {
                Node::Binary(Binary::Add | Binary::Sub | Binary::Mul, a, b) => open.extend([a, b]),
                Node::Binary(Binary::Div, a, _) | Node::Unary(Unary::Neg | Unary::Abs | Unary::Sqrt, a) => open.push(a),
                Node::Marked { value, .. } => open.push(value),
                _ => {}
            }
        }
        false
    }

    /// All nodes under `roots`, the roots among them, each once, children before parents.
    #[must_use]
    pub fn reachable(&self, roots: &[Expr]) -> Vec<Expr> {
        self.reachable_until(roots, |_| false)
    }

    /// Like [`Arena::reachable`], but leaves out `known` nodes and does not descend below them.
    pub(crate) fn reachable_until(&self, roots: &[Expr], known: impl Fn(Expr) -> bool) -> Vec<Expr> {
        self.reachable_down_to(roots, known, |_| false)
    }

    /// Like [`Arena::reachable`], but does not descend below nodes that are `whole`.
    pub(crate) fn reachable_above(&self, roots: &[Expr], whole: impl Fn(&Node) -> bool) -> Vec<Expr> {
        self.reachable_down_to(roots, |_| false, |expr| whole(self.node(expr)))
    }

    /// Like [`Arena::reachable`], but does not descend below nodes that depend on constants only.
    pub(crate) fn reachable_to_values(&self, roots: &[Expr]) -> Vec<Expr> {
        self.reachable_down_to(roots, |_| false, |expr| self.value(expr).is_some())
    }

    /// The same operation on other operands, in writing order.
    pub(crate) fn with_children(&mut self, expr: Expr, children: &[Expr]) -> Expr {
        // Building the same node anew would only find it again.
        if self.node(expr).children().eq(children.iter().copied()) {
            return expr;
        }
        let node = match (*self.node(expr), children) {
            (Node::Unary(function, _), [a]) => Node::Unary(function, *a),
            (Node::Binary(function, ..), [a, b]) => Node::Binary(function, *a, *b),
            (Node::Select { .. }, [lhs, rhs, then, otherwise]) => Node::Select { lhs: *lhs, rhs: *rhs, then: *then, otherwise: *otherwise },
            (Node::Call { function, order, .. }, [argument]) => Node::Call { function, order, argument: *argument },
            (Node::Marked { mark, .. }, [value]) => Node::Marked { mark, value: *value },
            _ => return expr,
        };
        self.build(node)
    }

    /// Like [`Arena::reachable_until`], but does not descend below nodes that are `whole`.
    pub(crate) fn reachable_down_to(&self, roots: &[Expr], known: impl Fn(Expr) -> bool, whole: impl Fn(Expr) -> bool) -> Vec<Expr> {
        // Children have smaller indices than their parents.
        let mut reached = Reached::new(roots.iter().map(|root| root.index() + 1).max().unwrap_or(0));
        let mut found: Vec<Expr> = roots.iter().copied().filter(|root| !known(*root) && reached.takes(*root)).collect();
        let mut next = 0;
        while let Some(expr) = found.get(next).copied() {
            next += 1;
            if whole(expr) {
                continue;
            }
            for child in self.node(expr).children() {
                if !known(child) && reached.takes(child) {
                    found.push(child);
                }
            }
        }
        reached.in_order(found.len())
    }

    /// True if an expression contains no leaves but parameters.
    pub(crate) fn is_fixed(&self, root: Expr) -> bool {
        self.leaves(root).iter().all(|leaf| matches!(leaf, Leaf::Parameter(_)))
    }

    /// The leaves that an expression depends on.
    #[must_use]
    pub fn leaves(&self, root: Expr) -> BTreeSet<Leaf> {
        self.leaves_of(&[root])
    }

    /// The leaves that any of several expressions depends on.
    #[must_use]
    pub(crate) fn leaves_of(&self, roots: &[Expr]) -> BTreeSet<Leaf> {
        let under = self.reachable_to_values(roots);
        let leaf = |expr: Expr| match *self.node(expr) {
            Node::Leaf(leaf) => Some(leaf),
            _ => None,
        };
        under.into_iter().filter_map(leaf).collect()
    }
}
