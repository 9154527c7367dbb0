//! Definitions that the `use` items of a mechanism bring in.
//!
//! A component of `constraint!` sees no name of the mechanism, and brings the constraints and components that it calls with it. Kinds of joints and
//! components have one namespace in a mechanism, so that a name which would mean one thing there and another one in the component is refused.

use crate::diag::{Diag, NameFact, ValueFact};
use crate::quantity::Ambient;
use crate::syntax::{self, ast};
use ast::{ComponentItem, Defined, Definition, Handed};
use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};

/// Constraints and forces, each with its name in the mechanism.
pub(crate) type Definitions = Vec<(String, Definition)>;

/// What all `use` items bring in.
#[derive(Debug, Default)]
pub(crate) struct Imported {
    pub(crate) definitions: Definitions,
    pub(crate) components: Vec<ComponentItem>,
}

/// A name that one `use` item brings in.
struct ImportedName {
    word: String,
    tokens: String,
    is_named: bool,
}

/// What one `use` item brings in.
struct Import {
    /// Its name in the mechanism.
    name: Ident,
    names: Vec<ImportedName>,
    /// Words that its components call.
    called: BTreeSet<String>,
}

/// Reads `name { definitions } …`. A single definition takes the name in its `use` item; the definitions of a bundle keep their own names.
pub(crate) fn imported(known: TokenStream, ambient: Ambient, diag: &mut Diag) -> Imported {
    let mut all = Imported::default();
    let mut taken: BTreeMap<String, String> = BTreeMap::new();
    let mut read: Vec<Import> = Vec::new();
    for (name, tokens) in entries(known) {
        let handed = syntax::parse_exported(tokens, diag).unwrap_or_default();
        let is_single = handed.iter().filter(|one| one.is_named).count() == 1;
        let mut import = Import { name: name.clone(), names: Vec::new(), called: BTreeSet::new() };
        for Handed { mut defined, tokens, is_named } in handed {
            let own = defined.head().name.to_string();
            let word = if is_named && is_single { name.to_string() } else { own };
            let text = tokens.to_string();
            if defined.ambient().is_some_and(|of| of != ambient) {
                diag.refuse::<()>(&name, ValueFact::only_elsewhere(word, None, ambient));
                break;
            }
            if let Defined::Component(component) = &mut defined {
                component.head.name = Ident::new(&word, name.span());
                import.called.extend(syntax::called(tokens));
            }
            import.names.push(ImportedName { word: word.clone(), tokens: text.clone(), is_named });
            // Two components may call the same one.
            if taken.insert(word.clone(), text.clone()).is_none_or(|before| before != text) {
                match defined {
                    Defined::Constraint(definition) => all.definitions.push((word, definition)),
                    Defined::Component(component) => all.components.push(component),
                }
            }
        }
        read.push(import);
    }
    for import in &read {
        if let Some(fact) = read.iter().filter(|other| import.name != other.name).find_map(|other| import.replaces(other)) {
            diag.refuse::<()>(&import.name, fact);
        }
    }
    all
}

impl Import {
    /// The fact that a name of this item means something else in a component of another one.
    fn replaces(&self, other: &Import) -> Option<NameFact> {
        let is_another = |name: &&ImportedName| {
            let there = other.names.iter().find(|there| there.word == name.word);
            match there {
                // The resolver refuses a name in two `use` items.
                Some(there) => !there.is_named && there.tokens != name.tokens,
                None => name.is_named && other.called.contains(&name.word),
            }
        };
        let ImportedName { word, is_named, .. } = self.names.iter().find(is_another)?;
        Some(NameFact::CalledByComponent { name: word.clone(), component: other.name.to_string(), can_be_renamed: *is_named })
    }
}

/// Names in the mechanism that have been handed over.
pub(crate) fn names(known: &TokenStream) -> Vec<String> {
    entries(known.clone()).into_iter().map(|(name, _)| name.to_string()).collect()
}

/// `name { definitions } …`
fn entries(known: TokenStream) -> Vec<(Ident, TokenStream)> {
    let trees: Vec<TokenTree> = known.into_iter().collect();
    let entry = |pair: &[TokenTree]| match pair {
        [TokenTree::Ident(name), TokenTree::Group(group)] if group.delimiter() == Delimiter::Brace => Some((name.clone(), group.stream())),
        _ => None,
    };
    trees.chunks(2).filter_map(entry).collect()
}
