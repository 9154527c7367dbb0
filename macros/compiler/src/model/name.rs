//! Names of declared items.

use crate::diag::Range;
use proc_macro2::Ident;
use quote::{ToTokens, TokenStreamExt};
use std::collections::BTreeSet;
use std::fmt;

/// The name of an item, as written and with its path.
#[derive(Clone, Debug)]
pub struct Name {
    /// Identifier as written in the declaration.
    pub word: Ident,
    /// Number of the declaration; all iterations of a loop and all parts of a component share it.
    pub declaration: usize,
    /// Indices of the item itself.
    pub indices: Vec<usize>,
    /// Full path: `leg[3].coupler`.
    pub path: String,
    /// Path as a Rust identifier, `leg_3_coupler`; unique for bodies and loads.
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

    /// The path without the marks of raw identifiers, as it is shown.
    pub(crate) fn unraw(&self) -> String {
        self.path.replace("r#", "")
    }

    /// Identifier with the item's own indices: `coupler[2]`.
    pub(crate) fn own(&self) -> String {
        self.indices.iter().fold(self.word.to_string(), |name, index| format!("{name}[{index}]"))
    }

    /// The field of the generated struct that holds a parameter or, below [`Name::INPUTS`], a part of an input.
    pub(crate) fn of_input(word: &Ident, input: &Name) -> Name {
        Name::within(&format!("{}.{}.", Name::INPUTS, input.own()), word, input.declaration, &[])
    }

    /// The field of the generated struct that holds the inputs.
    pub(crate) const INPUTS: &str = "inputs";

    /// The name of an input, from that of one of its parts: `inputs.theta.value` is of `theta`.
    pub(crate) fn input_path(&self) -> &str {
        let path = self.path.strip_prefix(Name::INPUTS).and_then(|path| path.strip_prefix('.'));
        path.and_then(|path| path.rsplit_once('.')).map_or(&self.path, |(input, _)| input)
    }

    /// The path as a user knows it: the value of an input is the input itself, and its rate is `theta.rate`.
    pub(crate) fn told(&self) -> &str {
        let path = self.path.strip_prefix(Name::INPUTS).and_then(|path| path.strip_prefix('.'));
        path.map_or(&self.path, |path| path.strip_suffix(".value").unwrap_or(path))
    }

    /// The name of the load of this joint on a body: `mesh_on_wheel`.
    pub(crate) fn on(&self, body: &Name) -> Name {
        Name { local: format!("{}_on_{}", self.local, body.local), ..self.clone() }
    }

    /// Gives names identifiers of their own, where those of `leg[0]` and `leg_0` would be the same: what is written as its identifier keeps it, and the
    /// other one has `_` after it.
    pub(crate) fn tell_apart(names: Vec<&mut Name>) {
        let is_written = |name: &Name| name.path.trim_start_matches("r#") == name.local;
        let (written, others): (Vec<&mut Name>, Vec<&mut Name>) = names.into_iter().partition(|name| is_written(name));
        let mut taken = BTreeSet::new();
        for name in written.into_iter().chain(others) {
            while !taken.insert(name.local.clone()) {
                name.local.push('_');
            }
        }
    }

    /// A name in a namespace whose paths begin with `prefix`.
    pub(crate) fn within(prefix: &str, word: &Ident, declaration: usize, indices: &[usize]) -> Name {
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

/// Declarations for which an error has been reported.
#[derive(Default)]
pub(crate) struct Said(BTreeSet<usize>);

impl Said {
    /// Records an error for this item. True if it is the first one for its declaration, in any loop iteration and any part.
    pub(crate) fn is_new(&mut self, name: &Name) -> bool {
        self.0.insert(name.declaration)
    }
}
