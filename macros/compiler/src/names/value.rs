//! Values of expressions while names are resolved.

use super::{GroupId, SpaceId};
use crate::diag::Kind;
use crate::expr::Expr;
use crate::geometry::{Components, Rotation};
use crate::quantity::InferredDim;
use crate::syntax::ast;
use std::rc::Rc;

/// Number of a frame; ground is 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct FrameId(pub(crate) usize);

impl FrameId {
    /// The frame that does not move.
    pub(crate) const GROUND: FrameId = FrameId(0);

    /// Its body; `None` for ground.
    pub(crate) fn body(self) -> Option<usize> {
        self.0.checked_sub(1)
    }
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

/// A point or an axis, by its local coordinates in the frame that carries it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fixed {
    pub(crate) frame: FrameId,
    pub(crate) local: Components,
    pub(crate) measure: InferredDim,
    /// Direction from which angles about an axis are counted, if declared.
    pub(crate) zero: Option<Components>,
}

/// A function of one variable.
#[derive(Clone, Debug)]
pub(crate) enum FunctionValue {
    /// A function written in the language.
    Written(ast::Shared<ast::FunctionItem>),
    /// A Rust function or a table, known to the arena by number.
    Numbered { number: u32, from: InferredDim, to: InferredDim },
}

/// Arguments of a joint, by parameter name.
pub(crate) type Arguments = Rc<Vec<(String, Value)>>;

/// Value of an expression.
#[derive(Clone, Debug)]
pub(crate) enum Value {
    Scalar(Scalar),
    Vector(Vector),
    Point(Fixed),
    Axis(Fixed),
    Body(FrameId),
    /// A product of rotations, of which the last comes first.
    Orientation(Rc<[Rotation]>),
    Function(FunctionValue),
    Joint {
        kind: String,
        arguments: Arguments,
    },
    /// A part, by its namespace.
    Part(SpaceId),
    /// An array that still lacks some of its indices.
    Array {
        group: GroupId,
        at: Vec<usize>,
    },
}

impl Value {
    /// The same inside a body: its own points and axes are their coordinates there.
    pub(crate) fn inside(self, body: Option<FrameId>) -> Value {
        match self {
            Value::Point(own) if body == Some(own.frame) => Value::Vector(Vector { parts: own.local, measure: own.measure }),
            // It keeps the direction from which angles count.
            Value::Axis(own) if body == Some(own.frame) => Value::Axis(Fixed { frame: FrameId::GROUND, ..own }),
            other => other,
        }
    }

    /// True if sums and products can be formed of the value.
    pub(crate) fn is_combinable(&self) -> bool {
        matches!(self, Value::Scalar(_)) || self.is_vector()
    }

    /// The number, if it is one.
    pub(crate) fn scalar(&self) -> Option<Scalar> {
        if let Value::Scalar(scalar) = self { Some(*scalar) } else { None }
    }

    /// The frame of a point, an axis or a body.
    pub(crate) fn frame(&self) -> Option<FrameId> {
        match self {
            Value::Point(fixed) | Value::Axis(fixed) => Some(fixed.frame),
            Value::Body(frame) => Some(*frame),
            _ => None,
        }
    }

    /// True if the value is a vector or stands for one.
    pub(crate) fn is_vector(&self) -> bool {
        matches!(self, Value::Vector(_) | Value::Point(_) | Value::Axis(_))
    }

    /// Kind of the value, for messages.
    pub(crate) fn kind(&self) -> Kind {
        match self {
            Value::Scalar(_) => Kind::Number,
            Value::Vector(_) => Kind::Vector,
            Value::Point(_) => Kind::Point,
            Value::Axis(_) => Kind::Axis,
            Value::Body(_) => Kind::Body,
            Value::Orientation(_) => Kind::Orientation,
            Value::Function(_) => Kind::Function,
            Value::Joint { .. } => Kind::Joint,
            Value::Part(_) => Kind::Part,
            Value::Array { .. } => Kind::Array,
        }
    }
}
