//! Freedoms: quantities that follow from forces.
//!
//! ```text
//! freedom a = e from e₀ at ė₀      of positions:   e − e₀ − ė₀ t at t = 0
//! freedom w = e from e₀            of speeds:      e − e₀
//! ```

use super::elaborate::Elaborator;
use super::statement::ScalarEquation;
use crate::diag::{EquationFact, Kind, MotionFact, ValueFact, Wanted};
use crate::expr::{Expr, Leaf};
use crate::hints::orientation_of;
use crate::names::{Scalar, Scope, Value};
use crate::quantity::{Dim, InferredDim};
use crate::syntax::ast;
use proc_macro2::Ident;

impl Elaborator<'_> {
    /// The equations of a freedom, which hold at t = 0 only. Without `from` its value at the declared start is still to be subtracted.
    pub(super) fn freedom(&mut self, name: &Ident, freedom: &ast::FreedomItem, scope: &Scope) -> Option<Vec<ScalarEquation>> {
        let range = freedom.value.range;
        self.is_no_joint(name, freedom, scope)?;
        if let Some(body) = orientation_of(&freedom.value) {
            return self.refuse(range, MotionFact::FreedomOfOrientation { name: name.to_string(), body });
        }
        let parts = self.quantities(&freedom.value, scope)?;
        let measure = parts.first()?.measure;
        if parts.iter().all(|part| self.arena.is_fixed(part.expr)) {
            let (value, coordinate) = (freedom.value.to_string(), self.names.a_coordinate());
            return self.refuse(range, MotionFact::FreedomOfNothing { name: name.to_string(), value, coordinate });
        }
        let timeless = scope.clone().timeless("the initial value of a freedom");
        let per_time = measure.per(InferredDim::Known(Dim::TIME));
        if let Some(from) = freedom.from.as_ref().filter(|_| freedom.at.is_none()) {
            let rate = from.to_string();
            self.measures_another(from, [measure, per_time], MotionFact::RateForStart { rate }, &timeless)?;
        }
        if let Some(at) = freedom.at.as_ref().filter(|_| freedom.from.is_none()) {
            let start = at.to_string();
            self.measures_another(at, [per_time, measure], MotionFact::StartForRate { start }, &timeless)?;
        }
        let from = self.initial(freedom.from.as_ref(), &parts, measure, &timeless)?;
        let at = self.initial(freedom.at.as_ref(), &parts, per_time, &timeless)?;
        if let (true, Some(at)) = (parts.iter().any(|part| self.has_speeds(part.expr)), &freedom.at) {
            return self.refuse(at.range, EquationFact::RateOfSpeed);
        }
        let time = self.arena.leaf(Leaf::Time);
        let equations = parts.into_iter().zip(from.into_iter().zip(at)).map(|(Scalar { expr, measure }, (from, at))| {
            let way = self.arena.mul(at, time);
            let rest = self.arena.sub(expr, from);
            ScalarEquation { residual: Scalar { expr: self.arena.sub(rest, way), measure }, range }
        });
        Some(equations.collect())
    }

    /// The numbers of a number, a vector or a joint that has one coordinate.
    fn quantities(&mut self, written: &ast::Expression, scope: &Scope) -> Option<Vec<Scalar>> {
        let value = self.value(written, scope)?;
        if let Value::Scalar(scalar) = value {
            return Some(vec![scalar]);
        }
        let vector = self.vector_of(written.range, value, Wanted::NumberOrVector)?;
        Some(vector.parts.iter().map(|expr| Scalar { expr: *expr, measure: vector.measure }).collect())
    }

    /// Refuses an initial value with the dimension of a rate, and a rate with that of a value.
    fn measures_another(
        &mut self,
        written: &ast::Expression,
        [wanted, other]: [InferredDim; 2],
        fact: MotionFact,
        scope: &Scope,
    ) -> Option<()> {
        let found = self.quantities(written, scope)?.first()?.measure;
        let fits = |measure: InferredDim| found.common(measure).is_some();
        if fits(other) && !fits(wanted) { self.refuse(written.range, fact) } else { Some(()) }
    }

    /// Initial values, zero if none are written.
    fn initial(&mut self, written: Option<&ast::Expression>, of: &[Scalar], measure: InferredDim, scope: &Scope) -> Option<Vec<Expr>> {
        let Some(written) = written else { return Some(vec![self.arena.integer(0); of.len()]) };
        let (found, wanted) = (self.quantities(written, scope)?, measure.settled());
        // Angles are doubted where they are written.
        if wanted != Dim::ANGLE {
            self.bare.note(written, wanted);
        }
        if found.len() != of.len() {
            let (wanted, found) = if of.len() == 1 { (Wanted::Number, Kind::Vector) } else { (Wanted::Vector, Kind::Number) };
            return self.not_a(written.range, wanted, found);
        }
        let values = found.into_iter().map(|value| {
            if value.measure.common(measure).is_none() {
                let (wanted, found) = (measure.settled(), value.measure.settled());
                return self.refuse(written.range, ValueFact::WrongDimension { wanted, found });
            }
            if !self.arena.is_fixed(value.expr) {
                return self.refuse(written.range, ValueFact::NotFixed { place: "the initial value of a freedom" });
            }
            Some(value.expr)
        });
        values.collect()
    }
}
