//! A definition is checked where it is written: with arguments that nothing is known of but their
//! kind.

use super::dimension::{Dim, Measure};
use super::elaborate::{Elaborator, Scope};
use super::resolve::Names;
use super::value::{Fixed, Function, Scalar, Value};
use super::Function as Numbered;
use crate::diag::{Diag, Fact};
use crate::expr::{Arena, Leaf};
use crate::library;
use crate::syntax::ast::{Definition, Joint, JointBody, Kind};
use std::rc::Rc;

/// Reports what is wrong with a definition. `others` are definitions it may name as joint kinds.
pub(crate) fn check(definition: &Definition, others: &[Definition], diag: &mut Diag) {
    let mut work = Elaborator {
        arena: Arena::new(),
        diag,
        names: Names::abstract_(),
        functions: Vec::new(),
        requirements: Vec::new(),
        requirement_places: Vec::new(),
        blame: None,
    };
    work.check(definition, others);
}

impl Elaborator<'_> {
    fn check(&mut self, definition: &Definition, others: &[Definition]) -> Option<()> {
        let mut scope = Scope::default();
        let mut seen_default = false;
        for formal in &definition.parameters {
            let name = formal.name.to_string();
            if scope.bound.iter().any(|(known, _)| *known == name) {
                return self.refuse(&formal.name, Fact::Duplicate { name });
            }
            if let Some(default) = &formal.default {
                seen_default = true;
                let found = self.value(default, &scope)?;
                self.check_default(formal, default, found)?;
            } else if seen_default {
                return self.refuse(&formal.name, Fact::DefaultBefore { name });
            }
            let value = self.unknown(&formal.kind, others)?;
            scope.bound.push((name, value));
        }
        let place = Joint { docs: definition.docs.clone(), is_drive: false, name: definition.name.clone(), body: JointBody::Equations(Vec::new()) };
        let residuals = self.statements(&definition.statements, scope, &place, &[])?;
        let of = residuals.len();
        for (row, residual) in residuals.iter().enumerate() {
            let depends = self.arena.leaves(residual.expr).iter().any(|leaf| matches!(leaf, Leaf::Coordinate(_)));
            if !depends {
                return self.refuse(&definition.name, Fact::RowOfNothing { joint: definition.name.to_string(), row: row + 1, of });
            }
        }
        Some(())
    }

    fn check_default(&mut self, formal: &crate::syntax::ast::Formal, default: &crate::syntax::ast::Expr, found: Value) -> Option<()> {
        match (&formal.kind, found) {
            (Kind::Scalar(written), Value::Scalar(scalar)) => {
                let wanted = self.dimension(written)?;
                if scalar.measure.fits(wanted) {
                    return Some(());
                }
                self.refuse(default.range, Fact::WrongDimension { wanted, found: scalar.measure.settled() })
            }
            (Kind::Quantity, Value::Scalar(_)) | (Kind::Body, Value::Body(_)) | (Kind::Point, Value::Point(_)) | (Kind::Axis, Value::Axis(_)) => Some(()),
            (_, other) => self.refuse(default.range, Fact::NotA { wanted: "what the parameter takes", found: other.noun() }),
        }
    }

    /// An argument of this kind of which nothing else is known.
    fn unknown(&mut self, kind: &Kind, others: &[Definition]) -> Option<Value> {
        Some(match kind {
            Kind::Point => Value::Point(self.unknown_fixed(Measure::Of(Dim::LENGTH))),
            Kind::Axis => Value::Axis(self.unknown_fixed(Measure::Flexible)),
            Kind::Body => Value::Body(self.new_frame("a body")),
            Kind::Quantity => Value::Scalar(self.unknown_scalar(Measure::Flexible)),
            Kind::Scalar(written) => {
                let dim = self.dimension(written)?;
                Value::Scalar(self.unknown_scalar(Measure::Of(dim)))
            }
            Kind::Function(from, to) => {
                let (from, to) = (self.dimension(from)?, self.dimension(to)?);
                self.functions.push(Numbered::Rust(Default::default()));
                let number = self.functions.len() as u32 - 1;
                Value::Function(Function::Numbered { number, from: Measure::Of(from), to: Measure::Of(to) })
            }
            Kind::Joint(name) => {
                let word = name.to_string();
                let known = others.iter().find(|other| *name == other.name).cloned().map(Rc::new);
                let Some(definition) = known.or_else(|| library::find(&word)) else {
                    return self.refuse(name, Fact::UnknownConstraint { name: word, near: None });
                };
                let mut arguments = Vec::new();
                for formal in &definition.parameters {
                    if !matches!(formal.kind, Kind::Joint(_)) {
                        arguments.push((formal.name.to_string(), self.unknown(&formal.kind, others)?));
                    }
                }
                Value::Joint { kind: word, arguments: Rc::new(arguments) }
            }
        })
    }

    fn unknown_scalar(&mut self, measure: Measure) -> Scalar {
        let number = self.arena.len() as u32;
        Scalar { expr: self.arena.leaf(Leaf::Parameter(number)), measure }
    }

    fn unknown_fixed(&mut self, measure: Measure) -> Fixed {
        let frame = self.new_frame("a body");
        let local = [self.unknown_scalar(measure).expr, self.unknown_scalar(measure).expr];
        Fixed { frame, local, measure }
    }
}

