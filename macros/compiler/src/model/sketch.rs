//! What equations no longer know and a picture needs: where points lie in their bodies, and what joints were made with.
//!
//! Everything here is an expression in an arena of its own, so that looking at a mechanism does not change how it is solved.

use super::Components;
use super::elaborate::{Elaborator, Scope};
use super::names::{Entity, EntityId};
use super::register::Register;
use super::value::{Fixed, FrameId, FunctionValue, Scalar, Value};
use crate::diag::Range;
use crate::expr::{Arena, Expr, Leaf};
use crate::quantity::{Dim, InferredDim};

/// Mechanisms with more bodies are not drawn: nothing could be told apart.
pub const MOST_DRAWN: usize = 200;

/// The geometry of a mechanism, as far as it was declared.
#[derive(Clone, Debug, Default)]
pub struct Sketch {
    /// Its expressions.
    pub arena: Arena,
    /// The declared points of bodies and of ground.
    pub points: Vec<Mark>,
    /// For each joint or drive, in the order declared, what it was made with.
    pub joints: Vec<Instantiation>,
    /// The outputs that are points of bodies.
    pub outputs: Vec<Mark>,
}

/// A point with a name.
#[derive(Clone, Debug)]
pub struct Mark {
    /// What it is called; that of a body without the body's name.
    pub name: String,
    /// Where it is.
    pub at: Local,
}

/// A point or an axis by its local coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Local {
    /// The body that it moves with; none for ground.
    pub body: Option<usize>,
    /// Its components in the body's frame, functions of parameters; those of a point are lengths.
    pub local: Components,
}

/// A constraint with its arguments.
#[derive(Clone, Debug, Default)]
pub struct Instantiation {
    /// The constraint's own name, whatever a `use` item calls it.
    pub kind: String,
    /// The arguments by the names of the definition; none for equations written inline.
    pub arguments: Vec<(String, Argument)>,
}

/// One argument.
#[derive(Clone, Debug)]
pub enum Argument {
    /// A point.
    Point(Local),
    /// An axis, of any length.
    Axis(Local),
    /// A body; none is ground.
    Body(Option<usize>),
    /// A number with what it measures.
    Number(Expr, Dim),
    /// A function of one variable, written out for the time in the variable's place.
    Function(Expr),
    /// Another joint.
    Joint(Instantiation),
}

impl Elaborator<'_> {
    /// What was declared of a mechanism's looks; to be asked for when everything else has been resolved.
    pub(super) fn sketch(&mut self, register: &Register) -> Sketch {
        if !self.diag.is_clean() || register.bodies.len() > MOST_DRAWN {
            return Sketch::default();
        }
        let arena = self.arena.clone();
        let points = register.marks.iter().filter_map(|mark| self.sketched_point(*mark)).collect();
        let joints = register.joints.iter().map(|(id, _)| self.sketched_joint(*id)).collect();
        let outputs = register.outputs.iter().filter_map(|(id, output)| {
            let value = self.of(*id, output, |this, _, context| this.value(&output.value, &Scope::of(context)))?;
            let Value::Point(point) = value else { return None };
            Some(Mark { name: self.names.declared[id.0].name.to_string(), at: local(point) })
        });
        let outputs = outputs.collect();
        Sketch { arena: std::mem::replace(&mut self.arena, arena), points, joints, outputs }
    }

    fn sketched_point(&mut self, mark: EntityId) -> Option<Mark> {
        let declared = &self.names.declared[mark.0];
        let Entity::Mark(..) = declared.entity else { return None };
        let (name, range) = (declared.name.own(), Range::from(&declared.name));
        let Some(Value::Point(point)) = self.entity(mark, range) else { return None };
        Some(Mark { name, at: local(point) })
    }

    fn sketched_joint(&mut self, joint: EntityId) -> Instantiation {
        let range = Range::from(&self.names.declared[joint.0].name);
        self.entity(joint, range).and_then(|value| self.made(range, value)).unwrap_or_default()
    }

    fn made(&mut self, range: Range, joint: Value) -> Option<Instantiation> {
        let Value::Joint { kind, arguments } = joint else { return None };
        let argument = |(name, value): &(String, Value)| Some((name.clone(), self.sketched(range, value.clone())?));
        Some(Instantiation { kind, arguments: arguments.iter().filter_map(argument).collect() })
    }

    fn sketched(&mut self, range: Range, value: Value) -> Option<Argument> {
        Some(match value {
            Value::Point(point) => Argument::Point(local(point)),
            Value::Axis(axis) => Argument::Axis(local(axis)),
            Value::Body(frame) => Argument::Body(body(frame)),
            Value::Scalar(scalar) => Argument::Number(scalar.expr, scalar.measure.settled()),
            Value::Function(function) => Argument::Function(self.written_out(range, &function)?),
            joint @ Value::Joint { .. } => Argument::Joint(self.made(range, joint)?),
            _ => return None,
        })
    }

    /// The value of a function at t: functions of one variable do not know the time, so that it can stand for the variable.
    fn written_out(&mut self, range: Range, function: &FunctionValue) -> Option<Expr> {
        let expr = self.arena.leaf(Leaf::Time);
        match function {
            FunctionValue::Numbered { number, .. } => Some(self.arena.call(*number, 0, expr)),
            FunctionValue::Written(written) => {
                let measure = InferredDim::Known(self.dimension(&written.from)?);
                self.written(range, written, Scalar { expr, measure }).map(|scalar| scalar.expr)
            }
        }
    }
}

fn local(fixed: Fixed) -> Local {
    Local { body: body(fixed.frame), local: fixed.local }
}

/// Ground is the first frame.
fn body(frame: FrameId) -> Option<usize> {
    frame.0.checked_sub(1)
}
