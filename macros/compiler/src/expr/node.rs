//! What an expression is made of. A [`Node`] is one operation; an [`Expr`] is its place.

use super::Exact;

/// The place of a node in its [`Arena`](super::Arena). Equal places mean equal expressions.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Expr(pub(crate) u32);

impl Expr {
    /// The place as a number; children have smaller ones than their parents.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// A quantity that an expression takes from outside.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Leaf {
    /// The time t.
    Time,
    /// A parameter, constant in time.
    Parameter(u32),
    /// A coordinate q.
    Coordinate(u32),
    /// A speed u; coordinates change by q̇ = N(q) u.
    Speed(u32),
    /// The rate u̇ of the speed of the same number.
    Acceleration(u32),
    /// A number that differs from place to place, where one expression stands for many of the same shape.
    Datum(u32),
}

/// A function of one operand.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Unary {
    /// −x
    Neg,
    /// √x
    Sqrt,
    /// sin x
    Sin,
    /// cos x
    Cos,
    /// tan x
    Tan,
    /// arcsin x, in [−π/2, π/2]
    Asin,
    /// arccos x, in [0, π]
    Acos,
    /// arctan x, in (−π/2, π/2)
    Atan,
    /// eˣ
    Exp,
    /// The natural logarithm.
    Ln,
    /// |x|
    Abs,
    /// 1 for positive operands, −1 for negative ones, the operand itself at 0 and NaN.
    Sign,
}

/// A function of two operands.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Binary {
    /// a + b
    Add,
    /// a − b
    Sub,
    /// a · b
    Mul,
    /// a / b
    Div,
    /// The angle of the vector (b, a): the first operand is the ordinate.
    Atan2,
}

/// One operation over nodes built before it.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Node {
    /// An exact number.
    Constant(Exact),
    /// A quantity from outside.
    Leaf(Leaf),
    /// A function of one operand.
    Unary(Unary, Expr),
    /// A function of two operands.
    Binary(Binary, Expr, Expr),
    /// `if lhs < rhs { then } else { otherwise }`; both branches are evaluated.
    Select {
        /// What is compared.
        lhs: Expr,
        /// What it is compared with.
        rhs: Expr,
        /// The value when `lhs < rhs`.
        then: Expr,
        /// The value when not, also when one side is NaN.
        otherwise: Expr,
    },
    /// A derivative of a function of one variable that the arena knows only by number.
    Call {
        /// The number of the function.
        function: u32,
        /// The order of the derivative: 0 is the function itself. Nobody can evaluate an order
        /// above 2, but differentiation may produce it.
        order: u8,
        /// Where the function is taken.
        argument: Expr,
    },
}

impl Node {
    /// The operands, in writing order.
    pub fn children(&self) -> impl Iterator<Item = Expr> + use<> {
        let operands = match *self {
            Node::Constant(_) | Node::Leaf(_) => [None; 4],
            Node::Unary(_, a) | Node::Call { argument: a, .. } => [Some(a), None, None, None],
            Node::Binary(_, a, b) => [Some(a), Some(b), None, None],
            Node::Select { lhs, rhs, then, otherwise } => [Some(lhs), Some(rhs), Some(then), Some(otherwise)],
        };
        operands.into_iter().flatten()
    }
}
