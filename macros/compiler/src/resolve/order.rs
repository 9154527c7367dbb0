//! Arguments that are missing or in another order than the parameters, and points that no joint has yet.

use super::elaborate::Elaborator;
use crate::diag::{ArityFact, MeantFor};
use crate::hints::point_of;
use crate::names::{Entity, FrameId, Scope, Value, completed, fitted, reordered, signature, too_few};
use crate::quantity::Ambient;
use crate::syntax::ast::{Argument, Definition, Formal, FormalKind, JointBody};
use proc_macro2::Ident;
use std::collections::BTreeSet;

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
        let values = values.filter(|values| !values.iter().any(|value| matches!(value, Value::Joint { .. }))).unwrap_or_default();
        let Some(places) = fitted(&self.arena, definition, &values).filter(|places| !places.is_empty()) else { return Some(()) };
        let is_missing = |(index, formal): &(usize, &Formal)| formal.default.is_none() && !places.contains(index);
        let missing: Vec<&Formal> = definition.parameters.iter().enumerate().filter(is_missing).map(|(_, formal)| formal).collect();
        let written: Vec<(usize, String)> =
            places.iter().zip(given).map(|(place, argument)| (*place, argument.value.to_string())).collect();
        if self.names.ambient == Ambient::Space && missing.iter().all(|formal| matches!(formal.kind, FormalKind::Axis)) {
            return self.have_axes(definition, kind, &written, &values);
        }
        // In order up to the end: the last ones are missing.
        if places.iter().copied().eq(0..places.len()) {
            return Some(());
        }
        let names = missing.iter().map(|formal| formal.name.to_string()).collect();
        let instead = completed(definition, &written, self.names.ambient).map_or(MeantFor::Nothing, MeantFor::Complete);
        self.refuse(kind, too_few(definition, given.len(), names, instead))
    }

    /// Refuses arguments that lack nothing but axes, as those of a joint of the plane do in space, and shows them with axes.
    fn have_axes(&mut self, definition: &Definition, kind: &Ident, given: &[(usize, String)], values: &[Value]) -> Option<()> {
        let (mut written, mut missing, mut without) = (Vec::new(), Vec::new(), Vec::new());
        let mut last: Option<(String, FrameId)> = None;
        for (index, formal) in definition.parameters.iter().enumerate() {
            match given.iter().position(|(place, _)| *place == index) {
                Some(number) => {
                    written.push(given[number].1.clone());
                    if let Value::Point(point) = &values[number] {
                        last = written.last().and_then(|text| text.rsplit_once('.')).map(|(owner, _)| (owner.to_owned(), point.frame));
                    }
                }
                None if formal.default.is_some() => {}
                None => {
                    let Some((owner, frame)) = &last else { return Some(()) };
                    if self.names.an_axis_of(*frame).is_none() && !without.contains(owner) {
                        without.push(owner.clone());
                    }
                    written.push(format!("{owner}.{}", self.names.an_axis_of(*frame).unwrap_or("z")));
                    missing.push(formal.name.to_string());
                }
            }
        }
        let (definition, signature) = (definition.name.to_string(), signature(definition));
        let instead = format!("{definition}({})", written.join(", "));
        self.refuse(kind, ArityFact::MissingAxes { definition, signature, missing, instead, without })
    }

    /// The first point of a body that no joint is written with; else its first point, or its origin.
    pub(super) fn free_point_of(&self, frame: FrameId) -> String {
        let body = &self.names.frames[frame.0].name;
        let mut used = BTreeSet::new();
        for declared in &self.names.declared {
            let Entity::Joint(joint) = &declared.entity else { continue };
            let JointBody::Of { arguments, .. } = &joint.body else { continue };
            used.extend(arguments.iter().filter_map(|argument| point_of(&argument.value, body)));
        }
        let points: Vec<&str> = self.names.points_of(frame).collect();
        let free = points.iter().find(|point| !used.contains(**point));
        free.or(points.first()).map_or("position".to_owned(), |point| (*point).to_owned())
    }
}
