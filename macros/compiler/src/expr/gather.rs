//! Terms of a sum that belong together, as one term.
//!
//! ```text
//! c₁ A s₁ + c₂ A s₂ = A (c₁ s₁ + c₂ s₂)    vectors fixed in one frame
//! c₁ x + c₂ x = (c₁ + c₂) x
//! ```
//!
//! A position that is reached through a body has one arm for each of the two joints there. Written as one vector they have one
//! derivative. No rule of simplification does this: it reassociates sums.

use super::lookup::{Lookup, Members};
use super::{Arena, Binary, Exact, Expr, Mark, Node, Triple, Unary};

/// A term: a coefficient times an expression.
type Term = (Exact, Expr);

/// Terms of one kind become one term.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum TermKind {
    /// Components along one axis of vectors fixed in one frame.
    Turned {
        frame: usize,
        axis: u8,
    },
    Same(Expr),
}

impl Arena {
    /// The expression with terms gathered in all its sums in which vectors of one frame meet. Every other sum stays as it is.
    pub(crate) fn gathered(&mut self, root: Expr) -> Expr {
        if !self.is_spatial() {
            return root;
        }
        let whole = |node: &Node| matches!(node, Node::Marked { .. });
        let all = self.reachable_above(&[root], whole);
        // Sums within sums are gathered with the outermost one.
        let mut outermost = Members::default();
        outermost.insert(root);
        for node in all.iter().map(|expr| self.node(*expr)).filter(|node| !is_sum(node) && !whole(node)) {
            outermost.extend(node.children().filter(|child| is_sum(self.node(*child))));
        }
        // Expressions that have changed.
        let mut known: Lookup<Expr, Expr> = Lookup::default();
        for expr in all {
            let node = *self.node(expr);
            if whole(&node) {
                continue;
            }
            let mut gathered = expr;
            if !known.is_empty() && node.children().any(|child| known.contains_key(&child)) {
                let children: Vec<Expr> = node.children().map(|child| known.get(&child).copied().unwrap_or(child)).collect();
                gathered = self.with_children(expr, &children);
            }
            if is_sum(&node) && outermost.contains(&expr) {
                gathered = self.gather(gathered);
            }
            if gathered != expr {
                known.insert(expr, gathered);
            }
        }
        known.get(&root).copied().unwrap_or(root)
    }

    /// A sum with its terms gathered: first those that no other joins, in the order in which they appear, then the vectors that became one.
    fn gather(&mut self, sum: Expr) -> Expr {
        let terms = self.terms(sum);
        if terms.iter().filter(|(_, expr)| matches!(self.node(*expr), Node::Marked { mark: Mark::Turned { .. }, .. })).count() < 2 {
            return sum;
        }
        let mut kinds: Vec<(TermKind, Vec<Term>)> = Vec::new();
        let mut places: Lookup<TermKind, usize> = Lookup::default();
        for term in &terms {
            let kind = self.kind(term.1);
            let place = *places.entry(kind).or_insert(kinds.len());
            match kinds.get_mut(place) {
                Some((_, alike)) => alike.push(*term),
                None => kinds.push((kind, vec![*term])),
            }
        }
        let has_arms = |(kind, terms): &(TermKind, Vec<Term>)| matches!(kind, TermKind::Turned { .. }) && terms.len() > 1;
        if !kinds.iter().any(has_arms) {
            return sum;
        }
        // The others often are known before an iteration, which then starts with their sum.
        kinds.sort_by_key(has_arms);
        let terms: Vec<Expr> = kinds.into_iter().map(|(kind, terms)| self.together(kind, &terms)).collect();
        self.sum(&terms)
    }

    /// The terms of a sum from the left.
    fn terms(&mut self, sum: Expr) -> Vec<Term> {
        let mut terms = Vec::new();
        let mut open = vec![(Exact::ONE, sum)];
        while let Some((factor, expr)) = open.pop() {
            match *self.node(expr) {
                Node::Binary(Binary::Add, a, b) => open.extend([(factor, b), (factor, a)]),
                Node::Binary(Binary::Sub, a, b) => open.extend([(factor.neg(), b), (factor, a)]),
                Node::Unary(Unary::Neg, a) => open.push((factor.neg(), a)),
                Node::Binary(Binary::Mul, a, b) => match self.as_constant(a).and_then(|constant| constant.checked_mul(factor)) {
                    Some(factor) => terms.push((factor, b)),
                    None => terms.push((factor, expr)),
                },
                Node::Constant(value) => match value.checked_mul(factor) {
                    Some(value) => terms.push((value, self.integer(1))),
                    None => terms.push((factor, expr)),
                },
                _ => terms.push((factor, expr)),
            }
        }
        terms
    }

    fn kind(&self, expr: Expr) -> TermKind {
        match *self.node(expr) {
            Node::Marked { mark: Mark::Turned { vector, axis }, .. } => TermKind::Turned { frame: self.vector(vector).0, axis },
            _ => TermKind::Same(expr),
        }
    }

    /// The sum of terms of one kind.
    fn together(&mut self, kind: TermKind, terms: &[Term]) -> Expr {
        match (kind, terms) {
            (TermKind::Turned { frame, axis }, [_, _, ..]) => {
                let mut local: Triple = [self.integer(0); 3];
                for (factor, expr) in terms {
                    let Node::Marked { mark: Mark::Turned { vector, .. }, .. } = *self.node(*expr) else { continue };
                    let parts = self.vector(vector).1;
                    local = [0, 1, 2].map(|k| {
                        let part = self.multiple(*factor, parts[k]);
                        self.add(local[k], part)
                    });
                }
                self.turned(frame, local)[usize::from(axis)]
            }
            (TermKind::Same(expr), _) => match terms.iter().try_fold(Exact::ZERO, |sum, (factor, _)| sum.checked_add(*factor)) {
                Some(factor) => self.multiple(factor, expr),
                None => self.sum_of(terms),
            },
            _ => self.sum_of(terms),
        }
    }

    fn multiple(&mut self, factor: Exact, expr: Expr) -> Expr {
        let factor = self.constant(factor);
        self.mul(factor, expr)
    }

    fn sum_of(&mut self, terms: &[Term]) -> Expr {
        let terms: Vec<Expr> = terms.iter().map(|(factor, expr)| self.multiple(*factor, *expr)).collect();
        self.sum(&terms)
    }
}

fn is_sum(node: &Node) -> bool {
    matches!(node, Node::Binary(Binary::Add | Binary::Sub, ..) | Node::Unary(Unary::Neg, _))
}
