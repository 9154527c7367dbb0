//! Registers every item by name: loops are unrolled, parts are expanded to the items of their components.
//!
//! Bodies, parameters, joints and outputs are numbered in the order of expansion, those of one part consecutively. Only whole numbers
//! are evaluated here.

use super::elaborate::Elaborator;
use super::{Name, Of};
use crate::diag::{ArrayFact, EquationFact, GrammarFact, NameFact};
use crate::expr::Leaf;
use crate::hints;
use crate::names::{
    Context, Declared, Entity, FrameId, INPUT_PARTS, Key, OpenPart, PartArguments, Progress, Register, Scalar, Scope, Sort, SpaceId, Value,
    Written, duplicate, is_one_of_many, is_reserved,
};
use crate::quantity::{Ambient, Dim, InferredDim};
use crate::syntax::ast::{self, Item, Marks};
use crate::syntax::plain;
use proc_macro2::Ident;
use std::rc::Rc;

/// Deepest nesting of parts.
const DEEPEST: usize = 20;

impl Elaborator<'_> {
    /// Registers all items of a mechanism.
    pub(super) fn register(&mut self, items: &[Item]) -> Register {
        let mut register = Register::default();
        register.places.push(OpenPart::default());
        for item in items {
            if let Item::Component(component) = item {
                self.component(component);
            }
        }
        let context = Context { space: SpaceId::MECHANISM, bound: Rc::default() };
        self.items(items, &context, 0, &mut register);
        register.joints.sort_by_key(|(_, joint)| joint.is_freedom());
        register
    }

    fn component(&mut self, component: &ast::Shared<ast::ComponentItem>) {
        let name = &component.head.name;
        let word = plain(name);
        if hints::is_of_generated_type(&word) {
            self.diag.refuse::<()>(name, ArrayFact::GeneratedType { name: word.clone() });
            self.names.components.entry(word).or_insert_with(|| component.clone());
        } else if self.names.components.contains_key(&word) {
            self.diag.refuse::<()>(name, NameFact::Duplicate { name: word, first: "another component" });
        } else {
            self.names.home = component.home;
            self.unless_refused(component, |this| this.head_is_sound(&component.head));
            self.names.home = None;
            self.names.components.insert(word, component.clone());
        }
    }

    /// Registers a list of items; `place` is the index of the part they belong to.
    pub(super) fn items(&mut self, items: &[Item], context: &Context, place: usize, register: &mut Register) {
        // Numbers come first: loop bounds and indices depend on them.
        for item in items {
            self.number_item(item, context, place, register);
        }
        for item in items {
            if self.diag.is_exhausted() {
                return;
            }
            self.item(item, context, place, register);
        }
    }

    fn number_item(&mut self, item: &Item, context: &Context, place: usize, register: &mut Register) {
        match item {
            Item::Parameter(parameter) => {
                let leaf = self.arena.leaf(Leaf::Parameter(register.parameters.len() as u32));
                let dim = self.unless_refused(parameter, |this| this.dimension_like(&parameter.dimension, &parameter.default));
                let value = dim.map(|dim| Value::Scalar(Scalar { expr: leaf, measure: InferredDim::Known(dim) }));
                let progress = value.map_or(Progress::Failed, Progress::Done);
                let written = Written { key: Key::Name(parameter.id()), name: &parameter.name, indices: &parameter.indices };
                let Some(id) = self.declare(written, Entity::Known, progress, Sort::Parameter, context) else { return };
                register.places[place].items.push((Of::Parameter, id, register.parameters.len()));
                register.parameters.push((id, parameter.clone()));
            }
            Item::Input(input) => self.input(input, context, register),
            Item::Refused(inner) => self.number_item(inner, context, place, register),
            Item::Let(binding) => {
                let written = Written { key: Key::Name(binding.id()), name: &binding.name, indices: &binding.indices };
                let id = self.declare(written, Entity::Let(binding.clone()), Progress::Untouched, Sort::Let, context);
                register.lets.extend(id);
            }
            Item::Function(function) => {
                let entity = Entity::Function(function.clone());
                let written = Written { key: Key::Name(function.id()), name: &function.name, indices: &[] };
                let id = self.declare(written, entity, Progress::Untouched, Sort::Function, context);
                register.functions.extend(id.map(|_| function.clone()));
            }
            _ => {}
        }
    }

    /// Registers an input: a name whose value, rate and acceleration are fields of the generated struct of inputs.
    fn input(&mut self, input: &ast::Shared<ast::ParameterItem>, context: &Context, register: &mut Register) {
        if context.space != SpaceId::MECHANISM {
            self.unless_refused(input, |this| this.refuse::<()>(&input.name, GrammarFact::OnlyAtTheTop { word: "input".into() }));
            return;
        }
        let first = register.parameters.len();
        let leaf = self.arena.leaf(Leaf::Input { number: first as u32, order: 0 });
        let dim = self.unless_refused(input, |this| this.dimension_like(&input.dimension, &input.default));
        let value = dim.map(|dim| Value::Scalar(Scalar { expr: leaf, measure: InferredDim::Known(dim) }));
        let progress = value.map_or(Progress::Failed, Progress::Done);
        let written = Written { key: Key::Name(input.id()), name: &input.name, indices: &input.indices };
        let Some(id) = self.declare(written, Entity::Known, progress, Sort::Input, context) else { return };
        let name = self.names.declared[id.0].name.clone();
        self.inputs.insert(first as u32, name.path.clone());
        register.inputs.push((id, first));
        for part in INPUT_PARTS {
            let name = Name::of_input(&Ident::new(part, input.name.span()), &name);
            let declared = Declared { entity: Entity::Known, progress: Progress::Failed, name, context: context.clone() };
            let part = self.insert(declared);
            register.parameters.push((part, input.clone()));
        }
    }

    fn item(&mut self, item: &Item, context: &Context, place: usize, register: &mut Register) {
        match item {
            Item::Ground(frame) => {
                if std::mem::replace(&mut register.has_ground, true) {
                    self.diag.refuse::<()>(&frame.name, NameFact::DuplicateGround);
                }
                if let Some(start) = frame.starts.first() {
                    self.diag.refuse::<()>(&start.what, EquationFact::GroundStart);
                }
                self.fill(FrameId::GROUND, &frame.marks, context, register);
            }
            Item::Body(frame) => {
                let written = Written { key: Key::Name(frame.id()), name: &frame.name, indices: &frame.indices };
                let Some(id) = self.declare(written, Entity::Known, Progress::Failed, Sort::Body, context) else { return };
                let path = self.names.declared[id.0].name.path.clone();
                let number = self.new_frame(&path);
                self.names.declared[id.0].progress = Progress::Done(Value::Body(number));
                register.places[place].items.push((Of::Body, id, register.bodies.len()));
                register.bodies.push((id, frame.clone()));
                self.fill(number, &frame.marks, context, register);
            }
            Item::Joint(joint) => {
                let sort = match joint.is_drive {
                    _ if joint.is_freedom() => Sort::Freedom,
                    true => Sort::Drive,
                    false => Sort::Joint,
                };
                let written = Written { key: Key::Name(joint.id()), name: &joint.name, indices: &joint.indices };
                let id = self.declare(written, Entity::Joint(joint.clone()), Progress::Untouched, sort, context);
                register.joints.extend(id.map(|id| (id, joint.clone())));
            }
            Item::Force(force) => {
                let written = Written { key: Key::Name(force.id()), name: &force.name, indices: &force.indices };
                let id = self.declare(written, Entity::Joint(force.clone()), Progress::Untouched, Sort::Force, context);
                register.forces.extend(id.map(|id| (id, force.clone())));
            }
            Item::Gravity(gravity) if register.gravity.is_some() => {
                self.diag.refuse::<()>(&gravity.keyword, NameFact::Duplicate { name: "gravity".to_owned(), first: "another `gravity`" });
            }
            Item::Gravity(gravity) => register.gravity = Some(gravity.clone()),
            Item::Start(start) => register.starts.push((start.clone(), context.clone())),
            Item::Output(output) => self.output_item(output, context, place, register),
            Item::Part(part) => self.part(part, context, place, register),
            Item::For(repeated) => {
                let bound = self.repeat(repeated.into(), &repeated.variable, &repeated.bounds, context, register);
                register.loops += 1;
                for inner in bound {
                    self.items(&repeated.items, &inner, place, register);
                }
                register.loops -= 1;
            }
            Item::Range(times) if register.range.is_some() => {
                self.diag.refuse::<()>(&times.keyword, NameFact::DuplicateRange);
            }
            Item::Range(times) => register.range = Some(times.clone()),
            Item::Use(uses) => self.names_are_new(uses),
            Item::Refused(inner) => self.item(inner, context, place, register),
            _ => {}
        }
    }

    /// Registers an output. Outputs have a namespace of their own.
    fn output_item(&mut self, output: &ast::Shared<ast::OutputItem>, context: &Context, place: usize, register: &mut Register) {
        let Some(indices) = self.written_indices(&output.indices, output, context) else { return };
        let name = self.names.full_name(context.space, Key::Name(output.id()), &output.name, &indices);
        self.names.outputs.insert((context.space, output.name.to_string()));
        let known = register.output_names.entry((context.space, output.name.to_string())).or_default();
        let is_like_others = known.first().is_none_or(|other| other.len() == indices.len());
        if !is_like_others || !known.insert(indices) {
            let fact = duplicate(name.to_string(), "another output", if is_like_others { &context.bound } else { &[] }, &output.indices);
            self.unless_refused(output, |this| this.refuse::<()>(&output.name, fact));
            return;
        }
        let declared = Declared { entity: Entity::Known, progress: Progress::Failed, name, context: context.clone() };
        let id = self.insert(declared);
        register.places[place].items.push((Of::Output, id, register.outputs.len()));
        register.outputs.push((id, output.clone()));
    }

    /// The contexts of a loop, one for each iteration.
    fn repeat(
        &mut self,
        item: Key,
        variable: &Ident,
        bounds: &ast::IndexRange,
        context: &Context,
        register: &mut Register,
    ) -> Vec<Context> {
        if !self.variable_is_new(item, variable, context) {
            return Vec::new();
        }
        let rounds = self.with_place(self.situation(context), |this| {
            this.unless_refused(item, |this| this.rounds(bounds, register.loops > 0, &Scope::of(context).timeless("an index")))
        });
        let rounds = rounds.unwrap_or_default();
        if self.charge(rounds.len(), variable).is_none() {
            return Vec::new();
        }
        let word = variable.to_string();
        let round = |number: i64| {
            let mut bound = context.bound.to_vec();
            let value = Scalar { expr: self.arena.integer(number), measure: InferredDim::Known(Dim::NUMBER) };
            bound.push((word.clone(), Value::Scalar(value)));
            Context { space: context.space, bound: Rc::new(bound) }
        };
        rounds.into_iter().map(round).collect()
    }

    /// Checks that a loop variable does not hide another name.
    fn variable_is_new(&mut self, item: Key, variable: &Ident, context: &Context) -> bool {
        let word = variable.to_string();
        let first = if context.bound.iter().any(|(known, _)| *known == word) {
            Some("the variable of another loop")
        } else {
            self.names.visible(context.space, &word).map(|group| self.names.group(group).sort.noun())
        };
        let fact = match first {
            Some(first) => NameFact::Duplicate { name: word, first },
            None if is_reserved(&word) => NameFact::Reserved { name: word },
            None => return true,
        };
        self.unless_refused(item, |this| this.refuse::<()>(variable, fact));
        false
    }

    /// Registers a part: its arguments and the items of its component, in a new namespace.
    fn part(&mut self, part: &ast::Shared<ast::PartItem>, context: &Context, place: usize, register: &mut Register) {
        let Some(component) = self.component_called(part, context.space) else { return };
        let word = component.head.name.to_string();
        if self.refused.contains(&Key::from(&component)) {
            return;
        }
        if register.open.contains(&word) {
            self.unless_refused(part, |this| this.refuse::<()>(&part.kind, ArrayFact::ComponentRecursion { name: word }));
            return;
        }
        if register.open.len() >= DEEPEST {
            self.give_up::<()>(&part.kind, GrammarFact::PartsTooDeep { limit: DEEPEST });
            return;
        }
        let written = Written { key: Key::Name(part.id()), name: &part.name, indices: &part.indices };
        let Some(id) = self.declare(written, Entity::Known, Progress::Failed, Sort::Part, context) else { return };
        let path = self.names.declared[id.0].name.path.clone();
        let slots = self.with_place(Some(path.clone()).filter(|_| is_one_of_many(context)), |this| {
            this.unless_refused(part, |this| {
                this.arguments_are_no_parameters(part, &component)?;
                this.slots(&component.head, &part.kind, &part.arguments)
            })
        });
        // Even if its arguments are wrong, the part is registered for the names in it.
        let slots = slots.unwrap_or_else(|| vec![None; component.head.parameters.len()]);
        let space = self.names.new_space(format!("{path}."), component.home);
        self.names.declared[id.0].progress = Progress::Done(Value::Part(space));
        let inner = Context { space, bound: Rc::default() };
        let made = Rc::new(PartArguments { component: component.clone(), part: part.clone(), slots, outside: context.clone() });
        for (number, formal) in component.head.parameters.iter().enumerate() {
            let entity = Entity::Argument(made.clone(), number);
            let id = self.declare(
                Written { key: Key::Formal(component.id(), number), name: &formal.name, indices: &[] },
                entity,
                Progress::Untouched,
                Sort::Argument,
                &inner,
            );
            register.lets.extend(id);
        }
        let number = register.places.len();
        register.places[place].items.push((Of::Part(0), id, number));
        register.parts.push(part.clone());
        register.places.push(OpenPart {
            component: Some(component.clone()),
            first: register.bodies.len(),
            items: Vec::new(),
            id: Some(id),
        });
        register.open.push(word);
        let loops = std::mem::take(&mut register.loops);
        self.items(&component.items, &inner, number, register);
        register.loops = loops;
        register.open.pop();
    }

    /// Reports an argument for a parameter inside the component: it is set in Rust. Arguments are for the parameters in the head.
    fn arguments_are_no_parameters(&mut self, part: &ast::PartItem, component: &ast::ComponentItem) -> Option<()> {
        let is_formal = |name: &Ident| component.head.parameters.iter().any(|formal| formal.name == *name);
        let is_parameter = |name: &Ident| component.items.iter().any(|item| matches!(item, Item::Parameter(inner) if inner.name == *name));
        let mut given = part.arguments.iter().filter_map(|argument| argument.name.as_ref());
        let Some(name) = given.find(|name| !is_formal(name) && is_parameter(name)) else { return Some(()) };
        let (component, part) = (component.head.name.to_string(), part.name.to_string());
        self.refuse(name, ArrayFact::ParameterAsArgument { component, name: name.to_string(), part })
    }

    /// Component of a part. Reports an unknown name, and returns the component that was probably meant.
    fn component_called(&mut self, part: &ast::Shared<ast::PartItem>, space: SpaceId) -> Option<ast::Shared<ast::ComponentItem>> {
        let word = plain(&part.kind);
        if let Some(component) = self.names.components_in(space).get(&word) {
            return Some(component.clone());
        }
        let near = self.nearest(&word, self.names.components_in(space).keys().map(String::as_str));
        let meant = near.as_ref().and_then(|near| self.names.components_in(space).get(near)).cloned();
        let is_force = self.known_definition(&word).map(|found| found.is_force);
        self.unless_refused(part, |this| this.refuse::<()>(&part.kind, ArrayFact::UnknownComponent { name: word, near, is_force }));
        meant
    }

    /// Registers the points and axes of a frame.
    fn fill(&mut self, frame: FrameId, marks: &Marks, context: &Context, register: &mut Register) {
        for mark in &marks.single {
            if self.diag.is_exhausted() {
                return;
            }
            let Some(indices) = self.written_indices(&mark.indices, mark, context) else { continue };
            let word = mark.name.to_string();
            let is_free = self.names.ambient == Ambient::Space && self.names.ambient.coordinate(&word).is_some();
            if self.names.ambient.start_words().any(|known| known == word) && !is_free {
                self.names.misused.insert(format!("{}.{word}", self.names.frames[frame.0].name));
                self.unless_refused(mark, |this| this.refuse::<()>(&mark.name, NameFact::Reserved { name: word }));
                continue;
            }
            let space = self.names.frames[frame.0].space;
            let name = self.names.full_name(space, Key::Name(mark.id()), &mark.name, &indices);
            let sort = if mark.is_axis { Sort::Axis } else { Sort::Point };
            let entity = Entity::Mark(frame, mark.clone());
            let declared = Declared { entity, progress: Progress::Untouched, name, context: context.clone() };
            let id = self.insert(declared);
            let body = self.names.frames[frame.0].name.clone();
            match self.names.join(space, &word, sort, indices, id) {
                Ok(()) => register.marks.push(id),
                Err(_) => {
                    self.unless_refused(mark, |this| this.refuse::<()>(&mark.name, NameFact::DuplicateMark { name: word, body }));
                }
            }
        }
        for repeated in &marks.loops {
            let bound = self.repeat(repeated.into(), &repeated.variable, &repeated.bounds, context, register);
            register.loops += 1;
            for inner in bound {
                self.fill(frame, &repeated.items, &inner, register);
            }
            register.loops -= 1;
        }
    }

    /// Checks that no two `use` items import the same name.
    fn names_are_new(&mut self, uses: &[ast::Use]) {
        for used in uses {
            let name = used.name.to_string();
            if self.names.used.contains(&name) {
                self.diag.refuse::<()>(&used.name, NameFact::Duplicate { name, first: "another `use`" });
            } else {
                self.names.used.push(name);
            }
        }
    }
}
