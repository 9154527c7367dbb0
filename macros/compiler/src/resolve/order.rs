//! Arguments that are missing or in another order than the parameters.

use super::elaborate::Elaborator;
use crate::diag::{ArityFact, MeantFor};
use crate::names::{Scope, Value, as_written, completed, fitted, reordered, signature, too_few};
use crate::quantity::Ambient;
use crate::syntax::ast::{Argument, Definition, Formal, FormalKind};
use proc_macro2::Ident;

impl Elaborator<'_> {
    /// If arguments were refused since there were `before` refusals, and all of them fit in another order, shows that order instead.
    pub(super) fn are_in_order(&mut self, definition: &Definition, given: &[Argument], before: usize, scope: &Scope) -> Option<()> {
        let (first, last) = (given.first()?, given.last()?);
        let refused = &self.diag.refusals()[before..];
        if given.iter().any(|argument| argument.name.is_some()) || !refused.iter().all(|refusal| refusal.fact.is_about_an_argument()) {
            return None;
        }
        // What else is wrong with an argument that was refused is not said.
        let known = self.diag.refusals().len();
        let values: Option<Vec<Value>> = given.iter().map(|argument| self.value(&argument.value, scope)).collect();
        self.diag.withdraw(known);
        let ordered = reordered(&self.arena, definition, given, values?)?;
        let name = definition.name.to_string();
        let instead = format!("{name}({})", ordered.join(", "));
        self.diag.withdraw(before);
        self.refuse(first.value.range.to(last.value.range), ArityFact::OtherOrder { name, instead, signature: signature(definition) })
    }

    /// Refuses arguments that fit in order but for some between them, which are missing, and shows them completed.
    pub(super) fn lack_none_between(&mut self, definition: &Definition, kind: &Ident, given: &[Argument], scope: &Scope) -> Option<()> {
        let needed = definition.parameters.iter().filter(|formal| formal.default.is_none());
        if given.len() >= needed.count() || given.iter().any(|argument| argument.name.is_some()) {
            return Some(());
        }
        let before = self.diag.refusals().len();
        let values: Option<Vec<Value>> = given.iter().map(|argument| self.value(&argument.value, scope)).collect();
        self.diag.withdraw(before);
        let values = values.unwrap_or_default();
        if let Some(fact) = self.names.with_ends(&self.arena, definition, given, &values) {
            return self.refuse(kind, fact);
        }
        let values = if values.iter().any(|value| matches!(value, Value::Joint { .. })) { Vec::new() } else { values };
        let Some(places) = fitted(&self.arena, definition, &values).filter(|places| !places.is_empty()) else { return Some(()) };
        let is_missing = |(index, formal): &(usize, &Formal)| formal.default.is_none() && !places.contains(index);
        let missing: Vec<&Formal> = definition.parameters.iter().enumerate().filter(is_missing).map(|(_, formal)| formal).collect();
        let written = as_written(definition, &places, given, &values);
        let are_axes = missing.iter().all(|formal| matches!(formal.kind, FormalKind::Axis));
        let are_points = missing.iter().all(|formal| matches!(formal.kind, FormalKind::Point)) && matches!(values[0], Value::Axis(_));
        if self.names.ambient == Ambient::Space && (are_axes || are_points) {
            let fact = self.names.with_marks(definition, &written, &values);
            return fact.map_or(Some(()), |fact| self.refuse(kind, fact));
        }
        // In order up to the end: the last ones are missing.
        let is_as_given =
            places.iter().copied().eq(0..places.len()) && written.iter().zip(given).all(|((_, text), one)| *text == one.value.to_string());
        if is_as_given && !missing.iter().all(|formal| matches!(formal.kind, FormalKind::Point)) {
            return Some(());
        }
        let names = missing.iter().map(|formal| formal.name.to_string()).collect();
        let instead = completed(&self.names, definition, &written).map_or(MeantFor::Nothing, MeantFor::Complete);
        self.refuse(kind, too_few(definition, given.len(), names, instead))
    }
}
