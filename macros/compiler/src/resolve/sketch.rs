//! Collects the geometry for the picture.

use super::elaborate::Elaborator;
use crate::diag::Range;
use crate::expr::{Derivatives, Expr, Leaf};
use crate::geometry::{Components, JointQuantity, Place, Triad};
use crate::model::sketch::{Instantiation, JointArgument, LocalVector, MOST_DRAWN, NamedPoint, Sketch};
use crate::names::{Entity, EntityId, Fixed, FunctionValue, Register, Scalar, Scope, Value};
use crate::quantity::{Ambient, InferredDim};

impl Elaborator<'_> {
    /// Collects the declared geometry; call it after everything else has been resolved.
    pub(super) fn sketch(&mut self, register: &Register) -> Sketch {
        if !self.diag.is_clean() || register.bodies.len() > MOST_DRAWN {
            return Sketch::default();
        }
        let arena = self.arena.clone();
        let points = register.marks.iter().filter_map(|mark| self.sketched_mark(*mark, false)).collect();
        let joints: Vec<Instantiation> =
            register.joints.iter().map(|(id, joint)| self.sketched_joint(*id, if joint.is_freedom() { "freedom" } else { "" })).collect();
        let forces = register.forces.iter().map(|(id, _)| (self.names.declared[id.0].name.unraw(), self.sketched_joint(*id, "")));
        let forces = forces.filter_map(|(name, made)| Some((name, made.between()?))).collect();
        let outputs = register.outputs.iter().filter_map(|(id, output)| {
            let value = self.resolved(*id, output, |this, _, context| this.value(&output.value, &Scope::of(context)))?;
            let Value::Point(point) = value else { return None };
            let name = &self.names.declared[id.0].name;
            Some(NamedPoint { name: name.to_string(), span: name.word.span(), at: local(point) })
        });
        let outputs = outputs.collect();
        let rates = self.rates(&joints, register);
        let axes = register.marks.iter().filter_map(|mark| self.sketched_mark(*mark, true)).collect();
        Sketch { arena: std::mem::replace(&mut self.arena, arena), points, axes, joints, forces, outputs, rates }
    }

    /// The rates of the laws of drives in space, whose equations contain the quantities of joints.
    fn rates(&mut self, joints: &[Instantiation], register: &Register) -> Vec<Option<Expr>> {
        if self.names.ambient != Ambient::Space {
            return Vec::new();
        }
        let mut by_time = Derivatives::new(Leaf::Time);
        let drives = register.joints.iter().map(|(_, joint)| joint.is_drive);
        let law = |(made, is_drive): (&Instantiation, bool)| {
            let numbers = made.arguments.iter().rev().filter_map(|(_, argument)| match argument {
                JointArgument::Number(value, _) => Some(*value),
                _ => None,
            });
            numbers.take(usize::from(is_drive)).next()
        };
        let laws: Vec<Option<Expr>> = joints.iter().zip(drives).map(law).collect();
        laws.into_iter().map(|law| law.map(|law| by_time.of(&mut self.arena, law))).collect()
    }

    fn sketched_mark(&mut self, mark: EntityId, is_axis: bool) -> Option<NamedPoint> {
        let declared = &self.names.declared[mark.0];
        let Entity::Mark(..) = declared.entity else { return None };
        let (name, span, range) = (declared.name.own(), declared.name.word.span(), Range::from(&declared.name));
        let ((Value::Point(at), false) | (Value::Axis(at), true)) = (self.entity(mark, range)?, is_axis) else { return None };
        Some(NamedPoint { name, span, at: local(at) })
    }

    fn sketched_joint(&mut self, joint: EntityId, kind: &str) -> Instantiation {
        let range = Range::from(&self.names.declared[joint.0].name);
        self.entity(joint, range).and_then(|value| self.made(range, value)).unwrap_or_else(|| Instantiation::without_arguments(kind))
    }

    fn made(&mut self, range: Range, joint: Value) -> Option<Instantiation> {
        let Value::Joint { kind, arguments } = joint else { return None };
        let argument = |(name, value): &(String, Value)| Some((name.clone(), self.sketched(range, value.clone())?));
        Some(Instantiation { kind, arguments: arguments.iter().filter_map(argument).collect() })
    }

    fn sketched(&mut self, range: Range, value: Value) -> Option<JointArgument> {
        Some(match value {
            Value::Point(point) => JointArgument::Point(local(point)),
            Value::Axis(axis) => JointArgument::Axis(local(axis)),
            Value::Body(frame) => JointArgument::Body(frame.body()),
            Value::Scalar(scalar) => match self.quantity_in_sketch(scalar.expr) {
                Some(quantity) => JointArgument::Joint(quantity),
                None if self.names.ambient == Ambient::Space && !self.follows_from_time(scalar.expr) => return None,
                None => JointArgument::Number(scalar.expr, scalar.measure.settled()),
            },
            Value::Function(function) => JointArgument::Function(self.written_out(range, &function)?),
            joint @ Value::Joint { .. } => JointArgument::Joint(self.made(range, joint)?),
            _ => return None,
        })
    }

    /// The points and axes between which the angle or the displacement of a joint in space is measured.
    fn quantity_in_sketch(&self, expr: Expr) -> Option<Instantiation> {
        let axis = |triad: Triad| JointArgument::Axis(LocalVector { body: triad.body, local: Components::space(triad.axes[2]) });
        let point = |place: Place| JointArgument::Point(LocalVector { body: place.body, local: Components::space(place.local) });
        let (kind, arguments) = match self.quantity_at(expr)? {
            JointQuantity::Angle(one, two) => ("angle", vec![("a", axis(one)), ("b", axis(two))]),
            JointQuantity::Displacement(along, from, to) => {
                ("displacement", vec![("P", point(from)), ("a", axis(along)), ("Q", point(to))])
            }
        };
        Some(Instantiation {
            kind: kind.to_owned(),
            arguments: arguments.into_iter().map(|(name, argument)| (name.to_owned(), argument)).collect(),
        })
    }

    /// It contains neither coordinates nor speeds.
    fn follows_from_time(&self, expr: Expr) -> bool {
        self.arena.leaves(expr).iter().all(|leaf| matches!(leaf, Leaf::Parameter(_) | Leaf::Time | Leaf::Input { .. }))
    }

    /// Value of a function at t. Functions of one variable do not depend on time, so that t can stand for the variable.
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

fn local(fixed: Fixed) -> LocalVector {
    LocalVector { body: fixed.frame.body(), local: fixed.local }
}
