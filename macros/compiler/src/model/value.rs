//! What an expression stands for while names are resolved.

use super::Components;
use super::names::{GroupId, SpaceId};
use crate::expr::Expr;
use crate::quantity::InferredDim;
use crate::syntax::ast;
use std::rc::Rc;

/// Number of a frame; ground is 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct FrameId(pub(crate) usize);

impl FrameId {
    /// The frame that does not move.
    pub(crate) const GROUND: FrameId = FrameId(0);
}

/// A number.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scalar {
    pub(crate) expr: Expr,
    pub(crate) measure: InferredDim,
}

/// A vector in ground.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Vector {
    pub(crate) parts: Components,
    pub(crate) measure: InferredDim,
}

/// Something fixed in a frame, by its local coordinates: a point or an axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fixed {
    pub(crate) frame: FrameId,
    pub(crate) local: Components,
    pub(crate) measure: InferredDim,
}

/// A function of one variable.
#[derive(Clone, Debug)]
pub(crate) enum FunctionValue {
    /// Written in the language.
    Written(ast::Node<ast::Function>),
    /// Known to the arena by number: a Rust function or a table.
    Numbered { number: u32, from: InferredDim, to: InferredDim },
}

/// The arguments that a joint was made with, by the names of its definition.
pub(crate) type Arguments = Rc<Vec<(String, Value)>>;

/// What an expression stands for.
#[derive(Clone, Debug)]
pub(crate) enum Value {
    Scalar(Scalar),
    Vector(Vector),
    Point(Fixed),
    Axis(Fixed),
    Body(FrameId),
    Function(FunctionValue),
    Joint {
        kind: String,
        arguments: Arguments,
    },
    /// A component's instance, by the space of its names.
    Part(SpaceId),
    /// Some of the indices of a name that has more of them.
    Array {
        group: GroupId,
        at: Vec<usize>,
    },
}

impl Value {
    /// Sums and products can be made of it.
    pub(crate) fn is_combinable(&self) -> bool {
        matches!(self, Value::Scalar(_) | Value::Vector(_) | Value::Point(_) | Value::Axis(_))
    }

    /// What it is, in words: `a point`.
    pub(crate) fn noun(&self) -> &'static str {
        match self {
            Value::Scalar(_) => "a number",
            Value::Vector(_) => "a vector",
            Value::Point(_) => "a point",
            Value::Axis(_) => "an axis",
            Value::Body(_) => "a body",
            Value::Function(_) => "a function",
            Value::Joint { .. } => "a joint",
            Value::Part(_) => "a part",
            Value::Array { .. } => "an array",
        }
    }
}
