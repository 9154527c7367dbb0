//! Where an expression stands: the names that it sees, and the definition that it belongs to.

use super::{Context, FrameId, SpaceId, Value};
use crate::diag::Range;
use crate::expr::Arena;
use crate::quantity::Dim;
use proc_macro2::Ident;

/// Names visible to an expression.
#[derive(Clone, Default)]
pub(crate) struct Scope {
    /// Names bound here, innermost last.
    pub(crate) bound: Vec<(String, Value)>,
    /// Namespace whose names are visible, besides those of the mechanism.
    pub(crate) space: Option<SpaceId>,
    /// Where `t` is not allowed, if it is not allowed here.
    pub(crate) timeless: Option<Timeless>,
    /// Body in which the expression stands: its own points and axes stand for their coordinates in it.
    pub(crate) body: Option<FrameId>,
}

/// A place where `t` is not allowed.
#[derive(Clone)]
pub(crate) enum Timeless {
    /// A start value, a point and the like.
    Place(&'static str),
    /// A joint.
    Joint {
        /// Its name.
        name: String,
        /// True if it takes points that may be meant to move.
        has_places: bool,
    },
}

impl Scope {
    /// Scope with all names of the mechanism.
    pub(crate) fn mechanism() -> Scope {
        Scope { space: Some(SpaceId::MECHANISM), ..Scope::default() }
    }

    /// Scope of an item.
    pub(crate) fn of(context: &Context) -> Scope {
        Scope { space: Some(context.space), bound: context.bound.to_vec(), ..Scope::default() }
    }

    /// The same scope without `t`.
    pub(crate) fn timeless(mut self, place: &'static str) -> Scope {
        self.timeless = Some(Timeless::Place(place));
        self
    }

    /// The same scope inside a body.
    pub(crate) fn within(mut self, body: FrameId) -> Scope {
        self.body = Some(body);
        self
    }

    /// The innermost variable of a loop around an item of the mechanism.
    pub(crate) fn index(&self, arena: &Arena) -> Option<&str> {
        self.space?;
        let whole = |value: &Value| match value {
            Value::Scalar(scalar) => arena.as_constant(scalar.expr).is_some_and(|value| value.to_f64().fract() == 0.0),
            _ => false,
        };
        self.bound.iter().rev().find(|(_, value)| whole(value)).map(|(variable, _)| variable.as_str())
    }

    /// Value of a name bound in this scope.
    pub(crate) fn value_of(&self, name: &Ident) -> Option<&Value> {
        self.bound.iter().rev().find(|(known, _)| name == known).map(|(_, value)| value)
    }
}

/// A definition being instantiated.
#[derive(Clone)]
pub(crate) struct Instance {
    /// Source range for errors: the kind of the joint.
    pub(crate) place: Range,
    /// The definition, or one of its equations, for messages.
    pub(crate) definition: String,
    /// Dimensions of the arguments for which the definition allows any.
    pub(crate) quantities: Vec<(String, Dim)>,
}
