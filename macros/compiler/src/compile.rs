//! The whole compiler on one page.

use crate::assembly::{self, Assembly};
use crate::connectivity;
use crate::diag::{self, Diag, Refusal};
use crate::dynamics;
use crate::emit;
use crate::expansion;
use crate::export;
use crate::hints;
use crate::import;
use crate::mobility;
use crate::model::{Facing, Model};
use crate::numeric::arms::shafts_for_arms;
use crate::picture::{self, Picture};
use crate::plan::{self, Plan};
use crate::redundancy;
use crate::resolve;
use crate::structure::{self, Structure};
use crate::stub;
use crate::syntax::{self, ast};
use crate::system::{self, System};
use crate::travel::{self, Motion};
use proc_macro2::{TokenStream, TokenTree};
use quote::quote;

/// The result of every room from tokens to tokens.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// Names resolved to ids, quantities with dimensions.
    pub model: Model,
    /// Unknowns and equations.
    pub system: System,
    /// Blocks in the order of solution.
    pub structure: Structure,
    /// Initial configuration.
    pub assembly: Assembly,
    /// Motion from the initial configuration.
    pub motion: Motion,
    /// Straight-line code to generate.
    pub plan: Plan,
    /// Picture of the mechanism.
    pub picture: Picture,
}

/// Compiles a `mechanism!` declaration to Rust.
#[must_use]
pub fn mechanism(tokens: TokenStream) -> TokenStream {
    let mut diag = Diag::default();
    let Some(tree) = syntax::parse(tokens.clone(), &mut diag) else { return diag.to_tokens() };
    let fallback = missing(&tree, &TokenStream::new()).filter(|_| diag.is_clean()).map(|missing| stub::fallback(&tree, missing));
    let rest = continued(&tree, tokens, TokenStream::new(), diag);
    quote!(#fallback #rest)
}

/// Compiles a declaration without `use` items and returns the result of every room; for tests and tools.
///
/// # Errors
/// All errors in the declaration.
pub fn compile(tokens: TokenStream) -> Result<Compiled, Vec<Refusal>> {
    let mut diag = Diag::default();
    let tree = syntax::parse(tokens, &mut diag);
    let compiled = tree.and_then(|tree| rooms(&tree, Vec::new(), &mut diag));
    compiled.ok_or_else(|| diag.refusals().to_vec())
}

/// Compiles a `constraint!` invocation to the macros that export its definitions.
#[must_use]
pub fn constraint(tokens: TokenStream) -> TokenStream {
    let mut diag = Diag::default();
    let Some(definitions) = syntax::parse_definitions(tokens, &mut diag) else { return diag.to_tokens() };
    check(&definitions, &mut diag);
    let (errors, exports) = (diag.to_tokens(), export::export(&definitions, !diag.is_clean()));
    let unused = diag.is_clean().then(|| diag::of_unused(&hints::unused_arguments(&definitions)));
    quote!(#errors #exports #unused)
}

/// Checks a `constraint!` invocation; for tests and tools.
///
/// # Errors
/// All errors in the definitions.
pub fn check_constraint(tokens: TokenStream) -> Result<(), Vec<Refusal>> {
    let mut diag = Diag::default();
    if let Some(definitions) = syntax::parse_definitions(tokens, &mut diag) {
        check(&definitions, &mut diag);
    }
    if diag.is_clean() { Ok(()) } else { Err(diag.refusals().to_vec()) }
}

/// Resumes the compilation of a mechanism after a definition has been handed over. The tokens are
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
        // The definition was rejected where it is written; an error here would only repeat that.
        return stub::stub(&tree);
    }
    continued(&tree, mechanism.stream(), quote!(#known #name { #definitions }), diag)
}

/// The manual pages of the library, as modules.
#[must_use]
pub fn library_pages() -> TokenStream {
    export::library_pages()
}

/// The pages of the error index, as modules.
#[must_use]
pub fn error_pages() -> TokenStream {
    export::error_pages()
}

/// Requests the next missing definition; compiles the mechanism if none is missing.
fn continued(tree: &ast::Mechanism, tokens: TokenStream, known: TokenStream, mut diag: Diag) -> TokenStream {
    if let Some(missing) = missing(tree, &known)
        && diag.is_clean()
    {
        return export::resume(missing, &known, &tokens);
    }
    let imported = import::imported(tree, known, &mut diag);
    let whole = (!imported.components.is_empty()).then(|| syntax::with_components(tree, imported.components, imported.homes));
    let whole = whole.as_ref().unwrap_or(tree);
    let compiled = rooms(whole, imported.definitions, &mut diag);
    let doubts = compiled.as_ref().map_or(&[][..], |compiled| &compiled.model.doubts);
    let hints::Unused { names, imports } = hints::unused(tree, tokens, &imported.brought, doubts);
    let (names, imports) = (diag::of_unused(&names), imports.iter().map(diag::Warning::to_tokens));
    match compiled {
        Some(Compiled { model, system, assembly, motion, plan, picture, .. }) => {
            let tokens = emit::emit(&model, &system, &assembly, &motion, &plan, &picture);
            let unwritten = expansion::write(&model.name.to_string(), &tokens);
            quote!(#tokens #names #(#imports)* #unwritten)
        }
        None => {
            let (errors, stub) = (diag.to_tokens(), stub::stub(whole));
            quote!(#errors #stub)
        }
    }
}

/// First name of a `use` item whose definition has not been handed over.
fn missing<'a>(tree: &'a ast::Mechanism, known: &TokenStream) -> Option<&'a ast::Use> {
    let names = import::names(known);
    let uses = tree.items.iter().filter_map(|item| if let ast::Item::Use(uses) = item { Some(uses) } else { None });
    uses.flatten().find(|used| !names.contains(&used.name.to_string()))
}

/// Runs all rooms after parsing. A room runs only if the one before it reported no error.
fn rooms(tree: &ast::Mechanism, definitions: import::Definitions, diag: &mut Diag) -> Option<Compiled> {
    if !diag.is_clean() {
        return None;
    }
    let mut model = resolve::resolve(tree, definitions, diag)?;
    let angles = hints::bare_angles(tree);
    let is_told = |warning: &diag::Warning| angles.iter().any(|told| told.range.last.end() == warning.range.last.end());
    model.doubts.retain(|warning| !is_told(warning));
    model.doubts.extend(angles);
    model.doubts.extend(hints::doubtful_expressions(tree));
    model.doubts.extend(hints::doubtful_shapes(tree));
    // Every name is an id, every quantity has a dimension.
    let mut doubts = model.doubts.clone();
    // Told beside errors only: without a declared start two axes may lie in line by chance.
    doubts.extend(shafts_for_arms(&model));
    let compiled = after_names(model, diag);
    if compiled.is_none() {
        diag.explain(&doubts);
    }
    compiled
}

/// Runs all rooms after names are resolved.
fn after_names(mut model: Model, diag: &mut Diag) -> Option<Compiled> {
    let mut system = system::assemble(&model, diag)?;
    let mut placed = placed(&model, &system, diag);
    if placed.is_none() && system.space.has_opposed && diag.is_of_open_joints() {
        // The declared starts turn axes of a joint against each other, and so no loop closes. With the axes along each other it may:
        // the unknowns, which depend on this, are chosen once more.
        let mut again = Diag::default();
        model.space.facing = Facing::Along;
        system = system::assemble(&model, &mut again)?;
        placed = self::placed(&model, &system, &mut again);
        if placed.is_some() {
            diag.withdraw(0);
        }
    }
    let (structure, assembly) = placed?;
    // There is an initial configuration; it is assembled unless the mechanism allows others.
    let motion = travel::follow(&model, &system, &structure, &assembly, diag)?;
    // The motion continues over its declared range, as far as it was followed.
    let loads = dynamics::loads(&model, &system, &structure, &assembly);
    // Loads of joints and drives are known, if there are masses or forces.
    let dynamics = dynamics::derive(&model, &system, &structure, &assembly, loads.as_ref(), diag)?;
    // The equations of motion of an integrated mechanism are known; all other coordinates are functions of its freedoms.
    let plan = plan::schedule(&model, &system, &structure, &assembly, dynamics.as_ref(), loads.as_ref(), diag)?;
    // All decisions about the generated code are made.
    let picture = picture::draw(&model, &system, &assembly);
    Some(Compiled { model, system, structure, assembly, motion, plan, picture })
}

/// Runs the rooms from the system to the assembly.
fn placed(model: &Model, system: &System, diag: &mut Diag) -> Option<(Structure, Assembly)> {
    // Only unknowns and equations are left, with all their derivatives.
    connectivity::check(model, system, diag)?;
    // All bodies are connected to ground.
    let redundancy = redundancy::find(model, system, diag)?;
    // No row is redundant, except in joints declared redundant: those rows are checked instead of solved.
    let structure = structure::analyze(&system.pattern, &redundancy.rows);
    mobility::check(model, system, &redundancy, &structure, diag)?;
    // Every unknown belongs to a block, and the blocks are in order.
    let assembly = assembly::assemble(model, system, &structure, diag)?;
    Some((structure, assembly))
}

fn check(definitions: &ast::Definitions, diag: &mut Diag) {
    if !diag.is_clean() {
        return;
    }
    export::check_names(definitions, diag);
    let is_constraint =
        |defined: &ast::Defined| if let ast::Defined::Constraint(definition) = defined { Some(definition.clone()) } else { None };
    let all: Vec<ast::Definition> = definitions.exports.iter().flat_map(|export| &export.definitions).filter_map(is_constraint).collect();
    for definition in &all {
        resolve::check_definition(definition, &all, diag);
    }
    for (component, handed) in export::components(definitions) {
        check_component(component, handed, diag);
    }
}

/// Checks a component as mechanisms would import it. A mistake in another component that it calls is reported once.
fn check_component(component: &ast::ComponentItem, handed: TokenStream, diag: &mut Diag) {
    let name = &component.head.name;
    let tree = syntax::without_items(name.clone(), component.head.ambient.unwrap_or_default());
    let mut own = Diag::default();
    let imported = import::imported(&tree, quote!(#name { #handed }), &mut own);
    let tree = syntax::with_components(&tree, imported.components, imported.homes);
    if own.is_clean() {
        resolve::resolve(&tree, imported.definitions, &mut own);
    }
    let place = |range: diag::Range| (range.first.start(), range.last.end());
    for refusal in own.refusals() {
        if diag.refusals().iter().all(|known| place(known.range) != place(refusal.range)) {
            diag.refuse::<()>(refusal.range, refusal.fact.clone());
        }
    }
}
