//! Parses outputs.

use super::ast::{Docs, ExpressionKind, OutputItem};
use super::expression::{declared, equals_behind, expression, in_brackets};

use super::dimension::dimension;
use super::tokens::{Parsed, expected, keyword, semicolon, wrong};
use crate::diag::GrammarFact;
use proc_macro2::Ident;
use syn::Token;
use syn::ext::IdentExt;
use syn::parse::ParseStream;

/// `output name = value;` or `slice output name = value with jerk;`
pub(super) fn output(input: ParseStream, docs: Docs) -> Parsed<OutputItem> {
    let is_slice = Ident::parse_any(input)? == "slice";
    if is_slice {
        if keyword(input).is_none_or(|word| word != "output") {
            return expected(input, "`output`, `joint`, `drive` or `force` after `slice`");
        }
        Ident::parse_any(input)?;
    }
    let before = input.fork();
    if !input.peek(syn::Ident) && !input.peek(Token![_]) && expression(&before.fork()).is_ok() {
        let value = expression(&before)?;
        if let ExpressionKind::List(names) = &value.kind
            && before.parse::<Option<Token![=]>>()?.is_some()
            && let ExpressionKind::Tuple(values) | ExpressionKind::List(values) = expression(&before)?.kind
            && names.len() == values.len()
        {
            let each = names.iter().zip(&values).map(|(name, value)| format!("output {name} = {value};"));
            let instead = each.collect::<Vec<_>>().join(" ");
            return wrong(value.range, GrammarFact::Misspelt { flaw: "every output has a name and a value of its own", instead });
        }
        return wrong(value.range, GrammarFact::OutputWithoutName { value: value.to_string() });
    }
    let (name, indices) = declared(input, "the name of the output")?;
    if input.peek(Token![:]) {
        let colon = input.span();
        input.parse::<Token![:]>()?;
        return wrong(
            dimension(input).map_or(colon.into(), |dimension| dimension.range),
            GrammarFact::OutputWithDimension { name: name.to_string() },
        );
    }
    if input.peek(Token![.]) || input.peek(Token![;]) {
        let value = expression(&before)?;
        if before.peek(Token![=]) && !before.peek(Token![==]) {
            before.parse::<Token![=]>()?;
            let instead = format!("output {} = {};", value.to_string().replace('.', "_"), expression(&before)?);
            return wrong(value.range, GrammarFact::Misspelt { flaw: "the name of an output is one word", instead });
        }
        return wrong(value.range, GrammarFact::OutputWithoutName { value: value.to_string() });
    }
    equals_behind(input, format_args!("output {name}{}", in_brackets(&indices)))?;
    let (value, jerk) = (expression(input)?, with_jerk(input)?);
    semicolon(input)?;
    Ok(OutputItem { docs, is_slice, name, indices, value, jerk })
}

/// `with jerk`
fn with_jerk(input: ParseStream) -> Parsed<Option<Ident>> {
    if keyword(input).is_none_or(|word| word != "with") {
        return Ok(None);
    }
    Ident::parse_any(input)?;
    match keyword(input) {
        Some(word) if word == "jerk" => Ok(Some(Ident::parse_any(input)?)),
        _ => expected(input, "`jerk` after `with`"),
    }
}
