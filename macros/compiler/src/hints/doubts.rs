//! Warnings about valid expressions that are often meant otherwise: powers of numbers with units, frequencies and periods as angles, inputs by the
//! time, rates of constants, drives that jump, forces along a velocity, free fall in other units or upwards, and free fall where nothing has a mass.

use super::arguments::{doubtful_arguments, programs_that_end};
use super::conversions::Angular;
use crate::diag::{Doubt, Range, Warning, quantity as in_words};
use crate::quantity::{self, Dim};
use crate::syntax::ast::{Argument, Expression, ExpressionKind, Item, JointBody, Mechanism, Operator, Relation, Statement, every_item};
use std::collections::BTreeSet;

/// Free fall that is slower or faster than this (m/s²) was rather meant in millimetres.
const USUAL: [f64; 2] = [0.02, 100.0];

/// Laws from 0 to 1.
const LAWS: [&str; 8] =
    ["linear", "harmonic", "cycloidal", "modified_sine", "modified_trapezoidal", "polynomial_345", "polynomial_4567", "smooth_step"];

/// Names of quantities that make an expression doubtful.
struct Suspects {
    /// Parameters.
    parameters: BTreeSet<String>,
    /// All inputs.
    all_inputs: BTreeSet<String>,
    /// Inputs that are velocities.
    inputs: BTreeSet<String>,
    /// Frequencies.
    frequencies: BTreeSet<String>,
    /// Times.
    periods: BTreeSet<String>,
}

/// Warnings about the expressions of a mechanism.
pub(crate) fn doubtful_expressions(tree: &Mechanism) -> Vec<Warning> {
    let is_rate = |dim: Dim| [Dim::ANGLE, Dim::LENGTH].contains(&dim.times(Dim::TIME));
    let (mut inputs, mut frequencies, mut periods, mut found) = (BTreeSet::new(), BTreeSet::new(), BTreeSet::new(), Vec::new());
    let (mut parameters, mut all_inputs) = (BTreeSet::new(), BTreeSet::new());
    for item in every_item(&tree.items) {
        let (Item::Parameter(quantity) | Item::Input(quantity)) = item else { continue };
        let (name, dim) = (quantity.name.to_string(), quantity.dimension.dim());
        if matches!(item, Item::Input(_)) { &mut all_inputs } else { &mut parameters }.insert(name.clone());
        if matches!(item, Item::Input(_)) && dim.is_some_and(is_rate) {
            inputs.insert(name);
        } else if dim == Some(Dim::NUMBER.per(Dim::TIME)) {
            frequencies.insert(name);
        } else if dim == Some(Dim::TIME) {
            periods.insert(name);
        }
        found.extend(turns_as_speed(&quantity.default).filter(|_| dim == Some(Dim::ANGLE.per(Dim::TIME))));
    }
    // A parameter of a component may have the name of an input, and its argument that of either.
    let arguments: BTreeSet<String> = every_item(&tree.items).flat_map(arguments_of).collect();
    inputs.retain(|name| !parameters.contains(name));
    let others = |names: &BTreeSet<String>, others: &BTreeSet<String>| names.difference(others).cloned().collect::<BTreeSet<String>>();
    let [parameters, all_inputs] = [others(&parameters, &all_inputs), others(&all_inputs, &parameters)];
    let [parameters, all_inputs] = [others(&parameters, &arguments), others(&all_inputs, &arguments)];
    let (names, angular) = (Suspects { parameters, all_inputs, inputs, frequencies, periods }, Angular::of(&tree.items));
    for item in every_item(&tree.items) {
        let at_top = written_in(item);
        at_top.iter().for_each(|value| value.each(&mut |part| found.extend(names.doubt(part))));
        if let Some(in_degrees) = degrees_in_output(item) {
            found.push(in_degrees);
        } else {
            found.extend(at_top.iter().flat_map(|value| angular.doubts(value)));
        }
        found.extend(names.turns_driven(item));
        found.extend(jump_of_drive(item));
        found.extend(driving_torques(item));
        found.extend(doubtful_arguments(item));
        if let Item::Gravity(gravity) = item {
            found.extend(unusual_gravity(&gravity.value));
            found.extend(gravity_upwards(&gravity.value));
            let without_mass = Warning { doubt: Doubt::GravityWithoutMass, range: gravity.value.range };
            found.extend(is_massless(&tree.items).then_some(without_mass));
        }
    }
    found.extend(programs_that_end(&tree.items));
    found
}

/// True if nothing in a mechanism has a mass, or can have one from elsewhere.
fn is_massless(items: &[Item]) -> bool {
    every_item(items).all(|item| match item {
        Item::Body(body) => body.masses.is_empty(),
        Item::Joint(joint) => match &joint.body {
            // Gear joints of multi-point constraints may add masses.
            JointBody::Of { kind, .. } => !kind.to_string().contains("_joint"),
            JointBody::Equations(statements) => !statements.iter().any(|statement| matches!(statement, Statement::Add(_))),
            _ => true,
        },
        Item::Use(_) | Item::Refused(_) => false,
        _ => true,
    })
}

/// The expressions that an item consists of.
fn written_in(item: &Item) -> Vec<&Expression> {
    match item {
        Item::Parameter(quantity) | Item::Input(quantity) => vec![&quantity.default],
        Item::Let(binding) => vec![&binding.value],
        Item::Function(function) => vec![&function.value],
        Item::Output(output) => vec![&output.value],
        Item::Start(start) => vec![&start.value],
        Item::Gravity(gravity) => vec![&gravity.value],
        Item::Part(part) => part.arguments.iter().map(|argument| &argument.value).collect(),
        Item::Ground(frame) | Item::Body(frame) => {
            let marks = frame.marks.single.iter().map(|mark| &mark.value);
            let starts = frame.starts.iter().map(|start| &start.value);
            marks.chain(starts).chain(frame.masses.iter().map(|mass| &mass.value)).collect()
        }
        Item::Joint(joint) | Item::Force(joint) => match &joint.body {
            JointBody::Of { arguments, .. } => arguments.iter().map(|argument| &argument.value).collect(),
            JointBody::Equations(statements) => statements.iter().flat_map(of_statement).collect(),
            JointBody::Freedom(freedom) => {
                [Some(&freedom.value), freedom.from.as_ref(), freedom.at.as_ref()].into_iter().flatten().collect()
            }
            JointBody::Energy(value) | JointBody::Value(value) => vec![value],
        },
        Item::Use(_) | Item::Range(_) | Item::Refused(_) | Item::Component(_) | Item::For(_) => Vec::new(),
    }
}

fn of_statement(statement: &Statement) -> Vec<&Expression> {
    match statement {
        Statement::Let(binding) => vec![&binding.value],
        Statement::Equation(one, two) => vec![one, two],
        Statement::Apply(applied) => vec![&applied.value],
        Statement::Potential(energy) => vec![energy],
        Statement::Require(_) | Statement::Add(_) => Vec::new(),
    }
}

/// The name beside `t` in a product, if it is one of these.
fn by_time(product: &Expression, names: &BTreeSet<String>) -> Option<String> {
    let ExpressionKind::Binary(Operator::Mul, one, two) = &product.kind else { return None };
    let named = [one, two].map(|side| side.name().map(ToString::to_string));
    let is_time = |side: usize| named[side].as_deref() == Some("t");
    let other = if is_time(1) { named[0].clone() } else { named[1].clone().filter(|_| is_time(0)) };
    other.filter(|name| names.contains(name))
}

impl Suspects {
    /// A frequency by the time as the law of a drive of an angle.
    fn turns_driven(&self, item: &Item) -> Option<Warning> {
        let Item::Joint(joint) = item else { return None };
        let JointBody::Of { kind, arguments } = &joint.body else { return None };
        if !["drive_angle", "drive_relative_angle", "drive_rotation"].iter().any(|name| kind == name) {
            return None;
        }
        let is_law = |argument: &&Argument| argument.name.as_ref().is_some_and(|name| name == "C");
        let law = &arguments.iter().find(is_law).or(arguments.last())?.value;
        let written = law.to_string();
        let doubt = match self.by_period(law) {
            Some(instead) => Doubt::PeriodsAsAngle { written, instead },
            None if by_time(law, &self.frequencies).is_some() => Doubt::TurnsAsAngle { written },
            None => match &law.kind {
                ExpressionKind::Call(rise, arguments) if LAWS.iter().any(|law| rise.last == law) && arguments.len() == 1 => {
                    Doubt::RiseOfOne { written }
                }
                _ => return None,
            },
        };
        Some(Warning { doubt, range: law.range })
    }

    /// `t / T` and `360 * t / T` with an angle in front, `3000 * t / 60s` with an angular velocity.
    fn by_period(&self, law: &Expression) -> Option<String> {
        let ExpressionKind::Binary(Operator::Div, above, below) = &law.kind else { return None };
        let period = below.to_string();
        let is_known = below.name().is_some_and(|name| self.periods.contains(&name.to_string()));
        // `t / 1s` is a number of seconds.
        let is_time_unit = |unit: &str| quantity::unit(unit).is_some_and(|unit| unit.1 == Dim::TIME);
        let is_written = matches!(&below.kind, ExpressionKind::Number { unit, digits } if digits != "1" && is_time_unit(unit));
        let is_minute = ["60s", "1min"].contains(&period.as_str());
        let is_time = |value: &Expression| value.name().is_some_and(|name| name == "t");
        match &above.kind {
            _ if is_time(above) => (is_known || is_written).then(|| format!("1turn * t / {period}")),
            ExpressionKind::Binary(Operator::Mul, factor, time) if is_time(time) => match &factor.kind {
                ExpressionKind::Number { digits, unit } if unit.is_empty() && ["90", "180", "360"].contains(&digits.as_str()) => {
                    (is_known || is_written || period == "1s").then(|| format!("{digits}deg * t / {period}"))
                }
                ExpressionKind::Number { digits, unit } if unit.is_empty() && is_minute => Some(format!("{digits}rpm * t")),
                _ => None,
            },
            _ => None,
        }
    }

    fn doubt(&self, value: &Expression) -> Option<Warning> {
        let warn = |doubt: Doubt, range: Range| Some(Warning { doubt, range });
        if let Some(input) = by_time(value, &self.inputs) {
            return warn(Doubt::InputByTime { input }, value.range);
        }
        match &value.kind {
            ExpressionKind::Binary(Operator::Power, base, exponent) => warn(raised_number(base, exponent)?, value.range),
            ExpressionKind::Binary(Operator::Mul, rate, time) if time.name().is_some_and(|name| name == "t") => {
                let input = rate_of(rate).filter(|name| self.all_inputs.contains(name))?;
                let flaw = format!("`{value}` is not `{input}`: its rate at one instant acts over all the time before it");
                warn(unlikely("rate_by_time", flaw, format!("write `{input}`")), value.range)
            }
            ExpressionKind::Call(..) if rate_of(value).is_some_and(|name| self.parameters.contains(&name)) => {
                let parameter = rate_of(value)?;
                let (flaw, help) =
                    (format!("`{parameter}` does not change with time: its rate is 0"), "a quantity that changes is an `input`");
                warn(unlikely("rate_of_parameter", flaw, help.to_owned()), value.range)
            }
            ExpressionKind::Call(function, arguments) if ["asin", "acos", "atan"].iter().any(|name| function.last == name) => {
                let angle = arguments.first().filter(|argument| is_angle(argument))?;
                let flaw = format!("`{angle}` is an angle already, and `{}` takes a number", function.last);
                warn(unlikely("angle_of_angle", flaw, format!("write `{angle}`")), value.range)
            }
            ExpressionKind::Call(function, arguments) if ["sin", "cos", "tan"].iter().any(|name| function.last == name) => {
                let angle = arguments.first()?;
                by_time(angle, &self.frequencies)?;
                warn(Doubt::TurnsAsAngle { written: angle.to_string() }, angle.range)
            }
            _ => None,
        }
    }
}

fn unlikely(name: &'static str, flaw: String, help: String) -> Doubt {
    Doubt::Unlikely { name, flaw, help }
}

/// The names that stand for what a component, a definition or a function takes, and those of loops and `let`.
fn arguments_of(item: &Item) -> Vec<String> {
    match item {
        Item::Component(component) => component.head.parameters.iter().map(|formal| formal.name.to_string()).collect(),
        Item::Function(function) => function.argument.iter().map(ToString::to_string).collect(),
        Item::For(repeated) => vec![repeated.variable.to_string()],
        Item::Let(binding) => vec![binding.name.to_string()],
        Item::Joint(joint) | Item::Force(joint) => match &joint.body {
            JointBody::Equations(statements) => statements.iter().filter_map(named).collect(),
            _ => Vec::new(),
        },
        _ => Vec::new(),
    }
}

/// The name that a statement declares.
fn named(statement: &Statement) -> Option<String> {
    if let Statement::Let(binding) = statement { Some(binding.name.to_string()) } else { None }
}

/// The name in `rate(name)`.
fn rate_of(value: &Expression) -> Option<String> {
    match &value.kind {
        ExpressionKind::Call(function, arguments) if function.last == "rate" => match arguments.as_slice() {
            [only] => only.name().map(ToString::to_string),
            _ => None,
        },
        _ => None,
    }
}

/// Doubts a drive whose law is one number before an instant and another one after it.
fn jump_of_drive(item: &Item) -> Option<Warning> {
    let Item::Joint(joint) = item else { return None };
    let JointBody::Of { kind, arguments } = &joint.body else { return None };
    let law = &arguments.last()?.value;
    let ExpressionKind::If { lhs, relation, rhs, then, otherwise } = &law.kind else { return None };
    let is_time = |value: &Expression| value.name().is_some_and(|name| name == "t");
    let instant = if is_time(lhs) { rhs } else { Some(lhs).filter(|_| is_time(rhs))? };
    let is_below = matches!(relation, Relation::Less | Relation::LessOrEqual);
    let (from, to) = if is_below == is_time(lhs) { (then, otherwise) } else { (otherwise, then) };
    let number = |value: &Expression| match &value.kind {
        // Of numbers without a unit others speak.
        ExpressionKind::Number { digits, unit } if !unit.is_empty() => Some(digits.parse::<f64>().ok()? * quantity::unit(unit)?.0.to_f64()),
        _ => None,
    };
    if !kind.to_string().starts_with("drive_") || number(from)? == number(to)? {
        return None;
    }
    let flaw = format!("the drive jumps from {from} to {to} at t = {instant}, and no body can move like that");
    let is_simple = matches!(instant.kind, ExpressionKind::Number { .. } | ExpressionKind::Path(_));
    let instant = if is_simple { instant.to_string() } else { format!("({instant})") };
    let height = if number(from)? == 0.0 { to.to_string() } else { format!("({to} - {from})") };
    let begin = if number(from)? == 0.0 { String::new() } else { format!("{from} + ") };
    let help = format!(
        "move from one to the other gradually, for example with `{begin}{height} * cycloidal((t - {instant}) / 0.5s)`; if the jump is intended, name one of the values with `let`"
    );
    Some(Warning { doubt: unlikely("jump_of_drive", flaw, help), range: law.range })
}

/// Doubts a torque on a body along its angular velocity, and a force at a point along its velocity.
fn driving_torques(item: &Item) -> Vec<Warning> {
    let Item::Force(force) = item else { return Vec::new() };
    let JointBody::Equations(statements) = &force.body else { return Vec::new() };
    let doubt = |statement: &Statement| {
        let Statement::Apply(applied) = statement else { return None };
        let ExpressionKind::Binary(Operator::Mul, factor, speed) = &applied.value.kind else { return None };
        let ExpressionKind::Number { unit, .. } = &factor.kind else { return None };
        let own = match &speed.kind {
            ExpressionKind::Field(body, name) => name == "angular_velocity" && body.to_string() == applied.target.to_string(),
            ExpressionKind::Call(function, arguments) => {
                function.last == "rate" && arguments.first().is_some_and(|point| point.to_string() == applied.target.to_string())
            }
            _ => false,
        };
        if !own || unit.is_empty() {
            return None;
        }
        let flaw = format!("`{}` drives the motion instead of damping it", applied.value);
        let help = format!("write `-{}`, or name the number with `let` if it is meant", applied.value);
        Some(Warning { doubt: unlikely("driving_force", flaw, help), range: applied.value.range })
    };
    statements.iter().filter_map(doubt).collect()
}

/// Doubts `1 / 0.5s` as an angular velocity.
fn turns_as_speed(value: &Expression) -> Option<Warning> {
    let ExpressionKind::Binary(Operator::Div, number, time) = &value.kind else { return None };
    let (ExpressionKind::Number { digits: above, unit: none }, ExpressionKind::Number { digits, unit }) = (&number.kind, &time.kind) else {
        return None;
    };
    let (size, dim) = quantity::unit(unit)?;
    let per_minute = 60.0 * above.parse::<f64>().ok()? / (digits.parse::<f64>().ok()? * size.to_f64());
    let rounded = (per_minute * 1e6).round() / 1e6;
    let doubt = Doubt::TurnsAsSpeed { written: value.to_string(), in_rpm: format!("{rounded}rpm") };
    (none.is_empty() && dim == Dim::TIME && rounded.is_finite()).then_some(Warning { doubt, range: value.range })
}

/// Doubts an angle that is multiplied by 180 and divided by pi.
fn degrees_in_output(item: &Item) -> Option<Warning> {
    let Item::Output(output) = item else { return None };
    let of = |value: &Expression, operator: Operator| match &value.kind {
        ExpressionKind::Binary(found, one, two) if *found == operator => Some((one.clone(), two.clone())),
        _ => None,
    };
    let is_half_turn = |value: &Expression| matches!(&value.kind, ExpressionKind::Number { digits, unit } if unit.is_empty() && digits.parse() == Ok(180.0));
    let is_pi = |value: &Expression| value.name().is_some_and(|name| name == "pi");
    let (product, last) = of(&output.value, Operator::Div)?;
    let (angle, factor) = of(&product, Operator::Mul)?;
    if !is_half_turn(&factor) || !is_pi(&last) || !is_angle(&angle) {
        return None;
    }
    let doubt = Doubt::DegreesInOutput { written: output.value.to_string(), angle: angle.to_string() };
    Some(Warning { doubt, range: output.value.range })
}

/// True for angles of bodies and joints, and for sums and differences of them.
fn is_angle(value: &Expression) -> bool {
    match &value.kind {
        ExpressionKind::Field(_, name) => name == "angle",
        ExpressionKind::Binary(Operator::Add | Operator::Sub, one, two) => is_angle(one) && is_angle(two),
        _ => false,
    }
}

/// Doubts free fall that is written out and that is much slower or faster than on earth.
fn unusual_gravity(value: &Expression) -> Option<Warning> {
    let ExpressionKind::Tuple(written) = &value.kind else { return None };
    let part = |part: &Expression| {
        let part = if let ExpressionKind::Negative(inner) = &part.kind { inner } else { part };
        match &part.kind {
            ExpressionKind::Number { digits, unit } if unit.is_empty() => digits.parse::<f64>().ok(),
            ExpressionKind::Number { digits, unit } => Some(digits.parse::<f64>().ok()? * quantity::unit(unit)?.0.to_f64()),
            _ => None,
        }
    };
    let parts: Vec<f64> = written.iter().map(part).collect::<Option<_>>()?;
    let greatest = parts.iter().copied().fold(0.0, f64::max);
    let size = parts.iter().map(|part| part * part).sum::<f64>().sqrt();
    let found = in_words(size, Dim::ACCELERATION);
    let is_unusual = size > 0.0 && !(USUAL[0]..=USUAL[1]).contains(&size);
    let is_negative = |(part, number): (&Expression, &f64)| *number == greatest && matches!(part.kind, ExpressionKind::Negative(_));
    let instead = if written.iter().zip(&parts).any(is_negative) { "-9.81m_s2" } else { "9.81m_s2" };
    is_unusual.then_some(Warning { doubt: Doubt::UnusualGravity { found, instead }, range: value.range })
}

/// Doubts free fall as on earth along y or z, where it points upwards.
fn gravity_upwards(value: &Expression) -> Option<Warning> {
    let ExpressionKind::Tuple(parts) = &value.kind else { return None };
    let size = |part: &Expression| match &part.kind {
        ExpressionKind::Number { digits, unit } => {
            Some(digits.parse::<f64>().ok()? * quantity::unit(unit).map_or(1.0, |unit| unit.0.to_f64()))
        }
        _ => None,
    };
    let sizes: Vec<f64> = parts.iter().map(size).collect::<Option<_>>()?;
    let (first, others) = sizes.split_first()?;
    let is_upwards =
        *first == 0.0 && others.iter().all(|size| *size == 0.0 || (9.7..9.9).contains(size)) && others.iter().any(|size| *size > 0.0);
    let written = parts.iter().zip(&sizes).find(|(_, size)| **size > 0.0)?.0.to_string();
    is_upwards.then_some(Warning { doubt: Doubt::GravityUpwards { written }, range: value.range })
}

/// Doubts `20mm^2`, which is (20 mm)².
fn raised_number(base: &Expression, exponent: &Expression) -> Option<Doubt> {
    let (sign, exponent) = match &exponent.kind {
        ExpressionKind::Negative(inner) => ("-", inner.as_ref()),
        _ => ("", exponent),
    };
    let ExpressionKind::Number { digits, unit } = &base.kind else { return None };
    let ExpressionKind::Number { digits: power, unit: none } = &exponent.kind else { return None };
    // Parentheses are two tokens.
    let is_bare = base.range.first.start() == base.range.last.start();
    let is_same = digits.parse::<f64>().is_ok_and(|value| value == 0.0 || value == 1.0) || power == "1" && sign.is_empty();
    if !is_bare || is_same || unit.is_empty() || !none.is_empty() {
        return None;
    }
    let instead = match sign {
        "" if quantity::unit(&format!("{unit}{power}")).is_some() => format!("{digits}{unit}{power}"),
        "" => format!("{digits} * 1{unit}^{power}"),
        _ if unit == "min" && power == "1" => format!("{digits}rpm"),
        _ if power == "1" => format!("{digits} / 1{unit}"),
        _ => format!("{digits} / 1{unit}^{power}"),
    };
    Some(Doubt::RaisedNumber {
        written: format!("{digits}{unit}^{sign}{power}"),
        meaning: format!("({digits}{unit})^{sign}{power}"),
        instead,
    })
}
