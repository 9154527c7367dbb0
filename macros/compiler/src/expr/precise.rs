//! Expressions of constants, computed to about 100 bits.
//!
//! Terms that cancel in exact arithmetic cancel here too, where an evaluation in `f64` leaves a rounding error.

use super::exact::Twofold;
use super::{Arena, Binary, Expr, Node, Unary};

/// Less than this is the rounding error of a number of order 1: 2⁻⁹⁰.
const DIRT: f64 = 1.0 / (1_u128 << 90) as f64;

impl Arena {
    /// 0, 1 or −1 for an expression of constants of order 1 that has this value; otherwise the expression itself.
    ///
    /// Of functions of constants, sine, cosine and square root are known.
    pub(crate) fn snapped(&mut self, expr: Expr) -> Expr {
        let value = if self.as_constant(expr).is_none() { self.precisely(expr) } else { None };
        let is_near = |whole: &i64| value.is_some_and(|value| value.minus(Twofold::whole(*whole)).round().abs() < DIRT);
        match [0, 1, -1].into_iter().find(is_near) {
            Some(whole) => self.integer(whole),
            None => expr,
        }
    }

    fn precisely(&mut self, root: Expr) -> Option<Twofold> {
        self.value(root)?;
        for expr in self.reachable_until(&[root], |expr| self.precise.contains_key(&expr)) {
            let of = |expr: Expr| self.precise[&expr];
            let value = match *self.node(expr) {
                Node::Constant(value) => value.twofold(),
                Node::Unary(Unary::Neg, a) => of(a).neg(),
                Node::Unary(Unary::Sqrt, a) => of(a).sqrt()?,
                Node::Unary(Unary::Sin, a) => of(a).sine_and_cosine()?[0],
                Node::Unary(Unary::Cos, a) => of(a).sine_and_cosine()?[1],
                Node::Binary(Binary::Add, a, b) => of(a).plus(of(b)),
                Node::Binary(Binary::Sub, a, b) => of(a).minus(of(b)),
                Node::Binary(Binary::Mul, a, b) => of(a).mul(of(b)),
                Node::Binary(Binary::Div, a, b) => of(a).div(of(b)),
                _ => return None,
            };
            self.precise.insert(expr, value);
        }
        self.precise.get(&root).copied()
    }
}
