//! Replaces leaves by expressions.

use super::lookup::Lookup;
use super::{Arena, Expr, Leaf, Node};
use std::collections::BTreeMap;

/// Replacements of leaves by expressions. A substitution belongs to one arena.
#[derive(Clone, Debug, Default)]
pub struct Substitution {
    map: BTreeMap<Leaf, Expr>,
    memo: Lookup<Expr, Expr>,
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
        let is_known = |expr: Expr| arena.value(expr).is_some() || self.memo.contains_key(&expr);
        for expr in arena.reachable_until(&[root], is_known) {
            let node = *arena.node(expr);
            let children: Vec<Expr> = node.children().map(|child| self.memo.get(&child).copied().unwrap_or(child)).collect();
            let replaced = match node {
                Node::Leaf(leaf) => self.map.get(&leaf).copied().unwrap_or(expr),
                // A component of a frame with other leaves is no component of that frame.
                Node::Marked { .. } if !node.children().eq(children.iter().copied()) => children[0],
                _ => arena.with_children(expr, &children),
            };
            self.memo.insert(expr, replaced);
        }
        self.memo.get(&root).copied().unwrap_or(root)
    }
}
