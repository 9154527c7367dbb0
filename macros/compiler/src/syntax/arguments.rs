//! Parses the arguments of joints, forces and parts.

use super::ast::{Argument, Expression};
use super::expression::expression;
use super::slip::{law_as_closure, no_word_behind};
use super::tokens::{Parsed, comma, name, parentheses, wrong};
use crate::diag::GrammarFact;
use syn::Token;
use syn::parse::ParseStream;

/// `(value, name: value, …)`
pub(super) fn arguments(input: ParseStream) -> Parsed<Vec<Argument>> {
    let (content, _) = parentheses(input)?;
    let mut arguments = Vec::new();
    while !content.is_empty() {
        arguments.push(argument(&content)?);
        if let Some(Argument { name, value }) = arguments.last() {
            if name.is_none() {
                no_equation(&content, value)?;
            }
            no_word_behind(&content, value)?;
        }
        comma(&content, "`,` or `)`")?;
    }
    Ok(arguments)
}

/// Refuses `revolute(crank.B == rod.position)`.
fn no_equation(input: ParseStream, value: &Expression) -> Parsed<()> {
    if !input.peek(Token![==]) {
        return Ok(());
    }
    let ahead = input.fork();
    ahead.parse::<Token![==]>()?;
    let other = expression(&ahead)?;
    let instead = format!("{value}, {other}");
    wrong(value.range.to(other.range), GrammarFact::Misspelt { flaw: "arguments are separated by commas", instead })
}

/// `value` or `name: value`
fn argument(input: ParseStream) -> Parsed<Argument> {
    let is_named = input.peek(syn::Ident) && input.peek2(Token![:]) && !input.peek2(Token![::]);
    if input.peek(syn::Ident) && input.peek2(Token![=]) && !input.peek2(Token![==]) {
        let name = name(input, "the name of the argument")?;
        if input.peek(Token![=>]) {
            let arrow = input.parse::<Token![=>]>()?;
            return wrong(arrow.spans[0], law_as_closure(&name.to_string(), &expression(input)?));
        }
        return wrong(input.span(), GrammarFact::ArgumentByEquals { name: name.to_string() });
    }
    if !is_named {
        return Ok(Argument { name: None, value: expression(input)? });
    }
    let name = name(input, "the name of the argument")?;
    input.parse::<Token![:]>()?;
    Ok(Argument { name: Some(name), value: expression(input)? })
}
