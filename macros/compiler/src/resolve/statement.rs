//! The statements of a definition or of an inline joint: equations, and conditions on parameters.

use super::elaborate::Elaborator;
use super::{Name, Parameter, Requirement, tabulated};
use crate::diag::{EquationFact, Fact, Range, ValueFact};
use crate::expr::{Expr, Node, Unary, Values, evaluate};
use crate::hints::{argument_of, place_of_argument};
use crate::names::{FixedValue, FrameId, Instance, Scalar, Scope, Value};
use crate::syntax::ast::{self, ExpressionKind, Relation, Statement};
use std::collections::BTreeSet;

/// One scalar equation: left minus right side, and the source range for its errors.
#[derive(Clone, Copy)]
pub(super) struct ScalarEquation {
    pub(super) residual: Scalar,
    pub(super) range: Range,
}

/// An angle counts as a right angle if its |cos| is below this fraction of it, the error of its last digit.
const RIGHT: f64 = 2.0 * f64::EPSILON;

impl Elaborator<'_> {
    /// The residuals of a list of statements.
    pub(super) fn statements(
        &mut self,
        statements: &[Statement],
        mut scope: Scope,
        joint: &Name,
        places: &[(String, Range)],
    ) -> Option<Vec<ScalarEquation>> {
        let mut rows: Vec<ScalarEquation> = Vec::new();
        let of = statements.iter().filter(|statement| matches!(statement, Statement::Equation(..))).count();
        let mut number = 0;
        let mut complete = true;
        for statement in statements {
            match statement {
                Statement::Let(binding) => {
                    let value = self.binding(binding, &scope)?;
                    scope.bound.push((binding.name.to_string(), value));
                }
                Statement::Equation(lhs, rhs) if self.applied.is_some() => {
                    return self.refuse(lhs.range.to(rhs.range), EquationFact::EquationInForce);
                }
                Statement::Equation(lhs, rhs) => {
                    number += 1;
                    match self.numbered(number, of, |this| this.residuals(lhs, rhs, &scope)) {
                        Some(residuals) => {
                            let range = self.blame.as_ref().map_or(lhs.range.to(rhs.range), |blame| blame.place);
                            rows.extend(residuals.into_iter().map(|residual| ScalarEquation { residual, range }));
                        }
                        None => complete = false,
                    }
                }
                Statement::Apply(ast::Applied { target: at, .. }) | Statement::Potential(at) if self.applied.is_none() => {
                    return self.refuse(at.range, EquationFact::ForceInJoint);
                }
                Statement::Apply(applied) => complete &= self.apply_force(applied, &scope).is_some(),
                Statement::Potential(energy) => complete &= self.energy(energy, true, &scope).is_some(),
                Statement::Add(added) => complete &= self.add_mass(added, &scope).is_some(),
                Statement::Require(requirement) => complete &= self.requirement(requirement, &scope, joint, places).is_some(),
            }
            // One error per instance is enough: the next one would mark the same token.
            if !complete && self.blame.is_some() {
                return None;
            }
        }
        if complete && rows.is_empty() && self.applied.is_none() {
            return self.refuse(joint, EquationFact::NoEquations { name: joint.word.to_string() });
        }
        let applies = statements.iter().any(|statement| matches!(statement, Statement::Apply(_)));
        if complete && self.applied.is_some() && !applies {
            let body = self.names.frames.get(1).filter(|_| !self.names.is_abstract()).map(|frame| frame.name.clone());
            return self.refuse(joint, EquationFact::NoForces { name: joint.word.to_string(), body, ambient: self.names.ambient });
        }
        complete.then_some(rows)
    }

    /// Runs `read`. Inside a definition that is being instantiated, its errors name the equation.
    fn numbered<T>(&mut self, number: usize, of: usize, read: impl FnOnce(&mut Self) -> T) -> T {
        let outer = self.blame.clone();
        if let (Some(Instance { definition, .. }), true) = (&mut self.blame, of > 1) {
            *definition = format!("equation {number} of {definition}");
        }
        let value = read(self);
        self.blame = outer;
        value
    }

    /// Checks a condition between bodies; keeps one between numbers until the defaults are known, unless it is constant.
    fn requirement(&mut self, requirement: &ast::Condition, scope: &Scope, joint: &Name, places: &[(String, Range)]) -> Option<()> {
        let (left, right) = (self.value(&requirement.lhs, scope), self.value(&requirement.rhs, scope));
        let (left, right) = (left?, right?);
        let place = place_of_argument(&requirement.lhs, places);
        match (left, right) {
            (Value::Body(one), Value::Body(two)) => self.body_requirement(requirement, [one, two], scope, places),
            (Value::Scalar(one), Value::Scalar(two)) => self.number_requirement(requirement, one, two, joint, place),
            (left, right) => self.refuse(requirement.range(), ValueFact::CannotCompare { one: left.kind(), two: right.kind() }),
        }
    }

    /// Checks that two bodies are the same, or that they differ.
    fn body_requirement(
        &mut self,
        requirement: &ast::Condition,
        [one, two]: [FrameId; 2],
        scope: &Scope,
        places: &[(String, Range)],
    ) -> Option<()> {
        let ast::Condition { lhs, relation, rhs, why } = requirement;
        // If the bodies must differ, the first argument is taken as right.
        let (holds, sides) = match relation {
            Relation::Equal => (one == two, [(lhs, two), (rhs, one)]),
            Relation::Different => (one != two, [(rhs, one), (lhs, two)]),
            _ => return self.refuse(requirement.range(), ValueFact::OrderOfBodies),
        };
        if holds || [one, two].iter().any(|frame| self.names.frames[frame.0].is_unknown()) {
            return Some(());
        }
        let mut blamed = sides.into_iter().filter_map(|(side, other)| {
            let instead = |given| self.names.mark_instead(scope.value_of(given)?, *relation, other, &scope.bound);
            Some((place_of_argument(side, places)?, argument_of(side).and_then(instead)))
        });
        let first = blamed.next();
        // An argument in whose place another one can be proposed comes first.
        let best = first.iter().cloned().chain(blamed).find(|(_, instead)| instead.is_some()).or(first);
        let (place, instead) = best.map_or((None, None), |(place, instead)| (Some(place), instead));
        self.refuse_at(place, requirement.range(), EquationFact::RequirementFails { why: why.clone(), instead })
    }

    fn number_requirement(
        &mut self,
        requirement: &ast::Condition,
        one: Scalar,
        two: Scalar,
        joint: &Name,
        place: Option<Range>,
    ) -> Option<()> {
        let Some(measure) = one.measure.common(two.measure) else {
            let (one, two) = (one.measure.settled(), two.measure.settled());
            return self.refuse(requirement.range(), ValueFact::Unlike { action: "compare", one, two });
        };
        let (lhs, rhs) = (one.expr, two.expr);
        if self.names.is_abstract() || !self.arena.is_fixed(lhs) || !self.arena.is_fixed(rhs) {
            // A function of time may vanish at some instants; the solver has to detect that.
            return Some(());
        }
        let why = requirement.why.clone();
        if self.arena.leaves(lhs).is_empty() && self.arena.leaves(rhs).is_empty() {
            let values = self.numbers(&[], &[lhs, rhs]);
            let holds = requirement.relation.holds(values[0], values[1]);
            return if holds {
                Some(())
            } else {
                self.refuse_at(place, requirement.range(), EquationFact::RequirementFails { why, instead: None })
            };
        }
        // The compared quantity has its name in the definition.
        let compared = match &requirement.lhs.kind {
            ExpressionKind::Path(path) => format!("{joint}.{}", path.last),
            _ => joint.to_string(),
        };
        self.requirements.push(Requirement { lhs, relation: requirement.relation, rhs, dim: measure.settled(), joint: compared, why });
        let blamed = place.or(self.blame.as_ref().map(|blame| blame.place));
        self.requirement_places.push((blamed.unwrap_or(requirement.range()), joint.clone()));
        Some(())
    }

    /// Reports an error at the argument at fault, if there is one.
    fn refuse_at<T>(&mut self, place: Option<Range>, range: Range, fact: impl Into<Fact>) -> Option<T> {
        let place = place.or(self.blame.as_ref().map(|blame| blame.place));
        self.refuse_here(place.unwrap_or(range), fact)
    }

    /// Checks that the conditions on parameters hold at the declared defaults.
    pub(super) fn requirements_hold(&mut self, parameters: &[Parameter]) {
        if !self.diag.is_clean() {
            return;
        }
        let defaults: Vec<_> = parameters.iter().map(|parameter| parameter.default).collect();
        let defaults = self.numbers(&[], &defaults);
        let mut said = BTreeSet::new();
        for index in 0..self.requirements.len() {
            let Requirement { lhs, relation, rhs, ref why, joint: ref compared, .. } = self.requirements[index];
            let (why, compared) = (why.clone(), compared.clone());
            let values = self.numbers(&defaults, &[lhs, rhs]);
            // Each condition of a declaration is reported once, however many parts there are.
            let (place, joint) = &self.requirement_places[index];
            if !relation.holds(values[0], values[1]) && said.insert((joint.declaration, compared.replacen(&joint.path, "", 1))) {
                self.diag.refuse::<()>(*place, EquationFact::RequirementFailsAtDefaults { why, value: values[0] });
            }
        }
    }

    /// Checks that points, axes and start values are finite at the declared defaults.
    pub(super) fn fixed_values_are_finite(&mut self, parameters: &[Parameter]) {
        if !self.diag.is_clean() {
            return;
        }
        let defaults: Vec<_> = parameters.iter().map(|parameter| parameter.default).collect();
        let defaults = self.numbers(&[], &defaults);
        let fixed = std::mem::take(&mut self.fixed_values);
        if self.are_finite(&fixed.iter().map(|value| value.expr).collect::<Vec<_>>(), &defaults) {
            return;
        }
        for FixedValue { expr, item, range, noun, place } in fixed {
            if !self.is_finite(expr, &defaults) {
                self.with_place(place, |this| {
                    this.unless_refused(item, |this| this.refuse::<()>(range, ValueFact::NotFinite { place: noun }))
                });
            }
        }
    }

    /// True if an expression of parameters alone has a finite value, as far as the compiler can evaluate it. The tangent of a right
    /// angle is not finite, although no binary number is a right angle.
    pub(super) fn is_finite(&self, expr: Expr, parameters: &[f64]) -> bool {
        let is_rust = |function: u32| matches!(self.functions.get(function as usize), Some(super::Function::Rust(_)));
        let calls_rust = |under: Expr| matches!(*self.arena.node(under), Node::Call { function, .. } if is_rust(function));
        self.arena.reachable(&[expr]).into_iter().any(calls_rust) || self.are_finite(&[expr], parameters)
    }

    /// True if all expressions of parameters alone have finite values that the compiler can evaluate.
    fn are_finite(&self, exprs: &[Expr], parameters: &[f64]) -> bool {
        let angle = |under: Expr| if let Node::Unary(Unary::Tan, angle) = *self.arena.node(under) { Some(angle) } else { None };
        let angles: Vec<Expr> = self.arena.reachable(exprs).into_iter().filter_map(angle).collect();
        let is_right = |angle: &f64| libm::cos(*angle).abs() < RIGHT * angle.abs().max(1.0);
        self.numbers(parameters, exprs).iter().all(|value| value.is_finite()) && !self.numbers(parameters, &angles).iter().any(is_right)
    }

    /// Evaluates expressions of parameters alone.
    pub(super) fn numbers(&self, parameters: &[f64], roots: &[crate::expr::Expr]) -> Vec<f64> {
        let functions = |number: u32, x: f64| tabulated(&self.functions, number, x);
        let values = Values { time: 0.0, parameters, coordinates: &[], speeds: &[], accelerations: &[], functions: &functions };
        evaluate(&self.arena, roots, &values)
    }
}
