//! Expressions that are often written in place of others.

use crate::diag::{Fact, Note, Range, ValueFact};
use crate::quantity::{self, Dim};
use crate::syntax::ast::{Expression, ExpressionKind, Limits, Operator};
use proc_macro2::Ident;

/// A unit written in parts, with its number, as a single unit: `500N / mm` as `500N_mm`; and the identifiers taken for units.
pub(crate) fn unit_in_parts(value: &Expression) -> Option<(String, Vec<&Ident>)> {
    match &value.kind {
        ExpressionKind::Number { digits, unit } if !unit.is_empty() => Some((format!("{digits}{unit}"), Vec::new())),
        ExpressionKind::Negative(number) => unit_in_parts(number).map(|(text, names)| (format!("-{text}"), names)),
        ExpressionKind::Binary(operator, lhs, rhs) => {
            let between = match operator {
                Operator::Mul => "",
                Operator::Div => "_",
                _ => return None,
            };
            let (before, mut names) = unit_in_parts(lhs)?;
            let (name, exponent) = named_power(rhs)?;
            names.push(name);
            Some((format!("{before}{between}{name}{exponent}"), names))
        }
        _ => None,
    }
}

/// `m`, or `m^2` with its exponent.
fn named_power(value: &Expression) -> Option<(&Ident, &str)> {
    match &value.kind {
        ExpressionKind::Path(path) => Some((path.name.as_ref()?, "")),
        ExpressionKind::Binary(Operator::Power, base, exponent) => match &exponent.kind {
            ExpressionKind::Number { digits, unit } if unit.is_empty() => Some((named_power(base)?.0, digits)),
            _ => None,
        },
        _ => None,
    }
}

/// The two factors of `cross(a, b)`.
pub(crate) fn cross_product(value: &Expression) -> Option<[&Expression; 2]> {
    match &value.kind {
        ExpressionKind::Call(path, arguments) if path.last == "cross" => arguments.iter().collect::<Vec<_>>().try_into().ok(),
        _ => None,
    }
}

/// The turns about x, y and z by three angles that are written as a vector.
pub(crate) fn by_turns(value: &Expression) -> Option<String> {
    let ExpressionKind::Tuple(angles) = &value.kind else { return None };
    let [x, y, z] = angles.as_slice() else { return None };
    let is_angle = |value: &Expression| match &value.kind {
        ExpressionKind::Number { unit, .. } => quantity::unit(unit).is_some_and(|(_, dim)| dim == Dim::ANGLE && !unit.is_empty()),
        _ => false,
    };
    if !angles.iter().any(is_angle) || !angles.iter().all(|angle| is_angle(angle) || is_zero(angle)) {
        return None;
    }
    Some(format!("turn((1, 0, 0), {x}) * turn((0, 1, 0), {y}) * turn((0, 0, 1), {z})"))
}

/// A step between two values, or a ramp, as other programs write them, as a law: `STEP(t, 0, 0, 1, height)`, `ramp(t, speed)`.
pub(crate) fn by_law(name: &Ident, arguments: &[Expression]) -> Option<String> {
    let law = match name.to_string().to_lowercase().as_str() {
        "step" => "smooth_step",
        "step5" => "polynomial_345",
        "havsin" => "harmonic",
        "ramp" => {
            return if let [variable, rate] = arguments { Some(format!("{} * {}", as_factor(rate), as_operand(variable))) } else { None };
        }
        _ => return None,
    };
    let [variable, from, low, to, high] = arguments else { return None };
    let is_time = variable.name().is_some_and(|name| name == "t" || name.to_string().eq_ignore_ascii_case("time"));
    let variable = if is_time { "t".to_owned() } else { as_operand(variable) };
    let end = |value: &Expression| format!("{}{}", as_operand(value), if is_time && is_bare(value) { "s" } else { "" });
    let share = match is_zero(from) {
        true => format!("{variable} / {}", end(to)),
        false => format!("({variable} - {}) / ({} - {})", end(from), end(to), end(from)),
    };
    Some(match is_zero(low) {
        true => format!("{} * {law}({share})", in_degrees(high).unwrap_or_else(|| as_factor(high))),
        false => {
            let [from, to] = [low, high].map(|value| in_degrees(value).unwrap_or_else(|| value.to_string()));
            let less = in_degrees(low).unwrap_or_else(|| as_operand(low));
            format!("{from} + ({to} - {less}) * {law}({share})")
        }
    })
}

/// The point at which a force may act that depends on a body: the first `body.P` in it, or `body.position`.
///
/// * `is_body`: given, true for the name of a body.
pub(crate) fn place_in(value: &Expression, is_body: impl Fn(&str) -> bool) -> Option<String> {
    let mut found = None;
    value.each(&mut |part| {
        if let ExpressionKind::Field(owner, name) = &part.kind
            && let Some(body) = owner.name().map(ToString::to_string).filter(|body| is_body(body))
        {
            let is_point = name.to_string().starts_with(char::is_uppercase);
            found.get_or_insert(if is_point { format!("{body}.{name}") } else { format!("{body}.position") });
        }
    });
    found
}

/// `90d` and `-90d`, angles in Adams.
fn in_degrees(value: &Expression) -> Option<String> {
    match &value.kind {
        ExpressionKind::Number { digits, unit } if unit == "d" || unit == "D" => Some(format!("{digits}deg")),
        ExpressionKind::Negative(inner) => in_degrees(inner).map(|angle| format!("(-{angle})")),
        _ => None,
    }
}

/// A value on the left of a product or a quotient.
pub(super) fn as_factor(value: &Expression) -> String {
    match value.kind {
        ExpressionKind::Binary(Operator::Add | Operator::Sub, ..) | ExpressionKind::If { .. } => format!("({value})"),
        _ => value.to_string(),
    }
}

/// A value on the right of any operator.
fn as_operand(value: &Expression) -> String {
    if matches!(value.kind, ExpressionKind::Binary(..) | ExpressionKind::Negative(_)) { format!("({value})") } else { as_factor(value) }
}

/// A law of the time that lacks the unit of an angular velocity: `2 * pi * t` as `2 * pi * 1rad_s * t`.
pub(crate) fn with_rate(value: &Expression) -> Option<String> {
    let ExpressionKind::Binary(Operator::Mul, factor, time) = &value.kind else { return None };
    let is_time = time.name().is_some_and(|name| name == "t");
    (is_time && !matches!(factor.kind, ExpressionKind::Number { .. })).then(|| format!("{} * 1rad_s * t", as_factor(factor)))
}

/// True for a literal zero, as a number or as a vector.
pub(crate) fn is_zero(value: &Expression) -> bool {
    match &value.kind {
        ExpressionKind::Number { digits, .. } => digits.parse() == Ok(0.0),
        ExpressionKind::Tuple(items) => items.iter().all(is_zero),
        _ => false,
    }
}

/// The body of `body.orientation`.
pub(crate) fn orientation_of(value: &Expression) -> Option<String> {
    match &value.kind {
        ExpressionKind::Field(body, name) if name == "orientation" => Some(body.to_string()),
        _ => None,
    }
}

/// A product of a length or an angle and `t`, as `10mm * t`, with the number as a rate: `10mm_s * t`.
pub(crate) fn by_time(value: &Expression) -> Option<(&Expression, Dim, String)> {
    match &value.kind {
        ExpressionKind::Negative(inner) => by_time(inner),
        ExpressionKind::Binary(Operator::Add | Operator::Sub, lhs, rhs) => by_time(lhs).or_else(|| by_time(rhs)),
        ExpressionKind::Binary(Operator::Mul, lhs, rhs) => {
            let is_time = |side: &Expression| matches!(&side.kind, ExpressionKind::Path(path) if path.last == "t");
            let number = if is_time(rhs) { lhs } else { Some(rhs).filter(|_| is_time(lhs))? };
            let ExpressionKind::Number { digits, unit } = &number.kind else { return None };
            let dim = quantity::unit(unit)?.1;
            let rate = format!("{unit}_s");
            (quantity::unit(&rate)?.1.times(Dim::TIME) == dim).then(|| (number.as_ref(), dim, format!("{digits}{rate} * t")))
        }
        _ => None,
    }
}

/// Text of a constant: a number with a unit as written, anything else by its value in SI.
pub(crate) fn in_words(written: &Expression, value: f64, dim: Dim) -> String {
    let (sign, inner) = match &written.kind {
        ExpressionKind::Negative(inner) => ("-", &inner.kind),
        kind => ("", kind),
    };
    match inner {
        ExpressionKind::Number { digits, unit } if !unit.is_empty() => format!("{sign}{digits} {unit}"),
        _ => format!("{value} {}", dim.unit()).trim_end().to_owned(),
    }
}

/// A number without a unit that is a factor of an expression, or of its first term.
fn bare_factor(value: &Expression) -> Option<String> {
    match &value.kind {
        ExpressionKind::Number { digits, unit } => unit.is_empty().then(|| digits.clone()),
        ExpressionKind::Negative(inner) => bare_factor(inner),
        ExpressionKind::Binary(Operator::Mul, lhs, rhs) => bare_factor(lhs).or_else(|| bare_factor(rhs)),
        ExpressionKind::Binary(Operator::Add | Operator::Sub | Operator::Div, lhs, _) => bare_factor(lhs),
        _ => None,
    }
}

/// The name of a factor of a product.
fn factor_name(value: &Expression) -> Option<String> {
    let without_sign = |value: &'_ Expression| match &value.kind {
        ExpressionKind::Negative(inner) => inner.name().map(ToString::to_string),
        _ => value.name().map(ToString::to_string),
    };
    match &value.kind {
        ExpressionKind::Negative(inner) => factor_name(inner),
        ExpressionKind::Binary(Operator::Mul, lhs, rhs) => without_sign(lhs).or_else(|| without_sign(rhs)),
        _ => None,
    }
}

/// The factor of a term of a controller: a number without a unit, or a name.
pub(crate) fn gain(value: &Expression) -> Option<String> {
    bare_factor(value).or_else(|| factor_name(value))
}

/// True for a number without a unit, or a list of some.
pub(crate) fn is_bare(value: &Expression) -> bool {
    match &value.kind {
        ExpressionKind::Number { unit, .. } => unit.is_empty(),
        ExpressionKind::Tuple(items) => items.iter().all(is_bare),
        _ => false,
    }
}

/// The number or the name beside `t` in a product.
pub(crate) fn without_time(value: &Expression) -> Option<String> {
    let ExpressionKind::Binary(Operator::Mul, one, two) = &value.kind else { return None };
    let is_simple = |side: &Expression| matches!(side.kind, ExpressionKind::Number { .. } | ExpressionKind::Path(_));
    if !is_simple(one) || !is_simple(two) {
        return None;
    }
    let is_time = |side: &Expression| side.name().is_some_and(|name| name == "t");
    match (is_time(one), is_time(two)) {
        (false, true) => Some(one.to_string()),
        (true, false) => Some(two.to_string()),
        _ => None,
    }
}

/// Adds to an error about a dimension what was probably meant.
///
/// * `declared`: given, an expression in which a declared name stands like a unit, that name, and the number with the unit.
/// * `written`: given, an expression in the place of a quantity of this dimension.
pub(crate) fn noted(
    declared: &Option<(Range, String, String)>,
    fact: ValueFact,
    range: Range,
    written: Option<(&Expression, Dim)>,
) -> Fact {
    let fact = Box::new(Fact::from(fact));
    let (start, end) = (range.first.start(), range.last.end());
    if let Some((within, name, instead)) = declared
        && start == within.first.start()
        && within.last.end() <= end
    {
        return Fact::Noted { fact, note: Note::DeclaredUnit { name: name.clone(), instead: instead.clone() } };
    }
    match written.and_then(|(written, wanted)| with_unit(written, wanted)) {
        Some([number, instead]) => Fact::Noted { fact, note: Note::BareFactor { number, instead } },
        None => *fact,
    }
}

/// Adds to the refusal of a default the bounds that lack its unit. A bound of 0 needs none.
pub(crate) fn with_bare_bounds(fact: ValueFact, default: &Expression, limits: Option<&Limits>) -> Fact {
    let fact = Fact::from(fact);
    let bounds = limits.into_iter().flat_map(|limits| limits.from.iter().chain(&limits.to));
    match (&default.kind, bounds.filter_map(bare_factor).next_back()) {
        (ExpressionKind::Number { unit, .. }, Some(number)) if !unit.is_empty() && number != "0" => {
            let note = Note::BareFactor { instead: format!("{number}{unit}"), number };
            Fact::Noted { fact: Box::new(fact), note }
        }
        _ => fact,
    }
}

/// Adds to the refusal of an equation of a rate and a product with `t` that the factor `t` is superfluous: `arm.angular_velocity == 60rpm * t`.
pub(crate) fn with_time_too_much(fact: Fact, sides: [&Expression; 2], dims: [Dim; 2]) -> Fact {
    let grown = |rate: usize, other: usize| dims[rate].times(Dim::TIME) == dims[other];
    let late = [(0, 1), (1, 0)].into_iter().find(|(rate, other)| grown(*rate, *other)).and_then(|(_, late)| without_time(sides[late]));
    match late.filter(|_| !matches!(fact, Fact::Noted { .. })) {
        Some(written) => Fact::Noted { fact: Box::new(fact), note: Note::WithoutTime { written } },
        None => fact,
    }
}

/// The number that lacks a unit where a quantity of dimension `wanted` is, with the usual unit.
pub(crate) fn with_unit(value: &Expression, wanted: Dim) -> Option<[String; 2]> {
    const USUAL: [(Dim, &str); 5] = [(Dim::LENGTH, "mm"), (Dim::FORCE, "N"), (Dim::TORQUE, "Nm"), (Dim::MASS, "kg"), (Dim::TIME, "s")];
    let (_, unit) = USUAL.into_iter().find(|(dim, _)| *dim == wanted)?;
    let number = bare_factor(value)?;
    let instead = format!("{number}{unit}");
    Some([number, instead])
}

/// The digits of a number in mm, as the length that was probably meant.
pub(crate) fn in_millimetres(written: &Expression) -> Option<String> {
    match &written.kind {
        ExpressionKind::Number { digits, .. } => Some(format!("{digits}mm")),
        _ => None,
    }
}

/// Parameter on one side of a condition: `P`, or `P.body`.
pub(crate) fn argument_of(side: &Expression) -> Option<&Ident> {
    match &side.kind {
        ExpressionKind::Path(path) => path.name.as_ref(),
        ExpressionKind::Field(owner, _) => argument_of(owner),
        _ => None,
    }
}

/// Source range of the argument on one side of a condition.
pub(crate) fn place_of_argument(side: &Expression, places: &[(String, Range)]) -> Option<Range> {
    let name = argument_of(side)?;
    places.iter().find(|(known, _)| name == known).map(|(_, range)| *range)
}

/// True if an expression is surely no whole number: it contains a number with a unit or a fraction, π, `t` or an angle.
pub(crate) fn is_measured(value: &Expression) -> bool {
    match &value.kind {
        ExpressionKind::Number { digits, unit } => !unit.is_empty() || digits.contains('.'),
        ExpressionKind::Path(path) => path.last == "t" || path.last == "pi",
        ExpressionKind::Field(_, name) => name == "angle",
        ExpressionKind::Negative(inner) => is_measured(inner),
        ExpressionKind::Binary(_, lhs, rhs) => is_measured(lhs) || is_measured(rhs),
        _ => false,
    }
}

/// The first number with a decimal comma among components: `60, 5mm` as `60.5mm`.
pub(crate) fn decimal_comma<'a>(items: impl Iterator<Item = &'a Expression>) -> Option<String> {
    let digits_of = |item: &Expression| match &item.kind {
        ExpressionKind::Number { digits, unit } if digits.bytes().all(|digit| digit.is_ascii_digit()) => {
            Some((digits.clone(), unit.clone()))
        }
        _ => None,
    };
    let items: Vec<_> = items.map(digits_of).collect();
    items.windows(2).find_map(|pair| {
        let [(whole, none), (fraction, unit)] = [pair[0].as_ref()?, pair[1].as_ref()?];
        (none.is_empty() && !unit.is_empty()).then(|| format!("{whole}.{fraction}{unit}"))
    })
}
