//! Warnings about angles without a unit, which count as radians.

use crate::diag::{AngleOf, Doubt, Range, Warning};
use crate::library;
use crate::syntax::ast::{Expression, ExpressionKind, Item, JointBody, Mechanism, Operator, Statement, every_item};
use proc_macro2::Ident;

/// Drives that prescribe an angle.
const DRIVES: [&str; 3] = ["drive_angle", "drive_relative_angle", "drive_rotation"];

/// Warnings about starts of angles, constant laws of drives, and sines, cosines and tangents, of bare numbers that are probably degrees.
pub(crate) fn bare_angles(tree: &Mechanism) -> Vec<Warning> {
    let mut found = Vec::new();
    every_item(&tree.items).for_each(|item| of_item(item, &mut found));
    found
}

fn of_item(item: &Item, found: &mut Vec<Warning>) {
    match item {
        Item::Parameter(parameter) | Item::Input(parameter) => of(&parameter.default, found),
        Item::Let(binding) => of(&binding.value, found),
        Item::Function(function) => of(&function.value, found),
        Item::Joint(joint) | Item::Force(joint) => of_joint(&joint.body, found),
        Item::Output(output) => of(&output.value, found),
        Item::Start(start) => {
            if names_angle(&start.quantity) {
                of_angle(AngleOf::Start, &start.value, found);
            }
            of(&start.value, found);
        }
        Item::Ground(frame) | Item::Body(frame) => {
            frame.marks.single.iter().for_each(|mark| of(&mark.value, found));
            frame.starts.iter().filter(|start| start.what == "angle").for_each(|start| of_angle(AngleOf::Start, &start.value, found));
            frame.starts.iter().for_each(|start| of(&start.value, found));
        }
        Item::Part(part) => part.arguments.iter().for_each(|argument| of(&argument.value, found)),
        Item::Use(_) | Item::Gravity(_) | Item::Range(_) | Item::Refused(_) | Item::Component(_) | Item::For(_) => {}
    }
}

fn of_joint(body: &JointBody, found: &mut Vec<Warning>) {
    match body {
        JointBody::Of { kind, arguments } => {
            arguments.iter().for_each(|argument| of(&argument.value, found));
            if let Some(law) = arguments.last().filter(|_| DRIVES.iter().any(|drive| kind == drive)) {
                of_angle(AngleOf::Law, &law.value, found);
            }
        }
        JointBody::Equations(statements) => statements.iter().for_each(|statement| match statement {
            Statement::Let(binding) => of(&binding.value, found),
            Statement::Equation(one, two) => [one, two].into_iter().for_each(|side| of(side, found)),
            Statement::Apply(applied) => of(&applied.value, found),
            Statement::Potential(energy) => of(energy, found),
            Statement::Require(_) | Statement::Add(_) => {}
        }),
        JointBody::Freedom(freedom) => {
            of(&freedom.value, found);
            if let Some(from) = freedom.from.as_ref().filter(|_| names_angle(&freedom.value)) {
                of_angle(AngleOf::Start, from, found);
            }
        }
        JointBody::Energy(value) | JointBody::Value(value) => of(value, found),
    }
}

fn of(expr: &Expression, found: &mut Vec<Warning>) {
    expr.each(&mut |part| {
        let ExpressionKind::Call(path, arguments) = &part.kind else { return };
        let name = path.name.as_ref().map(ToString::to_string).filter(|name| ["sin", "cos", "tan"].contains(&name.as_str()));
        if let (Some(function), [argument]) = (name, arguments.as_slice()) {
            of_angle(AngleOf::Function(function), argument, found);
        }
    });
}

/// True for `body.angle` and `joint.angle`.
fn names_angle(value: &Expression) -> bool {
    matches!(&value.kind, ExpressionKind::Field(_, name) if name == "angle")
}

fn of_angle(of: AngleOf, value: &Expression, found: &mut Vec<Warning>) {
    let of = if is_number(value) { of } else { AngleOf::Part };
    found.extend(degrees(value).map(|(number, range)| Warning { doubt: Doubt::BareAngle { of, number }, range }));
}

/// A bare number of more than a turn in radians, as written: it is rather one of degrees. Also where it is a term, or a factor of a sine or a law.
fn degrees(argument: &Expression) -> Option<(String, Range)> {
    match &argument.kind {
        ExpressionKind::Negative(inner) if is_number(inner) => degrees(inner).map(|(number, _)| (format!("-{number}"), argument.range)),
        ExpressionKind::Negative(inner) => degrees(inner),
        ExpressionKind::Number { digits, unit } if unit.is_empty() => {
            let is_large = digits.parse::<f64>().is_ok_and(|value| value > std::f64::consts::TAU);
            is_large.then(|| (digits.clone(), argument.range))
        }
        ExpressionKind::Binary(Operator::Add | Operator::Sub, one, two) => degrees(one).or_else(|| degrees(two)),
        ExpressionKind::Binary(Operator::Mul, one, two) => match (is_number(one), is_wave(two), is_wave(one)) {
            (true, true, _) => degrees(one),
            (_, _, true) if is_number(two) => degrees(two),
            _ => None,
        },
        _ => None,
    }
}

/// True for a literal with or without a sign.
fn is_number(value: &Expression) -> bool {
    match &value.kind {
        ExpressionKind::Negative(inner) => is_number(inner),
        kind => matches!(kind, ExpressionKind::Number { .. }),
    }
}

/// True for a sine or cosine, or a law of the library that goes from 0 to 1.
pub(super) fn is_wave(value: &Expression) -> bool {
    let is_of_waves = |name: &Ident| name == "sin" || name == "cos" || library::functions().any(|law| name == law && law != "wrap");
    matches!(&value.kind, ExpressionKind::Call(path, _) if path.name.as_ref().is_some_and(is_of_waves))
}
