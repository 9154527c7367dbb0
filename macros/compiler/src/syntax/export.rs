//! Parses `constraint!`: constraints, forces, components and bundles of them.

use super::ast::{Defined, Definition, Definitions, Docs, Export, Handed};
use super::definition::definition;
use super::options::passing;
use super::repeated::component;
use super::tokens::{Parsed, attributes, block, docs, keyword, name, report, skip_item, visibility};
use crate::diag::Diag;
use proc_macro2::{Ident, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{LitStr, token};

/// `pub constraint name(parameters) { statements }`, `pub component Name(parameters) { items }` or `pub bundle name { definitions }`, any number.
pub(super) fn definitions(input: ParseStream, diag: &mut Diag) -> Option<Definitions> {
    let mut exports = Vec::new();
    while !input.is_empty() {
        let before = input.fork();
        match export(input, diag) {
            Ok(export) => exports.push(export),
            Err(refusal) => {
                diag.refuse::<()>(refusal.range, refusal.fact);
                exports.extend(promised(&before));
                skip_item(input, &before, is_export);
            }
        }
    }
    Some(Definitions { exports })
}

/// Definitions as handed over by an exported name: its own, behind `bundle` if it is the name of one, and in braces those that its components call.
/// If there are components, the name of their crate stands first.
pub(super) fn exported(input: ParseStream, diag: &mut Diag) -> Option<Vec<Handed>> {
    let mut handed = Vec::new();
    let origin = input.parse::<LitStr>().map_or_else(|_| String::new(), |origin| origin.value());
    let is_of_bundle = keyword(input).is_some_and(|word| word == "bundle");
    if is_of_bundle {
        input.parse::<Ident>().ok()?;
    }
    while !input.is_empty() {
        if input.peek(token::Brace) {
            let content = report(block(input, "`{`"), diag)?;
            let fellows = exported(&content, diag)?;
            handed.extend(fellows.into_iter().map(|fellow| Handed { is_named: false, origin: origin.clone(), ..fellow }));
            continue;
        }
        let begin = input.fork();
        let defined = report(defined(input, diag), diag)?;
        handed.push(Handed {
            defined,
            tokens: report(between(&begin, input), diag)?,
            is_named: true,
            is_of_bundle,
            origin: origin.clone(),
        });
    }
    Some(handed)
}

/// Reads the name of a rejected definition, so that a `use` of it is not rejected as well; the word before the name may be the error.
fn promised(input: ParseStream) -> Option<Export> {
    attributes(input).ok()?;
    let visibility = visibility(input).ok()?;
    Ident::parse_any(input).ok()?;
    let name = input.parse().ok()?;
    Some(Export {
        docs: Docs::default(),
        visibility,
        name,
        definitions: Vec::new(),
        tokens: TokenStream::new(),
        is_bundle: false,
        members: Vec::new(),
    })
}

/// True if the next export begins here.
fn is_export(input: ParseStream) -> bool {
    let ahead = input.fork();
    visibility(&ahead).is_ok() && keyword(&ahead).filter(is_export_word).is_some() && ahead.peek2(syn::Ident)
}

fn is_export_word(word: &Ident) -> bool {
    word == "constraint" || word == "force" || word == "component" || word == "bundle"
}

fn export(input: ParseStream, diag: &mut Diag) -> Parsed<Export> {
    let begin = input.fork();
    let ahead = input.fork();
    attributes(&ahead)?;
    let visibility = visibility(&ahead)?;
    if keyword(&ahead).is_some_and(|word| word == "bundle") {
        return bundle(input, diag);
    }
    // Handed over are the tokens from the word `constraint` to the closing brace; of a component also the attributes before it, which are
    // those of its struct.
    let defined = defined(input, diag)?;
    let tokens = between(if let Defined::Component(_) = defined { &begin } else { &ahead }, input)?;
    let Definition { docs, name, .. } = defined.head().clone();
    Ok(Export { docs, visibility, name, definitions: vec![defined], tokens, is_bundle: false, members: Vec::new() })
}

/// A constraint, a force or a component.
fn defined(input: ParseStream, diag: &mut Diag) -> Parsed<Defined> {
    let ahead = input.fork();
    attributes(&ahead)?;
    visibility(&ahead)?;
    if keyword(&ahead).is_none_or(|word| word != "component") {
        return definition(input).map(Defined::Constraint);
    }
    let (docs, others) = attributes(input)?;
    visibility(input)?;
    let docs = passing(docs, others, "component")?;
    component(input, docs, None, diag).map(Defined::Component)
}

/// The tokens between two positions in the input.
fn between(begin: ParseStream, end: ParseStream) -> Parsed<TokenStream> {
    let mut tokens = TokenStream::new();
    while begin.cursor() < end.cursor() {
        tokens.extend([begin.parse::<TokenTree>()?]);
    }
    Ok(tokens)
}

/// `bundle name { definitions }`
fn bundle(input: ParseStream, diag: &mut Diag) -> Parsed<Export> {
    let docs = docs(input)?;
    let visibility = visibility(input)?;
    Ident::parse_any(input)?;
    let name = name(input, "the name of the bundle")?;
    let content = block(input, "`{` and the definitions of the bundle")?;
    let tokens: TokenStream = content.fork().parse()?;
    let (mut definitions, mut members) = (Vec::new(), Vec::new());
    while !content.is_empty() {
        let before = content.fork();
        match defined(&content, diag) {
            Ok(defined) => {
                members.push((defined.head().name.clone(), between(&before, &content)?));
                definitions.push(defined);
            }
            Err(refusal) => {
                diag.refuse::<()>(refusal.range, refusal.fact);
                skip_item(&content, &before, is_export);
            }
        }
    }
    Ok(Export { docs, visibility, name, definitions, tokens, is_bundle: true, members })
}
