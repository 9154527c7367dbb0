//! The whole compiler on one page.

use crate::assembly::{self, Assembly};
use crate::connectivity;
use crate::diag::{Diag, Refusal};
use crate::emit;
use crate::expansion;
use crate::mobility;
use crate::model::{self, Model};
use crate::picture::{self, Picture};
use crate::plan::{self, Plan};
use crate::redundancy;
use crate::structure::{self, Structure};
use crate::syntax::{self, ast};
use crate::system::{self, System};
use crate::travel::{self, Motion};
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use quote::quote;

/// Every noun that is made on the way from tokens to tokens.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// Names are ids, quantities have dimensions.
    pub model: Model,
    /// Unknowns and equations.
    pub system: System,
    /// The order of solution.
    pub structure: Structure,
    /// The configuration to start from.
    pub assembly: Assembly,
    /// How the motion goes on from there.
    pub motion: Motion,
    /// Straight lines.
    pub plan: Plan,
    /// What it looks like.
    pub picture: Picture,
}

/// A definition under the name it has in a mechanism.
type Known = Vec<(String, ast::Definition)>;

/// Compiles a `mechanism!` declaration to Rust.
#[must_use]
pub fn mechanism(tokens: TokenStream) -> TokenStream {
    let mut diag = Diag::default();
    let Some(tree) = syntax::parse(tokens.clone(), &mut diag) else { return diag.to_tokens() };
    let fallback = missing(&tree, &TokenStream::new()).filter(|_| diag.is_clean()).map(|missing| emit::fallback(&tree, missing));
    let rest = continued(&tree, tokens, TokenStream::new(), diag);
    quote!(#fallback #rest)
}

/// Compiles a mechanism as far as its plan, without `use` items; for tests and tools.
///
/// # Errors
/// Everything that is wrong with the declaration.
pub fn compile(tokens: TokenStream) -> Result<Compiled, Vec<Refusal>> {
    let mut diag = Diag::default();
    let tree = syntax::parse(tokens, &mut diag);
    let compiled = tree.and_then(|tree| rooms(&tree, Known::new(), &mut diag));
    compiled.ok_or_else(|| diag.refusals().to_vec())
}

/// Compiles a `constraint!` invocation to the macros that stand for its definitions.
#[must_use]
pub fn constraint(tokens: TokenStream) -> TokenStream {
    let mut diag = Diag::default();
    let Some(definitions) = syntax::parse_definitions(tokens, &mut diag) else { return diag.to_tokens() };
    check(&definitions, &mut diag);
    let (errors, exports) = (diag.to_tokens(), emit::export(&definitions, !diag.is_clean()));
    quote!(#errors #exports)
}

/// What is wrong with a `constraint!` invocation; for tests and tools.
///
/// # Errors
/// Everything that is wrong with the definitions.
pub fn check_constraint(tokens: TokenStream) -> Result<(), Vec<Refusal>> {
    let mut diag = Diag::default();
    if let Some(definitions) = syntax::parse_definitions(tokens, &mut diag) {
        check(&definitions, &mut diag);
    }
    if diag.is_clean() { Ok(()) } else { Err(diag.refusals().to_vec()) }
}

/// Goes on with a mechanism after a definition has been handed over:
/// `{ definitions } { known } name { mechanism }`.
#[must_use]
pub fn resume(tokens: TokenStream) -> TokenStream {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    let [TokenTree::Group(definitions), TokenTree::Group(known), TokenTree::Ident(name), TokenTree::Group(mechanism)] = trees.as_slice()
    else {
        return quote!(::core::compile_error! { "`__resume` is called by `mechanism!` only" });
    };
    let (definitions, known) = (definitions.stream(), known.stream());
    let mut diag = Diag::default();
    let Some(tree) = syntax::parse(mechanism.stream(), &mut diag) else { return diag.to_tokens() };
    if definitions.is_empty() {
        // The definition has been refused where it stands; nothing is left to say here.
        return emit::stub(&tree);
    }
    continued(&tree, mechanism.stream(), quote!(#known #name { #definitions }), diag)
}

/// The manual pages of the library as modules.
#[must_use]
pub fn library_pages() -> TokenStream {
    emit::library_pages()
}

/// The pages of the index of errors as modules.
#[must_use]
pub fn error_pages() -> TokenStream {
    emit::error_pages()
}

/// Asks for the next definition that is not known yet, or compiles.
fn continued(tree: &ast::Mechanism, tokens: TokenStream, known: TokenStream, mut diag: Diag) -> TokenStream {
    if let Some(missing) = missing(tree, &known)
        && diag.is_clean()
    {
        return emit::resume(missing, &known, &tokens);
    }
    let definitions = definitions(known, &mut diag);
    match rooms(tree, definitions, &mut diag) {
        Some(Compiled { model, system, assembly, motion, plan, picture, .. }) => {
            let tokens = emit::emit(&model, &system, &assembly, &motion, &plan, &picture);
            let unwritten = expansion::write(&model.name.to_string(), &tokens);
            quote!(#tokens #unwritten)
        }
        None => {
            let (errors, stub) = (diag.to_tokens(), emit::stub(tree));
            quote!(#errors #stub)
        }
    }
}

/// The first constraint in a `use` item that has not been handed over.
fn missing<'a>(tree: &'a ast::Mechanism, known: &TokenStream) -> Option<&'a ast::Use> {
    let names = names(known);
    let uses = tree.items.iter().filter_map(|item| if let ast::Item::Use(uses) = item { Some(uses) } else { None });
    uses.flatten().find(|used| !names.contains(&used.name.to_string()))
}

/// From what was written to straight lines. A room is not entered if the one before refused.
fn rooms(tree: &ast::Mechanism, definitions: Known, diag: &mut Diag) -> Option<Compiled> {
    if !diag.is_clean() {
        return None;
    }
    let model = model::resolve(tree, definitions, diag)?;
    // Every name is an id, every quantity has a dimension.
    let system = system::assemble(&model, diag)?;
    // There are unknowns and equations only, with all their derivatives.
    connectivity::check(&model, &system, diag)?;
    // All bodies hang on ground.
    let redundant = redundancy::find(&model, &system, diag)?;
    // No row says what others say, but for those of redundant joints, which are checked instead of solved.
    let structure = structure::analyze(&system.pattern, &redundant);
    mobility::check(&model, &system, &redundant, diag)?;
    // Every unknown belongs to a block, and the blocks are in order.
    let assembly = assembly::assemble(&model, &system, &structure, diag)?;
    // There is a configuration to start from, an assembled one unless the mechanism allows others.
    let motion = travel::follow(&model, &system, &structure, &assembly, diag)?;
    // The motion goes on over its range, as far as that was seen.
    let plan = plan::schedule(&model, &system, &structure, &assembly);
    // Nothing is left to decide.
    let picture = picture::draw(&model, &system, &assembly);
    Some(Compiled { model, system, structure, assembly, motion, plan, picture })
}

fn check(definitions: &ast::Definitions, diag: &mut Diag) {
    if !diag.is_clean() {
        return;
    }
    model::check_names(definitions, diag);
    let all: Vec<ast::Definition> = definitions.exports.iter().flat_map(|export| export.definitions.clone()).collect();
    for definition in &all {
        model::check_definition(definition, &all, diag);
    }
}

/// `name { definitions } …`
fn entries(known: TokenStream) -> Vec<(String, TokenStream)> {
    let trees: Vec<TokenTree> = known.into_iter().collect();
    let entry = |pair: &[TokenTree]| match pair {
        [TokenTree::Ident(name), TokenTree::Group(group)] if group.delimiter() == Delimiter::Brace => {
            Some((name.to_string(), group.stream()))
        }
        _ => None,
    };
    trees.chunks(2).filter_map(entry).collect()
}

fn names(known: &TokenStream) -> Vec<String> {
    entries(known.clone()).into_iter().map(|(name, _)| name).collect()
}

/// A single definition goes by the name of its `use` item, those of a bundle by their own.
fn definitions(known: TokenStream, diag: &mut Diag) -> Known {
    let mut definitions = Known::new();
    for (name, tokens) in entries(known) {
        let mut parsed = syntax::parse_exported(tokens, diag).unwrap_or_default();
        match parsed.len() {
            1 => definitions.extend(parsed.pop().map(|definition| (name, definition))),
            _ => definitions.extend(parsed.into_iter().map(|definition| (definition.name.to_string(), definition))),
        }
    }
    definitions
}
