//! Nodes of expressions. A [`Node`] is one operation; an [`Expr`] is its index.

use super::Exact;

/// Index of a node in its [`Arena`](super::Arena). Equal indices mean equal expressions.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Expr(pub(crate) u32);

impl Expr {
    /// The index as a number; children have smaller indices than their parents.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// Axes of ground in space.
const AXES: usize = 3;

/// A variable of an expression.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Leaf {
    /// The time t.
    Time,
    /// A parameter, constant in time.
    Parameter(u32),
    /// An input or one of its derivatives by time, given from outside for each state: by the number of the parameter that is its value
    /// at the start, and the order of the derivative, up to 2.
    Input {
        /// Number of the parameter that holds the value; those of the rate and of the acceleration follow.
        number: u32,
        /// Order of the derivative.
        order: u8,
    },
    /// A coordinate q.
    Coordinate(u32),
    /// A speed u; coordinates change by q̇ = N(q) u.
    Speed(u32),
    /// The rate u̇ of the speed of the same number.
    Acceleration(u32),
    /// The rate ü of the acceleration of the same number.
    Jerk(u32),
    /// Placeholder for a number, in an expression shared by several of the same shape.
    Datum(u32),
    /// An infinitesimal turn of a body in space about an axis of ground, three for each body. Expressions are differentiated by it and
    /// never contain it.
    Turn(u32),
}

impl Leaf {
    /// The derivatives of an input by time that are known are those up to this order.
    pub(crate) const HIGHEST_RATE: u8 = 2;

    /// The derivative by time of an input or of one of its rates; `None` for other leaves, and beyond the acceleration.
    #[must_use]
    pub(crate) const fn rate_of_input(self) -> Option<Leaf> {
        match self {
            Leaf::Input { number, order } if order < Leaf::HIGHEST_RATE => Some(Leaf::Input { number, order: order + 1 }),
            _ => None,
        }
    }

    /// The turns of a body about the axes of ground.
    #[must_use]
    pub(crate) fn turns_of(body: usize) -> [Leaf; 3] {
        [0, 1, 2].map(|axis| Leaf::Turn((AXES * body + axis) as u32))
    }

    /// True for coordinates and speeds.
    #[must_use]
    pub const fn moves(self) -> bool {
        matches!(self, Leaf::Coordinate(_) | Leaf::Speed(_))
    }

    /// True for the time and for inputs, which change with it.
    #[must_use]
    pub(crate) const fn is_of_time(self) -> bool {
        matches!(self, Leaf::Time | Leaf::Input { .. })
    }
}

/// Meaning of an expression, which has its own rule of differentiation or stands for an unknown of its own.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Mark {
    /// A component of a vector fixed in a frame, along an axis of ground. Its rate is that of ω × v.
    Turned {
        /// Number of the vector in its [`Arena`](super::Arena).
        vector: u32,
        /// Axis of ground: 0, 1 or 2.
        axis: u8,
    },
    /// The angle or the displacement of a joint, by the number of the joint's own coordinate.
    OfJoint(u32),
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
    /// A variable.
    Leaf(Leaf),
    /// A function of one operand.
    Unary(Unary, Expr),
    /// A function of two operands.
    Binary(Binary, Expr, Expr),
    /// `if lhs < rhs { then } else { otherwise }`; both branches are evaluated.
    Select {
        /// Left side of the comparison.
        lhs: Expr,
        /// Right side of the comparison.
        rhs: Expr,
        /// The value when `lhs < rhs`.
        then: Expr,
        /// The value otherwise, also if one side is NaN.
        otherwise: Expr,
    },
    /// A derivative of a function of one variable, which the arena knows only by number.
    Call {
        /// Number of the function.
        function: u32,
        /// Order of the derivative; 0 is the function itself. Orders above 2 cannot be evaluated, but differentiation may produce them.
        order: u8,
        /// Argument of the function.
        argument: Expr,
    },
    /// An expression with a meaning. Its value is that of the expression.
    Marked {
        /// The meaning.
        mark: Mark,
        /// The expression.
        value: Expr,
    },
}

impl Node {
    /// The same operation on other operands.
    pub(crate) fn with_children(self, mut of: impl FnMut(Expr) -> Expr) -> Node {
        match self {
            Node::Constant(_) | Node::Leaf(_) => self,
            Node::Unary(function, a) => Node::Unary(function, of(a)),
            Node::Binary(function, a, b) => Node::Binary(function, of(a), of(b)),
            Node::Select { lhs, rhs, then, otherwise } => {
                Node::Select { lhs: of(lhs), rhs: of(rhs), then: of(then), otherwise: of(otherwise) }
            }
            Node::Call { function, order, argument } => Node::Call { function, order, argument: of(argument) },
            Node::Marked { mark, value } => Node::Marked { mark, value: of(value) },
        }
    }

    /// The operands, in writing order.
    pub(crate) fn children(&self) -> Operands {
        match *self {
            Node::Constant(_) | Node::Leaf(_) => Operands { all: [Expr(0); 4], next: 4 },
            Node::Unary(_, a) | Node::Call { argument: a, .. } | Node::Marked { value: a, .. } => Operands { all: [a; 4], next: 3 },
            Node::Binary(_, a, b) => Operands { all: [a, a, a, b], next: 2 },
            Node::Select { lhs, rhs, then, otherwise } => Operands { all: [lhs, rhs, then, otherwise], next: 0 },
        }
    }
}

/// The operands of a node, the last of `all`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Operands {
    all: [Expr; 4],
    next: usize,
}

impl Iterator for Operands {
    type Item = Expr;

    fn next(&mut self) -> Option<Expr> {
        let operand = self.all.get(self.next).copied();
        self.next += 1;
        operand
    }
}
