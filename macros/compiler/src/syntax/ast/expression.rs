//! Expressions as written.

use super::Path;
use crate::diag::Range;
use proc_macro2::Ident;

/// An expression.
#[derive(Clone, Debug)]
pub struct Expression {
    /// Kind of expression.
    pub kind: ExpressionKind,
    /// Source range, from the first to the last token.
    pub range: Range,
    /// Longest path to a leaf, bounded by the parser.
    pub depth: u16,
}

impl Expression {
    /// Visits the expression and all its parts.
    pub(crate) fn each<'a>(&'a self, visit: &mut impl FnMut(&'a Expression)) {
        visit(self);
        match &self.kind {
            ExpressionKind::Path(_) | ExpressionKind::Number { .. } => {}
            ExpressionKind::Field(value, _) | ExpressionKind::Negative(value) => value.each(visit),
            ExpressionKind::Index(one, two) | ExpressionKind::Binary(_, one, two) => {
                one.each(visit);
                two.each(visit);
            }
            ExpressionKind::Call(_, items) | ExpressionKind::Tuple(items) | ExpressionKind::List(items) => {
                items.iter().for_each(|item| item.each(visit));
            }
            ExpressionKind::If { lhs, rhs, then, otherwise, .. } => {
                [lhs, rhs, then, otherwise].into_iter().for_each(|part| part.each(visit))
            }
        }
    }

    /// The name, if the expression is one.
    pub(crate) fn name(&self) -> Option<&Ident> {
        match &self.kind {
            ExpressionKind::Path(path) => path.name.as_ref(),
            _ => None,
        }
    }
}

/// Kinds of expressions.
#[derive(Clone, Debug)]
pub enum ExpressionKind {
    /// `120mm`
    Number {
        /// The digits, without unit.
        digits: String,
        /// Name of the unit; empty if there is none.
        unit: String,
    },
    /// A name or a path to a Rust item.
    Path(Path),
    /// `value.field`
    Field(Box<Expression>, Ident),
    /// `array[index]`
    Index(Box<Expression>, Box<Expression>),
    /// `function(arguments)`
    Call(Path, Vec<Expression>),
    /// `-value`
    Negative(Box<Expression>),
    /// `lhs op rhs`
    Binary(Operator, Box<Expression>, Box<Expression>),
    /// `(x, y)`
    Tuple(Vec<Expression>),
    /// `[a, b, …]`
    List(Vec<Expression>),
    /// `if lhs < rhs { then } else { otherwise }`
    If {
        /// Left side of the relation.
        lhs: Box<Expression>,
        /// Relation to test.
        relation: Relation,
        /// Right side of the relation.
        rhs: Box<Expression>,
        /// Value if the relation holds.
        then: Box<Expression>,
        /// Value if it does not.
        otherwise: Box<Expression>,
    },
}

/// A binary operator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// `+`
    Add,
    /// `-`
    Sub,
    /// `*`
    Mul,
    /// `/`
    Div,
    /// `%`
    Rem,
    /// `^`
    Power,
}

/// Relation between two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// `<`
    Less,
    /// `<=`
    LessOrEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterOrEqual,
    /// `==`
    Equal,
    /// `!=`
    Different,
}

impl Relation {
    /// Evaluates the comparison. An undecidable one counts as true: Rust functions are not run in the compiler.
    pub(crate) fn holds(self, lhs: f64, rhs: f64) -> bool {
        if lhs.is_nan() || rhs.is_nan() {
            return true;
        }
        match self {
            Relation::Less => lhs < rhs,
            Relation::LessOrEqual => lhs <= rhs,
            Relation::Greater => lhs > rhs,
            Relation::GreaterOrEqual => lhs >= rhs,
            Relation::Equal => lhs == rhs,
            Relation::Different => lhs != rhs,
        }
    }
}
