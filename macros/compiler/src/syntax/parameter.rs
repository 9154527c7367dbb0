//! Parses parameters and inputs, and bounds.

use super::ast::{Docs, Expression, ExpressionKind, Limits, ParameterItem, Relation};
use super::dimension::required_dimension;
use super::expression::{declared, expression, in_brackets, relation};
use super::tokens::{Parsed, equals, expected, keyword, semicolon, wrong};
use crate::diag::{GrammarFact, Range};
use crate::quantity::{self, Dim};
use proc_macro2::Ident;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Token, token};

/// `param name: Dimension = default;`
pub(super) fn parameter(input: ParseStream, docs: Docs) -> Parsed<ParameterItem> {
    Ident::parse_any(input)?;
    let (name, indices) = declared(input, "the name of the parameter")?;
    if input.peek(Token![=]) {
        return without_dimension(input, (&name, &indices));
    }
    let dimension = required_dimension(input)?;
    if !input.peek(Token![=]) {
        return expected(input, "`=` and the default of the parameter");
    }
    equals(input)?;
    let default = expression(input)?;
    no_least_and_greatest(input, &default)?;
    no_comparison(input, &default)?;
    let limits = if input.peek(Token![in]) { Some(limits(input)?) } else { None };
    semicolon(input)?;
    Ok(ParameterItem { docs, name, indices, dimension, default, limits })
}

/// Refuses `param a = 50mm;`.
fn without_dimension<T>(input: ParseStream, (name, indices): (&Ident, &[Expression])) -> Parsed<T> {
    let (ahead, range) = (input.fork(), input.span());
    equals(&ahead)?;
    let default = expression(&ahead)?;
    let unit = match &default.kind {
        ExpressionKind::Number { unit, .. } if unit.is_empty() => Some(Dim::NUMBER),
        ExpressionKind::Number { unit, .. } => quantity::unit(unit).map(|(_, dim)| dim),
        _ => None,
    };
    let dimension = Dim::names().find(|known| unit.is_some() && Dim::named(known) == unit);
    let bounds = if ahead.peek(Token![in]) { " in …" } else { "" };
    let default = dimension.map(|dimension| (dimension, format!("{default}{bounds}")));
    let name = format!("{name}{}", in_brackets(indices));
    wrong(range, GrammarFact::ParameterWithoutDimension { name, default })
}

/// Refuses `50mm min 10mm max 60mm`.
fn no_least_and_greatest(input: ParseStream, default: &Expression) -> Parsed<()> {
    let ahead = input.fork();
    let mut ends = [None, None];
    while let Some(place) = keyword(&ahead).and_then(|word| ["min", "max"].iter().position(|known| word == known)) {
        Ident::parse_any(&ahead)?;
        ahead.parse::<Option<Token![=]>>()?;
        ends[place] = Some(expression(&ahead)?.to_string());
    }
    if ends == [None, None] {
        return Ok(());
    }
    let [least, greatest] = ends;
    let is_closed = if greatest.is_some() { "=" } else { "" };
    let instead = format!("{default} in {}..{is_closed}{}", least.unwrap_or_default(), greatest.unwrap_or_default());
    wrong(input.span(), GrammarFact::Misspelt { flaw: "bounds come after `in`", instead })
}

/// Refuses `40mm >= 10mm` as a default with a bound.
fn no_comparison(input: ParseStream, default: &Expression) -> Parsed<()> {
    let ahead = input.fork();
    let Ok(relation) = relation(&ahead) else { return Ok(()) };
    let bound = expression(&ahead)?;
    let instead = match relation {
        Relation::Greater | Relation::GreaterOrEqual => format!("{default} in {bound}.."),
        Relation::Less => format!("{default} in ..{bound}"),
        Relation::LessOrEqual => format!("{default} in ..={bound}"),
        Relation::Equal | Relation::Different => return Ok(()),
    };
    wrong(input.span(), GrammarFact::Misspelt { flaw: "bounds come after `in`", instead })
}

/// `input name: Dimension = start;`; without a start it begins at 0.
pub(super) fn input_item(input: ParseStream, docs: Docs) -> Parsed<ParameterItem> {
    Ident::parse_any(input)?;
    let (name, indices) = declared(input, "the name of the input")?;
    no_drive(input, &name)?;
    if input.peek(Token![=]) {
        return without_dimension(input, (&name, &indices));
    }
    let dimension = required_dimension(input)?;
    if input.peek(token::Paren) {
        let [(word, 1)] = dimension.factors.as_slice() else { return expected(input, "`=` or `;`") };
        let instead = format!("input {name}{}: {word} = …;", in_brackets(&indices));
        return wrong(dimension.range, GrammarFact::Misspelt { flaw: "an input changes with time by itself", instead });
    }
    let default = if input.peek(Token![=]) {
        equals(input)?;
        expression(input)?
    } else {
        Expression { kind: ExpressionKind::Number { digits: "0".into(), unit: String::new() }, range: Range::from(&name), depth: 1 }
    };
    let limits = if input.peek(Token![in]) { Some(limits(input)?) } else { None };
    semicolon(input)?;
    Ok(ParameterItem { docs, name, indices, dimension, default, limits })
}

/// Refuses `input name = drive_angle(…)`.
fn no_drive(input: ParseStream, name: &Ident) -> Parsed<()> {
    let ahead = input.fork();
    let call = ahead.parse::<Token![=]>().ok().and_then(|_| ahead.parse::<Ident>().ok()).filter(|_| ahead.peek(token::Paren));
    match call.filter(|call| call.to_string().starts_with("drive_")) {
        Some(call) => {
            let is_angle = ["angle", "rotation"].iter().any(|word| call.to_string().contains(word));
            let dimension = if is_angle { "Angle" } else { "Length" };
            let instead = format!("input {name}: {dimension}; drive d = {call}(…, {name});");
            wrong(input.span(), GrammarFact::Misspelt { flaw: "an input is a quantity, which a drive may follow", instead })
        }
        None => Ok(()),
    }
}

/// A number as it is written, and its unit.
fn measured(value: &Expression) -> Option<(f64, &str)> {
    match &value.kind {
        ExpressionKind::Number { digits, unit } => Some((digits.parse().ok()?, unit)),
        ExpressionKind::Negative(inner) => measured(inner).map(|(number, unit)| (-number, unit)),
        _ => None,
    }
}

/// `in from..to`, `in from..=to`, or one of them with one end
pub(super) fn limits(input: ParseStream) -> Parsed<Limits> {
    input.parse::<Token![in]>()?;
    let mut range = Range::from(input.span());
    let from = if input.peek(Token![..]) { None } else { Some(expression(input)?) };
    let is_inclusive = input.peek(Token![..=]);
    if is_inclusive {
        range = range.to(input.parse::<Token![..=]>()?.spans[2]);
    } else if input.peek(Token![..]) {
        range = range.to(input.parse::<Token![..]>()?.spans[1]);
    } else {
        if let Some(Expression { kind: ExpressionKind::List(ends) | ExpressionKind::Tuple(ends), range, .. }) = &from
            && let [least, greatest] = ends.as_slice()
        {
            let instead = format!("in {least}..={greatest}");
            return wrong(*range, GrammarFact::Misspelt { flaw: "bounds stand on both sides of `..=`", instead });
        }
        return expected(input, "`..` or `..=` and the greatest value");
    }
    let is_open = input.peek(Token![;]);
    if is_open && (is_inclusive || from.is_none()) {
        return expected(input, "the greatest value");
    }
    let to = if is_open { None } else { Some(expression(input)?) };
    let range = to.as_ref().map_or(range, |to| range.to(to.range));
    // In SI no value lies between them.
    if let (Some(from), Some(to)) = (&from, &to)
        && let (Some((least, "")), Some((greatest, unit))) = (measured(from), measured(to))
        && let Some((size, _)) = quantity::unit(unit)
        && least < greatest
        && least > greatest * size.to_f64()
    {
        let dots = if is_inclusive { "..=" } else { ".." };
        let flaw = "each bound has a unit of its own";
        return wrong(from.range, GrammarFact::Misspelt { flaw, instead: format!("in {from}{unit}{dots}{to}") });
    }
    Ok(Limits { from, to, is_inclusive, range })
}
