//! What a definition takes, in words.

use crate::diag::nearest;
use crate::diag::{ArityFact, Range};
use crate::syntax::ast::{Argument, Definition, Dimension, Formal, Kind};
use proc_macro2::Ident;

/// `revolute(P: Point, Q: Point)`
fn signature(definition: &Definition) -> String {
    let parameter = |formal: &Formal| {
        let optional = if formal.default.is_some() { " = …" } else { "" };
        format!("{}: {}{optional}", formal.name, kind_name(&formal.kind))
    };
    let parameters: Vec<String> = definition.parameters.iter().map(parameter).collect();
    format!("{}({})", definition.name, parameters.join(", "))
}

fn kind_name(kind: &Kind) -> String {
    match kind {
        Kind::Point => "Point".into(),
        Kind::Axis => "Axis".into(),
        Kind::Body => "Body".into(),
        Kind::Quantity => "Quantity".into(),
        Kind::Function(from, to) => format!("Function({}) -> {}", dimension_name(from), dimension_name(to)),
        Kind::Joint(kind) => format!("Joint({kind})"),
        Kind::Scalar(dimension) => dimension_name(dimension),
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

pub(super) fn noun(kind: &Kind) -> String {
    match kind {
        Kind::Point => "a point".into(),
        Kind::Axis => "an axis".into(),
        Kind::Body => "a body".into(),
        Kind::Quantity => "a number".into(),
        Kind::Function(..) => "a function of one variable".into(),
        Kind::Joint(kind) => format!("a `{kind}` joint"),
        Kind::Scalar(dimension) => format!("a number ({})", dimension_name(dimension)),
    }
}

/// Where the argument for each parameter was written.
pub(super) fn places(definition: &Definition, given: &[Argument]) -> Vec<(String, Range)> {
    let place = |(position, argument): (usize, &Argument)| {
        let name = argument.name.as_ref().or(definition.parameters.get(position).map(|formal| &formal.name))?;
        Some((name.to_string(), argument.value.range))
    };
    given.iter().enumerate().filter_map(place).collect()
}

/// How many arguments a definition takes, at least and at most.
fn takes(definition: &Definition) -> [usize; 2] {
    let required = definition.parameters.iter().filter(|formal| formal.default.is_none()).count();
    [required, definition.parameters.len()]
}

pub(super) fn too_many(definition: &Definition, found: usize) -> ArityFact {
    ArityFact::TooManyArguments {
        definition: definition.name.to_string(),
        signature: signature(definition),
        takes: takes(definition),
        found,
    }
}

pub(super) fn too_few(definition: &Definition, found: usize, missing: Vec<String>) -> ArityFact {
    let (name, signature) = (definition.name.to_string(), signature(definition));
    ArityFact::MissingArguments { definition: name, signature, takes: takes(definition), found, missing }
}

pub(super) fn unknown_argument(definition: &Definition, name: &Ident) -> ArityFact {
    let names: Vec<String> = definition.parameters.iter().map(|formal| formal.name.to_string()).collect();
    let near = nearest(&name.to_string(), names.iter().map(String::as_str));
    ArityFact::UnknownArgument { definition: definition.name.to_string(), name: name.to_string(), signature: signature(definition), near }
}
