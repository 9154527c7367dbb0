//! Magnitude of the terms of an expression that is made of pieces, such as a law of a cam.
//!
//! A branch of an `if` counts only where it is taken, and there the comparison bounds its argument: a polynomial for arguments between 0 and 1
//! does not count with the powers of an argument of 100.
//!
//! ```text
//! a · b    |a| size b + |b| size a, at most size a size b
//! ```

use crate::expr::{Arena, Binary, Exact, Expr, Leaf, Node, Unary};
use crate::quantity::Dim;
use crate::system::Coordinate;
use std::collections::{BTreeMap, BTreeSet};

/// Most nodes that are looked at: pieces of pieces may be very many.
const MOST: usize = 20_000;

/// What is known of a node.
#[derive(Clone, Copy)]
struct Term {
    /// Sum of the magnitudes of its terms.
    size: Expr,
    /// Its value is no larger.
    bound: Expr,
    /// Lower and upper end of its values, as far as they are known.
    ends: [Option<Expr>; 2],
}

/// By node, the ends of its values within a piece.
type Limits = BTreeMap<Expr, [Option<Expr>; 2]>;

/// The magnitude of an expression with pieces; `None` without, and where there are too many.
pub(super) fn in_pieces(arena: &mut Arena, root: Expr, unknowns: &[usize], all: &[Coordinate]) -> Option<Expr> {
    let under = arena.reachable_to_values(&[root]);
    if !under.iter().any(|expr| matches!(arena.node(*expr), Node::Select { .. })) {
        return None;
    }
    let mut moving = BTreeSet::new();
    for expr in under {
        let moves = arena.value(expr).is_none()
            && match *arena.node(expr) {
                Node::Leaf(Leaf::Coordinate(index)) => unknowns.contains(&(index as usize)),
                node => node.children().any(|child| moving.contains(&child)),
            };
        if moves {
            moving.insert(expr);
        }
    }
    let mut pieces = Pieces { arena, moving, all, visits: 0, is_at_rest: unknowns.is_empty() };
    Some(pieces.term(root, &Limits::new())?.size)
}

struct Pieces<'a> {
    arena: &'a mut Arena,
    /// Nodes that contain unknowns.
    moving: BTreeSet<Expr>,
    all: &'a [Coordinate],
    visits: usize,
    /// True if there are no unknowns.
    is_at_rest: bool,
}

impl Pieces<'_> {
    /// The term of a root between the limits of a piece.
    fn term(&mut self, root: Expr, limits: &Limits) -> Option<Term> {
        let mut terms: BTreeMap<Expr, Term> = BTreeMap::new();
        for expr in self.outside_of_pieces(root) {
            self.visits += 1;
            if self.visits > MOST {
                return None;
            }
            let term = self.of_node(expr, limits, &terms)?;
            let ends = limits.get(&expr).copied().unwrap_or_default();
            let term = match ends {
                [None, None] => term,
                _ => self.between(Term { ends: [ends[0].or(term.ends[0]), ends[1].or(term.ends[1])], ..term }),
            };
            terms.insert(expr, term);
        }
        terms.get(&root).copied()
    }

    /// Nodes under a root, children first, without the pieces whose comparison contains unknowns.
    fn outside_of_pieces(&self, root: Expr) -> BTreeSet<Expr> {
        let (mut found, mut pending) = (BTreeSet::new(), vec![root]);
        while let Some(expr) = pending.pop() {
            if !found.insert(expr) || self.arena.value(expr).is_some() {
                continue;
            }
            match *self.arena.node(expr) {
                Node::Select { lhs, rhs, .. } if self.moving.contains(&lhs) || self.moving.contains(&rhs) => pending.extend([lhs, rhs]),
                node => pending.extend(node.children()),
            }
        }
        found
    }

    fn of_node(&mut self, expr: Expr, limits: &Limits, terms: &BTreeMap<Expr, Term>) -> Option<Term> {
        let node = *self.arena.node(expr);
        if !self.moving.contains(&expr) {
            let size = self.at_rest(expr, node, terms);
            let bound = self.arena.unary(Unary::Abs, expr);
            return Some(Term { size, bound, ends: [Some(expr); 2] });
        }
        let of = |child: Expr| terms[&child];
        Some(match node {
            Node::Binary(operator @ (Binary::Add | Binary::Sub), a, b) => self.sum(operator, of(a), of(b)),
            Node::Binary(Binary::Mul, a, b) => {
                let (size, bound) = self.product(of(a), of(b));
                Term { size, bound, ends: [None; 2] }
            }
            Node::Binary(Binary::Div, a, b) if !self.moving.contains(&b) => self.quotient(of(a), b),
            Node::Unary(Unary::Neg, a) => {
                let zero = self.arena.integer(0);
                let zero = Term { size: zero, bound: zero, ends: [Some(zero); 2] };
                self.sum(Binary::Sub, zero, of(a))
            }
            Node::Unary(Unary::Abs, a) => Term { ends: [None; 2], ..of(a) },
            Node::Marked { value, .. } if self.is_at_rest => of(value),
            Node::Unary(Unary::Sqrt, a) => {
                let [size, bound] = [of(a).size, of(a).bound].map(|square| self.arena.sqrt(square));
                Term { size, bound, ends: [None; 2] }
            }
            Node::Select { lhs, rhs, then, otherwise } => self.pieces([lhs, rhs, then, otherwise], limits, terms)?,
            Node::Binary(Binary::Atan2, ..) => {
                let (one, half) = (self.arena.integer(1), self.arena.constant(Exact::PI));
                let back = self.arena.neg(half);
                Term { size: one, bound: half, ends: [Some(back), Some(half)] }
            }
            Node::Leaf(Leaf::Coordinate(index)) if self.all[index as usize].role.dim() == Dim::LENGTH => self.free(0),
            _ => self.free(1),
        })
    }

    /// A term of which only the size is known.
    fn free(&mut self, size: i64) -> Term {
        let size = self.arena.integer(size);
        Term { size, bound: size, ends: [None; 2] }
    }

    /// The size of a node without unknowns; of an `if`, that of the branch taken.
    fn at_rest(&mut self, expr: Expr, node: Node, terms: &BTreeMap<Expr, Term>) -> Expr {
        if self.arena.value(expr).is_some() {
            return self.arena.unary(Unary::Abs, expr);
        }
        let of = |child: Expr| terms[&child];
        match node {
            Node::Binary(Binary::Add | Binary::Sub, a, b) => self.arena.add(of(a).size, of(b).size),
            Node::Binary(Binary::Mul, a, b) => self.product(of(a), of(b)).0,
            Node::Binary(Binary::Div, a, b) => self.arena.div(of(a).size, of(b).bound),
            Node::Unary(Unary::Neg | Unary::Abs, a) => of(a).size,
            Node::Marked { value, .. } if self.is_at_rest => of(value).size,
            Node::Unary(Unary::Sqrt, a) => self.arena.sqrt(of(a).size),
            Node::Unary(Unary::Sin | Unary::Cos, _) => self.arena.integer(1),
            Node::Select { lhs, rhs, then, otherwise } => self.arena.select(lhs, rhs, of(then).size, of(otherwise).size),
            _ => self.arena.unary(Unary::Abs, expr),
        }
    }

    fn sum(&mut self, operator: Binary, a: Term, b: Term) -> Term {
        let other = if operator == Binary::Sub { [b.ends[1], b.ends[0]] } else { b.ends };
        let mut end = |a: Option<Expr>, b: Option<Expr>| Some(self.arena.binary(operator, a?, b?));
        let ends = [end(a.ends[0], other[0]), end(a.ends[1], other[1])];
        let (size, bound) = (self.arena.add(a.size, b.size), self.arena.add(a.bound, b.bound));
        self.between(Term { size, bound, ends })
    }

    /// Size and bound of a product. A factor that is as large as its terms brings no other error than theirs.
    fn product(&mut self, a: Term, b: Term) -> (Expr, Expr) {
        let bound = self.arena.mul(a.bound, b.bound);
        if a.size == a.bound || b.size == b.bound {
            return (self.arena.mul(a.size, b.size), bound);
        }
        let (one, two) = (self.arena.mul(a.bound, b.size), self.arena.mul(b.bound, a.size));
        (self.arena.add(one, two), bound)
    }

    fn quotient(&mut self, a: Term, by: Expr) -> Term {
        let divisor = self.arena.unary(Unary::Abs, by);
        let [size, bound] = [a.size, a.bound].map(|part| self.arena.div(part, divisor));
        let is_positive = self.arena.value(by).is_some_and(|value| value > 0.0);
        let ends = a.ends.map(|end| Some(self.arena.div(end.filter(|_| is_positive)?, by)));
        self.between(Term { size, bound, ends })
    }

    /// The term with the bound that follows from its ends, or with the end that follows from its bound, if one end is unknown.
    fn between(&mut self, term: Term) -> Term {
        let (Some(low), Some(high)) = (term.ends[0], term.ends[1]) else {
            let back = self.arena.neg(term.bound);
            return match term.ends {
                [None, None] => term,
                [low, high] => Term { ends: [low.or(Some(back)), high.or(Some(term.bound))], ..term },
            };
        };
        let constants = [low, high].map(|end| self.arena.value(end).map(f64::abs));
        let [one, two] = [low, high].map(|end| self.arena.unary(Unary::Abs, end));
        let bound = match constants {
            [Some(a), Some(b)] if a < b => two,
            [Some(_), Some(_)] => one,
            _ if low == high => one,
            _ => self.arena.add(one, two),
        };
        Term { bound, ends: [Some(low), Some(high)], ..term }
    }

    /// The term of an `if`: the sum of both branches, each between the limits at which it is taken.
    fn pieces(&mut self, [lhs, rhs, then, otherwise]: [Expr; 4], limits: &Limits, terms: &BTreeMap<Expr, Term>) -> Option<Term> {
        let (is_left, is_right) = (!self.moving.contains(&rhs), !self.moving.contains(&lhs));
        let limited = |number: usize| {
            let mut limits = limits.clone();
            let mut known = |of: Expr, end: usize, value: Expr| {
                let mut ends = terms.get(&of).map(|term| term.ends).unwrap_or_default();
                ends[end] = Some(value);
                limits.insert(of, ends);
            };
            if is_left {
                known(lhs, 1 - number, rhs);
            } else if is_right {
                known(rhs, number, lhs);
            }
            limits
        };
        let (one, two) = (self.term(then, &limited(0))?, self.term(otherwise, &limited(1))?);
        let (size, bound) = (self.arena.add(one.size, two.size), self.arena.add(one.bound, two.bound));
        Some(Term { size, bound, ends: [None; 2] })
    }
}
