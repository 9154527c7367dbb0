//! Joints: a definition with its parameters bound to arguments, or equations written inline.

use super::dimension::{Dim, Measure};
use super::elaborate::{Blame, Elaborator, Scope, Timeless};
use super::signature::{noun, places, too_few, too_many, unknown_argument};
use super::statement::Row;
use super::suggest::nearest;
use super::value::{Fixed, FrameId, Function, Scalar, Value};
use crate::diag::{Fact, Range};
use crate::expr::Leaf;
use crate::library;
use crate::syntax::ast::{self, Argument, Definition, Formal, JointBody, Kind};
use proc_macro2::Ident;
use std::rc::Rc;

impl Elaborator<'_> {
    /// The scalar equations of a joint.
    pub(super) fn joint_rows(&mut self, joint: &ast::Joint) -> Option<Vec<Row>> {
        let shared = Rc::new(joint.clone());
        match &joint.body {
            JointBody::Equations(statements) => {
                let scope = self.joint_scope(joint);
                self.statements(statements, scope, joint, &[])
            }
            JointBody::Of { kind, arguments: given, .. } => {
                let arguments = self.joint_arguments(&shared)?;
                let definition = self.definition(kind)?;
                let scope = Scope { bound: arguments.to_vec(), ..Scope::default() };
                let outer = self.blame.replace(self.blame_for(&definition, kind, &arguments));
                let rows = self.statements(&definition.statements, scope, joint, &places(&definition, given));
                self.blame = outer;
                rows
            }
        }
    }

    fn blame_for(&self, definition: &Definition, kind: &Ident, arguments: &[(String, Value)]) -> Blame {
        let is_open =
            |name: &String| definition.parameters.iter().any(|formal| formal.name == *name && matches!(formal.kind, Kind::Quantity));
        let quantity = |(name, value): &(String, Value)| match value {
            Value::Scalar(scalar) if is_open(name) => Some((name.clone(), scalar.measure.settled())),
            _ => None,
        };
        let quantities = arguments.iter().filter_map(quantity).collect();
        Blame { place: kind.into(), definition: format!("`{}`", definition.name), quantities }
    }

    fn joint_scope(&self, joint: &ast::Joint) -> Scope {
        let timeless = (!joint.is_drive).then(|| Timeless::Joint(joint.name.to_string()));
        Scope { timeless, ..Scope::mechanism() }
    }

    /// The arguments of a joint by the names of its definition; none for equations.
    pub(super) fn bind_joint(&mut self, joint: &ast::Joint) -> Option<Vec<(String, Value)>> {
        let JointBody::Of { kind, arguments } = &joint.body else { return Some(Vec::new()) };
        let definition = self.definition(kind)?;
        let scope = self.joint_scope(joint);
        self.bind(&definition, kind, arguments, &scope)
    }

    /// The first argument of a joint that depends on time.
    pub(super) fn time_dependent_argument(&self, joint: &ast::Joint) -> Option<Range> {
        let JointBody::Of { kind, arguments } = &joint.body else { return None };
        let definition = self.names.definitions.get(&kind.to_string()).cloned().or_else(|| library::find(&kind.to_string()))?;
        let bound = self.names.arguments_of(&joint.name)?;
        let is_time_dependent = |name: &String| {
            let value = bound.iter().find(|(known, _)| known == name).map(|(_, value)| value);
            matches!(value, Some(Value::Scalar(scalar)) if self.arena.leaves(scalar.expr).contains(&Leaf::Time))
        };
        places(&definition, arguments).into_iter().find(|(name, _)| is_time_dependent(name)).map(|(_, range)| range)
    }

    pub(super) fn definition(&mut self, kind: &Ident) -> Option<Rc<Definition>> {
        let word = kind.to_string();
        if let Some(definition) = self.names.definitions.get(&word) {
            return Some(definition.clone());
        }
        if let Some(definition) = library::find(&word) {
            return Some(definition);
        }
        let known = self.names.definitions.keys().map(String::as_str).chain(library::constraints());
        let near = nearest(&word, known);
        self.refuse(kind, Fact::UnknownConstraint { name: word, near })
    }

    /// Binds every parameter of a definition, or says which argument is to blame.
    fn bind(&mut self, definition: &Definition, kind: &Ident, given: &[Argument], scope: &Scope) -> Option<Vec<(String, Value)>> {
        let slots = self.slots(definition, kind, given)?;
        let mut bound: Vec<(String, Value)> = Vec::new();
        let mut complete = true;
        for (formal, slot) in definition.parameters.iter().zip(slots) {
            let value = match (slot, &formal.default) {
                (Some(argument), _) => self.argument(definition, formal, argument, scope),
                // A default stands in the definition and sees the parameters before it.
                (None, Some(default)) => {
                    let inner = Scope { bound: bound.clone(), ..Scope::default() };
                    self.argument(definition, formal, default, &inner)
                }
                (None, None) => None,
            };
            complete &= value.is_some();
            bound.extend(value.map(|value| (formal.name.to_string(), value)));
        }
        complete.then_some(bound)
    }

    /// What was written for each parameter of a definition, if anything.
    fn slots<'a>(&mut self, definition: &Definition, kind: &Ident, given: &'a [Argument]) -> Option<Vec<Option<&'a ast::Expr>>> {
        let wanted = &definition.parameters;
        let mut slots: Vec<Option<&ast::Expr>> = vec![None; wanted.len()];
        let mut named_before = false;
        for (position, argument) in given.iter().enumerate() {
            let slot = match &argument.name {
                None if named_before => return self.refuse(argument.value.range, Fact::PositionalAfterNamed),
                None if position >= wanted.len() => return self.refuse(argument.value.range, too_many(definition, given.len())),
                None => position,
                Some(name) => {
                    named_before = true;
                    match wanted.iter().position(|formal| formal.name == *name) {
                        Some(slot) => slot,
                        None => return self.refuse(name, unknown_argument(definition, name)),
                    }
                }
            };
            if slots[slot].replace(&argument.value).is_some() {
                let blamed = argument.name.as_ref().map_or(argument.value.range, Range::from);
                return self.refuse(blamed, Fact::DuplicateArgument { name: wanted[slot].name.to_string() });
            }
        }
        let missing = wanted.iter().zip(&slots).filter(|(formal, slot)| slot.is_none() && formal.default.is_none());
        let missing: Vec<String> = missing.map(|(formal, _)| formal.name.to_string()).collect();
        if missing.is_empty() { Some(slots) } else { self.refuse(kind, too_few(definition, given.len(), missing)) }
    }

    /// One argument, of the kind its parameter takes.
    fn argument(&mut self, definition: &Definition, formal: &Formal, argument: &ast::Expr, scope: &Scope) -> Option<Value> {
        let value = self.value(argument, scope)?;
        let found = match &value {
            Value::Joint { kind, .. } => format!("a `{kind}` joint"),
            other => other.noun().to_owned(),
        };
        let instead = self.instead(&formal.kind, argument, &value);
        let wrong = |this: &mut Self, wanted: String| {
            let (parameter, definition) = (formal.name.to_string(), definition.name.to_string());
            this.refuse(
                argument.range,
                Fact::WrongArgument { parameter, definition, wanted, found: found.clone(), instead: instead.clone() },
            )
        };
        match (&formal.kind, value) {
            (Kind::Point, value @ Value::Point(_)) | (Kind::Axis, value @ Value::Axis(_)) | (Kind::Body, value @ Value::Body(_)) => {
                Some(value)
            }
            // A constant vector is a place or a direction in ground.
            (Kind::Point, Value::Vector(vector)) if self.is_fixed(vector.x) && self.is_fixed(vector.y) => {
                if !vector.measure.fits(Dim::LENGTH) {
                    return self.refuse(argument.range, Fact::WrongDimension { wanted: Dim::LENGTH, found: vector.measure.settled() });
                }
                let measure = Measure::Of(Dim::LENGTH);
                Some(Value::Point(Fixed { frame: FrameId::GROUND, local: [vector.x, vector.y], measure }))
            }
            (Kind::Axis, Value::Vector(vector)) if self.is_fixed(vector.x) && self.is_fixed(vector.y) => {
                let measure = Measure::Of(vector.measure.settled());
                Some(Value::Axis(Fixed { frame: FrameId::GROUND, local: [vector.x, vector.y], measure }))
            }
            (Kind::Quantity, value @ Value::Scalar(_)) => Some(value),
            (Kind::Scalar(written), Value::Scalar(scalar)) => {
                let wanted = self.dimension(written)?;
                if !scalar.measure.fits(wanted) {
                    let fact = Fact::WrongArgumentDimension {
                        parameter: formal.name.to_string(),
                        definition: definition.name.to_string(),
                        wanted,
                        found: scalar.measure.settled(),
                    };
                    return self.refuse(argument.range, fact);
                }
                Some(Value::Scalar(Scalar { measure: Measure::Of(wanted), ..scalar }))
            }
            (Kind::Function(from, to), Value::Function(function)) => {
                let (from, to) = (self.dimension(from)?, self.dimension(to)?);
                self.function_argument(argument.range, function, from, to).map(Value::Function)
            }
            (Kind::Joint(wanted), Value::Joint { kind, arguments }) => {
                if wanted != &kind {
                    return wrong(self, format!("a `{wanted}` joint"));
                }
                Some(Value::Joint { kind, arguments })
            }
            (kind, _) => wrong(self, noun(kind)),
        }
    }

    /// What might have been meant by an argument of another kind.
    fn instead(&self, wanted: &Kind, argument: &ast::Expr, found: &Value) -> Option<String> {
        match (wanted, found, &argument.kind) {
            (Kind::Point, Value::Body(frame), ast::ExprKind::Path(path)) => {
                Some(format!("{}.{}", path.last, self.names.a_point_of(*frame).unwrap_or("position")))
            }
            (Kind::Body, Value::Point(point), _) => Some(self.names.frames[point.frame.0].name.clone()),
            (Kind::Axis, Value::Body(_) | Value::Point(_), _) => Some("(1, 0)".to_owned()),
            _ => None,
        }
    }

    fn function_argument(&mut self, range: Range, function: Function, from: Dim, to: Dim) -> Option<Function> {
        let (takes, gives) = match &function {
            Function::Written(written) => (Measure::Of(self.dimension(&written.from)?), Measure::Of(self.dimension(&written.to)?)),
            Function::Numbered { from, to, .. } => (*from, *to),
        };
        let (from, to) = (Measure::Of(from), Measure::Of(to));
        if from.common(takes).is_none() {
            return self.refuse(range, Fact::FunctionTakes { wanted: from.settled(), found: takes.settled() });
        }
        if to.common(gives).is_none() {
            return self.refuse(range, Fact::WrongDimension { wanted: to.settled(), found: gives.settled() });
        }
        Some(match function {
            Function::Numbered { number, .. } => Function::Numbered { number, from, to },
            written => written,
        })
    }
}
