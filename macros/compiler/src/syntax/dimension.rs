//! Parses dimensions: products of powers of named dimensions.

use super::ast::Dimension;
use super::tokens::{Parsed, brackets, expected, literal, name, wrong};
use crate::diag::{GrammarFact, Range};
use syn::parse::ParseStream;
use syn::{LitInt, Token, token};

/// Largest exponent in a dimension.
const LARGEST_EXPONENT: u8 = 6;

/// `: Dimension`
pub(super) fn required_dimension(input: ParseStream) -> Parsed<Dimension> {
    if !input.peek(Token![:]) {
        return expected(input, "`:` and a dimension such as `Length`");
    }
    input.parse::<Token![:]>()?;
    dimension(input)
}

/// `-> Dimension`
pub(super) fn dimension_of_value(input: ParseStream) -> Parsed<Dimension> {
    if !input.peek(Token![->]) {
        return expected(input, "`->` and the dimension of the value");
    }
    input.parse::<Token![->]>()?;
    dimension(input)
}

/// `Length * Angle / Time^2`, also `Length * Angle * Time^-2`
pub(super) fn dimension(input: ParseStream) -> Parsed<Dimension> {
    let mut factors = Vec::new();
    let mut sign = 1;
    let mut range = Range::from(input.span());
    if input.peek(token::Bracket) {
        let (content, range) = brackets(input)?;
        let written = format!("[{}]", content.cursor().token_stream()).replace(" ;", ";");
        return wrong(range, GrammarFact::ArrayOfDimension { written });
    }
    loop {
        let factor = name(input, "a dimension such as `Length`")?;
        range = range.to(&factor);
        let mut power = 1;
        if input.peek(Token![^]) {
            input.parse::<Token![^]>()?;
            range = range.to(input.span());
            power = exponent(input)?;
        }
        factors.push((factor, sign * power));
        if input.peek(Token![*]) {
            input.parse::<Token![*]>()?;
            sign = 1;
        } else if input.peek(Token![/]) {
            input.parse::<Token![/]>()?;
            sign = -1;
        } else {
            return Ok(Dimension { factors, range });
        }
    }
}

fn exponent(input: ParseStream) -> Parsed<i16> {
    let sign = if input.peek(Token![-]) {
        input.parse::<Token![-]>()?;
        -1
    } else {
        1
    };
    if !literal(input)? || !input.peek(LitInt) {
        return expected(input, "a whole number");
    }
    let literal: LitInt = input.parse()?;
    match literal.base10_parse::<u8>() {
        Ok(exponent) if exponent <= LARGEST_EXPONENT => Ok(sign * i16::from(exponent)),
        _ => wrong(literal.span(), GrammarFact::ExponentTooLarge { limit: LARGEST_EXPONENT }),
    }
}
