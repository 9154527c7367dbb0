//! Checks for a probable intent where another kind of item was written: a value for a force, a force for a joint, a number
//! for a torque in space.

use super::Joint;
use super::elaborate::Elaborator;
use super::statement::ScalarEquation;
use crate::diag::{EquationFact, JerkObstacle, JointValue, MotionFact, ValueFact, Word};
use crate::hints::{by_time, cross_product, is_zero, place_in, unit_in_parts};
use crate::library;
use crate::names::{FrameId, Register, Scope, Sort, SpaceId, Value};
use crate::quantity::{self, Ambient, Dim};
use crate::syntax::ast::{self, Definition, ExpressionKind, Formal, FormalKind, JointItem, Statement, Task};
use proc_macro2::Ident;

impl Elaborator<'_> {
    /// Word with which an item is declared.
    fn word_of(&self, joint: &JointItem, space: SpaceId) -> Word {
        let group = self.names.find(space, &joint.name.to_string());
        let is_force = group.is_some_and(|group| self.names.group(group).sort == Sort::Force);
        match (is_force, joint.is_drive) {
            (true, _) => Word::Force,
            (false, true) => Word::Drive,
            (false, false) => Word::Joint,
        }
    }

    /// Refuses a force that is declared as a joint or a drive, a joint without numbers as a drive, and a joint or a drive as a force.
    pub(super) fn is_of_its_word(&mut self, joint: &JointItem, space: SpaceId, kind: &Ident, definition: &Definition) -> Option<()> {
        let applies = definition.statements.iter().any(|statement| matches!(statement, Statement::Apply(_)));
        let (word, name, constraint) = (self.word_of(joint, space), joint.name.to_string(), kind.to_string());
        match (word, applies) {
            (Word::Force, false) => {
                let is_drive = constraint.starts_with("drive_");
                self.refuse(kind, MotionFact::ConstraintForForce { constraint, is_drive, name })
            }
            (Word::Joint | Word::Drive, true) => {
                let is_along = definition.parameters.first().is_some_and(|formal| formal.name == "P");
                let drive = || if is_along { "drive_distance(P, Q, law)".to_owned() } else { self.names.a_drive("law") };
                let instead = (word == Word::Drive).then(drive);
                self.refuse(kind, MotionFact::ForceForConstraint { force: constraint, word, name, instead })
            }
            (Word::Drive, false) if !definition.takes_numbers() => self.refuse(kind, MotionFact::JointForDrive { constraint, name }),
            _ => Some(()),
        }
    }

    /// Refuses a value where a call or equations are wanted, with a line that uses it.
    pub(super) fn value_alone(&mut self, joint: &JointItem, written: &ast::Expression, scope: &Scope) -> Option<Vec<ScalarEquation>> {
        let (found, value, name) = (self.value(written, scope)?, written.to_string(), &joint.name);
        let word = self.word_of(joint, scope.space.unwrap_or(SpaceId::MECHANISM));
        let dim = match &found {
            Value::Scalar(scalar) => scalar.measure.settled(),
            _ => Dim::NUMBER,
        };
        let is_torque = dim.agrees(Dim::TORQUE);
        let fact = match word {
            Word::Force => {
                let first = self.names.frames.get(1).map_or("body", |frame| frame.name.as_str());
                let is_body = |name: &str| self.names.frames[1..].iter().any(|frame| frame.name == name);
                let place = place_in(written, is_body).unwrap_or_else(|| format!("{first}.position"));
                let body = place.split_once('.').map_or(first, |(body, _)| body);
                let instead = match (&found, is_torque, self.names.ambient) {
                    (Value::Vector(_), ..) => format!("force {name} = {{ at {place}: {value}; }}"),
                    (_, true, Ambient::Plane) => format!("force {name} = {{ on {body}: {value}; }}"),
                    (_, true, Ambient::Space) => format!("force {name} = {{ on {body}: (0Nm, 0Nm, {value}); }}"),
                    (_, _, Ambient::Plane) => format!("force {name} = {{ at {body}.position: (0N, {value}); }}"),
                    (_, _, Ambient::Space) => format!("force {name} = {{ at {body}.position: (0N, 0N, {value}); }}"),
                };
                MotionFact::ValueForForce { value, instead, laws: library::forces(self.names.ambient).map(str::to_owned).collect() }
            }
            Word::Drive => {
                let call = match &written.kind {
                    ExpressionKind::Field(owner, field) if field == "angle" && self.names.ambient == Ambient::Plane => {
                        format!("drive_angle({owner}, 60rpm * t)")
                    }
                    ExpressionKind::Field(_, field) if field == "angle" => format!("drive_rotation({value}, 60rpm * t)"),
                    _ if dim.times(Dim::TIME) == Dim::ANGLE => self.names.a_drive(&format!("{value} * t")),
                    _ => self.names.a_drive(&value),
                };
                MotionFact::ValueForConstraint { word, value, instead: format!("drive {name} = {call};") }
            }
            Word::Joint => {
                let call = if self.names.ambient == Ambient::Space { "revolute(P, a, Q, b)" } else { "revolute(P, Q)" };
                MotionFact::ValueForConstraint { word, value, instead: format!("joint {name} = {call};") }
            }
        };
        self.refuse(written.range, fact)
    }

    /// Refuses `10mm * t` for `10mm_s * t` where dimensions do not agree.
    pub(super) fn is_by_rates(&mut self, written: [&ast::Expression; 2]) -> Option<()> {
        let Some((number, found, instead)) = written.into_iter().find_map(by_time) else { return Some(()) };
        self.refuse(number.range, ValueFact::NotARate { written: number.to_string(), found, instead })
    }

    /// Refuses a vector that is the torque on a body in the plane.
    pub(super) fn is_undirected(&mut self, applied: &ast::Applied, scope: &Scope) -> Option<()> {
        let torque = match &applied.value.kind {
            // Of three components the last one turns in the plane.
            ExpressionKind::Tuple(items) => (items.len() == 3).then(|| items[2].to_string()),
            _ if matches!(self.value(&applied.value, scope)?, Value::Vector(_) | Value::Point(_) | Value::Axis(_)) => None,
            _ => return Some(()),
        };
        self.refuse(applied.value.range, MotionFact::TorqueWithAxis { body: applied.target.to_string(), torque })
    }

    /// Refuses a number that is a force, or a torque in space.
    pub(super) fn is_directed(&mut self, applied: &ast::Applied, frame: FrameId, scope: &Scope) -> Option<()> {
        let Value::Scalar(scalar) = self.value(&applied.value, scope)? else { return Some(()) };
        let (value, ambient) = (applied.value.to_string(), self.names.ambient);
        let fact = if applied.is_torque {
            let axis = self.names.an_axis_of(frame).map(|axis| format!("{}.{axis}", self.names.frames[frame.0].name));
            MotionFact::TorqueWithoutAxis { torque: value, axis }
        } else {
            let is_torque = scalar.measure.settled().agrees(Dim::TORQUE);
            let on = is_torque.then(|| self.names.frames[frame.0].name.clone());
            MotionFact::ForceWithoutDirection { force: value, ambient, on }
        };
        self.refuse(applied.value.range, fact)
    }

    /// Refuses `cross(a, b) == 0` in space: where it holds, its three rows are equivalent to two.
    pub(super) fn has_no_cross_product(&mut self, joint: &JointItem, statements: &[Statement], scope: &Scope) -> Option<()> {
        if self.names.ambient == Ambient::Plane || joint.is_redundant || !self.judges_rows {
            return Some(());
        }
        for statement in statements {
            let Statement::Equation(lhs, rhs) = statement else { continue };
            let (Some([one, two]), other) = (cross_product(lhs), rhs) else { continue };
            if !is_zero(other) {
                continue;
            }
            // Names bound by a `let` before it are not known here: then nothing is proposed about them.
            let axes = [one, two].map(|factor| self.names.is_axis(factor, scope));
            let [one, two] = [one.to_string(), two.to_string()];
            let rows = match axes {
                [true, _] => Some(format!("across({one}, {two}) == 0;")),
                [false, true] => Some(format!("across({two}, {one}) == 0;")),
                [false, false] => None,
            };
            let parallel = (axes == [true, true]).then(|| format!("joint {} = parallel_axes({one}, {two});", joint.name));
            return self.refuse(lhs.range.to(rhs.range), EquationFact::CrossProduct { rows, parallel });
        }
        Some(())
    }

    /// A number with its unit, where the unit is written in parts that are no names: `500N_mm` for `500N / mm`.
    pub(super) fn unit_of_parts(&mut self, written: &ast::Expression, scope: &Scope) -> Option<String> {
        let (text, names) = unit_in_parts(written)?;
        let is_known = |name: &&Ident| {
            let declared = scope.space.and_then(|space| self.names.visible(space, &name.to_string()));
            declared.is_some_and(|group| self.names.group(group).sort.may_be_number()) || scope.value_of(name).is_some()
        };
        let unit = text.trim_start_matches(|letter: char| letter.is_ascii_digit() || ['-', '.'].contains(&letter));
        if names.is_empty() || quantity::unit(unit).is_none() {
            return None;
        }
        match names.iter().find(|name| is_known(name)) {
            None => Some(text),
            Some(declared) => {
                self.declared_unit = Some((written.range, declared.to_string(), text));
                None
            }
        }
    }

    /// Refuses a joint as a freedom, and offers the coordinates that it leaves.
    pub(super) fn is_no_joint(&mut self, name: &Ident, freedom: &ast::FreedomItem, scope: &Scope) -> Option<()> {
        let written = &freedom.value;
        let Value::Joint { kind, arguments } = self.value(written, scope)? else { return Some(()) };
        let joint = written.to_string();
        let mut offers = Vec::new();
        for word in ["angle", "displacement", "angle_a", "angle_b"] {
            if matches!(self.quantity_of(&kind, &arguments, word), Some(Value::Scalar(_))) {
                offers.push(format!("{joint}.{word}"));
            }
        }
        if offers.is_empty() {
            offers = self.names.coordinates_across(&joint, &arguments);
        }
        // The start of one of several quantities is none of the others.
        let clauses = [(" from ", &freedom.from), (" at ", &freedom.at)].into_iter().filter(|_| offers.len() == 1);
        let start = clauses.filter_map(|(word, value)| Some(format!("{word}{}", value.as_ref()?))).collect();
        self.refuse(written.range, MotionFact::FreedomOfJoint { name: name.to_string(), joint, offers, start })
    }

    /// A joint of a body in space that has an angle.
    pub(super) fn hinge_of(&mut self, frame: FrameId) -> Option<String> {
        let joints = self.names.joints_of(frame).map(|(name, kind, arguments)| (name.to_owned(), kind.to_owned(), arguments.clone()));
        let joints: Vec<_> = joints.collect();
        let hinge = joints.into_iter().find(|(_, kind, arguments)| self.quantity_of(kind, arguments, "angle").is_some());
        hinge.map(|(name, ..)| name)
    }

    /// Refuses a joint where its angle or its displacement is wanted, and it has none.
    pub(super) fn has_quantity(
        &mut self,
        definition: &Definition,
        formal: &Formal,
        argument: &ast::Expression,
        value: &Value,
    ) -> Option<()> {
        let (FormalKind::Scalar(written), Value::Joint { kind, arguments }) = (&formal.kind, value) else { return Some(()) };
        let (wanted, other, drive) = match written.dim() {
            Some(Dim::ANGLE) => (JointValue::Angle, "displacement", "drive_translation"),
            Some(Dim::LENGTH) => (JointValue::Displacement, "angle", "drive_rotation"),
            _ => return Some(()),
        };
        if self.names.ambient == Ambient::Plane {
            return Some(());
        }
        let has_other = self.quantity_of(kind, arguments, other).is_some();
        let instead = (has_other && definition.name.to_string().starts_with("drive_")).then(|| format!("{drive}({argument}, …)"));
        let fact = MotionFact::JointWithoutValue { definition: definition.name.to_string(), wanted, kind: kind.clone(), instead };
        self.refuse(argument.range, fact)
    }

    /// Refuses slices beside inputs, and drives by inputs beside freedoms.
    pub(super) fn fits_inputs(&mut self, task: Task, register: &Register, joints: &[Joint]) {
        let Some(input) = self.inputs.values().next().cloned() else { return };
        for (_, output) in register.outputs.iter().filter(|(_, output)| output.is_slice && task.is_solved()) {
            let fact = MotionFact::SliceBesideInput { output: output.name.to_string(), input: input.clone() };
            self.unless_refused(output, |this| this.refuse::<()>(&output.name, fact));
        }
        if task != Task::Motion {
            return;
        }
        let freedom = joints.iter().find(|joint| joint.freedom.is_some()).map(|joint| joint.name.to_string());
        for joint in joints {
            let Some(input) = joint.residuals.iter().find_map(|residual| self.input_in(residual.expr)) else { continue };
            let fact = MotionFact::InputBesideFreedom { drive: joint.name.to_string(), input, freedom: freedom.clone() };
            self.refuse::<()>(&joint.name, fact);
        }
    }

    /// Refuses outputs with jerk where coordinates are not solved for.
    pub(super) fn fits_jerks(&mut self, task: Task, register: &Register) {
        let freedom = register.a_freedom();
        let obstacle = match task {
            Task::Kinematics => return,
            Task::EquationsOnly => JerkObstacle::EquationsOnly,
            Task::Motion => JerkObstacle::Integrated { freedom },
        };
        for (_, output) in &register.outputs {
            self.unless_refused(output, |this| this.may_have_jerk(output, obstacle.clone()));
        }
    }

    /// Refuses slices and a range of time beside freedoms: integration takes all bodies along, and ends where it is told to.
    pub(super) fn fits_freedoms(&mut self, task: Task, register: &Register) {
        if task != Task::Motion {
            return;
        }
        let freedom = register.a_freedom();
        for (_, output) in register.outputs.iter().filter(|(_, output)| output.is_slice) {
            let fact = MotionFact::SliceBesideFreedom { output: output.name.to_string(), freedom: freedom.clone() };
            self.unless_refused(output, |this| this.refuse::<()>(&output.name, fact));
        }
        if let Some(range) = &register.range {
            self.refuse::<()>(&range.keyword, MotionFact::RangeBesideFreedom { freedom });
        }
    }
}
