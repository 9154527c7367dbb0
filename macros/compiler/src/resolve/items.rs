//! Items that no other item refers to by name; each is resolved once, in the order written.

use super::elaborate::Elaborator;
use super::statement::ScalarEquation;
use super::{Freedom, Joint, Layout, Method, Name, Of, Output, Residual};
use crate::diag::{ArrayFact, EquationFact, JerkObstacle, Kind, MotionFact, NameFact, Range, ValueFact};
use crate::expr::{Expr, Leaf};
use crate::hints::is_generated;
use crate::names::{Context, EntityId, FrameId, Register, Scalar, Scope, Value};
use crate::quantity::{Ambient, Dim, InferredDim};
use crate::syntax::ast::{self, JointItem, Mechanism};
use proc_macro2::Ident;
use std::collections::BTreeSet;

impl Elaborator<'_> {
    /// Resolves `let`s, arguments of parts and functions in the order written, so that errors in unused ones are found as well.
    pub(super) fn lets_and_functions(&mut self, register: &Register) {
        for binding in &register.lets {
            let range = Range::from(&self.names.declared[binding.0].name);
            self.entity(*binding, range);
        }
        for function in &register.functions {
            self.check_function(function);
        }
    }

    /// Checks a function once on its own, with an unknown argument.
    fn check_function(&mut self, function: &ast::Shared<ast::FunctionItem>) {
        let (from, to) = (self.dimension(&function.from), self.dimension(&function.to));
        let (Some(from), Some(to)) = (from, to) else { return };
        let Some(argument) = &function.argument else {
            if !matches!(function.value.kind, ast::ExpressionKind::Path(_)) {
                self.refuse::<()>(function.value.range, ValueFact::FunctionNeedsArgument);
            }
            return;
        };
        let leaf = self.arena.leaf(Leaf::Parameter(u32::MAX));
        let mut scope = Scope::mechanism().timeless("a function of one variable");
        scope.bound.push((argument.to_string(), Value::Scalar(Scalar { expr: leaf, measure: InferredDim::Known(from) })));
        self.names.open_functions.push(function.name.to_string());
        self.unless_refused(function, |this| this.scalar_of(&function.value, to, &scope));
        self.names.open_functions.pop();
    }

    pub(super) fn joints(&mut self, register: &Register) -> Vec<Joint> {
        let joint = |this: &mut Self, (id, joint): &(EntityId, ast::Shared<ast::JointItem>)| {
            this.resolved(*id, joint, |this, name, context| this.joint(*id, joint, name, context))
        };
        let mut joints = Vec::new();
        for declared in &register.joints {
            if let Some((joint, rows)) = joint(self, declared) {
                if self.names.ambient == Ambient::Space {
                    self.note_relations(joints.len(), &rows);
                }
                joints.push(joint);
            }
        }
        joints
    }

    fn joint(&mut self, id: EntityId, joint: &ast::JointItem, name: &Name, context: &Context) -> Option<(Joint, Vec<ScalarEquation>)> {
        let rows = self.joint_rows(id, joint, name, context)?;
        let kind = match &joint.body {
            ast::JointBody::Of { kind, .. } => kind.to_string(),
            ast::JointBody::Equations(_) => "equation".to_owned(),
            ast::JointBody::Freedom(_) => "freedom".to_owned(),
            ast::JointBody::Energy(_) => "energy".to_owned(),
            ast::JointBody::Value(_) => "value".to_owned(),
        };
        let freedom = match &joint.body {
            ast::JointBody::Freedom(freedom) => Some(Freedom { is_from_start: freedom.from.is_none() }),
            _ => None,
        };
        self.rows_are_sound(id, joint, &rows);
        self.rows_are_affine(&name.to_string(), &rows);
        let residual = |row: &ScalarEquation| {
            let is_velocity = self.has_speeds(row.residual.expr);
            let time = InferredDim::Known(if is_velocity { Dim::TIME } else { Dim::NUMBER });
            Residual { expr: row.residual.expr, dim: row.residual.measure.times(time).settled(), is_velocity }
        };
        let residuals = rows.iter().map(residual).collect();
        let place = self.place_of_load(id, joint);
        let JointItem { is_drive, is_redundant, is_slice, .. } = *joint;
        let velocity = joint.velocity.as_ref().map(Range::from);
        Some((Joint { name: name.clone(), kind, is_drive, is_redundant, is_slice, velocity, freedom, residuals, place }, rows))
    }

    /// The last point of a joint that moves; without one, the origin of the last body that does.
    fn place_of_load(&mut self, id: EntityId, joint: &ast::JointItem) -> Option<(usize, Vec<Expr>)> {
        let Value::Joint { arguments, .. } = self.entity(id, (&joint.name).into())? else { return None };
        let zero = self.arena.integer(0);
        let origin = vec![zero; self.names.ambient.components()];
        let moving = |value: &Value| match value {
            Value::Point(point) => Some((point.frame.0.checked_sub(1)?, point.local.to_vec(), true)),
            Value::Axis(axis) => Some((axis.frame.0.checked_sub(1)?, origin.clone(), false)),
            Value::Body(frame) => Some((frame.0.checked_sub(1)?, origin.clone(), false)),
            _ => None,
        };
        let found: Vec<(usize, Vec<Expr>, bool)> = arguments.iter().filter_map(|(_, value)| moving(value)).collect();
        let place = found.iter().rev().find(|(_, _, is_point)| *is_point).or(found.last())?;
        Some((place.0, place.1.clone()))
    }

    /// Checks that every row depends on a position, and that no row of a joint depends on time; reports at most one error.
    fn rows_are_sound(&mut self, id: EntityId, joint: &ast::JointItem, rows: &[ScalarEquation]) {
        let (name, of) = (joint.name.to_string(), rows.len());
        let leaves = |row: &ScalarEquation| self.arena.leaves(row.residual.expr);
        // An argument of an unused component may move.
        let may_move = |leaf: &Leaf| leaf.moves() || self.is_unused && matches!(leaf, Leaf::Parameter(_));
        let is_of_nothing = |row: &ScalarEquation| !leaves(row).iter().any(may_move);
        if let Some(row) = rows.iter().position(is_of_nothing) {
            self.refuse_here::<()>(rows[row].range, EquationFact::RowOfNothing { joint: name, row: row + 1, of, at_defaults: false });
        } else if let Some(row) = rows.iter().find(|row| !joint.is_drive && leaves(row).into_iter().any(Leaf::is_of_time)) {
            let input = self.input_in(row.residual.expr);
            let range = self.time_dependent_argument(id, joint).unwrap_or(row.range);
            self.refuse_here::<()>(
                range,
                match input {
                    Some(input) => EquationFact::InputInJoint { joint: name, input },
                    None => EquationFact::TimeInJoint { joint: name, has_places: joint.takes_places() },
                },
            );
        }
    }

    /// Resolves all outputs; `None` for each rejected one.
    pub(super) fn outputs(&mut self, register: &Register) -> Vec<Option<Output>> {
        let output = |(id, output): &(EntityId, ast::Shared<ast::OutputItem>)| {
            self.resolved(*id, output, |this, name, context| this.output(output, name, context))
        };
        register.outputs.iter().map(output).collect()
    }

    fn output(&mut self, output: &ast::OutputItem, name: &Name, context: &Context) -> Option<Output> {
        let value = self.value(&output.value, &Scope::of(context))?;
        let found = if matches!(value, Value::Body(FrameId::GROUND)) { Kind::Ground } else { value.kind() };
        let (components, measure) = match value {
            Value::Scalar(scalar) => (vec![scalar.expr], scalar.measure),
            Value::Body(frame) if frame != FrameId::GROUND => {
                self.may_have_jerk(output, JerkObstacle::Body)?;
                let (name, body) = (name.clone(), Some(frame.0 - 1));
                return Some(Output { name, body, components: Vec::new(), dim: Dim::NUMBER, derivatives: 2 });
            }
            other => match self.as_vector(other) {
                Some(vector) => (vector.parts.to_vec(), vector.measure),
                None => return self.refuse(output.value.range, ValueFact::NotAnOutput { found }),
            },
        };
        if components.iter().any(|part| self.arena.is_never_finite(*part)) {
            return self.refuse(output.value.range, ValueFact::NotFinite { place: "the output" });
        }
        let Some(derivatives @ 1..) = components.iter().map(|part| self.derivatives_of(*part)).min() else {
            return self.refuse(output.value.range, ValueFact::OutputWithoutRate);
        };
        if derivatives == 1 {
            self.may_have_jerk(output, JerkObstacle::Velocity)?;
        }
        let derivatives = derivatives + usize::from(output.jerk.is_some());
        Some(Output { name: name.clone(), body: None, components, dim: measure.settled(), derivatives })
    }

    /// Refuses an output with jerk, if it is declared so.
    pub(super) fn may_have_jerk(&mut self, output: &ast::OutputItem, obstacle: JerkObstacle) -> Option<()> {
        let Some(jerk) = &output.jerk else { return Some(()) };
        self.refuse(jerk, MotionFact::NoJerk { output: output.name.to_string(), obstacle })
    }

    /// One method for each output name. The method of an output in a part begins with the names of the enclosing parts.
    pub(super) fn methods(&mut self, layout: &Layout, register: &Register, outputs: &[Option<Output>], tree: &Mechanism) -> Vec<Method> {
        let mut methods = Vec::new();
        self.methods_of(layout, register, &[0], &[], "", &mut methods);
        methods.sort_by_key(|method: &Method| method.members.first().copied());
        let mut taken = BTreeSet::new();
        for method in &methods {
            let word = method.name.to_string();
            let slice = word.strip_prefix("solve_for_");
            let is_of_slice = |output: &str| methods.iter().any(|method| method.is_slice && method.name == output);
            if is_generated(&method.name, tree) || slice.is_some_and(is_of_slice) {
                self.refuse::<()>(&method.name, NameFact::Generated { name: word });
            } else if !taken.insert(word.clone()) {
                self.refuse::<()>(&method.name, NameFact::Duplicate { name: word, first: "another output" });
            }
            let shape = |member: &usize| outputs[*member].as_ref().map(|output| (output.components.len(), output.dim, output.derivatives));
            let mut shapes = method.members.iter().filter_map(shape);
            let first = shapes.next();
            if shapes.any(|other| Some(other) != first) {
                self.refuse::<()>(&method.name, ArrayFact::UnlikeOutputs { name: method.name.to_string() });
            }
        }
        // Rejected outputs have no number, but then no code is emitted.
        methods
    }

    /// Adds the methods of the outputs in some parts of one component.
    fn methods_of(&self, layout: &Layout, register: &Register, parts: &[usize], sizes: &[usize], prefix: &str, methods: &mut Vec<Method>) {
        let Some(first) = parts.first() else { return };
        let component = &layout.components[layout.parts[*first].component];
        for (number, field) in component.fields.iter().enumerate() {
            let members: Vec<usize> =
                parts.iter().flat_map(|part| layout.parts[*part].members.get(number).cloned().unwrap_or_default()).collect();
            let sizes: Vec<usize> = sizes.iter().chain(&field.sizes).copied().collect();
            match field.of {
                Of::Output => {
                    let word = if prefix.is_empty() { field.name.clone() } else { joined(prefix, &field.name) };
                    let is_slice = members.iter().any(|member| register.outputs[*member].1.is_slice);
                    methods.push(Method { name: word, docs: field.docs.clone(), sizes, members, is_slice });
                }
                Of::Part(_) => {
                    let prefix = format!("{prefix}{}_", field.name.to_string().trim_start_matches("r#"));
                    self.methods_of(layout, register, &members, &sizes, &prefix, methods);
                }
                Of::Parameter | Of::Input | Of::Body => {}
            }
        }
    }
}

/// `leg_` and `toe` make `leg_toe`.
fn joined(prefix: &str, name: &Ident) -> Ident {
    Ident::new(&format!("{prefix}{}", name.to_string().trim_start_matches("r#")), name.span())
}
