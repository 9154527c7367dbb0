//! The items of a mechanism: registered by name first, resolved when asked for.

use super::builtin::BUILTINS;
use super::dimension::{Dim, Measure};
use super::elaborate::{Elaborator, Scope};
use super::instance::Row;
use super::suggest::nearest;
use super::value::{Arguments, Fixed, FrameId, Function, Scalar, Value};
use super::{Body, Coordinate, Joint, Model, Output, Parameter, Residual};
use crate::diag::{Diag, Fact};
use crate::expr::{Expr, Leaf};
use crate::syntax::ast::{self, Definition, Item};
use proc_macro2::Ident;
use std::collections::BTreeMap;
use std::rc::Rc;

/// Names that expressions give a meaning of their own.
pub(super) const RESERVED: &[&str] = &["t", "pi", "ground"];

/// Names of generated functions, which an output may not have.
const GENERATED: &[&str] = &[
    "phi", "jacobian", "jacobian_entries", "nu", "gamma", "linearize", "solve", "solve_near", "solve_from", "advance", "sweep", "start", "validate",
    "characteristic_length", "with_defaults", "cast", "clone", "default", "state",
];

/// A generated function has this name.
pub(crate) fn is_generated(name: &Ident) -> bool {
    GENERATED.iter().any(|known| name == known)
}

/// How far an item has been resolved.
#[derive(Clone)]
enum Progress<T> {
    Untouched,
    Open,
    Done(T),
    /// It was refused; whoever needs it stays silent.
    Failed,
}

/// What a name of the mechanism stands for.
#[derive(Clone)]
enum Entity {
    Value(Option<Value>),
    Let(Rc<ast::Let>, Progress<Value>),
    Function(Rc<ast::Function>),
    Joint(Rc<ast::Joint>, Progress<Arguments>),
}

/// A point or an axis, and how far it has been resolved.
pub(super) struct Mark {
    written: Rc<ast::Mark>,
    progress: Progress<Value>,
}

/// A frame and what is fixed in it.
pub(super) struct Frame {
    pub(super) name: String,
    /// x, y and angle; ground has none.
    pub(super) coordinates: Option<[Expr; 3]>,
    pub(super) marks: BTreeMap<String, Mark>,
    /// Names of the marks as declared.
    pub(super) order: Vec<String>,
}

/// All names of a mechanism.
#[derive(Default)]
pub(crate) struct Names {
    pub(super) frames: Vec<Frame>,
    pub(super) definitions: BTreeMap<String, Rc<Definition>>,
    /// Functions whose bodies are being looked at, to stop recursion.
    pub(super) open_functions: Vec<String>,
    /// A definition is checked on its own, with bodies and numbers nothing is known of.
    is_abstract: bool,
    /// Everything declared, and what it is in words.
    entities: BTreeMap<String, (Entity, &'static str)>,
    order: Vec<String>,
    /// Names that `use` items brought in.
    used: Vec<String>,
}

impl Names {
    /// With ground as the only frame.
    pub(super) fn new() -> Names {
        let ground = Frame { name: "ground".into(), coordinates: None, marks: BTreeMap::new(), order: Vec::new() };
        Names { frames: vec![ground], ..Names::default() }
    }

    /// For checking a definition on its own.
    pub(super) fn abstract_() -> Names {
        Names { is_abstract: true, ..Names::new() }
    }

    pub(super) fn is_abstract(&self) -> bool {
        self.is_abstract
    }

    pub(super) fn is_known(&self, name: &Ident) -> bool {
        self.entities.contains_key(&name.to_string())
    }

    /// Every declared name, in order.
    pub(super) fn all(&self) -> Vec<String> {
        self.order.clone()
    }

    /// `body.name` for a point or an axis of this name.
    pub(super) fn mark_called(&self, name: &Ident) -> Option<String> {
        let owner = self.frames.iter().find(|frame| frame.marks.contains_key(&name.to_string()))?;
        Some(format!("{}.{name}", owner.name))
    }

    /// The name of a joint stands for a joint, not for another item declared before it.
    fn is_declared_as(&self, joint: &ast::Joint) -> bool {
        matches!(self.entities.get(&joint.name.to_string()), Some((Entity::Joint(declared, _), _)) if declared.is_drive == joint.is_drive)
    }

    /// What a joint was made with, once that is known.
    pub(super) fn arguments_of(&self, joint: &Ident) -> Option<Arguments> {
        match self.entities.get(&joint.to_string()) {
            Some((Entity::Joint(_, Progress::Done(arguments)), _)) => Some(arguments.clone()),
            _ => None,
        }
    }

    /// The first point of a frame.
    pub(super) fn a_point_of(&self, frame: FrameId) -> Option<&str> {
        let frame = &self.frames[frame.0];
        frame.order.iter().map(String::as_str).find(|name| frame.marks.get(*name).is_some_and(|mark| !mark.written.is_axis))
    }

    /// Notes how far an item has been resolved.
    fn set(&mut self, name: String, entity: Entity) {
        if let Some(known) = self.entities.get_mut(&name) {
            known.0 = entity;
        }
    }

    /// The names of declared functions, in order.
    pub(super) fn functions(&self) -> Vec<String> {
        let is_function = |name: &&String| matches!(self.entities.get(*name), Some((Entity::Function(_), _)));
        self.order.iter().filter(is_function).cloned().collect()
    }
}

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

    /// A frame with three fresh coordinates.
    pub(super) fn new_frame(&mut self, name: &str) -> FrameId {
        let first = 3 * (self.names.frames.len() as u32 - 1);
        let coordinates = [0, 1, 2].map(|offset| self.arena.leaf(Leaf::Coordinate(first + offset)));
        self.names.frames.push(Frame { name: name.to_owned(), coordinates: Some(coordinates), marks: BTreeMap::new(), order: Vec::new() });
        FrameId(self.names.frames.len() - 1)
    }

    fn fill(&mut self, id: FrameId, frame: &ast::Frame) {
        for mark in &frame.marks {
            let word = mark.name.to_string();
            if matches!(word.as_str(), "x" | "y" | "angle" | "position") {
                self.diag.refuse::<()>(&mark.name, Fact::Reserved { name: word });
                continue;
            }
            let names = &mut self.names.frames[id.0];
            if names.marks.contains_key(&word) {
                let body = names.name.clone();
                self.diag.refuse::<()>(&mark.name, Fact::DuplicateMark { name: word, body });
                continue;
            }
            names.order.push(word.clone());
            names.marks.insert(word, Mark { written: Rc::new(mark.clone()), progress: Progress::Untouched });
        }
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
                    ast::JointBody::Of { kind, .. } => Some(Value::Joint { kind: kind.to_string(), arguments }),
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

    /// A point or an axis of a frame, evaluated once.
    pub(super) fn mark(&mut self, frame: FrameId, name: &str) -> Option<Value> {
        let entry = self.names.frames[frame.0].marks.get(name)?;
        let mark = entry.written.clone();
        match &entry.progress {
            Progress::Done(value) => return Some(value.clone()),
            Progress::Failed => return None,
            Progress::Open => return self.refuse(&mark.name, Fact::Cycle { name: name.to_owned() }),
            Progress::Untouched => {}
        }
        self.set_mark(frame, name, Progress::Open);
        let value = self.fixed(frame, &mark);
        self.set_mark(frame, name, value.clone().map_or(Progress::Failed, Progress::Done));
        value
    }

    fn set_mark(&mut self, frame: FrameId, name: &str, progress: Progress<Value>) {
        if let Some(entry) = self.names.frames[frame.0].marks.get_mut(name) {
            entry.progress = progress;
        }
    }

    fn fixed(&mut self, frame: FrameId, mark: &ast::Mark) -> Option<Value> {
        let vector = self.vector(&mark.value, &Scope::mechanism().timeless("a point or an axis"))?;
        if !self.is_fixed(vector.x) || !self.is_fixed(vector.y) {
            return self.refuse(mark.value.range, Fact::NotFixed { place: "a point or an axis" });
        }
        let local = [vector.x, vector.y];
        if mark.is_axis {
            let is_zero = local.iter().all(|part| self.arena.as_constant(*part).is_some_and(|value| value.is_zero()));
            if is_zero {
                return self.refuse(mark.value.range, Fact::ZeroAxis { name: mark.name.to_string() });
            }
            let measure = Measure::Of(vector.measure.settled());
            return Some(Value::Axis(Fixed { frame, local, measure }));
        }
        if !vector.measure.fits(Dim::LENGTH) {
            return self.refuse(mark.value.range, Fact::WrongDimension { wanted: Dim::LENGTH, found: vector.measure.settled() });
        }
        Some(Value::Point(Fixed { frame, local, measure: Measure::Of(Dim::LENGTH) }))
    }

    /// All bodies with their coordinates and start values.
    fn bodies(&mut self, tree: &ast::Mechanism) -> Vec<Body> {
        let mut bodies = Vec::new();
        for item in &tree.items {
            match item {
                Item::Ground(frame) => {
                    if let Some(start) = frame.starts.first() {
                        self.diag.refuse::<()>(&start.what, Fact::GroundStart);
                    }
                }
                Item::Body(frame) => bodies.push(self.body(frame)),
                _ => {}
            }
        }
        bodies
    }

    fn body(&mut self, frame: &ast::Frame) -> Body {
        let mut starts: [Option<Expr>; 3] = [None; 3];
        let scope = Scope::mechanism().timeless("a start value");
        for start in &frame.starts {
            let word = start.what.to_string();
            let found: Option<Vec<(usize, Expr)>> = match word.as_str() {
                "x" => self.scalar_of(&start.value, Dim::LENGTH, &scope).map(|value| vec![(0, value.expr)]),
                "y" => self.scalar_of(&start.value, Dim::LENGTH, &scope).map(|value| vec![(1, value.expr)]),
                "angle" => self.scalar_of(&start.value, Dim::ANGLE, &scope).map(|value| vec![(2, value.expr)]),
                "position" => self.vector(&start.value, &scope).and_then(|vector| {
                    if !vector.measure.fits(Dim::LENGTH) {
                        return self.refuse(start.value.range, Fact::WrongDimension { wanted: Dim::LENGTH, found: vector.measure.settled() });
                    }
                    Some(vec![(0, vector.x), (1, vector.y)])
                }),
                _ => {
                    let near = nearest(&word, ["x", "y", "angle", "position"].into_iter());
                    self.refuse(&start.what, Fact::UnknownStart { name: word.clone(), near })
                }
            };
            for (which, expr) in found.unwrap_or_default() {
                if !self.is_fixed(expr) {
                    self.refuse::<()>(start.value.range, Fact::NotFixed { place: "a start value" });
                } else if starts[which].replace(expr).is_some() {
                    self.refuse::<()>(&start.what, Fact::DuplicateStart { name: word.clone(), body: frame.name.to_string() });
                    break;
                }
            }
        }
        let kinds = [("x", Dim::LENGTH), ("y", Dim::LENGTH), ("angle", Dim::ANGLE)];
        let coordinates = kinds.into_iter().zip(starts).map(|((name, dim), start)| Coordinate { name, dim, start }).collect();
        Body { docs: frame.docs.clone(), name: frame.name.clone(), coordinates }
    }

    /// Resolves every point and axis, used or not, and gives the local coordinates of the points.
    fn marks(&mut self) -> Vec<Expr> {
        let mut lengths = Vec::new();
        for frame in 0..self.names.frames.len() {
            for name in self.names.frames[frame].order.clone() {
                if let Some(Value::Point(point)) = self.mark(FrameId(frame), &name) {
                    lengths.extend(point.local);
                }
            }
        }
        lengths
    }

    /// Resolves `let`s and functions in the order written: whether anything uses them or not, a
    /// mistake in them is found.
    fn lets_and_functions(&mut self, tree: &ast::Mechanism) {
        for item in &tree.items {
            match item {
                Item::Let(binding) if self.names.is_known(&binding.name) => {
                    self.declared(&binding.name);
                }
                Item::Function(function) => self.check_function(function),
                _ => {}
            }
        }
    }

    /// A function is checked once on its own, with an argument that nothing is known of.
    fn check_function(&mut self, function: &ast::Function) {
        let (from, to) = (self.dimension(&function.from), self.dimension(&function.to));
        let (Some(from), Some(to)) = (from, to) else { return };
        let Some(argument) = &function.argument else {
            if !matches!(function.value.kind, ast::ExprKind::Path(_)) {
                self.refuse::<()>(function.value.range, Fact::FunctionNeedsArgument);
            }
            return;
        };
        let leaf = self.arena.leaf(Leaf::Parameter(u32::MAX));
        let mut scope = Scope::mechanism().timeless("a function of one variable");
        scope.bound.push((argument.to_string(), Value::Scalar(Scalar { expr: leaf, measure: Measure::Of(from) })));
        self.names.open_functions.push(function.name.to_string());
        self.scalar_of(&function.value, to, &scope);
        self.names.open_functions.pop();
    }

    fn joints(&mut self, tree: &ast::Mechanism) -> Vec<Joint> {
        let mut joints = Vec::new();
        for item in &tree.items {
            let Item::Joint(joint) = item else { continue };
            if !self.names.is_declared_as(joint) || joints.iter().any(|known: &Joint| known.name == joint.name) {
                // The name belongs to another item; that has been refused.
                continue;
            }
            let Some(rows) = self.joint_rows(joint) else { continue };
            let kind = match &joint.body {
                ast::JointBody::Of { kind, .. } => kind.to_string(),
                ast::JointBody::Equations(_) => "equation".to_owned(),
            };
            self.rows_are_sound(joint, &rows);
            let residual = |row: Row| Residual { expr: row.residual.expr, dim: row.residual.measure.settled() };
            let residuals = rows.into_iter().map(residual).collect();
            joints.push(Joint { docs: joint.docs.clone(), name: joint.name.clone(), kind, is_drive: joint.is_drive, residuals });
        }
        joints
    }

    /// Every row depends on a position, and those of a joint not on time; one refusal is enough.
    fn rows_are_sound(&mut self, joint: &ast::Joint, rows: &[Row]) {
        let (name, of) = (joint.name.to_string(), rows.len());
        let leaves = |row: &Row| self.arena.leaves(row.residual.expr);
        let is_of_nothing = |row: &Row| !leaves(row).iter().any(|leaf| matches!(leaf, Leaf::Coordinate(_)));
        if let Some(row) = rows.iter().position(is_of_nothing) {
            self.diag.refuse::<()>(rows[row].range, Fact::RowOfNothing { joint: name, row: row + 1, of });
        } else if let Some(row) = rows.iter().find(|row| !joint.is_drive && leaves(row).contains(&Leaf::Time)) {
            let range = self.time_dependent_argument(joint).unwrap_or(row.range);
            self.diag.refuse::<()>(range, Fact::TimeInJoint { joint: name });
        }
    }

    fn outputs(&mut self, tree: &ast::Mechanism) -> Vec<Output> {
        let mut outputs: Vec<Output> = Vec::new();
        for item in &tree.items {
            let Item::Output(output) = item else { continue };
            let word = output.name.to_string();
            if is_generated(&output.name) {
                self.diag.refuse::<()>(&output.name, Fact::Generated { name: word });
                continue;
            }
            if outputs.iter().any(|known| known.name == word) {
                self.diag.refuse::<()>(&output.name, Fact::Duplicate { name: word, first: "another output" });
                continue;
            }
            let Some(value) = self.value(&output.value, &Scope::mechanism()) else { continue };
            let noun = value.noun();
            let (components, measure) = match value {
                Value::Scalar(scalar) => (vec![scalar.expr], scalar.measure),
                other => match self.as_vector(other) {
                    Some(vector) => (vec![vector.x, vector.y], vector.measure),
                    None => {
                        self.diag.refuse::<()>(output.value.range, Fact::NotAnOutput { found: noun });
                        continue;
                    }
                },
            };
            outputs.push(Output { docs: output.docs.clone(), name: output.name.clone(), components, dim: measure.settled() });
        }
        outputs
    }
}
