//! Parses components, their parts, and loops.

use super::arguments::arguments;
use super::ast::{ComponentItem, Definition, Docs, For, IndexRange, Item, Marks, PartItem};
use super::definition::{ambient, formals};
use super::expression::{NESTING, declared, expression, in_brackets, list};
use super::frame::marks;
use super::item::{ItemContext, items};
use super::tokens::{
    Parsed, block, docs, equals, expected, keyword, name, parentheses, report, semicolon, skip_to_block, statement_text, wrong,
};
use crate::diag::{Diag, GrammarFact};
use crate::quantity::Ambient;
use proc_macro2::Ident;
use std::rc::Rc;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Token, token};

/// `component Name(parameters) { items }`. `outer`: given, where the bodies of the mechanism move; without one the component may say it,
/// as in `component Name(parameters) in space { items }`.
pub(super) fn component(input: ParseStream, docs: Docs, outer: Option<Ambient>, diag: &mut Diag) -> Parsed<ComponentItem> {
    Ident::parse_any(input)?;
    let name = name(input, "the name of the component")?;
    let parameters = report(formals(input, "`(` and what the component takes, or `()`"), diag);
    if parameters.is_none() && skip_to_block(input).is_none() {
        return expected(input, "`{` and the items of the component");
    }
    let parameters = parameters.unwrap_or_default();
    let own = if outer.is_none() { self::ambient(input)? } else { None };
    let ambient = outer.or(own).unwrap_or_default();
    let content = block(input, "`{` and the items of the component")?;
    let items = items(&content, ItemContext { is_top: false, variable: None, ambient }, diag);
    Ok(ComponentItem {
        docs: docs.clone(),
        head: Definition { docs, name, parameters, ambient: own, is_force: false, statements: Vec::new() },
        items,
        home: None,
    })
}

/// `part name = Component(arguments);`
pub(super) fn part(input: ParseStream, docs: Docs) -> Parsed<PartItem> {
    Ident::parse_any(input)?;
    let (name, indices) = declared(input, "the name of the part")?;
    if input.peek(syn::Ident) && input.peek2(token::Paren) {
        let (own, range) = (self::name(input, "the name of the part")?, name.span());
        let instead = format!("part {own} = {name}{};", statement_text(input)?);
        return wrong(range, GrammarFact::Misspelt { flaw: "a part has its name first", instead });
    }
    if input.peek(token::Brace) {
        let instead = format!("body {name}{} {{ … }}", in_brackets(&indices));
        return wrong(&name, GrammarFact::Misspelt { flaw: "a part is made of a component; with points of its own it is a body", instead });
    }
    equals(input)?;
    let kind = self::name(input, "a component, as in `Leg(…)`")?;
    if !input.peek(token::Paren) {
        if kind == "new" && input.peek(syn::Ident) {
            let (made, instead) = (self::name(input, "a component")?, statement_text(input)?);
            let instead = format!("part {name}{} = {made}{instead};", in_brackets(&indices));
            return wrong(kind.span(), GrammarFact::Misspelt { flaw: "a component is called without `new`", instead });
        }
        return expected(input, "`(` and the arguments of the component");
    }
    let arguments = Rc::new(arguments(input)?);
    semicolon(input)?;
    Ok(PartItem { docs, name, indices, kind, arguments })
}

/// `for variable in from..to { items }`
pub(super) fn repeated_items(input: ParseStream, ambient: Ambient, diag: &mut Diag) -> Parsed<For<Vec<Item>>> {
    let (variable, bounds) = head(input)?;
    let content = block(input, "`{` and the items of the loop")?;
    let items = items(&content, ItemContext { is_top: false, variable: Some(&variable), ambient }, diag);
    Ok(For { variable, bounds, items })
}

/// `for variable in from..to { points and axes }`
pub(super) fn repeated_marks(input: ParseStream) -> Parsed<For<Marks>> {
    let (variable, bounds) = head(input)?;
    let content = block(input, "`{` and the points of the loop")?;
    let mut repeated = Marks::default();
    while !content.is_empty() {
        docs(&content)?;
        marks(&content, &mut repeated, ItemContext { is_top: false, variable: Some(&variable), ambient: Ambient::default() })?;
    }
    Ok(For { variable, bounds, items: repeated })
}

/// Refuses `for body in bodies.iter()` and `for i in range(3)`.
fn counts(input: ParseStream, variable: &Ident) -> Parsed<()> {
    let (ahead, place) = (input.fork(), input.span());
    if let Ok((content, range)) = parentheses(&ahead)
        && let Ok(bounds) = bounds(&content)
        && ahead.peek(token::Brace)
    {
        let (from, to, dots) = (bounds.from, bounds.to, if bounds.is_inclusive { "..=" } else { ".." });
        let instead = format!("for {variable} in {from}{dots}{to}");
        return wrong(range, GrammarFact::Misspelt { flaw: "a range has no parentheses", instead });
    }
    no_length(input, variable)?;
    let ahead = input.fork();
    let Ok(array) = ahead.parse::<Ident>() else { return Ok(()) };
    let flaw = "a loop counts whole numbers";
    if array == "range" && ahead.peek(token::Paren) {
        let (content, _) = parentheses(&ahead)?;
        let values = list(&content, NESTING)?;
        let numbers: Option<Vec<usize>> = values.iter().map(|value| value.to_string().parse().ok()).collect();
        let instead = match (numbers.as_deref(), values.as_slice()) {
            (Some(&[first, second, step]), _) if second > first && step > 0 => {
                let index = if first == 0 { format!("{step} * {variable}") } else { format!("{first} + {step} * {variable}") };
                format!("for {variable} in 0..{} {{ … {index} … }}", (second - first).div_ceil(step))
            }
            (Some(&[first, second] | &[first, second, _]), _) if second <= first => format!("for {variable} in {second}..{first}"),
            (_, [first, second]) => format!("for {variable} in {first}..{second}"),
            (_, [first, second, step, ..]) => {
                format!("for {variable} in 0..({second} - {first}) / {step} {{ … {first} + {step} * {variable} … }}")
            }
            (_, [only]) => format!("for {variable} in 0..{only}"),
            (_, []) => format!("for {variable} in 0..3"),
        };
        return wrong(place, GrammarFact::Misspelt { flaw, instead });
    }
    let is_method = ahead.peek(Token![.]) && !ahead.peek(Token![..]) && {
        ahead.parse::<Token![.]>()?;
        ahead.parse::<Ident>().is_ok_and(|method| ["iter", "iter_mut", "into_iter"].iter().any(|known| method == known))
    };
    match is_method || ahead.peek(token::Brace) {
        true => wrong(place, GrammarFact::Misspelt { flaw, instead: format!("for i in 0..3 {{ … {array}[i] … }}") }),
        false => Ok(()),
    }
}

/// Refuses `0..links.len()`.
fn no_length(input: ParseStream, variable: &Ident) -> Parsed<()> {
    let ahead = input.fork();
    let Ok(from) = expression(&ahead) else { return Ok(()) };
    let place = ahead.span();
    let is_range = ahead.parse::<Token![..=]>().is_ok() || ahead.parse::<Token![..]>().is_ok();
    if !is_range || ahead.parse::<Ident>().is_err() || ahead.parse::<Token![.]>().is_err() {
        return Ok(());
    }
    let is_length = ahead.parse::<Ident>().is_ok_and(|word| ["len", "length", "size", "count"].iter().any(|known| word == known));
    let flaw = "elements are not counted: their number has a name, as in `let n = 3;`";
    match is_length && ahead.peek(token::Paren) {
        true => wrong(place, GrammarFact::Misspelt { flaw, instead: format!("for {variable} in {from}..n") }),
        false => Ok(()),
    }
}

/// `from..to` or `from..=to`
fn bounds(input: ParseStream) -> Parsed<IndexRange> {
    let from = expression(input)?;
    let is_inclusive = input.peek(Token![..=]);
    if is_inclusive {
        input.parse::<Token![..=]>()?;
    } else if input.peek(Token![..]) {
        input.parse::<Token![..]>()?;
    } else {
        return expected(input, "`..` or `..=` and the end of the range");
    }
    Ok(IndexRange { from, to: expression(input)?, is_inclusive })
}

/// Refuses `1:n`, as it is written in MATLAB.
fn no_colon(input: ParseStream, variable: &Ident) -> Parsed<()> {
    let (ahead, place) = (input.fork(), input.span());
    let Ok(from) = expression(&ahead) else { return Ok(()) };
    if ahead.peek(Token![::]) || ahead.parse::<Token![:]>().is_err() {
        return Ok(());
    }
    let to = expression(&ahead)?;
    let flaw = "a range has two dots, and `=` where its end belongs to it";
    match ahead.peek(token::Brace) {
        true => wrong(place, GrammarFact::Misspelt { flaw, instead: format!("for {variable} in {from}..={to}") }),
        false => Ok(()),
    }
}

/// `for variable in from..to`
fn head(input: ParseStream) -> Parsed<(Ident, IndexRange)> {
    input.parse::<Token![for]>()?;
    let variable = name(input, "a name after `for`")?;
    if keyword(input).is_none_or(|word| word != "in") {
        return expected(input, "`in` and a range such as `0..6`");
    }
    input.parse::<Token![in]>()?;
    counts(input, &variable)?;
    no_colon(input, &variable)?;
    let bounds = bounds(input)?;
    Ok((variable, bounds))
}
