//! Parses joints, drives, freedoms, forces and energies.

use super::arguments::arguments;
use super::ast::{Docs, Expression, FreedomItem, JointBody, JointItem};
use super::definition::statement;
use super::expression::{declared, equals_behind, expression, in_brackets, value};
use super::tokens::{Parsed, braces, equals, expected, keyword, name, next, path, semicolon, statement_text, wrong};
use crate::diag::{GrammarFact, MotionFact, Word};
use crate::quantity::Ambient;
use crate::words::home;
use proc_macro2::{Ident, TokenTree};
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Token, token};

/// `joint name = …;`, `redundant joint name = …;` or `drive name = …;`
pub(super) fn joint(input: ParseStream, docs: Docs) -> Parsed<JointItem> {
    let mut word = Ident::parse_any(input)?;
    let is_redundant = word == "redundant";
    if is_redundant {
        if keyword(input).is_none_or(|word| word != "joint") {
            return expected(input, "`joint`: only a joint can be redundant");
        }
        word = Ident::parse_any(input)?;
    }
    let is_drive = word == "drive";
    let word = match word.to_string().as_str() {
        "drive" => Word::Drive,
        "force" => Word::Force,
        _ => Word::Joint,
    };
    let what = match word {
        Word::Joint => "the name of the joint",
        Word::Drive => "the name of the drive",
        Word::Force => "the name of the force",
    };
    let before = input.fork();
    let (name, indices) = declared(input, what)?;
    if input.peek(token::Paren) {
        return wrong(&name, GrammarFact::Unnamed { word, kind: name.to_string() });
    }
    if input.peek(syn::Ident) && input.peek2(token::Paren) {
        let (found, second) = (next(input), input.parse::<Ident>()?);
        let is_kind = |word: &Ident| word.to_string().starts_with("drive_") || home(&word.to_string(), Ambient::Plane).is_some();
        if is_kind(&second) && !is_kind(&name) {
            let instead = format!("{word} {name}{} = {second}{};", in_brackets(&indices), statement_text(input)?);
            return wrong(&second, GrammarFact::WithoutEquals { found, instead });
        }
        let instead = format!("{word} {second} = {name}(…);");
        return wrong(&name, GrammarFact::Misspelt { flaw: "the name comes first, and the kind behind `=`", instead });
    }
    // `drive crank.angle = …`
    if input.peek(Token![.]) && word == Word::Drive {
        let value = expression(&before)?;
        return wrong(value.range, MotionFact::DriveWithoutName { value: value.to_string() });
    }
    // `joint crank.A = rod.position`
    if input.peek(Token![.]) && word == Word::Joint {
        let value = expression(&before)?;
        before.parse::<Token![=]>()?;
        before.parse::<Option<Token![=]>>()?;
        let instead = format!("joint name = {{ {value} == {}; }}", expression(&before)?);
        return wrong(value.range, GrammarFact::Misspelt { flaw: "a joint has a name, and equations stand in braces", instead });
    }
    if input.peek(token::Brace) {
        return expected(input, "`=` before the braces");
    }
    if let Some(place) = keyword(input).filter(|place| word == Word::Force && (place == "at" || place == "on")) {
        Ident::parse_any(input)?;
        let (target, _) = (expression(input)?, equals(input)?);
        let clause = format!("{place} {target}: {}", expression(input)?);
        return wrong(&place, GrammarFact::ForceBeforePlace { name: name.to_string(), clause });
    }
    equals_behind(input, format_args!("{word} {name}{}", in_brackets(&indices)))?;
    let body = match () {
        () if input.peek(token::Brace) => equations(input)?,
        () if is_value(input, word) => bare(input, word, &name)?,
        () => instance(input)?,
    };
    Ok(JointItem { docs, is_drive, is_redundant, is_slice: false, velocity: None, name, indices, body })
}

/// `freedom name = value from start at rate;`
pub(super) fn freedom(input: ParseStream, docs: Docs) -> Parsed<JointItem> {
    Ident::parse_any(input)?;
    let before = input.fork();
    let (name, indices) = declared(input, "the name of the freedom")?;
    if input.peek(Token![.]) {
        let value = expression(&before)?;
        return wrong(value.range, MotionFact::FreedomWithoutName { value: value.to_string() });
    }
    equals_behind(input, format_args!("freedom {name}{}", in_brackets(&indices)))?;
    let value = expression(input)?;
    if input.peek(Token![=]) && !input.peek(Token![==]) {
        let sign = input.span();
        input.parse::<Token![=]>()?;
        return wrong(sign, MotionFact::StartWithEquals { value: value.to_string(), start: expression(input)?.to_string() });
    }
    let is_number = |behind: Option<(TokenTree, _)>| matches!(behind, Some((TokenTree::Literal(_), _)));
    if input.peek(Token![,]) && input.cursor().punct().is_some_and(|(_, behind)| is_number(behind.token_tree())) {
        let comma = input.parse::<Token![,]>()?.spans[0];
        let instead = format!("{value} from {}", expression(input)?);
        return wrong(comma, GrammarFact::Misspelt { flaw: "the value at t = 0 comes after `from`", instead });
    }
    let clause = |word: &str| -> Parsed<Option<Expression>> {
        if keyword(input).is_none_or(|found| found != word) {
            return Ok(None);
        }
        Ident::parse_any(input)?;
        expression(input).map(Some)
    };
    let (from, at) = (clause("from")?, clause("at")?);
    if let (Some(from), None, true) = (&from, &at, input.peek(Token![,])) {
        let comma = input.parse::<Token![,]>()?.spans[0];
        if keyword(input).is_some_and(|word| word == "at") {
            Ident::parse_any(input)?;
        }
        let instead = format!("{value} from {from} at {}", expression(input)?);
        return wrong(comma, GrammarFact::Misspelt { flaw: "the rate at t = 0 comes after `at`", instead });
    }
    if let (None, Some(at), Some(late)) = (&from, &at, clause("from")?) {
        let (range, value) = (at.range.to(late.range), value.to_string());
        let is_rate = |number: &Expression| match &number.kind {
            super::ast::ExpressionKind::Number { unit, .. } => unit.contains("_s") || unit == "rpm",
            _ => false,
        };
        // Either the order is wrong or the words are.
        let (from, at) = if is_rate(&late) && !is_rate(at) { (at, &late) } else { (&late, at) };
        return wrong(range, MotionFact::RateBeforeStart { value, from: from.to_string(), at: at.to_string() });
    }
    if !input.peek(Token![;]) && keyword(input).is_some() {
        return expected(input, "`from` and the value at t = 0, `at` and the rate at t = 0, or `;`");
    }
    semicolon(input)?;
    let body = JointBody::Freedom(Box::new(FreedomItem { value, from, at }));
    Ok(JointItem { docs, is_drive: true, is_redundant: false, is_slice: false, velocity: None, name, indices, body })
}

/// `energy name = value;`
pub(super) fn energy(input: ParseStream, docs: Docs) -> Parsed<JointItem> {
    Ident::parse_any(input)?;
    let (name, indices) = declared(input, "the name of the energy")?;
    let ahead = input.fork();
    if ahead.parse::<Option<Token![=]>>()?.is_some() && ahead.peek(token::Brace) {
        let (content, range) = braces(&ahead)?;
        if let Ok(value) = expression(&content)
            && (content.is_empty() || content.peek(Token![;]) && content.cursor().token_tree().is_some_and(|(_, rest)| rest.eof()))
        {
            let instead = format!("energy {name} = {value};");
            return wrong(range, GrammarFact::Misspelt { flaw: "an energy is one value, without braces", instead });
        }
    }
    let body = JointBody::Energy(Box::new(value(input, format_args!("energy {name}{}", in_brackets(&indices)))?));
    Ok(JointItem { docs, is_drive: true, is_redundant: false, is_slice: false, velocity: None, name, indices, body })
}

/// `{ lhs == rhs; … }`, with or without a semicolon after it.
fn equations(input: ParseStream) -> Parsed<JointBody> {
    let (content, _) = braces(input)?;
    let mut statements = Vec::new();
    while !content.is_empty() {
        statements.push(statement(&content)?);
    }
    if input.peek(Token![;]) {
        input.parse::<Token![;]>()?;
    }
    Ok(JointBody::Equations(statements))
}

/// True if an expression follows that is no call of a constraint or a force.
fn is_value(input: ParseStream, word: Word) -> bool {
    if input.peek2(Token![::]) || input.peek(Token![::]) {
        return false;
    }
    if !input.peek(syn::Ident::peek_any) {
        return !input.is_empty() && !input.peek(Token![;]) && !input.peek(token::Bracket);
    }
    let is_alone = input.peek2(Token![;]);
    let is_choice = word == Word::Force && input.peek(Token![if]);
    let is_operand = [input.peek2(Token![*]), input.peek2(Token![/]), input.peek2(Token![+]), input.peek2(Token![-])];
    is_choice || input.peek2(Token![.]) || input.peek2(Token![^]) || is_operand.contains(&true) || is_alone && word == Word::Force
}

/// `value;`, for a message about it, or an equation that lacks its braces.
fn bare(input: ParseStream, word: Word, name: &Ident) -> Parsed<JointBody> {
    let value = expression(input)?;
    if input.peek(Token![==]) {
        input.parse::<Token![==]>()?;
        let other = expression(input)?;
        let fact = MotionFact::EquationWithoutBraces { word, name: name.to_string(), equation: format!("{value} == {other}") };
        return wrong(value.range.to(other.range), fact);
    }
    if let Some(place) = keyword(input).filter(|place| word == Word::Force && (place == "at" || place == "on")) {
        Ident::parse_any(input)?;
        let clause = format!("{place} {}: {value}", expression(input)?);
        return wrong(value.range, GrammarFact::ForceBeforePlace { name: name.to_string(), clause });
    }
    semicolon(input)?;
    Ok(JointBody::Value(Box::new(value)))
}

/// `kind(arguments);`
fn instance(input: ParseStream) -> Parsed<JointBody> {
    if input.peek(Token![::]) || input.peek2(Token![::]) {
        let path = path(input)?;
        let text = path.tokens.to_string().replace(' ', "");
        return wrong(path.range, GrammarFact::PathOfConstraint { path: text, last: path.last.to_string() });
    }
    let kind = name(input, "a constraint such as `revolute(…)`, or `{ lhs == rhs; }`")?;
    if !input.peek(token::Paren) {
        if kind == "redundant" && input.peek(syn::Ident) {
            let instead = format!("redundant joint name = {}(…);", name(input, "a constraint")?);
            return wrong(kind.span(), GrammarFact::Misspelt { flaw: "`redundant` stands before `joint`", instead });
        }
        return expected(input, "`(` and the arguments");
    }
    let arguments = arguments(input)?;
    semicolon(input)?;
    Ok(JointBody::Of { kind, arguments })
}
