//! The statements of a definition or of an inline joint: equations, and conditions on parameters.

use super::elaborate::{Blame, Elaborator, Scope};
use super::value::{Scalar, Value};
use super::{Name, Parameter, Requirement};
use crate::diag::{Fact, Range};
use crate::expr::{Values, evaluate};
use crate::syntax::ast::{self, Relation, Statement};

/// One scalar equation: left minus right side, and what to blame for it.
#[derive(Clone, Copy)]
pub(super) struct Row {
    pub(super) residual: Scalar,
    pub(super) range: Range,
}

impl Elaborator<'_> {
    /// The residuals of a list of statements.
    pub(super) fn statements(
        &mut self,
        statements: &[Statement],
        mut scope: Scope,
        joint: &Name,
        places: &[(String, Range)],
    ) -> Option<Vec<Row>> {
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
            return self.refuse(joint, Fact::NoEquations { name: joint.word.to_string() });
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
    fn requirement(&mut self, requirement: &ast::Requirement, scope: &Scope, joint: &Name, places: &[(String, Range)]) -> Option<()> {
        let (left, right) = (self.value(&requirement.lhs, scope), self.value(&requirement.rhs, scope));
        let (left, right) = (left?, right?);
        let place = match &requirement.lhs.kind {
            ast::ExprKind::Path(path) => places.iter().find(|(name, _)| path.name.as_ref().is_some_and(|known| known == name)),
            _ => None,
        };
        let place = place.map(|(_, range)| *range);
        match (left, right) {
            (Value::Body(one), Value::Body(two)) => self.body_requirement(requirement, one == two, place),
            (Value::Scalar(one), Value::Scalar(two)) => self.number_requirement(requirement, one, two, joint, place),
            (left, right) => self.refuse(range(requirement), Fact::CannotCompare { one: left.noun(), two: right.noun() }),
        }
    }

    /// Two bodies must be the same, or must not be.
    fn body_requirement(&mut self, requirement: &ast::Requirement, is_same: bool, place: Option<Range>) -> Option<()> {
        let holds = match requirement.relation {
            Relation::Equal => is_same,
            Relation::Different => !is_same,
            _ => return self.refuse(range(requirement), Fact::OrderOfBodies),
        };
        if holds || self.names.is_abstract() {
            return Some(());
        }
        self.refuse_at(place, range(requirement), Fact::RequirementFails { why: requirement.why.clone() })
    }

    fn number_requirement(
        &mut self,
        requirement: &ast::Requirement,
        one: Scalar,
        two: Scalar,
        joint: &Name,
        place: Option<Range>,
    ) -> Option<()> {
        let Some(measure) = one.measure.common(two.measure) else {
            let (one, two) = (one.measure.settled(), two.measure.settled());
            return self.refuse(range(requirement), Fact::Unlike { action: "compare", one, two });
        };
        let (lhs, rhs) = (one.expr, two.expr);
        if self.names.is_abstract() || !self.is_fixed(lhs) || !self.is_fixed(rhs) {
            // A law of time can be zero at times; that is for the solver to notice.
            return Some(());
        }
        let why = requirement.why.clone();
        if self.arena.leaves(lhs).is_empty() && self.arena.leaves(rhs).is_empty() {
            let values = self.numbers(&[], &[lhs, rhs]);
            let holds = holds(requirement.relation, values[0], values[1]);
            return if holds { Some(()) } else { self.refuse_at(place, range(requirement), Fact::RequirementFails { why }) };
        }
        // What is compared goes by the name it has in the definition.
        let joint = match &requirement.lhs.kind {
            ast::ExprKind::Path(path) => format!("{joint}.{}", path.last),
            _ => joint.to_string(),
        };
        self.requirements.push(Requirement { lhs, relation: requirement.relation, rhs, dim: measure.settled(), joint, why });
        let blamed = place.or(self.blame.as_ref().map(|blame| blame.place));
        self.requirement_places.push(blamed.unwrap_or(range(requirement)));
        Some(())
    }

    /// Refuses at an argument if one is to blame.
    fn refuse_at<T>(&mut self, place: Option<Range>, range: Range, fact: Fact) -> Option<T> {
        let place = place.or(self.blame.as_ref().map(|blame| blame.place));
        self.say(place.unwrap_or(range), fact)
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

/// From the first token of a condition to the last.
fn range(requirement: &ast::Requirement) -> Range {
    requirement.lhs.range.to(requirement.rhs.range)
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
