//! Checks a definition where it is written, with arguments of which only the kind is known.

use super::Function as Numbered;
use super::elaborate::Elaborator;
use super::statement::ScalarEquation;
use super::{Components, Name};
use crate::diag::{ArityFact, Diag, EquationFact, Known, NameFact, ValueFact};
use crate::expr::{Expr, Leaf};
use crate::library;
use crate::names::{Fixed, FunctionValue, Names, RESERVED, Scalar, Scope, UNKNOWN_BODY, Value, wanted};
use crate::quantity::{Dim, InferredDim};
use crate::syntax::ast::{Definition, Dimension, FormalKind};
use crate::words::nearest;
use std::rc::Rc;

/// Kinds of parameters other than dimensions.
const KINDS: &[&str] = &["Point", "Axis", "Body", "Quantity", "Function", "Joint"];

/// Reports the errors in a definition, which may use the definitions in `others` as kinds of joints.
pub(crate) fn check(definition: &Definition, others: &[Definition], diag: &mut Diag) {
    let mut work = Elaborator::new(diag, Names::abstract_(definition.ambient.unwrap_or_default()));
    work.check(definition, others);
}

impl Elaborator<'_> {
    fn check(&mut self, definition: &Definition, others: &[Definition]) -> Option<()> {
        let scope = self.formals(definition, others)?;
        let place = Name::plain(&definition.name);
        self.applied = definition.is_force.then(Vec::new);
        let rows = self.statements(&definition.statements, scope, &place, &[])?;
        let of = rows.len();
        for (row, ScalarEquation { residual, range }) in rows.into_iter().enumerate() {
            let depends = self.arena.leaves(residual.expr).iter().any(|leaf| matches!(leaf, Leaf::Coordinate(_) | Leaf::Speed(_)));
            if !depends {
                return self.refuse(
                    range,
                    EquationFact::RowOfNothing { joint: definition.name.to_string(), row: row + 1, of, at_defaults: false },
                );
            }
        }
        Some(())
    }

    /// Binds every parameter to an unknown value of its kind.
    fn formals(&mut self, definition: &Definition, others: &[Definition]) -> Option<Scope> {
        let mut scope = Scope::default();
        let mut seen_default = false;
        for formal in &definition.parameters {
            let name = formal.name.to_string();
            if RESERVED.contains(&name.as_str()) {
                return self.refuse(&formal.name, NameFact::Reserved { name });
            }
            if scope.bound.iter().any(|(known, _)| *known == name) {
                return self.refuse(&formal.name, NameFact::Duplicate { name, first: "another parameter" });
            }
            let value = self.unknown(&formal.kind, others)?;
            if let Some(default) = &formal.default {
                seen_default = true;
                let found = self.value(default, &scope)?;
                self.check_default(formal, default, found)?;
            } else if seen_default {
                return self.refuse(&formal.name, ArityFact::DefaultBefore { name });
            }
            scope.bound.push((name, value));
        }
        Some(scope)
    }

    /// Checks the names and the kinds of the parameters of a component.
    pub(super) fn head_is_sound(&mut self, head: &Definition) -> Option<()> {
        for (number, formal) in head.parameters.iter().enumerate() {
            let (name, before) = (formal.name.to_string(), &head.parameters[..number]);
            if before.iter().any(|known| known.name == formal.name) {
                return self.refuse(&formal.name, NameFact::Duplicate { name, first: "another parameter" });
            }
            if formal.default.is_none() && before.iter().any(|known| known.default.is_some()) {
                return self.refuse(&formal.name, ArityFact::DefaultBefore { name });
            }
            match &formal.kind {
                FormalKind::Scalar(written) => drop(self.kind_dimension(written)?),
                FormalKind::Joint(kind) => drop(self.definition(kind)?),
                FormalKind::Function(from, to) => drop((self.dimension(from)?, self.dimension(to)?)),
                FormalKind::Point | FormalKind::Axis | FormalKind::Body | FormalKind::Quantity => {}
            }
        }
        Some(())
    }

    fn check_default(&mut self, formal: &crate::syntax::ast::Formal, default: &crate::syntax::ast::Expression, found: Value) -> Option<()> {
        match (&formal.kind, found) {
            (FormalKind::Scalar(written), Value::Scalar(scalar)) => {
                let wanted = self.dimension(written)?;
                if scalar.measure.fits(wanted) {
                    return Some(());
                }
                self.refuse(default.range, ValueFact::WrongDimension { wanted, found: scalar.measure.settled() })
            }
            (FormalKind::Quantity, Value::Scalar(_))
            | (FormalKind::Body, Value::Body(_))
            | (FormalKind::Point, Value::Point(_))
            | (FormalKind::Axis, Value::Axis(_)) => Some(()),
            (kind, other) => self.refuse(default.range, ValueFact::WrongDefault { wanted: wanted(kind), found: other.kind() }),
        }
    }

    /// An unknown argument of the given kind.
    pub(super) fn unknown(&mut self, kind: &FormalKind, others: &[Definition]) -> Option<Value> {
        Some(match kind {
            FormalKind::Point => Value::Point(self.unknown_fixed(InferredDim::Known(Dim::LENGTH))),
            FormalKind::Axis => Value::Axis(self.unknown_fixed(InferredDim::Any)),
            FormalKind::Body => Value::Body(self.new_frame(UNKNOWN_BODY)),
            FormalKind::Quantity => Value::Scalar(self.unknown_scalar(InferredDim::Any)),
            FormalKind::Scalar(written) => {
                let dim = self.kind_dimension(written)?;
                Value::Scalar(self.unknown_scalar(InferredDim::Known(dim)))
            }
            FormalKind::Function(from, to) => {
                let (from, to) = (self.dimension(from)?, self.dimension(to)?);
                self.functions.push(Numbered::Rust(Default::default()));
                let number = self.functions.len() as u32 - 1;
                Value::Function(FunctionValue::Numbered { number, from: InferredDim::Known(from), to: InferredDim::Known(to) })
            }
            FormalKind::Joint(name) => {
                let word = name.to_string();
                let known = others.iter().find(|other| *name == other.name).cloned().map(Rc::new);
                let Some(definition) = known.or_else(|| library::find(&word, self.names.ambient)) else {
                    let own: Vec<String> = others.iter().map(|other| other.name.to_string()).collect();
                    let near = nearest(&word, own.iter().map(String::as_str).chain(library::constraints(self.names.ambient)));
                    return self.refuse(
                        name,
                        NameFact::UnknownConstraint {
                            name: word,
                            near,
                            is_force: false,
                            home: None,
                            known: Known::of(library::constraints(self.names.ambient)),
                        },
                    );
                };
                let mut arguments = Vec::new();
                for formal in &definition.parameters {
                    if !matches!(formal.kind, FormalKind::Joint(_)) {
                        arguments.push((formal.name.to_string(), self.unknown(&formal.kind, others)?));
                    }
                }
                Value::Joint { kind: word, arguments: Rc::new(arguments) }
            }
        })
    }

    /// Resolves a dimension. A single unknown word may be a mistyped kind.
    fn kind_dimension(&mut self, written: &Dimension) -> Option<Dim> {
        if let [(word, 1)] = written.factors.as_slice()
            && Dim::named(&word.to_string()).is_none()
        {
            let name = word.to_string();
            let near = nearest(&name, KINDS.iter().copied().chain(Dim::names()));
            return self.refuse(word, NameFact::UnknownKind { name, near });
        }
        self.dimension(written)
    }

    fn unknown_scalar(&mut self, measure: InferredDim) -> Scalar {
        let number = self.arena.len() as u32;
        Scalar { expr: self.arena.leaf(Leaf::Parameter(number)), measure }
    }

    fn unknown_fixed(&mut self, measure: InferredDim) -> Fixed {
        let frame = self.new_frame(UNKNOWN_BODY);
        let parts: Vec<Expr> = (0..self.names.ambient.components()).map(|_| self.unknown_scalar(measure).expr).collect();
        let local = Components::new(&parts).unwrap_or(Components::plane(parts[0], parts[0]));
        Fixed { frame, local, measure, zero: None }
    }
}
