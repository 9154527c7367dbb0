//! Items that nothing else refers to by name: each is looked at once, in the order written.

use super::dimension::Measure;
use super::elaborate::{Elaborator, Scope};
use super::names::is_generated;
use super::statement::Row;
use super::value::{Scalar, Value};
use super::{Joint, Output, Residual};
use crate::diag::Fact;
use crate::expr::Leaf;
use crate::syntax::ast::{self, Item};

impl Elaborator<'_> {
    /// Resolves `let`s and functions in the order written: whether anything uses them or not, a
    /// mistake in them is found.
    pub(super) fn lets_and_functions(&mut self, tree: &ast::Mechanism) {
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

    pub(super) fn joints(&mut self, tree: &ast::Mechanism) -> Vec<Joint> {
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

    pub(super) fn outputs(&mut self, tree: &ast::Mechanism) -> Vec<Output> {
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
