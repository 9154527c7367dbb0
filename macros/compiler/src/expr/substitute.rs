//! Replaces leaves by expressions.

use super::{Arena, Expr, Leaf, Node};
use std::collections::{BTreeMap, HashMap};

/// Replacements of leaves by expressions. A substitution belongs to one arena.
#[derive(Clone, Debug, Default)]
pub struct Substitution {
    map: BTreeMap<Leaf, Expr>,
    memo: HashMap<Expr, Expr>,
}

impl Substitution {
    /// Creates a substitution that replaces nothing.
    #[must_use]
    pub fn new() -> Substitution {
        Substitution::default()
    }

    /// Replaces `leaf` by `by` from now on; `by` itself is not changed.
    pub fn replace(&mut self, leaf: Leaf, by: Expr) {
        self.map.insert(leaf, by);
        self.memo.clear();
    }

    /// The expression with its leaves replaced.
    pub fn of(&mut self, arena: &mut Arena, root: Expr) -> Expr {
        for expr in arena.reachable(&[root]) {
            if self.memo.contains_key(&expr) {
                continue;
            }
            let node = *arena.node(expr);
            let new = |child: Expr| self.memo.get(&child).copied().unwrap_or(child);
            let is_same = node.children().all(|child| new(child) == child);
            let replaced = match node {
                Node::Leaf(leaf) => self.map.get(&leaf).copied().unwrap_or(expr),
                // Building it anew would only find the same node again.
                _ if is_same => expr,
                Node::Constant(_) => expr,
                Node::Unary(function, value) => {
                    let value = new(value);
                    arena.unary(function, value)
                }
                Node::Binary(function, one, two) => {
                    let (one, two) = (new(one), new(two));
                    arena.binary(function, one, two)
                }
                Node::Select { lhs, rhs, then, otherwise } => {
                    let [lhs, rhs, then, otherwise] = [lhs, rhs, then, otherwise].map(new);
                    arena.select(lhs, rhs, then, otherwise)
                }
                // What is replaced inside a frame is differentiated as written.
                Node::Marked { value, .. } => new(value),
                Node::Call { function, order, argument } => {
                    let argument = new(argument);
                    arena.call(function, order, argument)
                }
            };
            self.memo.insert(expr, replaced);
        }
        self.memo.get(&root).copied().unwrap_or(root)
    }
}
