//! Expressions as text, for lines that a message proposes to type.

use super::{Expression, ExpressionKind, Operator, Relation};
use std::fmt::{Display, Formatter, Result};

impl Display for Operator {
    fn fmt(&self, f: &mut Formatter) -> Result {
        f.write_str(match self {
            Operator::Add => "+",
            Operator::Sub => "-",
            Operator::Mul => "*",
            Operator::Div => "/",
            Operator::Rem => "%",
            Operator::Power => "^",
        })
    }
}

impl Display for Relation {
    fn fmt(&self, f: &mut Formatter) -> Result {
        f.write_str(match self {
            Relation::Less => "<",
            Relation::LessOrEqual => "<=",
            Relation::Greater => ">",
            Relation::GreaterOrEqual => ">=",
            Relation::Equal => "==",
            Relation::Different => "!=",
        })
    }
}

impl Operator {
    /// Tighter operators have a higher number.
    fn tightness(self) -> u8 {
        match self {
            Operator::Add | Operator::Sub => 1,
            Operator::Mul | Operator::Div | Operator::Rem => 2,
            Operator::Power => 4,
        }
    }
}

impl Display for Expression {
    fn fmt(&self, f: &mut Formatter) -> Result {
        match &self.kind {
            ExpressionKind::Number { digits, unit } => write!(f, "{digits}{unit}"),
            ExpressionKind::Path(path) => write!(f, "{}", path.tokens.to_string().replace(' ', "")),
            ExpressionKind::Field(owner, field) => write!(f, "{}.{field}", Inner(owner, u8::MAX)),
            ExpressionKind::Index(array, index) => write!(f, "{}[{index}]", Inner(array, u8::MAX)),
            ExpressionKind::Call(path, arguments) => {
                write!(f, "{}({})", path.tokens.to_string().replace(' ', ""), List(arguments))
            }
            ExpressionKind::Negative(value) => write!(f, "-{}", Inner(value, 3)),
            ExpressionKind::Binary(Operator::Power, base, exponent) => write!(f, "{}^{}", Inner(base, 5), Inner(exponent, 3)),
            // The right side of a difference or a quotient is grouped where it is a sum or a product itself.
            ExpressionKind::Binary(operator, lhs, rhs) => {
                let tightness = operator.tightness();
                write!(f, "{} {operator} {}", Inner(lhs, tightness), Inner(rhs, tightness + 1))
            }
            ExpressionKind::Tuple(items) => write!(f, "({})", List(items)),
            ExpressionKind::List(items) => write!(f, "[{}]", List(items)),
            ExpressionKind::If { lhs, relation, rhs, then, otherwise } => {
                write!(f, "if {lhs} {relation} {rhs} {{ {then} }} else {{ {otherwise} }}")
            }
        }
    }
}

/// An operand, in parentheses where it binds less tightly than this.
struct Inner<'a>(&'a Expression, u8);

impl Display for Inner<'_> {
    fn fmt(&self, f: &mut Formatter) -> Result {
        let Inner(value, tightness) = self;
        let own = match &value.kind {
            ExpressionKind::Binary(operator, ..) => operator.tightness(),
            ExpressionKind::Negative(_) => 3,
            ExpressionKind::If { .. } => 0,
            _ => u8::MAX,
        };
        if own < *tightness { write!(f, "({value})") } else { write!(f, "{value}") }
    }
}

/// Expressions with commas between them.
struct List<'a>(&'a [Expression]);

impl Display for List<'_> {
    fn fmt(&self, f: &mut Formatter) -> Result {
        self.0.iter().enumerate().try_for_each(|(number, item)| write!(f, "{}{item}", if number == 0 { "" } else { ", " }))
    }
}
