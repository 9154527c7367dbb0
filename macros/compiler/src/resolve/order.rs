//! Arguments in another order than the parameters, and points that no joint has yet.

use super::elaborate::Elaborator;
use crate::diag::ArityFact;
use crate::hints::point_of;
use crate::names::{Entity, FrameId, Scope, Value, fits, signature};
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
        let mut open: Vec<(&Argument, Value)> = given.iter().zip(values?).collect();
        // What is written out is of ground.
        let frame = |value: &Value| value.frame().unwrap_or(FrameId::GROUND);
        let (mut ordered, mut last_frame) = (Vec::new(), FrameId::GROUND);
        for (index, formal) in definition.parameters[..given.len()].iter().enumerate() {
            // A point and the axis after it belong to one body.
            let is_axis = |formal: &Formal| matches!(formal.kind, FormalKind::Axis);
            let has_axis = definition.parameters.get(index + 1).is_some_and(is_axis);
            let axes = open.iter().filter(|(_, value)| fits(&self.arena, &FormalKind::Axis, value));
            let axes: Vec<FrameId> = axes.map(|(_, value)| frame(value)).collect();
            let is_beside = |own: FrameId| if is_axis(formal) { own == last_frame } else { has_axis && axes.contains(&own) };
            let fitting: Vec<usize> = (0..open.len()).filter(|place| fits(&self.arena, &formal.kind, &open[*place].1)).collect();
            let place = *fitting.iter().find(|place| is_beside(frame(&open[**place].1))).or(fitting.first())?;
            let (argument, value) = open.remove(place);
            ordered.push(argument.value.to_string());
            last_frame = frame(&value);
        }
        let name = definition.name.to_string();
        let instead = format!("{name}({})", ordered.join(", "));
        self.diag.withdraw(before);
        self.refuse(first.value.range.to(last.value.range), ArityFact::OtherOrder { name, instead, signature: signature(definition) })
    }

    /// Refuses arguments that lack nothing but axes, as those of a joint of the plane do in space, and shows them with axes.
    pub(super) fn has_its_axes(&mut self, definition: &Definition, kind: &Ident, given: &[Argument], scope: &Scope) -> Option<()> {
        let needed = definition.parameters.iter().filter(|formal| formal.default.is_none());
        let is_short = given.len() < needed.count() && given.iter().all(|argument| argument.name.is_none());
        if self.names.ambient != Ambient::Space || !is_short {
            return Some(());
        }
        let before = self.diag.refusals().len();
        let values: Option<Vec<Value>> = given.iter().map(|argument| self.value(&argument.value, scope)).collect();
        self.diag.withdraw(before);
        let mut open = given.iter().zip(values.unwrap_or_default()).peekable();
        let (mut written, mut missing, mut without) = (Vec::new(), Vec::new(), Vec::new());
        let mut last: Option<(String, FrameId)> = None;
        for formal in &definition.parameters {
            match open.next_if(|(_, value)| fits(&self.arena, &formal.kind, value)) {
                Some((argument, value)) => {
                    written.push(argument.value.to_string());
                    if let Value::Point(point) = value {
                        last = written.last().and_then(|text| text.rsplit_once('.')).map(|(owner, _)| (owner.to_owned(), point.frame));
                    }
                }
                None if matches!(formal.kind, FormalKind::Axis) => {
                    let Some((owner, frame)) = &last else { return Some(()) };
                    if self.names.an_axis_of(*frame).is_none() && !without.contains(owner) {
                        without.push(owner.clone());
                    }
                    written.push(format!("{owner}.{}", self.names.an_axis_of(*frame).unwrap_or("z")));
                    missing.push(formal.name.to_string());
                }
                None if formal.default.is_some() => {}
                None => return Some(()),
            }
        }
        if missing.is_empty() || open.next().is_some() {
            return Some(());
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
