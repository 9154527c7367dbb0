//! Resolves the items of a mechanism: registered by name first, then resolved once each, on first use.

use super::elaborate::Elaborator;
use super::{Layout, Method, Model, Name, Parameter};
use crate::diag::{Diag, NameFact, Range, ValueFact};
use crate::hints::{self, in_words, with_bare_bounds};
use crate::names::{
    Context, Declared, Entity, EntityId, FunctionValue, INPUT_PARTS, Key, Names, PartArguments, Progress, Register, Scalar, Scope, Value,
    is_one_of_many,
};
use crate::quantity::{self, Dim, InferredDim};
use crate::syntax::ast::{self, Definition};
use crate::words::nearest;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// Resolves a whole mechanism; `definitions` are imported by its `use` items.
pub(crate) fn resolve(tree: &ast::Mechanism, definitions: Vec<(String, Definition)>, diag: &mut Diag) -> Option<Model> {
    hints::is_meant(tree, diag)?;
    let definitions = definitions.into_iter().map(|(name, definition)| (name, Rc::new(definition))).collect();
    let mut work = Elaborator::new(diag, Names::new(definitions, tree.ambient));
    work.names.homes.clone_from(&tree.homes);
    work.judges_rows = tree.task.is_determined() && tree.closing == ast::Closing::Deny;
    let register = work.register(&tree.items);
    if work.diag.is_exhausted() {
        return None;
    }
    let layout = work.layout(&register);
    let parameters = work.parameters(&register);
    let defaults: Vec<_> = parameters.iter().map(|parameter| parameter.default).collect();
    work.defaults = work.numbers(&[], &defaults);
    work.lets_and_functions(&register);
    let mut bodies = work.bodies(&register);
    let lengths = work.marks(&register);
    let joints = work.joints(&register);
    work.joint_starts(&register);
    let (declared_forces, forces) = work.forces(&register);
    work.gather_masses(&mut bodies);
    work.fits_freedoms(tree.task, &register);
    work.fits_jerks(tree.task, &register);
    work.fits_inputs(tree.task, &register, &joints);
    let gravity = work.gravity(&register);
    let outputs = work.outputs(&register);
    let methods = work.methods(&layout, &register, &outputs, tree);
    work.unused_components(&register);
    work.requirements_hold(&parameters);
    work.fixed_values_are_finite(&parameters);
    let range = work.times(&register, &parameters);
    let sketch = work.sketch(&register);
    let Elaborator { mut arena, functions, mut requirements, space, energies, bare, .. } = work;
    for body in &bodies {
        requirements.extend(body.masses.iter().flat_map(|mass| mass.requirements(&mut arena, &body.name.to_string())));
    }
    let model = Model {
        arena,
        docs: tree.docs.clone(),
        visibility: tree.visibility.clone(),
        name: tree.name.clone(),
        ambient: tree.ambient,
        space: space.geometry,
        starts: space.starts,
        quantity_items: space.quantity_items,
        task: tree.task,
        closing: tree.closing,
        allows_far_start: tree.allows_far_start,
        has_stub: tree.items.iter().any(|item| matches!(item, ast::Item::Use(_))),
        following: tree.following,
        requests: tree.requests.clone(),
        range,
        layout,
        parameters,
        bodies,
        lengths,
        joints,
        forces,
        declared_forces,
        energies,
        gravity,
        outputs: outputs.into_iter().flatten().collect(),
        methods,
        functions,
        requirements,
        sketch,
        doubts: bare.doubts(),
    };
    diag.is_clean().then_some(model)
}

/// Public interface of a mechanism, as far as it can be read.
pub(crate) struct Outline {
    pub(crate) layout: Layout,
    pub(crate) methods: Vec<Method>,
    /// The outputs by number.
    pub(crate) outputs: Vec<ast::Shared<ast::OutputItem>>,
    /// Joints, drives and freedoms.
    pub(crate) joints: Vec<(Name, ast::Shared<ast::JointItem>)>,
    pub(crate) forces: Vec<(Name, ast::Shared<ast::JointItem>)>,
    /// Number of bodies.
    pub(crate) bodies: usize,
}

/// Outline of a mechanism despite its errors, for its stub.
pub(crate) fn outline(tree: &ast::Mechanism) -> Outline {
    let mut diag = Diag::default();
    let mut work = Elaborator::new(&mut diag, Names::new(BTreeMap::new(), tree.ambient));
    work.names.homes.clone_from(&tree.homes);
    let register = work.register(&tree.items);
    let layout = work.layout(&register);
    let mut methods = work.methods(&layout, &register, &vec![None; register.outputs.len()], tree);
    let mut taken = BTreeSet::new();
    methods.retain(|method| !hints::is_generated(&method.name, tree) && taken.insert(method.name.to_string()));
    let named = |(id, joint): (EntityId, _)| (work.names.declared[id.0].name.clone(), joint);
    let [joints, forces] = [register.joints, register.forces].map(|items| items.into_iter().map(named).collect());
    let outputs = register.outputs.into_iter().map(|(_, output)| output).collect();
    Outline { layout, methods, outputs, joints, forces, bodies: register.bodies.len() }
}

impl Elaborator<'_> {
    /// The fields of the generated structs.
    pub(super) fn parameters(&mut self, register: &Register) -> Vec<Parameter> {
        let parameter = |this: &mut Self, number: usize, (id, written): &(EntityId, ast::Shared<ast::ParameterItem>)| {
            let order = this.inputs.range(..=number as u32).next_back().map_or(0, |(first, _)| number - *first as usize);
            this.resolved(*id, written, |this, name, context| {
                let declared = this.parameter(written, name, context)?;
                if !(1..INPUT_PARTS.len()).contains(&order) {
                    return Some(declared);
                }
                let dim = (0..order).fold(declared.dim, |dim, _| dim.per(Dim::TIME));
                Some(Parameter { dim, default: this.arena.integer(0), bounds: None, ..declared })
            })
        };
        register.parameters.iter().enumerate().filter_map(|(number, declared)| parameter(self, number, declared)).collect()
    }

    /// Resolves a declared item, unless its declaration was rejected before.
    pub(super) fn resolved<T>(
        &mut self,
        id: EntityId,
        item: impl Into<Key>,
        look: impl FnOnce(&mut Self, &Name, &Context) -> Option<T>,
    ) -> Option<T> {
        let Declared { name, context, .. } = &self.names.declared[id.0];
        let (name, context) = (name.clone(), context.clone());
        let place = is_one_of_many(&context).then(|| format!("in `{name}`"));
        let outer = self.space.item.replace(name.clone());
        let home = std::mem::replace(&mut self.names.home, self.names.spaces[context.space.0].home);
        let found = self.with_place(place, |this| this.unless_refused(item, |this| look(this, &name, &context)));
        (self.space.item, self.names.home) = (outer, home);
        found
    }

    /// Runs `look` on a declaration, unless it was rejected before, so that each declaration is rejected only once.
    pub(super) fn unless_refused<T>(&mut self, item: impl Into<Key>, look: impl FnOnce(&mut Self) -> Option<T>) -> Option<T> {
        let key = item.into();
        if self.refused.contains(&key) {
            return None;
        }
        let before = self.diag.refusals().len();
        let found = look(self);
        if self.diag.refusals().len() > before {
            self.refused.insert(key);
        }
        found
    }

    /// Runs `look`; errors that it reports name `place`.
    pub(super) fn with_place<T>(&mut self, place: Option<String>, look: impl FnOnce(&mut Self) -> T) -> T {
        let outer = std::mem::replace(&mut self.place, place);
        let found = look(self);
        self.place = outer;
        found
    }

    fn parameter(&mut self, parameter: &ast::ParameterItem, name: &Name, context: &Context) -> Option<Parameter> {
        // An unknown dimension was reported by `register`.
        let dim = parameter.dimension.dim()?;
        let scope = Scope::of(context).timeless("the default of a parameter");
        let default = self.scalar_of(&parameter.default, dim, &scope)?.expr;
        if !self.arena.leaves(default).is_empty() {
            let help = "a quantity that follows from others is declared with `let`";
            return self.refuse(parameter.default.range, ValueFact::NotConstant { place: "the default of a parameter", help });
        }
        if !self.is_finite(default, &[]) {
            return self.refuse(parameter.default.range, ValueFact::NotFinite { place: "the default" });
        }
        let bounds = match &parameter.limits {
            Some(limits) => Some(self.bounds(limits, dim, &scope)?),
            None => None,
        };
        let value = self.numbers(&[], &[default])[0];
        let written = in_words(&parameter.default, value, dim);
        if let Some(bounds) = bounds.as_ref().filter(|bounds| !bounds.hold(value)) {
            let fact = ValueFact::DefaultOutOfBounds { value: written, bounds: bounds.text.clone() };
            let fact = with_bare_bounds(fact, &parameter.default, parameter.limits.as_ref());
            return self.refuse(parameter.default.range, fact);
        }
        Some(Parameter { name: name.clone(), dim, default, written, bounds })
    }

    /// Resolves the names in a dimension.
    pub(super) fn dimension(&mut self, written: &ast::Dimension) -> Option<Dim> {
        self.dimension_or(written, None)
    }

    /// Resolves the names in the dimension of a quantity with this default, whose unit tells what a number type of Rust was meant to be.
    pub(super) fn dimension_like(&mut self, written: &ast::Dimension, default: &ast::Expression) -> Option<Dim> {
        let of_default = match &default.kind {
            ast::ExpressionKind::Number { unit, .. } => {
                quantity::unit(unit).and_then(|(_, dim)| Dim::names().find(|name| Dim::named(name) == Some(dim)))
            }
            _ => None,
        };
        self.dimension_or(written, of_default)
    }

    fn dimension_or(&mut self, written: &ast::Dimension, of_default: Option<&str>) -> Option<Dim> {
        if let Some((unknown, _)) = written.factors.iter().find(|(name, _)| Dim::named(&name.to_string()).is_none()) {
            let name = unknown.to_string();
            let near = nearest(&name, Dim::names());
            // A `Speed` may be one of turning.
            let meant = |own: &&str| match near.as_deref() {
                None => *own != "Number",
                Some(near) => near == "Number" || near == "Velocity" && *own == "AngularVelocity",
            };
            let near = of_default.filter(meant).map(ToOwned::to_owned).or(near);
            return self.refuse(unknown, NameFact::UnknownDimension { name, near });
        }
        written.dim()
    }

    /// Value of a declared item, resolved on first use; `range` is the use.
    pub(super) fn entity(&mut self, id: EntityId, range: Range) -> Option<Value> {
        let declared = &self.names.declared[id.0];
        match &declared.progress {
            Progress::Done(value) => return Some(value.clone()),
            Progress::Failed => return None,
            Progress::Open => {
                let range = if let Entity::Mark(..) = declared.entity { Range::from(&declared.name) } else { range };
                let name = declared.name.own();
                let way = self.names.open.iter().skip_while(|open| **open != id).skip(1);
                let through = way.map(|open| self.names.declared[open.0].name.path.clone()).collect();
                return self.refuse(range, NameFact::Cycle { name, through });
            }
            Progress::Untouched => {}
        }
        let entity = declared.entity.clone();
        self.names.declared[id.0].progress = Progress::Open;
        self.names.open.push(id);
        let value = match &entity {
            Entity::Known => None,
            Entity::Let(binding) => self.resolved(id, binding, |this, _, context| this.binding(binding, &Scope::of(context))),
            Entity::Function(function) => self.function_value(function),
            Entity::Joint(joint) => self.resolved(id, joint, |this, _, context| this.joint_value(joint, context)),
            Entity::Mark(frame, mark) => self.resolved(id, mark, |this, _, context| this.fixed(*frame, mark, context)),
            Entity::Argument(made, number) => self.made_with(id, made, *number),
        };
        self.names.open.pop();
        self.names.declared[id.0].progress = value.clone().map_or(Progress::Failed, Progress::Done);
        value
    }

    fn function_value(&mut self, function: &ast::Shared<ast::FunctionItem>) -> Option<Value> {
        // A signature declares the dimensions of a Rust function.
        if let (None, ast::ExpressionKind::Path(path)) = (&function.argument, &function.value.kind) {
            let (from, to) = (self.dimension(&function.from)?, self.dimension(&function.to)?);
            return Some(Value::Function(self.rust_function(path, InferredDim::Known(from), InferredDim::Known(to))));
        }
        Some(Value::Function(FunctionValue::Written(function.clone())))
    }

    fn joint_value(&mut self, joint: &ast::JointItem, context: &Context) -> Option<Value> {
        let arguments = Rc::new(self.bind_joint(joint, context)?);
        match &joint.body {
            // A definition renamed by `use` keeps its own kind.
            ast::JointBody::Of { kind, .. } => Some(Value::Joint { kind: self.definition(kind)?.name.to_string(), arguments }),
            ast::JointBody::Equations(_) => Some(Value::Joint { kind: "equation".into(), arguments }),
            ast::JointBody::Freedom(freedom) => self.value(&freedom.value, &self.joint_scope(joint, context)),
            ast::JointBody::Energy(_) => Some(Value::Joint { kind: "energy".into(), arguments }),
            // `joint_rows` refuses it.
            ast::JointBody::Value(_) => None,
        }
    }

    /// Evaluates an argument of a part. A written argument belongs to the context of the part, a default to the component.
    fn made_with(&mut self, id: EntityId, made: &Rc<PartArguments>, number: usize) -> Option<Value> {
        let formal = &made.component.head.parameters[number];
        let owner = self.names.declared[id.0].context.clone();
        let (written, key, context) = match (made.slots[number], &formal.default) {
            (Some(argument), _) => (&made.part.arguments[argument].value, Key::Argument(made.part.id(), argument), &made.outside),
            (None, Some(default)) => (default, Key::Default(made.component.id(), number), &owner),
            (None, None) => return None,
        };
        let part = self.names.spaces[owner.space.0].prefix.trim_end_matches('.').to_owned();
        let place = is_one_of_many(&made.outside).then(|| format!("in `{part}`"));
        let scope = Scope::of(context);
        self.with_place(place, |this| this.unless_refused(key, |this| this.argument(&made.component.head, formal, written, &scope)))
    }

    /// Evaluates a `let`. A bare number is a pure number unless a dimension is declared.
    pub(super) fn binding(&mut self, binding: &ast::Let, scope: &Scope) -> Option<Value> {
        if let Some(written) = &binding.dimension {
            let dim = self.dimension(written)?;
            return self.scalar_of(&binding.value, dim, scope).map(Value::Scalar);
        }
        let settle = |measure: InferredDim| InferredDim::Known(measure.settled());
        Some(match self.value(&binding.value, scope)? {
            Value::Scalar(scalar) => Value::Scalar(Scalar { measure: settle(scalar.measure), ..scalar }),
            other => other,
        })
    }
}
