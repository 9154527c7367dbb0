//! Expressions as Rust, with the fewest parentheses that keep the order of operations.

use super::literal::{number, real};
use crate::expr::{Arena, Binary, Expr, Node, Unary};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use std::collections::BTreeMap;

/// How tightly an expression holds together.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Strength {
    Sum,
    Product,
    Sign,
    Atom,
}

/// Prints expressions in which some have a name.
pub(super) struct Printer<'a> {
    pub(super) arena: &'a Arena,
    pub(super) names: &'a BTreeMap<Expr, String>,
    /// How sine and cosine are had together: `sin_cos`, the same bits everywhere, or `turn`, which is faster.
    pub(super) turn: &'static str,
}

impl Printer<'_> {
    /// The expression by its name if it has one, else written out.
    pub(super) fn expression(&self, expr: Expr) -> TokenStream {
        self.print(expr).0
    }

    /// The expression so that a method can be called on it.
    pub(super) fn operand(&self, expr: Expr) -> TokenStream {
        self.at_least(expr, Strength::Atom)
    }

    /// The value of the expression, if it depends on constants only.
    pub(super) fn constant(&self, expr: Expr) -> Option<f64> {
        self.arena.value(expr)
    }

    /// The expression written out, even if it has a name.
    pub(super) fn definition(&self, expr: Expr) -> TokenStream {
        self.write(expr).0
    }

    fn print(&self, expr: Expr) -> (TokenStream, Strength) {
        match self.names.get(&expr) {
            Some(name) => (named(name), Strength::Atom),
            None => self.write(expr),
        }
    }

    fn write(&self, expr: Expr) -> (TokenStream, Strength) {
        if let Some(value) = self.arena.value(expr) {
            return (real(value), Strength::Atom);
        }
        match *self.arena.node(expr) {
            Node::Constant(_) | Node::Leaf(_) | Node::Call { .. } => (quote!(), Strength::Atom),
            Node::Marked { value, .. } => self.print(value),
            Node::Unary(Unary::Neg, value) => {
                let value = self.at_least(value, Strength::Sign);
                (quote!(-#value), Strength::Sign)
            }
            Node::Unary(function, value) => {
                let value = self.at_least(value, Strength::Atom);
                let method = Ident::new(method(function), Span::mixed_site());
                (quote!(#value.#method()), Strength::Atom)
            }
            Node::Binary(Binary::Atan2, y, x) => {
                let (y, x) = (self.at_least(y, Strength::Atom), self.expression(x));
                (quote!(#y.atan2(#x)), Strength::Atom)
            }
            // The right operand of the same strength is put in parentheses: rounding depends on it.
            Node::Binary(Binary::Add, one, two) => {
                let (one, two) = (self.at_least(one, Strength::Sum), self.at_least(two, Strength::Product));
                (quote!(#one + #two), Strength::Sum)
            }
            Node::Binary(Binary::Sub, one, two) => {
                let (one, two) = (self.at_least(one, Strength::Sum), self.at_least(two, Strength::Product));
                (quote!(#one - #two), Strength::Sum)
            }
            Node::Binary(Binary::Mul, one, two) => {
                let (one, two) = (self.at_least(one, Strength::Product), self.at_least(two, Strength::Sign));
                (quote!(#one * #two), Strength::Product)
            }
            Node::Binary(Binary::Div, one, two) => {
                let (one, two) = (self.at_least(one, Strength::Product), self.at_least(two, Strength::Sign));
                (quote!(#one / #two), Strength::Product)
            }
            Node::Select { lhs, rhs, then, otherwise } => {
                let [lhs, rhs, then, otherwise] = [lhs, rhs, then, otherwise].map(|part| self.expression(part));
                (quote!(T::select_less(#lhs, #rhs, #then, #otherwise)), Strength::Atom)
            }
        }
    }

    fn at_least(&self, expr: Expr, needed: Strength) -> TokenStream {
        let (tokens, strength) = self.print(expr);
        if strength < needed { quote!((#tokens)) } else { tokens }
    }
}

/// `self.leg[3].length`, `state.1.theta.value`, or a local name.
pub(super) fn named(name: &str) -> TokenStream {
    match (name.strip_prefix("self."), name.strip_prefix("state.1.")) {
        (Some(path), _) => {
            let place = place(path);
            quote!(self.#place)
        }
        (_, Some(path)) => {
            let place = place(path);
            quote!(state.1.#place)
        }
        _ => {
            let local = local(name);
            quote!(#local)
        }
    }
}

/// `leg[3].length`
pub(super) fn place(path: &str) -> TokenStream {
    let segment = |segment: &str| {
        let mut parts = segment.split('[');
        let name = super::identifier(parts.next().unwrap_or_default());
        let indices = parts.filter_map(|index| index.trim_end_matches(']').parse().ok().map(number));
        quote!(#name #([#indices])*)
    };
    let segments = path.split('.').map(segment);
    quote!(#(#segments).*)
}

/// A local of generated code, which cannot be confused with the user's.
pub(super) fn local(name: &str) -> Ident {
    Ident::new(name, Span::mixed_site())
}

fn method(function: Unary) -> &'static str {
    match function {
        Unary::Sqrt => "sqrt",
        Unary::Tan => "tan",
        Unary::Asin => "asin",
        Unary::Acos => "acos",
        Unary::Atan => "atan",
        Unary::Exp => "exp",
        Unary::Ln => "ln",
        Unary::Abs => "abs",
        Unary::Sign => "sign",
        // A sine or cosine always has a name, a sign its own operator.
        Unary::Sin | Unary::Cos | Unary::Neg => "sin_cos",
    }
}
