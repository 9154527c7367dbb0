//! What a declared item is called.

use crate::diag::Range;
use proc_macro2::Ident;
use quote::{ToTokens, TokenStreamExt};
use std::collections::BTreeSet;
use std::fmt;

/// The name of an item, as written and as called from outside.
#[derive(Clone, Debug)]
pub struct Name {
    /// As written where it was declared.
    pub word: Ident,
    /// The number of its declaration: all rounds of a loop and all parts of a component have it in common.
    pub declaration: usize,
    /// Its own indices.
    pub indices: Vec<usize>,
    /// As it is called from outside: `leg[3].coupler`.
    pub path: String,
    /// The same as a name of Rust, `leg_3_coupler`; that of a body is unlike all others.
    pub local: String,
}

impl Name {
    /// A name of the mechanism itself, without indices.
    #[must_use]
    pub fn plain(word: &Ident) -> Name {
        let path = word.to_string();
        let local = path.trim_start_matches("r#").to_owned();
        Name { word: word.clone(), declaration: 0, indices: Vec::new(), path, local }
    }

    /// Its word and its own indices: `coupler[2]`.
    pub(super) fn own(&self) -> String {
        self.indices.iter().fold(self.word.to_string(), |name, index| format!("{name}[{index}]"))
    }

    /// A name in a space whose names begin with `prefix`.
    pub(super) fn within(prefix: &str, word: &Ident, declaration: usize, indices: &[usize]) -> Name {
        let mut name = Name { declaration, indices: indices.to_vec(), ..Name::plain(word) };
        name.path = format!("{prefix}{}", name.own());
        name.local = name.path.replace(['.', '['], "_").replace(']', "").replace("r#", "");
        name
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.path)
    }
}

impl From<&Name> for Range {
    fn from(name: &Name) -> Range {
        (&name.word).into()
    }
}

impl ToTokens for Name {
    fn to_tokens(&self, tokens: &mut proc_macro2::TokenStream) {
        tokens.append(self.word.clone());
    }
}

/// The declarations of which something has been said.
#[derive(Default)]
pub(crate) struct Said(BTreeSet<usize>);

impl Said {
    /// Nothing has been said of this item, nor of another by the same declaration: in another round of a loop, or in another part.
    pub(crate) fn is_new(&mut self, name: &Name) -> bool {
        self.0.insert(name.declaration)
    }
}
