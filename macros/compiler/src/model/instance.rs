//! Joints: a definition with its parameters bound to arguments, or equations written inline.

use super::dimension::{Dim, Measure};
use super::elaborate::{Blame, Elaborator, Scope, Timeless};
use super::suggest::nearest;
use super::value::{Fixed, FrameId, Function, Scalar, Value};
use super::{Parameter, Requirement};
use crate::diag::{Fact, Range};
use crate::expr::{Leaf, Values, evaluate};
use crate::library;
use crate::syntax::ast::{self, Argument, Definition, Formal, JointBody, Kind, Relation, Statement};
use proc_macro2::Ident;
use std::rc::Rc;

/// One scalar equation: left minus right side, and what to blame for it.
#[derive(Clone, Copy)]
pub(super) struct Row {
    pub(super) residual: Scalar,
    pub(super) range: Range,
}

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
        let is_open = |name: &String| definition.parameters.iter().any(|formal| formal.name == *name && matches!(formal.kind, Kind::Quantity));
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

    fn definition(&mut self, kind: &Ident) -> Option<Rc<Definition>> {
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
            this.refuse(argument.range, Fact::WrongArgument { parameter, definition, wanted, found: found.clone(), instead: instead.clone() })
        };
        match (&formal.kind, value) {
            (Kind::Point, value @ Value::Point(_)) | (Kind::Axis, value @ Value::Axis(_)) | (Kind::Body, value @ Value::Body(_)) => Some(value),
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

    /// The residuals of a list of statements.
    pub(super) fn statements(&mut self, statements: &[Statement], mut scope: Scope, joint: &ast::Joint, places: &[(String, Range)]) -> Option<Vec<Row>> {
        let mut rows: Vec<Row> = Vec::new();
        let of = statements.iter().filter(|statement| matches!(statement, Statement::Equation(..))).count();
        let mut number = 0;
        let mut complete = true;
        for statement in statements {
            match statement {
                Statement::Let(binding) => {
                    let value = self.binding(binding, &scope)?;
                    scope.bound.push((binding.name.to_string(), value));
                }
                Statement::Equation(lhs, rhs) => {
                    number += 1;
                    match self.numbered(number, of, |this| this.residuals(lhs, rhs, &scope)) {
                        Some(residuals) => {
                            let range = self.blame.as_ref().map_or(lhs.range.to(rhs.range), |blame| blame.place);
                            rows.extend(residuals.into_iter().map(|residual| Row { residual, range }));
                        }
                        None => complete = false,
                    }
                }
                Statement::Require(requirement) => complete &= self.requirement(requirement, &scope, joint, places).is_some(),
            }
            // Inside an instance one error is enough: the next would blame the same token.
            if !complete && self.blame.is_some() {
                return None;
            }
        }
        if complete && rows.is_empty() {
            return self.refuse(&joint.name, Fact::NoEquations { name: joint.name.to_string() });
        }
        complete.then_some(rows)
    }

    /// Inside a definition that is being instantiated, names the equation in what is refused.
    fn numbered<T>(&mut self, number: usize, of: usize, read: impl FnOnce(&mut Self) -> T) -> T {
        let outer = self.blame.clone();
        if let (Some(Blame { definition, .. }), true) = (&mut self.blame, of > 1) {
            *definition = format!("equation {number} of {definition}");
        }
        let value = read(self);
        self.blame = outer;
        value
    }

    /// A condition: on bodies it is decided here, on numbers it is kept until defaults are known.
    fn requirement(&mut self, requirement: &ast::Requirement, scope: &Scope, joint: &ast::Joint, places: &[(String, Range)]) -> Option<()> {
        let (left, right) = (self.value(&requirement.lhs, scope), self.value(&requirement.rhs, scope));
        let (left, right) = (left?, right?);
        let place = match &requirement.lhs.kind {
            ast::ExprKind::Path(path) => places.iter().find(|(name, _)| path.name.as_ref().is_some_and(|known| known == name)),
            _ => None,
        };
        let place = place.map(|(_, range)| *range);
        let range = requirement.lhs.range.to(requirement.rhs.range);
        if let (Value::Body(one), Value::Body(two)) = (&left, &right) {
            let holds = (one == two) == (requirement.relation == Relation::Equal);
            if holds || self.names.is_abstract() {
                return Some(());
            }
            return self.refuse_at(place, range, Fact::RequirementFails { why: requirement.why.clone() });
        }
        let (Value::Scalar(one), Value::Scalar(two)) = (&left, &right) else {
            return self.refuse(range, Fact::CannotCompare { one: left.noun(), two: right.noun() });
        };
        if one.measure.common(two.measure).is_none() {
            return self.refuse(range, Fact::Unlike { action: "compare", one: one.measure.settled(), two: two.measure.settled() });
        }
        let (lhs, rhs) = (one.expr, two.expr);
        if self.names.is_abstract() {
            return Some(());
        }
        if !self.is_fixed(lhs) || !self.is_fixed(rhs) {
            // A law of time can be zero at times; that is for the solver to notice.
            return Some(());
        }
        if self.arena.leaves(lhs).is_empty() && self.arena.leaves(rhs).is_empty() {
            let values = self.numbers(&[], &[lhs, rhs]);
            if !holds(requirement.relation, values[0], values[1]) {
                return self.refuse_at(place, range, Fact::RequirementFails { why: requirement.why.clone() });
            }
            return Some(());
        }
        let (joint, why) = (joint.name.to_string(), requirement.why.clone());
        self.requirements.push(Requirement { lhs, relation: requirement.relation, rhs, joint, why });
        self.requirement_places.push(place.or(self.blame.as_ref().map(|blame| blame.place)).unwrap_or(range));
        Some(())
    }

    /// Refuses at an argument if one is to blame.
    fn refuse_at<T>(&mut self, place: Option<Range>, range: Range, fact: Fact) -> Option<T> {
        let place = place.or(self.blame.as_ref().map(|blame| blame.place));
        self.diag.refuse(place.unwrap_or(range), fact)
    }

    /// Conditions on parameters must hold at the declared defaults.
    pub(super) fn requirements_hold(&mut self, parameters: &[Parameter]) {
        if !self.diag.is_clean() {
            return;
        }
        let defaults: Vec<_> = parameters.iter().map(|parameter| parameter.default).collect();
        let defaults = self.numbers(&[], &defaults);
        for index in 0..self.requirements.len() {
            let Requirement { lhs, relation, rhs, ref why, .. } = self.requirements[index];
            let why = why.clone();
            let values = self.numbers(&defaults, &[lhs, rhs]);
            if !holds(relation, values[0], values[1]) {
                let place = self.requirement_places[index];
                self.diag.refuse::<()>(place, Fact::RequirementFailsAtDefaults { why, value: values[0] });
            }
        }
    }

    /// The values of expressions of parameters alone.
    pub(super) fn numbers(&self, parameters: &[f64], roots: &[crate::expr::Expr]) -> Vec<f64> {
        let functions = |number: u32, x: f64| match self.functions.get(number as usize) {
            Some(super::Function::Table(table)) => table.evaluate(x),
            _ => [f64::NAN; 3],
        };
        let values = Values { time: 0.0, parameters, coordinates: &[], velocities: &[], accelerations: &[], functions: &functions };
        evaluate(&self.arena, roots, &values)
    }
}

/// A comparison that cannot be decided (a Rust function is not run in the compiler) counts as true.
fn holds(relation: Relation, lhs: f64, rhs: f64) -> bool {
    if lhs.is_nan() || rhs.is_nan() {
        return true;
    }
    match relation {
        Relation::Less => lhs < rhs,
        Relation::LessOrEqual => lhs <= rhs,
        Relation::Greater => lhs > rhs,
        Relation::GreaterOrEqual => lhs >= rhs,
        Relation::Equal => lhs == rhs,
        Relation::Different => lhs != rhs,
    }
}

fn too_many(definition: &Definition, found: usize) -> Fact {
    Fact::TooManyArguments { definition: definition.name.to_string(), signature: signature(definition), takes: takes(definition), found }
}

fn too_few(definition: &Definition, found: usize, missing: Vec<String>) -> Fact {
    let (name, signature) = (definition.name.to_string(), signature(definition));
    Fact::MissingArguments { definition: name, signature, takes: takes(definition), found, missing }
}

/// How many arguments a definition takes, at least and at most.
fn takes(definition: &Definition) -> [usize; 2] {
    let required = definition.parameters.iter().filter(|formal| formal.default.is_none()).count();
    [required, definition.parameters.len()]
}

fn unknown_argument(definition: &Definition, name: &Ident) -> Fact {
    let names: Vec<String> = definition.parameters.iter().map(|formal| formal.name.to_string()).collect();
    let near = nearest(&name.to_string(), names.iter().map(String::as_str));
    Fact::UnknownArgument { definition: definition.name.to_string(), name: name.to_string(), signature: signature(definition), near }
}

/// Where the argument for each parameter was written.
fn places(definition: &Definition, given: &[Argument]) -> Vec<(String, Range)> {
    let place = |(position, argument): (usize, &Argument)| {
        let name = argument.name.as_ref().or(definition.parameters.get(position).map(|formal| &formal.name))?;
        Some((name.to_string(), argument.value.range))
    };
    given.iter().enumerate().filter_map(place).collect()
}

/// `revolute(P: Point, Q: Point)`
pub(crate) fn signature(definition: &Definition) -> String {
    let parameter = |formal: &Formal| {
        let optional = if formal.default.is_some() { " = …" } else { "" };
        format!("{}: {}{optional}", formal.name, kind_name(&formal.kind))
    };
    let parameters: Vec<String> = definition.parameters.iter().map(parameter).collect();
    format!("{}({})", definition.name, parameters.join(", "))
}

fn kind_name(kind: &Kind) -> String {
    match kind {
        Kind::Point => "Point".into(),
        Kind::Axis => "Axis".into(),
        Kind::Body => "Body".into(),
        Kind::Quantity => "Quantity".into(),
        Kind::Function(from, to) => format!("Function({}) -> {}", dimension_name(from), dimension_name(to)),
        Kind::Joint(kind) => format!("Joint({kind})"),
        Kind::Scalar(dimension) => dimension_name(dimension),
    }
}

fn dimension_name(dimension: &ast::Dimension) -> String {
    let mut text = String::new();
    for (position, (name, exponent)) in dimension.factors.iter().enumerate() {
        let separator = match (position, *exponent > 0) {
            (0, _) => "",
            (_, true) => " * ",
            (_, false) => " / ",
        };
        let power = if exponent.abs() == 1 { String::new() } else { format!("^{}", exponent.abs()) };
        text += &format!("{separator}{name}{power}");
    }
    text
}

pub(super) fn noun(kind: &Kind) -> String {
    match kind {
        Kind::Point => "a point".into(),
        Kind::Axis => "an axis".into(),
        Kind::Body => "a body".into(),
        Kind::Quantity => "a number".into(),
        Kind::Function(..) => "a function of one variable".into(),
        Kind::Joint(kind) => format!("a `{kind}` joint"),
        Kind::Scalar(dimension) => format!("a number ({})", dimension_name(dimension)),
    }
}
