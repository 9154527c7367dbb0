//! Names that nothing in the declaration uses.
//!
//! Parameters, inputs, `let`s, functions and arguments act only through the expressions that name them, and components through their parts: one
//! that is named nowhere changes nothing. Declared points and axes are left out, since they may be read from Rust and are drawn in pictures, and so
//! are `let`s of constraints, which are read by the names of joints. An argument of a constraint that only other definitions read, by the name of
//! a joint, causes a warning all the same: a definition is rarely meant to ignore what it is given.

use crate::diag::{Doubt, Warning};
use crate::syntax::ast::{Defined, Definitions, Expression, ExpressionKind, Item, Mechanism, every_item};
use proc_macro2::{Ident, TokenStream, TokenTree};
use std::collections::BTreeMap;

/// The names of parameters, inputs, `let`s, functions, components and their arguments that are written once, where they are declared.
/// `tokens`: given, all of the mechanism; `doubts`: given, the warnings about it.
///
/// A word that is written again with another meaning counts as a use. Of a parameter whose default is doubtful one warning is enough.
pub(crate) fn unused<'a>(tree: &'a Mechanism, tokens: TokenStream, doubts: &[Warning]) -> Vec<&'a Ident> {
    let is_doubtful = |default: &Expression| {
        let number = |doubt: &Warning| if let Doubt::BareLength { number, .. } = &doubt.doubt { Some(number.clone()) } else { None };
        matches!(&default.kind, ExpressionKind::Number { digits, unit } if unit.is_empty()
            && doubts.iter().filter_map(number).any(|number| number == *digits))
    };
    let mut written = BTreeMap::new();
    count(tokens, &mut written);
    let mut names = Vec::new();
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
            _ => {}
        }
    }
    names.retain(|name| written.get(&name.to_string()) == Some(&1));
    names
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
            names.extend(formals.filter(|name| written.get(&name.to_string()) == Some(&1)));
        }
    }
    names
}

fn count(tokens: TokenStream, written: &mut BTreeMap<String, usize>) {
    for token in tokens {
        match token {
            TokenTree::Ident(name) => *written.entry(name.to_string()).or_default() += 1,
            TokenTree::Group(group) => count(group.stream(), written),
            _ => {}
        }
    }
}
