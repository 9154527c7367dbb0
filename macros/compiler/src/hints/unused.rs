//! Names that nothing in the declaration uses.
//!
//! Parameters, inputs, `let`s and functions act only through the expressions that name them: one that is named nowhere changes nothing. Points
//! and axes are left out, since they may be read from Rust and are drawn in pictures.

use crate::diag::{Doubt, Warning};
use crate::syntax::ast::{Expression, ExpressionKind, Item, Mechanism, every_item};
use proc_macro2::{Ident, TokenStream, TokenTree};
use std::collections::BTreeMap;

/// The names of parameters, inputs, `let`s and functions that are written once, where they are declared. `tokens`: given, all of the
/// mechanism; `doubts`: given, the warnings about it.
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
            _ => {}
        }
    }
    names.retain(|name| written.get(&name.to_string()) == Some(&1));
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
