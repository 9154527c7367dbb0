//! Declared ranges of parameters and of time.

use super::elaborate::Elaborator;
use super::{Bounds, Parameter, Times};
use crate::diag::ValueFact;
use crate::expr::Expr;
use crate::hints::in_words;
use crate::names::{Register, Scope};
use crate::quantity::Dim;
use crate::syntax::ast::{self, Limits};

impl Elaborator<'_> {
    /// Evaluates the declared bounds of a parameter. Reports bounds that are not constant, and empty ranges.
    pub(super) fn bounds(&mut self, limits: &Limits, dim: Dim, scope: &Scope) -> Option<Bounds> {
        let scope = &scope.clone().timeless("the bound of a parameter");
        let (from, to) = (self.bound(limits.from.as_ref(), dim, scope), self.bound(limits.to.as_ref(), dim, scope));
        let (from, to) = (from?, to?);
        let dots = if limits.is_inclusive { "..=" } else { ".." };
        let end = |written: &Option<ast::Expression>, value: Option<f64>| {
            written.as_ref().zip(value).map_or(String::new(), |(written, value)| in_words(written, value, dim))
        };
        let text = format!("{} {dots} {}", end(&limits.from, from), end(&limits.to, to)).trim().to_owned();
        let bounds = Bounds { from, to, is_inclusive: limits.is_inclusive, text };
        if let (Some(from), Some(to)) = (from, to)
            && (from > to || from == to && !limits.is_inclusive)
        {
            return self.refuse(limits.range, ValueFact::EmptyBounds { bounds: bounds.text, is_point: from == to });
        }
        Some(bounds)
    }

    /// Evaluates the declared range of time. Reports an empty range.
    pub(super) fn times(&mut self, register: &Register, parameters: &[Parameter]) -> Option<Times> {
        let limits = register.range.as_ref()?.limits.clone();
        let place = "the end of a range of time";
        let scope = Scope::mechanism().timeless(place);
        let defaults: Vec<Expr> = parameters.iter().map(|parameter| parameter.default).collect();
        let defaults = self.numbers(&[], &defaults);
        let mut end = |written: &ast::Expression| {
            let expr = self.scalar_of(written, Dim::TIME, &scope)?.expr;
            if !self.arena.is_fixed(expr) {
                return self.refuse(written.range, ValueFact::NotFixed { place });
            }
            let value = self.numbers(&defaults, &[expr])[0];
            if value.is_finite() { Some(value) } else { self.refuse(written.range, ValueFact::NotFinite { place }) }
        };
        let (from, to) = (end(limits.from.as_ref()?), end(limits.to.as_ref()?));
        let (from, to) = (from?, to?);
        if from >= to {
            let bounds = format!("{from} s .. {to} s");
            return self.refuse(limits.range, ValueFact::EmptyBounds { bounds, is_point: false });
        }
        Some(Times { from, to })
    }

    /// Evaluates one bound; `Some(None)` if it is not written.
    fn bound(&mut self, written: Option<&ast::Expression>, dim: Dim, scope: &Scope) -> Option<Option<f64>> {
        let Some(written) = written else { return Some(None) };
        let expr = self.scalar_of(written, dim, scope)?.expr;
        if !self.arena.leaves(expr).is_empty() {
            let help = "what depends on other parameters is a `require` in a constraint";
            return self.refuse(written.range, ValueFact::NotConstant { place: "the bound of a parameter", help });
        }
        let value = self.numbers(&[], &[expr])[0];
        if self.is_finite(expr, &[]) { Some(Some(value)) } else { self.refuse(written.range, ValueFact::NotFinite { place: "the bound" }) }
    }
}
