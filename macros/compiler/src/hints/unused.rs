//! Names that nothing in the declaration uses.
//!
//! Parameters, inputs, `let`s, functions and arguments act only through the expressions that name them, and components through their parts: one
//! that is named nowhere changes nothing. Declared points and axes are left out, since they may be read from Rust and are drawn in pictures, and so
//! are `let`s of constraints, which are read by the names of joints. An argument of a constraint that only other definitions read, by the name of
//! a joint, causes a warning all the same: a definition is rarely meant to ignore what it is given.

use crate::diag::{Doubt, Warning};
use crate::syntax::ast::{Defined, Definitions, Expression, ExpressionKind, Item, Mechanism, every_item};
use crate::syntax::plain;
use proc_macro2::{Ident, TokenStream, TokenTree};
use std::collections::BTreeMap;

/// What nothing in a mechanism uses.
pub(crate) struct Unused<'a> {
    /// Parameters, inputs, `let`s, functions, components and their arguments that are written once, where they are declared.
    pub(crate) names: Vec<&'a Ident>,
    /// `use` items that bring in nothing of what is used.
    pub(crate) imports: Vec<Warning>,
}

/// Finds what nothing uses. `tokens`: given, all of the mechanism; `brought`: given, the names in the mechanism that each `use` item brings in;
/// `doubts`: given, the warnings about the mechanism.
///
/// A word that is written again with another meaning counts as a use. Of a parameter whose default is doubtful one warning is enough.
pub(crate) fn unused<'a>(
    tree: &'a Mechanism,
    tokens: TokenStream,
    brought: &BTreeMap<String, Vec<String>>,
    doubts: &[Warning],
) -> Unused<'a> {
    let is_doubtful = |default: &Expression| {
        let number = |doubt: &Warning| if let Doubt::BareLength { number, .. } = &doubt.doubt { Some(number.clone()) } else { None };
        matches!(&default.kind, ExpressionKind::Number { digits, unit } if unit.is_empty()
            && doubts.iter().filter_map(number).any(|number| number == *digits))
    };
    let mut written = BTreeMap::new();
    count(tokens, &mut written);
    let (mut names, mut imports) = (Vec::new(), Vec::new());
    for item in every_item(&tree.items) {
        match item {
            Item::Parameter(parameter) if is_doubtful(&parameter.default) => {}
            Item::Parameter(parameter) | Item::Input(parameter) => names.push(&parameter.name),
            Item::Let(binding) => names.push(&binding.name),
            Item::Function(function) => names.push(&function.name),
            Item::Component(component) => {
                names.push(&component.head.name);
                names.extend(component.head.parameters.iter().map(|formal| &formal.name));
            }
            Item::Use(uses) => imports.extend(uses.iter().map(|used| &used.name)),
            _ => {}
        }
    }
    names.retain(|name| written.get(&plain(name)) == Some(&1));
    imports.retain(|name| {
        let own = plain(name);
        // The `use` item itself writes its name.
        let is_written = |word: &String| written.get(word).is_some_and(|times| *times > usize::from(*word == own));
        brought.get(&name.to_string()).is_some_and(|words| !words.iter().any(is_written))
    });
    let warning = |name: &Ident| Warning { doubt: Doubt::UnusedImport { name: name.to_string() }, range: name.into() };
    Unused { names, imports: imports.into_iter().map(warning).collect() }
}

/// The arguments of definitions in `constraint!` that are written once, where they are declared.
pub(crate) fn unused_arguments(definitions: &Definitions) -> Vec<&Ident> {
    let mut names = Vec::new();
    for export in &definitions.exports {
        let tokens_of = |defined: &Defined| export.members.iter().find(|(name, _)| *name == defined.head().name).map(|(_, tokens)| tokens);
        for defined in &export.definitions {
            let mut written = BTreeMap::new();
            count(tokens_of(defined).unwrap_or(&export.tokens).clone(), &mut written);
            let formals = defined.head().parameters.iter().map(|formal| &formal.name);
            names.extend(formals.filter(|name| written.get(&plain(name)) == Some(&1)));
        }
    }
    names
}

fn count(tokens: TokenStream, written: &mut BTreeMap<String, usize>) {
    for token in tokens {
        match token {
            TokenTree::Ident(name) => *written.entry(plain(&name)).or_default() += 1,
            TokenTree::Group(group) => count(group.stream(), written),
            _ => {}
        }
    }
}
