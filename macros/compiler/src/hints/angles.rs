//! Warnings about angles without a unit, which count as radians.

use crate::diag::{AngleOf, Doubt, Range, Warning};
use crate::library;
use crate::quantity::Dim;
use crate::syntax::ast::{
    Argument, Expression, ExpressionKind, Formal, FormalKind, Item, JointBody, Marks, Mechanism, Operator, Statement,
};
use proc_macro2::Ident;
use std::collections::{BTreeMap, BTreeSet};

/// Drives that prescribe an angle.
const DRIVES: [&str; 3] = ["drive_angle", "drive_relative_angle", "drive_rotation"];

/// Warnings about starts of angles, constant laws of drives, and sines, cosines and tangents, of bare numbers that are probably degrees.
pub(crate) fn bare_angles(tree: &Mechanism) -> Vec<Warning> {
    let mut found = Vec::new();
    search(&tree.items, &mut found);
    found
}

/// Warnings about the items of a mechanism or of a component, which sees its own names only, and about its components.
fn search(items: &[Item], found: &mut Vec<Warning>) {
    let (mut own, mut pending, mut components) = (Vec::new(), vec![items], Vec::new());
    let mut search = AngleSearch::default();
    while let Some(items) = pending.pop() {
        for item in items {
            match item {
                Item::For(repeated) => {
                    search.variables.insert(repeated.variable.to_string());
                    pending.push(&repeated.items);
                }
                Item::Component(component) => {
                    let is_angle = |formal: &Formal| match &formal.kind {
                        FormalKind::Scalar(dimension) => dimension.dim() == Some(Dim::ANGLE),
                        _ => false,
                    };
                    let formals = component.head.parameters.iter().map(|formal| (formal.name.to_string(), is_angle(formal)));
                    search.components.insert(component.head.name.to_string(), formals.collect());
                    components.push(&component.items);
                }
                _ => own.push(item),
            }
        }
    }
    for item in &own {
        match item {
            Item::Let(binding) if binding.indices.is_empty() => search.name(&binding.name, &binding.value, false),
            Item::Parameter(parameter) if parameter.dimension.dim() == Some(Dim::NUMBER) && parameter.indices.is_empty() => {
                search.name(&parameter.name, &parameter.default, true);
            }
            _ => {}
        }
    }
    own.into_iter().for_each(|item| search.of_item(item));
    found.extend(search.found);
    components.into_iter().for_each(|items| self::search(items, found));
}

/// A bare number in the place of an angle.
struct NumberAsAngle {
    /// As written.
    number: String,
    range: Range,
    /// The parameter whose default it is.
    parameter: Option<String>,
}

/// A search for bare numbers in the place of angles.
#[derive(Default)]
struct AngleSearch {
    /// Named numbers beyond a turn in radians.
    numbers: BTreeMap<String, NumberAsAngle>,
    /// Variables of loops.
    variables: BTreeSet<String>,
    /// By component, its parameters, and whether they are angles.
    components: BTreeMap<String, Vec<(String, bool)>>,
    found: Vec<Warning>,
}

impl AngleSearch {
    fn name(&mut self, name: &Ident, value: &Expression, is_parameter: bool) {
        if let Some(bare) = beyond_a_turn(value) {
            let parameter = is_parameter.then(|| name.to_string());
            self.numbers.insert(name.to_string(), NumberAsAngle { parameter, ..bare });
        }
    }

    fn of_item(&mut self, item: &Item) {
        match item {
            Item::Parameter(parameter) | Item::Input(parameter) => self.of(&parameter.default),
            Item::Let(binding) => self.of(&binding.value),
            Item::Function(function) => self.of(&function.value),
            Item::Joint(joint) | Item::Force(joint) => self.of_joint(&joint.body),
            Item::Output(output) => self.of(&output.value),
            Item::Start(start) => {
                if names_angle(&start.quantity) {
                    self.of_angle(AngleOf::Start, &start.value);
                }
                self.of(&start.value);
            }
            Item::Ground(frame) | Item::Body(frame) => {
                self.of_marks(&frame.marks);
                frame.starts.iter().filter(|start| start.what == "angle").for_each(|start| self.of_angle(AngleOf::Start, &start.value));
                frame.starts.iter().for_each(|start| self.of(&start.value));
            }
            Item::Part(part) => {
                part.arguments.iter().for_each(|argument| self.of(&argument.value));
                // A number alone is said to count as radians where it is resolved.
                let is_product = |argument: &&Argument| matches!(argument.value.kind, ExpressionKind::Binary(Operator::Mul, ..));
                for (place, argument) in part.arguments.iter().enumerate().filter(|(_, argument)| is_product(argument)) {
                    let name = argument.name.as_ref().map(ToString::to_string);
                    let is_meant = |formal: &(String, bool)| formal.1 && name.as_ref().is_none_or(|name| *name == formal.0);
                    let formals = self.components.get(&part.kind.to_string());
                    let formal = formals
                        .and_then(|formals| if name.is_some() { formals.iter().find(|one| is_meant(one)) } else { formals.get(place) });
                    if formal.is_some_and(is_meant) {
                        self.of_angle(AngleOf::Argument, &argument.value);
                    }
                }
            }
            Item::Use(_) | Item::Gravity(_) | Item::Range(_) | Item::Refused(_) | Item::Component(_) | Item::For(_) => {}
        }
    }

    fn of_joint(&mut self, body: &JointBody) {
        match body {
            JointBody::Of { kind, arguments } => {
                arguments.iter().for_each(|argument| self.of(&argument.value));
                if let Some(law) = arguments.last().filter(|_| DRIVES.iter().any(|drive| kind == drive)) {
                    self.of_angle(AngleOf::Law, &law.value);
                }
            }
            JointBody::Equations(statements) => statements.iter().for_each(|statement| match statement {
                Statement::Let(binding) => self.of(&binding.value),
                Statement::Equation(one, two) => [one, two].into_iter().for_each(|side| self.of(side)),
                Statement::Apply(applied) => self.of(&applied.value),
                Statement::Potential(energy) => self.of(energy),
                Statement::Require(_) | Statement::Add(_) => {}
            }),
            JointBody::Freedom(freedom) => {
                self.of(&freedom.value);
                if let Some(from) = freedom.from.as_ref().filter(|_| names_angle(&freedom.value)) {
                    self.of_angle(AngleOf::Start, from);
                }
            }
            JointBody::Energy(value) | JointBody::Value(value) => self.of(value),
        }
    }

    fn of_marks(&mut self, marks: &Marks) {
        marks.single.iter().for_each(|mark| self.of(&mark.value));
        for repeated in &marks.loops {
            self.variables.insert(repeated.variable.to_string());
            self.of_marks(&repeated.items);
        }
    }

    fn of(&mut self, expr: &Expression) {
        expr.each(&mut |part| {
            let ExpressionKind::Call(path, arguments) = &part.kind else { return };
            let name = path.name.as_ref().map(ToString::to_string).filter(|name| ["sin", "cos", "tan"].contains(&name.as_str()));
            if let (Some(function), [argument]) = (name, arguments.as_slice()) {
                self.of_angle(AngleOf::Function(function), argument);
            }
        });
    }

    fn of_angle(&mut self, of: AngleOf, value: &Expression) {
        let of = if is_number(value) { of } else { AngleOf::Part };
        let Some(NumberAsAngle { number, range, parameter }) = self.degrees(value) else { return };
        let of = parameter.map_or(of, AngleOf::Parameter);
        self.found.push(Warning { doubt: Doubt::BareAngle { of, number }, range });
    }

    /// A bare number of more than a turn in radians, as written: it is rather one of degrees. Also where it is a term, a factor of a sine, of a law
    /// or of the variable of a loop, or has a name, which is said once.
    fn degrees(&mut self, argument: &Expression) -> Option<NumberAsAngle> {
        match &argument.kind {
            ExpressionKind::Negative(inner) if is_number(inner) => {
                beyond_a_turn(inner).map(|bare| NumberAsAngle { number: format!("-{}", bare.number), range: argument.range, ..bare })
            }
            ExpressionKind::Negative(inner) => self.degrees(inner),
            ExpressionKind::Number { .. } => beyond_a_turn(argument),
            ExpressionKind::Path(_) => self.numbers.remove(&argument.name()?.to_string()),
            ExpressionKind::Binary(Operator::Add | Operator::Sub, one, two) => self.degrees(one).or_else(|| self.degrees(two)),
            ExpressionKind::Binary(Operator::Mul, one, two) => {
                let is_named = |factor: &Expression| matches!(&factor.kind, ExpressionKind::Path(_));
                match [(one, two), (two, one)].into_iter().find(|(_, other)| is_wave(other) || self.counts(other)) {
                    Some((factor, _)) if is_number(factor) || is_named(factor) => self.degrees(factor),
                    Some((factor, _)) => match &factor.kind {
                        // `360 / teeth * i`
                        ExpressionKind::Binary(Operator::Div, turn, _) if is_number(turn) => self.degrees(turn),
                        _ => None,
                    },
                    None => None,
                }
            }
            _ => None,
        }
    }

    /// True for the variable of a loop, and for sums with numbers.
    fn counts(&self, value: &Expression) -> bool {
        match &value.kind {
            ExpressionKind::Path(_) => value.name().is_some_and(|name| self.variables.contains(&name.to_string())),
            ExpressionKind::Binary(Operator::Add | Operator::Sub, one, two) => {
                self.counts(one) && is_number(two) || is_number(one) && self.counts(two)
            }
            _ => false,
        }
    }
}

/// A bare number of more than a turn in radians, as written.
fn beyond_a_turn(value: &Expression) -> Option<NumberAsAngle> {
    let ExpressionKind::Number { digits, unit } = &value.kind else { return None };
    let is_large = unit.is_empty() && digits.parse::<f64>().is_ok_and(|value| value > std::f64::consts::TAU);
    is_large.then(|| NumberAsAngle { number: digits.clone(), range: value.range, parameter: None })
}

/// True for `body.angle` and `joint.angle`.
fn names_angle(value: &Expression) -> bool {
    matches!(&value.kind, ExpressionKind::Field(_, name) if name == "angle")
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
