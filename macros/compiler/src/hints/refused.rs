//! Items that were refused, by the kind that their keyword probably means.

use crate::diag::nearest;
use crate::names::is_generated;
use crate::syntax::ast::{Item, Mechanism};
use proc_macro2::Ident;
use std::collections::BTreeSet;

/// The names of refused items of a kind, each once, with their number of indices.
pub(crate) fn refused<'a>(tree: &'a Mechanism, kind: &str) -> Vec<(&'a Ident, usize)> {
    let mut names: Vec<(&Ident, usize)> = Vec::new();
    let mut pending: Vec<&Item> = tree.items.iter().rev().collect();
    while let Some(item) = pending.pop() {
        match item {
            Item::Refused(refused) if is_meant(&refused.keyword, kind) && !is_generated(&refused.name) => {
                names.push((&refused.name, refused.indices.len()));
            }
            Item::For(repeated) => pending.extend(repeated.items.iter().rev()),
            _ => {}
        }
    }
    let mut taken = BTreeSet::new();
    names.retain(|(name, _)| taken.insert(name.to_string()));
    names
}

/// A keyword that may be mistyped stands for this kind of item.
fn is_meant(keyword: &Ident, kind: &str) -> bool {
    nearest(&keyword.to_string(), ["param", "body", "output"].into_iter()).is_some_and(|near| near == kind)
}
