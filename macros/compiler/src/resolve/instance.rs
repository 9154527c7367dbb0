//! Joints: definitions with parameters bound to arguments, or equations written inline.

use super::Name;
use super::elaborate::Elaborator;
use super::statement::ScalarEquation;
use crate::diag::{ArityFact, ArrayFact, EquationFact, Fact, Kind, MeantFor, MotionFact, Note, Range, ValueFact};
use crate::expr::Leaf;
use crate::hints::{decimal_comma, noted, with_rate, without_time};
use crate::library;
use crate::names::{
    Context, EntityId, Fixed, FrameId, FunctionValue, Instance, Scalar, Scope, Timeless, Value, is_between, nearest_kind, places, too_few,
    too_many, unknown_argument, unknown_kind, wanted,
};
use crate::quantity::{Ambient, Dim, InferredDim};
use crate::syntax::ast::{self, Argument, Definition, Formal, FormalKind, JointBody};
use crate::syntax::plain;
use proc_macro2::Ident;
use std::rc::Rc;

impl Elaborator<'_> {
    /// The scalar equations of a joint.
    pub(super) fn joint_rows(
        &mut self,
        id: EntityId,
        joint: &ast::JointItem,
        name: &Name,
        context: &Context,
    ) -> Option<Vec<ScalarEquation>> {
        match &joint.body {
            JointBody::Equations(statements) => {
                let scope = self.joint_scope(joint, context);
                self.has_no_cross_product(joint, statements, &scope)?;
                self.statements(statements, scope, name, &[])
            }
            JointBody::Energy(value) => self.energy(value, false, &self.joint_scope(joint, context)).map(|()| Vec::new()),
            JointBody::Value(value) => self.value_alone(joint, value, &self.joint_scope(joint, context)),
            JointBody::Freedom(freedom) => self.freedom(&joint.name, freedom, &self.joint_scope(joint, context)),
            JointBody::Of { kind, arguments: given, .. } => {
                let Value::Joint { arguments, .. } = self.entity(id, (&joint.name).into())? else { return None };
                let definition = self.definition(kind)?;
                if self.is_on_ground(&arguments) {
                    return self.refuse_here(kind, EquationFact::OnGround { joint: name.to_string(), kind: kind.to_string() });
                }
                let scope = Scope { bound: arguments.to_vec(), ..Scope::default() };
                let outer = self.blame.replace(self.blame_for(&definition, kind, &arguments));
                let rows = self.statements(&definition.statements, scope, name, &places(&definition, given));
                self.blame = outer;
                rows
            }
        }
    }

    /// True if points, axes or bodies were given, all of them of ground, and no argument moves.
    fn is_on_ground(&self, arguments: &[(String, Value)]) -> bool {
        let of_ground = |value: &Value| match value {
            Value::Point(fixed) | Value::Axis(fixed) => Some(fixed.frame == FrameId::GROUND),
            Value::Body(frame) => Some(*frame == FrameId::GROUND),
            Value::Scalar(scalar) => (!self.is_still(scalar.expr)).then_some(false),
            Value::Vector(vector) => vector.parts.iter().any(|part| !self.is_still(*part)).then_some(false),
            Value::Joint { .. } | Value::Part(_) | Value::Array { .. } => Some(false),
            Value::Orientation(_) => None,
            Value::Function(_) => None,
        };
        let mut found = arguments.iter().filter_map(|(_, value)| of_ground(value)).peekable();
        found.peek().is_some() && found.all(|is_of_ground| is_of_ground)
    }

    fn blame_for(&self, definition: &Definition, kind: &Ident, arguments: &[(String, Value)]) -> Instance {
        let is_open =
            |name: &String| definition.parameters.iter().any(|formal| formal.name == *name && matches!(formal.kind, FormalKind::Quantity));
        let quantity = |(name, value): &(String, Value)| match value {
            Value::Scalar(scalar) if is_open(name) => Some((name.clone(), scalar.measure.settled())),
            _ => None,
        };
        let quantities = arguments.iter().filter_map(quantity).collect();
        Instance { place: kind.into(), definition: format!("`{}`", definition.name), quantities }
    }

    pub(super) fn joint_scope(&self, joint: &ast::JointItem, context: &Context) -> Scope {
        let timeless = (!joint.is_drive).then(|| Timeless::Joint { name: joint.name.to_string(), has_places: joint.takes_places() });
        Scope { timeless, ..Scope::of(context) }
    }

    /// Arguments of a joint by parameter name; empty for inline equations.
    pub(super) fn bind_joint(&mut self, joint: &ast::JointItem, context: &Context) -> Option<Vec<(String, Value)>> {
        let JointBody::Of { kind, arguments } = &joint.body else { return Some(Vec::new()) };
        let definition = self.definition(kind)?;
        self.is_of_its_word(joint, context.space, kind, &definition)?;
        let scope = self.joint_scope(joint, context);
        self.bind(&definition, kind, arguments, &scope)
    }

    /// Source range of the first argument of a joint that depends on time.
    pub(super) fn time_dependent_argument(&mut self, id: EntityId, joint: &ast::JointItem) -> Option<Range> {
        let JointBody::Of { kind, arguments } = &joint.body else { return None };
        let definition = self.known_definition(&plain(kind))?;
        let Value::Joint { arguments: bound, .. } = self.entity(id, (&joint.name).into())? else { return None };
        let is_time_dependent = |name: &String| {
            let value = bound.iter().find(|(known, _)| known == name).map(|(_, value)| value);
            matches!(value, Some(Value::Scalar(scalar)) if self.arena.leaves(scalar.expr).into_iter().any(Leaf::is_of_time))
        };
        places(&definition, arguments).into_iter().find(|(name, _)| is_time_dependent(name)).map(|(_, range)| range)
    }

    pub(super) fn definition(&mut self, kind: &Ident) -> Option<Rc<Definition>> {
        let word = plain(kind);
        if let Some(definition) = self.known_definition(&word) {
            return Some(definition);
        }
        if self.names.components.contains_key(&word) {
            return self.refuse(kind, ArrayFact::ComponentAsConstraint { name: word });
        }
        if library::is_elsewhere(&word, self.names.ambient) {
            return self.refuse(kind, ValueFact::only_elsewhere(word, None, self.names.ambient));
        }
        let own = self.names.definitions().keys().map(String::as_str);
        if self.applied.is_some() {
            let laws: Vec<String> = own.chain(library::forces(self.names.ambient)).map(str::to_owned).collect();
            let near = nearest_kind(&word, &laws.iter().map(String::as_str).collect::<Vec<_>>(), |word, known| {
                self.nearest(word, known.iter().copied())
            });
            return self.refuse(kind, MotionFact::UnknownForce { name: word, near, laws, ambient: self.names.ambient });
        }
        let here: Vec<&str> = own.chain(library::constraints(self.names.ambient)).chain(library::forces(self.names.ambient)).collect();
        let fact = unknown_kind(word, &here, self.names.ambient, |word, known| self.nearest(word, known.iter().copied()));
        self.refuse(kind, fact)
    }

    /// Constraint with this name, imported or of the library; a library page is parsed once.
    pub(super) fn known_definition(&mut self, word: &str) -> Option<Rc<Definition>> {
        if let Some(definition) = self.names.definition(word) {
            return Some(definition.clone());
        }
        if let Some(known) = self.names.library.get(word) {
            return known.clone();
        }
        let found = library::find(word, self.names.ambient);
        self.names.library.insert(word.to_owned(), found.clone());
        found
    }

    /// Binds every parameter of a definition to a value, or reports the argument at fault.
    fn bind(&mut self, definition: &Definition, kind: &Ident, given: &[Argument], scope: &Scope) -> Option<Vec<(String, Value)>> {
        self.lack_none_between(definition, kind, given, scope)?;
        let slots: Vec<Option<&ast::Expression>> = self
            .slots(definition, kind, given)?
            .into_iter()
            .map(|slot| slot.and_then(|slot| given.get(slot)).map(|given| &given.value))
            .collect();
        let mut bound: Vec<(String, Value)> = Vec::new();
        let mut complete = true;
        let before = self.diag.refusals().len();
        for (formal, slot) in definition.parameters.iter().zip(slots) {
            let value = match (slot, &formal.default) {
                (Some(argument), _) => self.argument(definition, formal, argument, scope),
                // A default belongs to the definition and can use the parameters before it.
                (None, Some(default)) => {
                    let inner = Scope { bound: bound.clone(), ..Scope::default() };
                    self.argument(definition, formal, default, &inner)
                }
                (None, None) => None,
            };
            complete &= value.is_some();
            bound.extend(value.map(|value| (formal.name.to_string(), value)));
        }
        if !complete {
            self.diag.keep_other_force(before);
            self.are_in_order(definition, given, before, scope);
        }
        complete.then_some(bound)
    }

    /// For each parameter of a definition, the index of its argument, if one was written.
    pub(super) fn slots(&mut self, definition: &Definition, kind: &Ident, given: &[Argument]) -> Option<Vec<Option<usize>>> {
        let wanted = &definition.parameters;
        let mut slots: Vec<Option<usize>> = vec![None; wanted.len()];
        let mut named_before = false;
        for (position, argument) in given.iter().enumerate() {
            let slot = match &argument.name {
                None if named_before => {
                    let next = wanted.iter().zip(&slots).find(|(_, slot)| slot.is_none()).map(|(formal, _)| formal.name.to_string());
                    return self.refuse(argument.value.range, ArityFact::PositionalAfterNamed { next });
                }
                None if position >= wanted.len() => {
                    let decimals = decimal_comma(given.iter().map(|argument| &argument.value));
                    return self.refuse(argument.value.range, too_many(definition, given.len(), decimals));
                }
                None => position,
                Some(name) => {
                    named_before = true;
                    match wanted.iter().position(|formal| formal.name == *name) {
                        Some(slot) => slot,
                        None => return self.refuse(name, unknown_argument(definition, name)),
                    }
                }
            };
            if let Some(first) = slots[slot].replace(position) {
                let blamed = argument.name.as_ref().map_or(argument.value.range, Range::from);
                let (name, is_also_in_order) = (wanted[slot].name.to_string(), given[first].name.is_none());
                return self.refuse(blamed, ArityFact::DuplicateArgument { name, is_also_in_order });
            }
        }
        let missing = wanted.iter().zip(&slots).filter(|(formal, slot)| slot.is_none() && formal.default.is_none());
        let missing: Vec<String> = missing.map(|(formal, _)| formal.name.to_string()).collect();
        if missing.is_empty() {
            return Some(slots);
        }
        let meant = self.meant_by(definition, given);
        self.refuse(kind, too_few(definition, given.len(), missing, meant))
    }

    /// What the user may mean by too few arguments.
    fn meant_by(&self, definition: &Definition, given: &[Argument]) -> MeantFor {
        let name = definition.name.to_string();
        let components = given.iter().find(|argument| matches!(argument.value.kind, ast::ExpressionKind::Tuple(_)));
        if let ("constant_force", Some(components), [point, _]) = (name.as_str(), components, given) {
            return MeantFor::Components(format!("at {}: {}", point.value, components.value));
        }
        match given.first().and_then(|first| self.names.joint_kind(&first.value)) {
            Some(kind) if kind == "revolute" && library::is_force(&name) => MeantFor::Hinge,
            Some(_) if is_between(definition) || library::is_force(&name) => MeantFor::Joint,
            _ => MeantFor::Nothing,
        }
    }

    /// Evaluates an argument and checks its kind.
    pub(super) fn argument(
        &mut self,
        definition: &Definition,
        formal: &Formal,
        argument: &ast::Expression,
        scope: &Scope,
    ) -> Option<Value> {
        let value = match (&formal.kind, &argument.kind) {
            // If a point is written out, each coordinate is checked.
            (FormalKind::Point, ast::ExpressionKind::Tuple(items)) if items.len() == 2 => Value::Vector(self.location(argument, scope)?),
            (FormalKind::Function(..), ast::ExpressionKind::Call(path, _)) if self.names_function(path, scope) => {
                let (wanted, instead) = (wanted(&formal.kind), Some(path.last.to_string()));
                let (parameter, definition, ambient) = (formal.name.to_string(), definition.name.to_string(), self.names.ambient);
                let fact = ValueFact::WrongArgument { parameter, definition, wanted, found: Kind::Number, ambient, instead };
                return self.refuse(argument.range, fact);
            }
            _ => self.value(argument, scope)?,
        };
        let value = self.measured(formal, value)?;
        let found = if let Value::Joint { kind, .. } = &value { Kind::JointOf(kind.clone()) } else { value.kind() };
        self.has_quantity(definition, formal, argument, &value)?;
        self.is_no_coordinate(definition, formal, argument, scope)?;
        let instead = self.instead((definition, &formal.kind), argument, &value, scope);
        let wrong = |this: &mut Self| {
            let (parameter, definition, ambient) = (formal.name.to_string(), definition.name.to_string(), this.names.ambient);
            let wanted = wanted(&formal.kind);
            this.refuse(argument.range, ValueFact::WrongArgument { parameter, definition, wanted, found, ambient, instead })
        };
        match (&formal.kind, value) {
            (FormalKind::Point, value @ Value::Point(_))
            | (FormalKind::Axis, value @ Value::Axis(_))
            | (FormalKind::Body, value @ Value::Body(_)) => Some(value),
            // A constant vector stands for a point or a direction in ground.
            (FormalKind::Point, Value::Vector(vector)) if vector.parts.iter().all(|part| self.arena.is_fixed(*part)) => {
                if !vector.measure.fits(Dim::LENGTH) {
                    return self.refuse(argument.range, ValueFact::WrongDimension { wanted: Dim::LENGTH, found: vector.measure.settled() });
                }
                let measure = InferredDim::Known(Dim::LENGTH);
                Some(Value::Point(Fixed { frame: FrameId::GROUND, local: vector.parts, measure, zero: None }))
            }
            (FormalKind::Axis, Value::Vector(vector)) if vector.parts.iter().all(|part| self.arena.is_fixed(*part)) => {
                self.is_not_zero(argument.range, argument, vector.parts)?;
                let measure = InferredDim::Known(vector.measure.settled());
                Some(Value::Axis(Fixed { frame: FrameId::GROUND, local: vector.parts, measure, zero: None }))
            }
            (FormalKind::Quantity, value @ Value::Scalar(_)) => Some(value),
            (FormalKind::Scalar(written), Value::Scalar(scalar)) => self.quantity_argument(definition, formal, written, (argument, scalar)),
            (FormalKind::Function(from, to), Value::Function(function)) => {
                let (from, to) = (self.dimension(from)?, self.dimension(to)?);
                self.function_argument(argument.range, function, from, to).map(Value::Function)
            }
            (FormalKind::Joint(wanted), Value::Joint { kind, arguments }) => {
                if wanted != &kind {
                    return wrong(self);
                }
                Some(Value::Joint { kind, arguments })
            }
            _ => wrong(self),
        }
    }

    /// Checks the dimension of an argument.
    fn quantity_argument(
        &mut self,
        definition: &Definition,
        formal: &Formal,
        written: &ast::Dimension,
        (argument, scalar): (&ast::Expression, Scalar),
    ) -> Option<Value> {
        let wanted = self.dimension(written)?;
        self.note_bare(argument, wanted);
        // A length by angle counts as a length, but the lead of a screw is not the way of one radian.
        let is_by_angle =
            definition.name == "screw" && formal.name == "lead" && scalar.measure == InferredDim::Known(wanted.per(Dim::ANGLE));
        if is_by_angle || !scalar.measure.fits(wanted) {
            self.is_by_rates([argument, argument])?;
            let found = scalar.measure.settled();
            let fact = ValueFact::WrongArgumentDimension {
                parameter: formal.name.to_string(),
                definition: definition.name.to_string(),
                wanted,
                found,
            };
            // `10rad_s2 * t` for a speed that grows.
            let squared = without_time(argument).filter(|_| found.times(Dim::TIME) == wanted).map(|number| format!("0.5 * {number} * t^2"));
            let turning = || with_rate(argument).filter(|_| (wanted, found) == (Dim::ANGLE, Dim::TIME));
            if let Some(written) = squared.or_else(turning) {
                return self.refuse(argument.range, Fact::Noted { fact: Box::new(fact.into()), note: Note::Instead { written } });
            }
            let fact = noted(&self.declared_unit, fact, argument.range, (found == Dim::NUMBER).then_some((argument, wanted)));
            return self.refuse(argument.range, fact);
        }
        Some(Value::Scalar(Scalar { measure: InferredDim::Known(wanted), ..scalar }))
    }

    /// A joint stands for its angle where an angle is wanted, and for its displacement where a length is.
    fn measured(&mut self, formal: &Formal, value: Value) -> Option<Value> {
        let (FormalKind::Scalar(written), Value::Joint { kind, arguments }) = (&formal.kind, &value) else { return Some(value) };
        let name = match self.dimension(written)? {
            Dim::ANGLE => "angle",
            Dim::LENGTH => "displacement",
            _ => return Some(value),
        };
        let (kind, arguments) = (kind.clone(), arguments.clone());
        Some(self.quantity_of(&kind, &arguments, name).unwrap_or(value))
    }

    /// Refuses a coordinate of a body in space where an axis is wanted.
    fn is_no_coordinate(&mut self, definition: &Definition, formal: &Formal, argument: &ast::Expression, scope: &Scope) -> Option<()> {
        let (FormalKind::Axis, ast::ExpressionKind::Field(body, name), Ambient::Space) = (&formal.kind, &argument.kind, self.names.ambient)
        else {
            return Some(());
        };
        if ["x", "y", "z"].iter().all(|axis| name != axis) || !matches!(self.value(argument, scope)?, Value::Scalar(_)) {
            return Some(());
        }
        let Some(frame) = self.body_of(body, scope) else { return Some(()) };
        let (parameter, definition) = (formal.name.to_string(), definition.name.to_string());
        let (body, name) = (self.names.frames[frame.0].name.clone(), name.to_string());
        self.refuse(argument.range, ValueFact::CoordinateForAxis { parameter, definition, body, name })
    }

    /// The body that a word names.
    fn body_of(&mut self, written: &ast::Expression, scope: &Scope) -> Option<FrameId> {
        let ast::ExpressionKind::Path(_) = written.kind else { return None };
        if let Value::Body(frame) = self.value(written, scope)? { Some(frame) } else { None }
    }

    /// Suggests a replacement for an argument of the wrong kind.
    fn instead(
        &mut self,
        (definition, wanted): (&Definition, &FormalKind),
        argument: &ast::Expression,
        found: &Value,
        scope: &Scope,
    ) -> Option<String> {
        match (wanted, found, &argument.kind) {
            (FormalKind::Point, Value::Body(frame), ast::ExpressionKind::Path(path)) => {
                Some(format!("{}.{}", path.last, self.names.free_point_of(*frame)))
            }
            (FormalKind::Scalar(written), Value::Body(frame), _) if written.dim() == Some(Dim::ANGLE) => match self.names.ambient {
                Ambient::Plane => Some(format!("{argument}.angle")),
                Ambient::Space => self.hinge_of(*frame),
            },
            (FormalKind::Point | FormalKind::Axis | FormalKind::Body, Value::Function(_), ast::ExpressionKind::Path(path))
                if path.name.is_none() =>
            {
                Some(argument.to_string().replace("::", "."))
            }
            (FormalKind::Body, Value::Point(fixed) | Value::Axis(fixed), _) => Some(self.names.frames[fixed.frame.0].name.clone()),
            (FormalKind::Body, Value::Scalar(_), ast::ExpressionKind::Field(body, _)) => {
                self.body_of(body, scope).map(|frame| self.names.frames[frame.0].name.clone())
            }
            (FormalKind::Body, Value::Joint { arguments, .. }, _) => match self.names.bodies_of(arguments).as_slice() {
                [only] => Some((*only).to_owned()),
                [one, two] if definition.name == "drive_angle" => Some(format!("drive_relative_angle({one}, {two}, …)")),
                _ => None,
            },
            (FormalKind::Joint(wanted), Value::Body(frame), _) => {
                self.names.joints_of(*frame).find(|(_, kind, _)| wanted == kind).map(|(name, ..)| name.to_owned())
            }
            (FormalKind::Axis, Value::Body(frame) | Value::Point(Fixed { frame, .. }), _) => {
                let any = if self.names.ambient == Ambient::Space { "(1, 0, 0)" } else { "(1, 0)" };
                let axis = self.names.an_axis_of(*frame).map(|axis| format!("{}.{axis}", self.names.frames[frame.0].name));
                Some(axis.unwrap_or(any.to_owned()))
            }
            _ => None,
        }
    }

    /// True for a declared function, which is passed without its argument.
    fn names_function(&self, path: &ast::Path, scope: &Scope) -> bool {
        path.name.as_ref().is_some_and(|name| self.is_function(name, scope))
    }

    fn function_argument(&mut self, range: Range, function: FunctionValue, from: Dim, to: Dim) -> Option<FunctionValue> {
        let (takes, gives) = match &function {
            FunctionValue::Written(written) => {
                (InferredDim::Known(self.dimension(&written.from)?), InferredDim::Known(self.dimension(&written.to)?))
            }
            FunctionValue::Numbered { from, to, .. } => (*from, *to),
        };
        let (from, to) = (InferredDim::Known(from), InferredDim::Known(to));
        if from.common(takes).is_none() {
            return self.refuse(range, ValueFact::FunctionTakes { wanted: from.settled(), found: takes.settled() });
        }
        if to.common(gives).is_none() {
            return self.refuse(range, ValueFact::WrongDimension { wanted: to.settled(), found: gives.settled() });
        }
        Some(match function {
            FunctionValue::Numbered { number, .. } => FunctionValue::Numbered { number, from, to },
            written => written,
        })
    }
}
