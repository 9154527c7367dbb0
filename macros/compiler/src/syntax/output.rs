//! Parses outputs.

use super::ast::{Docs, OutputItem};
use super::expression::{declared, expression};

use super::tokens::{Parsed, equals, expected, keyword, semicolon};
use proc_macro2::Ident;
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
    let (name, indices) = declared(input, "the name of the output")?;
    equals(input)?;
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
