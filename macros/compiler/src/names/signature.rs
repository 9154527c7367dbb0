//! Signatures of definitions, for messages.

use super::value::Value;
use crate::diag::{ArityFact, MeantFor, Range, Wanted};
use crate::expr::{Arena, Expr};
use crate::quantity::{Dim, InferredDim};
use crate::syntax::ast::{Argument, Definition, Dimension, Formal, FormalKind};
use crate::words::nearest;
use proc_macro2::Ident;

/// `revolute(P: Point, Q: Point)`
pub(crate) fn signature(definition: &Definition) -> String {
    let parameter = |formal: &Formal| {
        let optional = if formal.default.is_some() { " = …" } else { "" };
        format!("{}: {}{optional}", formal.name, kind_name(&formal.kind))
    };
    let parameters: Vec<String> = definition.parameters.iter().map(parameter).collect();
    format!("{}({})", definition.name, parameters.join(", "))
}

fn kind_name(kind: &FormalKind) -> String {
    match kind {
        FormalKind::Point => "Point".into(),
        FormalKind::Axis => "Axis".into(),
        FormalKind::Body => "Body".into(),
        FormalKind::Quantity => "Quantity".into(),
        FormalKind::Function(from, to) => format!("Function({}) -> {}", dimension_name(from), dimension_name(to)),
        FormalKind::Joint(kind) => format!("Joint({kind})"),
        FormalKind::Scalar(dimension) => dimension_name(dimension),
    }
}

fn dimension_name(dimension: &Dimension) -> String {
    let mut text = String::new();
    for (position, (name, exponent)) in dimension.factors.iter().enumerate() {
        let separator = match (position, *exponent > 0) {
            (0, _) => "",
            (_, true) => " * ",
            (_, false) => " / ",
        };
        let power = if exponent.abs() == 1 { String::new() } else { format!("^{}", exponent.abs()) };
        text += &format!("{separator}{name}{power}");
    }
    text
}

/// Kind of value that a parameter takes.
pub(crate) fn wanted(kind: &FormalKind) -> Wanted {
    match kind {
        FormalKind::Point => Wanted::Point,
        FormalKind::Axis => Wanted::Axis,
        FormalKind::Body => Wanted::Body,
        FormalKind::Quantity => Wanted::Number,
        FormalKind::Function(from, to) => Wanted::FunctionOfOne([from, to].map(dimension_name)),
        FormalKind::Joint(kind) => Wanted::JointOf(kind.to_string()),
        FormalKind::Scalar(dimension) => Wanted::Quantity(dimension_name(dimension)),
    }
}

/// Source range of the argument for each parameter.
pub(crate) fn places(definition: &Definition, given: &[Argument]) -> Vec<(String, Range)> {
    let place = |(position, argument): (usize, &Argument)| {
        let name = argument.name.as_ref().or(definition.parameters.get(position).map(|formal| &formal.name))?;
        Some((name.to_string(), argument.value.range))
    };
    given.iter().enumerate().filter_map(place).collect()
}

/// Smallest and largest number of arguments.
fn takes(definition: &Definition) -> [usize; 2] {
    let required = definition.parameters.iter().filter(|formal| formal.default.is_none()).count();
    [required, definition.parameters.len()]
}

pub(crate) fn too_many(definition: &Definition, found: usize, decimals: Option<String>) -> ArityFact {
    ArityFact::TooManyArguments {
        decimals,
        definition: definition.name.to_string(),
        signature: signature(definition),
        takes: takes(definition),
        found,
    }
}

pub(crate) fn too_few(definition: &Definition, found: usize, missing: Vec<String>, meant: MeantFor) -> ArityFact {
    let (name, signature) = (definition.name.to_string(), signature(definition));
    ArityFact::MissingArguments { definition: name, signature, takes: takes(definition), found, missing, meant }
}

pub(crate) fn unknown_argument(definition: &Definition, name: &Ident) -> ArityFact {
    let names: Vec<String> = definition.parameters.iter().map(|formal| formal.name.to_string()).collect();
    let near = nearest(&name.to_string(), names.iter().map(String::as_str));
    ArityFact::UnknownArgument { definition: definition.name.to_string(), name: name.to_string(), signature: signature(definition), near }
}

/// True for what acts between two bodies, or in space between two axes: a hinge may be named in their place.
pub(crate) fn is_between(definition: &Definition) -> bool {
    let kinds: Vec<&FormalKind> = definition.parameters.iter().take(2).map(|formal| &formal.kind).collect();
    matches!(kinds.as_slice(), [FormalKind::Body, FormalKind::Body] | [FormalKind::Axis, FormalKind::Axis])
}

/// True if a value can be an argument for a parameter of this kind.
pub(crate) fn fits(arena: &Arena, kind: &FormalKind, value: &Value) -> bool {
    let is_of = |measure: InferredDim, is_length: bool| measure == InferredDim::Any || measure.fits(Dim::LENGTH) == is_length;
    let is_fixed = |part: &Expr| arena.is_fixed(*part);
    match (kind, value) {
        (FormalKind::Point, Value::Point(_)) | (FormalKind::Axis, Value::Axis(_)) | (FormalKind::Body, Value::Body(_)) => true,
        (FormalKind::Point | FormalKind::Axis, Value::Vector(vector)) => {
            vector.parts.iter().all(is_fixed) && is_of(vector.measure, matches!(kind, FormalKind::Point))
        }
        (FormalKind::Quantity, Value::Scalar(_)) | (FormalKind::Function(..), Value::Function(_)) => true,
        (FormalKind::Scalar(written), Value::Scalar(scalar)) => written.dim().is_some_and(|dim| scalar.measure.fits(dim)),
        (FormalKind::Scalar(_), Value::Joint { .. }) => true,
        (FormalKind::Joint(wanted), Value::Joint { kind, .. }) => wanted == kind,
        _ => false,
    }
}
