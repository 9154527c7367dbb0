//! The items of a mechanism: registered by name first, resolved when asked for.

use super::builtin::BUILTINS;
use super::dimension::{Dim, Measure};
use super::elaborate::{Elaborator, Scope};
use super::names::{Entity, Names, Progress, RESERVED};
use super::suggest::nearest;
use super::value::{Arguments, FrameId, Function, Scalar, Value};
use super::{Model, Parameter};
use crate::diag::{Diag, Fact};
use crate::expr::Leaf;
use crate::syntax::ast::{self, Definition, Item};
use proc_macro2::Ident;
use std::rc::Rc;

/// Resolves a whole mechanism; `definitions` are those its `use` items brought in.
pub(crate) fn resolve(tree: &ast::Mechanism, definitions: Vec<(String, Definition)>, diag: &mut Diag) -> Option<Model> {
    let definitions = definitions.into_iter().map(|(name, definition)| (name, Rc::new(definition))).collect();
    let mut work = Elaborator::new(diag, Names { definitions, ..Names::new() });
    work.register(tree);
    let parameters = work.parameters(tree);
    work.lets_and_functions(tree);
    let bodies = work.bodies(tree);
    let lengths = work.marks();
    let joints = work.joints(tree);
    let outputs = work.outputs(tree);
    work.requirements_hold(&parameters);
    let Elaborator { arena, functions, requirements, .. } = work;
    let model = Model {
        arena,
        docs: tree.docs.clone(),
        visibility: tree.visibility.clone(),
        name: tree.name.clone(),
        equations_only: tree.equations_only,
        parameters,
        bodies,
        lengths,
        joints,
        outputs,
        functions,
        requirements,
    };
    diag.is_clean().then_some(model)
}

impl Elaborator<'_> {
    /// Gives every item its name.
    fn register(&mut self, tree: &ast::Mechanism) {
        let mut parameters = 0;
        let mut has_ground = false;
        for item in &tree.items {
            match item {
                Item::Parameter(parameter) => {
                    let leaf = self.arena.leaf(Leaf::Parameter(parameters));
                    parameters += 1;
                    let dim = self.dimension(&parameter.dimension);
                    let value = dim.map(|dim| Value::Scalar(Scalar { expr: leaf, measure: Measure::Of(dim) }));
                    self.declare(&parameter.name, Entity::Value(value), "a parameter");
                }
                Item::Let(binding) => self.declare(&binding.name, Entity::Let(Rc::new(binding.clone()), Progress::Untouched), "a `let`"),
                Item::Function(function) => self.declare(&function.name, Entity::Function(Rc::new(function.clone())), "a function"),
                Item::Ground(frame) => {
                    if std::mem::replace(&mut has_ground, true) {
                        self.diag.refuse::<()>(&frame.name, Fact::DuplicateGround);
                    }
                    self.fill(FrameId::GROUND, frame);
                }
                Item::Body(frame) => {
                    let id = self.new_frame(&frame.name.to_string());
                    self.declare(&frame.name, Entity::Value(Some(Value::Body(id))), "a body");
                    self.fill(id, frame);
                }
                Item::Joint(joint) => {
                    let what = if joint.is_drive { "a drive" } else { "a joint" };
                    self.declare(&joint.name, Entity::Joint(Rc::new(joint.clone()), Progress::Untouched), what);
                }
                Item::Use(uses) => self.names_are_new(uses),
                Item::Output(_) | Item::Refused(_) => {}
            }
        }
    }

    fn declare(&mut self, name: &Ident, entity: Entity, what: &'static str) {
        let word = name.to_string();
        if RESERVED.contains(&word.as_str()) || BUILTINS.contains(&word.as_str()) {
            self.diag.refuse::<()>(name, Fact::Reserved { name: word });
        } else if let Some((_, first)) = self.names.entities.get(&word) {
            self.diag.refuse::<()>(name, Fact::Duplicate { name: word, first });
        } else {
            self.names.order.push(word.clone());
            self.names.entities.insert(word, (entity, what));
        }
    }

    /// No two `use` items bring in the same name.
    fn names_are_new(&mut self, uses: &[ast::Use]) {
        for used in uses {
            let name = used.name.to_string();
            if self.names.used.contains(&name) {
                self.diag.refuse::<()>(&used.name, Fact::Duplicate { name, first: "another `use`" });
            } else {
                self.names.used.push(name);
            }
        }
    }

    /// The fields of the generated struct.
    fn parameters(&mut self, tree: &ast::Mechanism) -> Vec<Parameter> {
        let parameters = tree.items.iter().filter_map(|item| if let Item::Parameter(parameter) = item { Some(parameter) } else { None });
        parameters.filter_map(|parameter| self.parameter(parameter)).collect()
    }

    fn parameter(&mut self, parameter: &ast::Parameter) -> Option<Parameter> {
        // An unknown dimension has been refused by `register`.
        let dim = Dim::of(&parameter.dimension)?;
        let scope = Scope::mechanism().timeless("the default of a parameter");
        let default = self.scalar_of(&parameter.default, dim, &scope)?.expr;
        if !self.arena.leaves(default).is_empty() {
            let help = "a quantity that follows from others is declared with `let`";
            return self.refuse(parameter.default.range, Fact::NotConstant { place: "the default of a parameter", help });
        }
        if !self.numbers(&[], &[default])[0].is_finite() {
            return self.refuse(parameter.default.range, Fact::NotFinite { place: "the default" });
        }
        Some(Parameter { docs: parameter.docs.clone(), name: parameter.name.clone(), dim, default })
    }

    /// The dimension behind its names.
    pub(super) fn dimension(&mut self, written: &ast::Dimension) -> Option<Dim> {
        if let Some((unknown, _)) = written.factors.iter().find(|(name, _)| Dim::named(&name.to_string()).is_none()) {
            let name = unknown.to_string();
            let near = nearest(&name, Dim::names());
            return self.refuse(unknown, Fact::UnknownDimension { name, near });
        }
        Dim::of(written)
    }

    /// The value of a declared name.
    pub(super) fn declared(&mut self, name: &Ident) -> Option<Value> {
        let word = name.to_string();
        match self.names.entities.get(&word)?.0.clone() {
            Entity::Value(value) => value,
            Entity::Function(function) => {
                // A signature over a Rust path gives the function its dimensions.
                if let (None, ast::ExprKind::Path(path)) = (&function.argument, &function.value.kind) {
                    let (from, to) = (self.dimension(&function.from)?, self.dimension(&function.to)?);
                    return Some(Value::Function(self.rust_function(path, Measure::Of(from), Measure::Of(to))));
                }
                Some(Value::Function(Function::Written(function)))
            }
            Entity::Let(_, Progress::Done(value)) => Some(value),
            Entity::Let(_, Progress::Failed) | Entity::Joint(_, Progress::Failed) => None,
            Entity::Let(binding, Progress::Untouched) => {
                self.names.set(word.clone(), Entity::Let(binding.clone(), Progress::Open));
                let value = self.binding(&binding, &Scope::mechanism());
                let progress = value.clone().map_or(Progress::Failed, Progress::Done);
                self.names.set(word, Entity::Let(binding, progress));
                value
            }
            Entity::Joint(joint, progress) => {
                let arguments = match progress {
                    Progress::Done(arguments) => arguments,
                    Progress::Open => return self.refuse(name, Fact::Cycle { name: word }),
                    _ => self.joint_arguments(&joint)?,
                };
                match &joint.body {
                    // A definition that was renamed by `use` is still of its own kind.
                    ast::JointBody::Of { kind, .. } => {
                        let kind = self.definition(kind)?.name.to_string();
                        Some(Value::Joint { kind, arguments })
                    }
                    ast::JointBody::Equations(_) => Some(Value::Joint { kind: "equation".into(), arguments }),
                }
            }
            Entity::Let(_, Progress::Open) => self.refuse(name, Fact::Cycle { name: word }),
        }
    }

    /// The arguments of a joint, evaluated once.
    pub(super) fn joint_arguments(&mut self, joint: &Rc<ast::Joint>) -> Option<Arguments> {
        let word = joint.name.to_string();
        match self.names.entities.get(&word) {
            Some((Entity::Joint(_, Progress::Done(arguments)), _)) => return Some(arguments.clone()),
            Some((Entity::Joint(_, Progress::Failed), _)) => return None,
            _ => {}
        }
        self.names.set(word.clone(), Entity::Joint(joint.clone(), Progress::Open));
        let arguments = self.bind_joint(joint).map(Rc::new);
        let progress = arguments.clone().map_or(Progress::Failed, Progress::Done);
        self.names.set(word, Entity::Joint(joint.clone(), progress));
        arguments
    }

    /// A `let`: a bare number becomes a pure number unless a dimension is said.
    pub(super) fn binding(&mut self, binding: &ast::Let, scope: &Scope) -> Option<Value> {
        if let Some(written) = &binding.dimension {
            let dim = self.dimension(written)?;
            return self.scalar_of(&binding.value, dim, scope).map(Value::Scalar);
        }
        let settle = |measure: Measure| Measure::Of(measure.settled());
        Some(match self.value(&binding.value, scope)? {
            Value::Scalar(scalar) => Value::Scalar(Scalar { measure: settle(scalar.measure), ..scalar }),
            other => other,
        })
    }
}
