//! Expressions of constants, computed to about 100 bits.
//!
//! Terms that cancel in exact arithmetic cancel here too, where an evaluation in `f64` leaves a rounding error; and a chain of constants,
//! as of one frame fixed in another, is rounded once.

use super::exact::Twofold;
use super::{Arena, Binary, Expr, Node, Unary};

/// Less than this is the rounding error of a number of order 1: 2⁻⁹⁰.
const DIRT: f64 = 1.0 / (1_u128 << 90) as f64;

/// The value of an expression of constants.
#[derive(Clone, Copy, Debug)]
pub(super) struct ConstantValue {
    /// In `f64`.
    pub(super) value: f64,
    /// To about 100 bits, where all operations are known so precisely.
    precise: Option<Twofold>,
}

impl ConstantValue {
    /// The value of an operation, from those of its operands; `None` if an operand has none.
    pub(super) fn of(node: &Node, operand: impl Fn(Expr) -> Option<ConstantValue>) -> Option<ConstantValue> {
        let value = node.value(|expr| operand(expr).map(|constant| constant.value))?;
        let precise = node.precisely(|expr| operand(expr)?.precise).filter(|precise| precise.round().is_finite());
        // An exact number has its rounded value already, and equal values may differ in the sign of zero.
        let is_rounded = |rounded: f64| matches!(node, Node::Constant(_)) || rounded == value || !value.is_finite();
        let value = precise.map(Twofold::round).filter(|rounded| !is_rounded(*rounded)).unwrap_or(value);
        Some(ConstantValue { value, precise })
    }
}

impl Arena {
    /// 0, 1 or −1 for an expression of constants of order 1 that has this value; otherwise the expression itself.
    ///
    /// Of functions of constants, sine, cosine and square root are known.
    pub(crate) fn snapped(&mut self, expr: Expr) -> Expr {
        let value =
            if self.as_constant(expr).is_none() { self.constants[expr.index()].and_then(|constant| constant.precise) } else { None };
        let is_near = |whole: &i64| value.is_some_and(|value| value.minus(Twofold::whole(*whole)).round().abs() < DIRT);
        match [0, 1, -1].into_iter().find(is_near) {
            Some(whole) => self.integer(whole),
            None => expr,
        }
    }
}

/// x + y; 0 where the rest is smaller than the rounding errors of both.
fn cleaned(x: Twofold, y: Twofold) -> Twofold {
    let sum = x.plus(y);
    let is_dirt = sum.round().abs() < DIRT * (x.round().abs() + y.round().abs());
    if is_dirt { Twofold::whole(0) } else { sum }
}

impl Node {
    /// The value of an operation on constants, from those of its operands; `None` where it is not known so precisely.
    fn precisely(&self, of: impl Fn(Expr) -> Option<Twofold>) -> Option<Twofold> {
        Some(match *self {
            Node::Constant(value) => value.twofold(),
            Node::Unary(Unary::Neg, a) => of(a)?.neg(),
            Node::Unary(Unary::Sqrt, a) => of(a)?.sqrt()?,
            Node::Unary(Unary::Sin, a) => of(a)?.sine_and_cosine()?[0],
            Node::Unary(Unary::Cos, a) => of(a)?.sine_and_cosine()?[1],
            Node::Binary(Binary::Add, a, b) => cleaned(of(a)?, of(b)?),
            Node::Binary(Binary::Sub, a, b) => cleaned(of(a)?, of(b)?.neg()),
            Node::Binary(Binary::Mul, a, b) => of(a)?.mul(of(b)?),
            Node::Binary(Binary::Div, a, b) => of(a)?.div(of(b)?),
            _ => return None,
        })
    }
}
