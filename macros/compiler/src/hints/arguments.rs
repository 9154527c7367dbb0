//! Warnings about arguments of joints and forces that are often meant otherwise: a carrier as a ring gear, a third number of teeth, a pressure
//! angle, a percentage of friction, negative stiffnesses and lengths.

use crate::diag::{Doubt, Warning};
use crate::quantity::{self, Dim};
use crate::syntax::ast::{Argument, Expression, ExpressionKind, Item, JointBody, Operator, every_item};

/// Coefficients of friction from here on were rather meant in per cent.
const SLIPPERY: f64 = 3.0;

/// Warnings about the arguments of an item.
pub(super) fn doubtful_arguments(item: &Item) -> Vec<Warning> {
    let mut found = negative_coefficients(item);
    found.extend(swapped_carrier(item));
    found.extend(number_as_phase(item));
    found.extend(percentage_of_friction(item));
    found.extend(negative_distance(item));
    found
}

/// Doubts a number in the place of the angle in which gears mesh: they have teeth or radii, and no pressure angle.
fn number_as_phase(item: &Item) -> Option<Warning> {
    let Item::Joint(joint) = item else { return None };
    let JointBody::Of { kind, arguments } = &joint.body else { return None };
    let bodies = if kind == "planetary" { 3 } else { 2 };
    if !["planetary", "gear_pair"].iter().any(|known| kind == known) {
        return None;
    }
    let phase = arguments.get(bodies + 2).filter(|_| arguments.iter().all(|argument| argument.name.is_none()))?;
    let ExpressionKind::Number { digits, unit } = &phase.value.kind else { return None };
    let is_pressure_angle = kind == "gear_pair" && ["20", "25", "14.5"].contains(&digits.as_str());
    if digits.parse() == Ok(0.0) || !(unit.is_empty() || unit == "deg" && is_pressure_angle) {
        return None;
    }
    let doubt = Doubt::NumberAsPhase { written: phase.value.to_string(), gears: kind.to_string() };
    Some(Warning { doubt, range: phase.value.range })
}

/// Doubts a coefficient of friction that is a percentage.
fn percentage_of_friction(item: &Item) -> Option<Warning> {
    let Item::Force(force) = item else { return None };
    let JointBody::Of { kind, arguments } = &force.body else { return None };
    let is_coefficient = |argument: &&Argument| argument.name.as_ref().is_some_and(|name| name == "coefficient");
    let found = &arguments.iter().find(is_coefficient).or(arguments.get(4).filter(|argument| argument.name.is_none()))?.value;
    let ExpressionKind::Number { digits, unit } = &found.kind else { return None };
    let value: f64 = digits.parse().ok()?;
    let doubt = Doubt::PercentageOfFriction { written: digits.clone(), instead: (value / 100.0).to_string() };
    (kind == "friction" && unit.is_empty() && value >= SLIPPERY).then_some(Warning { doubt, range: found.range })
}

/// Doubts a planetary train whose carrier is given as its ring gear.
fn swapped_carrier(item: &Item) -> Option<Warning> {
    let Item::Joint(joint) = item else { return None };
    let JointBody::Of { kind, arguments } = &joint.body else { return None };
    let [sun, ring, carrier, ..] = arguments.as_slice() else { return None };
    let is_called = |argument: &Argument, word: &str, other: &str| {
        let name = argument.value.to_string();
        argument.name.is_none() && name.contains(word) && !name.contains(other) && !name.contains("spring")
    };
    if kind != "planetary" || !is_called(ring, "carrier", "ring") || !is_called(carrier, "ring", "carrier") {
        return None;
    }
    let instead = format!("planetary({}, {}, {}, …)", sun.value, carrier.value, ring.value);
    Some(Warning { doubt: Doubt::CarrierAsRing { carrier: ring.value.to_string(), instead }, range: ring.value.range })
}

/// Doubts a driven distance that is negative at t = 0: a negative length alone, or with terms that are zero there.
fn negative_distance(item: &Item) -> Option<Warning> {
    let Item::Joint(joint) = item else { return None };
    let JointBody::Of { kind, arguments } = &joint.body else { return None };
    let is_law = |argument: &&Argument| argument.name.as_ref().is_some_and(|name| name == "C");
    let mut first = &arguments.iter().find(is_law).or(arguments.last()).filter(|_| kind == "drive_distance")?.value;
    while let ExpressionKind::Binary(Operator::Add | Operator::Sub, one, two) = &first.kind {
        if !begins_at_zero(two) {
            return None;
        }
        first = one;
    }
    let ExpressionKind::Negative(length) = &first.kind else { return None };
    let ExpressionKind::Number { unit, .. } = &length.kind else { return None };
    let is_length = quantity::unit(unit).is_some_and(|(_, dim)| dim == Dim::LENGTH);
    is_length.then(|| Warning { doubt: Doubt::NegativeRest { written: first.to_string(), of: "distance" }, range: first.range })
}

/// True for `t`, its products, quotients and powers, and sines of them.
fn begins_at_zero(term: &Expression) -> bool {
    match &term.kind {
        ExpressionKind::Path(_) => term.name().is_some_and(|name| name == "t"),
        ExpressionKind::Negative(inner) | ExpressionKind::Binary(Operator::Div | Operator::Power, inner, _) => begins_at_zero(inner),
        ExpressionKind::Binary(Operator::Mul, one, two) => begins_at_zero(one) || begins_at_zero(two),
        ExpressionKind::Call(path, arguments) => path.last == "sin" && arguments.iter().all(begins_at_zero),
        _ => false,
    }
}

/// Doubts programs of a whole turn that end, where a cam has them.
pub(super) fn programs_that_end(items: &[Item]) -> Vec<Warning> {
    let of_cam = |item: &Item| match item {
        Item::Joint(joint) => match &joint.body {
            JointBody::Of { kind, arguments } if ["cam_knife", "cam_roller", "cam_flat"].iter().any(|known| kind == known) => {
                arguments.iter().filter_map(|argument| argument.value.name()).map(ToString::to_string).collect()
            }
            _ => Vec::new(),
        },
        _ => Vec::new(),
    };
    let named: Vec<String> = every_item(items).flat_map(of_cam).collect();
    let doubt = |item: &Item| {
        let Item::Function(function) = item else { return None };
        let ExpressionKind::Call(path, arguments) = &function.value.kind else { return None };
        let [angle, _, program] = arguments.as_slice() else { return None };
        let is_own = path.last == "segments" && angle.name().is_some_and(|name| function.argument.as_ref() == Some(name));
        let ExpressionKind::List(segments) = &program.kind else { return None };
        let turn: f64 = segments.iter().map(degrees_of_segment).sum::<Option<f64>>()?;
        let is_meant = named.contains(&function.name.to_string()) && is_own && (turn - 360.0).abs() < 1e-9;
        is_meant.then(|| Warning { doubt: Doubt::ProgramEnds { function: function.name.to_string() }, range: program.range })
    };
    every_item(items).filter_map(doubt).collect()
}

/// The angle of `rise(12mm, 120deg, law)`, in degrees.
fn degrees_of_segment(segment: &Expression) -> Option<f64> {
    let ExpressionKind::Call(_, arguments) = &segment.kind else { return None };
    let in_degrees = |argument: &Expression| match &argument.kind {
        ExpressionKind::Number { digits, unit } if unit == "deg" => digits.parse().ok(),
        _ => None,
    };
    arguments.iter().find_map(in_degrees)
}

/// Doubts negative stiffnesses, dampings and lengths that are written out.
fn negative_coefficients(item: &Item) -> Vec<Warning> {
    const WITH_COEFFICIENTS: [&str; 6] = ["spring", "damper", "spring_damper", "torsion_spring", "torsion_damper", "torsion_spring_damper"];
    let Item::Force(force) = item else { return Vec::new() };
    let JointBody::Of { kind, arguments } = &force.body else { return Vec::new() };
    if !WITH_COEFFICIENTS.iter().any(|known| kind == known) {
        return Vec::new();
    }
    let doubt = |argument: &Argument| {
        let ExpressionKind::Negative(value) = &argument.value.kind else { return None };
        let ExpressionKind::Number { unit, .. } = &value.kind else { return None };
        let dim = quantity::unit(unit)?.1;
        let is_stiffness = [Dim::FORCE.per(Dim::LENGTH), Dim::TORQUE.per(Dim::ANGLE)].contains(&dim);
        let is_damping = [Dim::FORCE.per(Dim::LENGTH).times(Dim::TIME), Dim::TORQUE.per(Dim::ANGLE).times(Dim::TIME)].contains(&dim);
        let doubt = if dim == Dim::LENGTH {
            Doubt::NegativeRest { written: argument.value.to_string(), of: "rest length" }
        } else {
            Doubt::NegativeCoefficient { written: argument.value.to_string(), is_damping }
        };
        (is_stiffness || is_damping || dim == Dim::LENGTH).then_some(Warning { doubt, range: argument.value.range })
    };
    arguments.iter().filter_map(doubt).collect()
}
