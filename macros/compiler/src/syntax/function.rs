//! Parses functions of one variable.

use super::ast::FunctionItem;
use super::dimension::{dimension, dimension_of_value, required_dimension};
use super::expression::{expression, value};
use super::tokens::{Parsed, docs, equals, expected, name, parentheses, report, wrong};
use crate::diag::{Diag, GrammarFact};
use crate::quantity::Dim;
use crate::words::usual_dimension;
use proc_macro2::Ident;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Token, token};

/// Parses a single function with its doc comment.
pub(super) fn single_function(input: ParseStream, diag: &mut Diag) -> Option<FunctionItem> {
    report(docs(input).and_then(|_| function(input)), diag)
}

/// `function name(argument: Dimension) -> Dimension = value;`
pub(super) fn function(input: ParseStream) -> Parsed<FunctionItem> {
    Ident::parse_any(input)?;
    let name = name(input, "the name of the function")?;
    if !input.peek(token::Paren) {
        return expected(input, "`(argument: Dimension)`");
    }
    let (content, _) = parentheses(input)?;
    let argument = content.cursor().token_stream().to_string().replace(" :", ":");
    let is_named = content.peek2(Token![:]) && !content.peek2(Token![::]);
    if !is_named
        && input.peek(Token![->])
        && argument.starts_with(char::is_lowercase)
        && argument.bytes().all(|letter| letter.is_ascii_alphanumeric() || letter == b'_')
    {
        let instead = format!("function {name}({argument}: {})", usual_dimension(&argument).unwrap_or("Number"));
        return wrong(content.span(), GrammarFact::Misspelt { flaw: "the argument of a function has a dimension", instead });
    }
    let own = if is_named { Some(self::name(&content, "the name of the argument")?) } else { None };
    let from = if is_named { required_dimension(&content)? } else { dimension(&content)? };
    if !content.is_empty() {
        return wrong(content.span(), GrammarFact::OneArgument);
    }
    if input.peek(Token![=]) && !input.peek(Token![==]) {
        let range = input.span();
        equals(input)?;
        let value = expression(input)?.to_string();
        let has_unit = value.as_bytes().windows(2).any(|pair| pair[0].is_ascii_digit() && pair[1].is_ascii_alphabetic());
        let formal = match (is_named, Dim::named(&argument)) {
            (true, _) => argument,
            (false, None) => format!("{argument}: Number"),
            (false, Some(_)) => format!("x: {argument}"),
        };
        let instead = format!("function {name}({formal}) -> {} = {value};", if has_unit { "…" } else { "Number" });
        return wrong(range, GrammarFact::Misspelt { flaw: "a function has the dimensions of its argument and of its value", instead });
    }
    let to = dimension_of_value(input)?;
    let value = value(input, format_args!("function {name}({argument}) -> …"))?;
    Ok(FunctionItem { name, argument: own, from, to, value })
}
