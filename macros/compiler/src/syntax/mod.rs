//! Parses tokens to a syntax tree.
//!
//! In: the tokens between the macro's parentheses. Out: an [`ast::Mechanism`] or [`ast::Definitions`] that is grammatical. Not done
//! here: name resolution.
//!
//! A broken item is reported and skipped, so that the next one is still parsed; the parser never stops at the first error.

mod arguments;
pub mod ast;
mod definition;
mod dimension;
mod export;
mod expression;
mod frame;
mod function;
mod item;
mod joint;
mod options;
mod output;
mod parameter;
mod repeated;
mod salvage;
mod slip;
mod tokens;

use crate::diag::{Diag, GrammarFact, Refusal};
use crate::quantity::Ambient;
use ast::{ComponentHome, ComponentItem, Definition, Definitions, Expression, FunctionItem, Handed, Mechanism, Shared};
use proc_macro2::{Delimiter, Ident, Span, TokenStream, TokenTree};
use std::collections::BTreeSet;
use syn::parse::{ParseStream, Parser};

/// Parses a `mechanism!` declaration.
///
/// Returns the tree even if items were rejected, so that a stub of the type can be emitted; `None` only if not even the name could be
/// read.
pub(crate) fn parse(tokens: TokenStream, diag: &mut Diag) -> Option<Mechanism> {
    run(tokens, diag, item::mechanism)
}

/// Parses a `constraint!` invocation.
pub(crate) fn parse_definitions(tokens: TokenStream, diag: &mut Diag) -> Option<Definitions> {
    run(tokens, diag, export::definitions)
}

/// Parses the definitions behind an exported name, which have no visibility.
pub(crate) fn parse_exported(tokens: TokenStream, diag: &mut Diag) -> Option<Vec<Handed>> {
    run(tokens, diag, export::exported)
}

/// A mechanism with imported components, and the definitions that these see.
pub(crate) fn with_components(tree: &Mechanism, components: Vec<Shared<ComponentItem>>, homes: Vec<ComponentHome>) -> Mechanism {
    item::with_components(tree, components, homes)
}

/// A mechanism without items.
pub(crate) fn without_items(name: Ident, ambient: Ambient) -> Mechanism {
    item::without_items(name, ambient)
}

/// Words that are called, as in `word(…)`, and kinds of joints that are taken, as in `Joint(word)`.
pub(crate) fn called(tokens: TokenStream) -> BTreeSet<String> {
    let (mut words, mut pending) = (BTreeSet::new(), vec![tokens]);
    while let Some(tokens) = pending.pop() {
        let mut last: Option<String> = None;
        for token in tokens {
            let word = if let TokenTree::Ident(word) = &token { Some(plain(word)) } else { None };
            if let TokenTree::Group(group) = token {
                let is_call = group.delimiter() == Delimiter::Parenthesis;
                let taken = group.stream().into_iter().next().filter(|_| is_call && last.as_deref() == Some("Joint"));
                words.extend(last.take().filter(|_| is_call));
                words.extend(taken.map(|kind| kind.to_string().trim_start_matches("r#").to_owned()));
                pending.push(group.stream());
            }
            last = word;
        }
    }
    words
}

/// Parses a constraint or a force of the library.
pub(crate) fn parse_definition(tokens: TokenStream, diag: &mut Diag) -> Option<Definition> {
    run(tokens, diag, definition::single_definition)
}

/// Parses a function of the library.
pub(crate) fn parse_function(tokens: TokenStream, diag: &mut Diag) -> Option<FunctionItem> {
    run(tokens, diag, function::single_function)
}

/// Parses a formula of the compiler's own.
pub(crate) fn parse_formula(tokens: TokenStream) -> Option<Expression> {
    (|input: ParseStream| expression::expression(input).map_err(|_| input.error("no formula"))).parse2(tokens).ok()
}

/// Deepest nesting of delimiters, so that no walk over tokens can exhaust the stack.
const DEEPEST: u16 = 250;

/// The first delimiter that is nested too deep.
fn too_deep(tokens: &TokenStream) -> Option<Span> {
    let mut open = vec![tokens.clone().into_iter()];
    while let Some(innermost) = open.last_mut() {
        match innermost.next() {
            None => drop(open.pop()),
            Some(TokenTree::Group(group)) if open.len() > usize::from(DEEPEST) => return Some(group.span_open()),
            Some(TokenTree::Group(group)) => open.push(group.stream().into_iter()),
            Some(_) => {}
        }
    }
    None
}

/// A name without `r#`.
pub(crate) fn plain(name: &Ident) -> String {
    name.to_string().trim_start_matches("r#").to_owned()
}

fn run<T>(tokens: TokenStream, diag: &mut Diag, parse: fn(ParseStream, &mut Diag) -> Option<T>) -> Option<T> {
    if let Some(span) = too_deep(&tokens) {
        return diag.refuse(span, GrammarFact::TooDeep { limit: DEEPEST });
    }
    let mut tree = None;
    let read = |input: ParseStream| {
        tree = parse(input, diag);
        // The remaining tokens were reported already, or belong to a rejected item.
        input.parse::<TokenStream>().map(|_| ())
    };
    let result = read.parse2(tokens);
    if let Err(error) = result
        && diag.is_clean()
    {
        let Refusal { fact, range } = error.into();
        diag.refuse::<()>(range, fact);
    }
    tree
}
