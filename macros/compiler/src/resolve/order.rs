//! Arguments in another order than the parameters, and points that no joint has yet.

use super::elaborate::Elaborator;
use crate::diag::ArityFact;
use crate::hints::point_of;
use crate::names::{Entity, FrameId, Scope, Value, signature};
use crate::quantity::{Ambient, Dim, InferredDim};
use crate::syntax::ast::{Argument, Definition, FormalKind, JointBody};
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
        // All of them have a value: otherwise something else was refused.
        let values: Option<Vec<Value>> = given.iter().map(|argument| self.value(&argument.value, scope)).collect();
        let mut open: Vec<(&Argument, Value)> = given.iter().zip(values?).collect();
        let mut ordered = Vec::new();
        for formal in &definition.parameters[..given.len()] {
            let place = open.iter().position(|(_, value)| self.fits(&formal.kind, value))?;
            ordered.push(open.remove(place).0.value.to_string());
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
            match open.next_if(|(_, value)| self.fits(&formal.kind, value)) {
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

    /// True if a value can be an argument for a parameter of this kind.
    fn fits(&mut self, kind: &FormalKind, value: &Value) -> bool {
        let is_of = |measure: InferredDim, is_length: bool| measure == InferredDim::Any || measure.fits(Dim::LENGTH) == is_length;
        match (kind, value) {
            (FormalKind::Point, Value::Point(_)) | (FormalKind::Axis, Value::Axis(_)) | (FormalKind::Body, Value::Body(_)) => true,
            (FormalKind::Point | FormalKind::Axis, Value::Vector(vector)) => {
                let is_point = matches!(kind, FormalKind::Point);
                vector.parts.iter().all(|part| self.is_fixed(*part)) && is_of(vector.measure, is_point)
            }
            (FormalKind::Quantity, Value::Scalar(_)) | (FormalKind::Function(..), Value::Function(_)) => true,
            (FormalKind::Scalar(written), Value::Scalar(scalar)) => written.dim().is_some_and(|dim| scalar.measure.fits(dim)),
            (FormalKind::Scalar(_), Value::Joint { .. }) => true,
            (FormalKind::Joint(wanted), Value::Joint { kind, .. }) => wanted == kind,
            _ => false,
        }
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
