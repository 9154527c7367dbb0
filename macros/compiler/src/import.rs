//! Definitions that the `use` items of a mechanism bring in.
//!
//! A component of `constraint!` has a home: the definitions that it sees there, which are handed over together with it. Names of the mechanism cannot
//! change its meaning. Components become generated types, so that two components of one name have to be the same.

use crate::diag::{Diag, NameFact, ValueFact};
use crate::quantity::Ambient;
use crate::syntax::{self, ast, plain};
use ast::{ComponentHome, ComponentItem, Defined, Definition, Handed, Item, Mechanism, Shared};
use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};
use std::collections::BTreeMap;
use std::rc::Rc;

/// Constraints and forces, each with its name in the mechanism.
pub(crate) type Definitions = Vec<(String, Definition)>;

/// Definitions that all `use` items bring in, and those that come along.
#[derive(Debug, Default)]
pub(crate) struct Imported {
    pub(crate) definitions: Definitions,
    pub(crate) components: Vec<Shared<ComponentItem>>,
    /// The definitions that the components see.
    pub(crate) homes: Vec<ComponentHome>,
    /// By the name of each `use` item, the names in the mechanism that it brings in.
    pub(crate) brought: BTreeMap<String, Vec<String>>,
    /// By name in the mechanism, a component, its crate and tokens, and true if its name is that of a `use` item.
    known: BTreeMap<String, (Shared<ComponentItem>, String, bool)>,
    /// The same of constraints.
    kinds: BTreeMap<String, (String, bool)>,
}

/// Reads `name { definitions } …`. A single definition takes the name in its `use` item; the definitions of a bundle keep their own names.
pub(crate) fn imported(tree: &Mechanism, known: TokenStream, diag: &mut Diag) -> Imported {
    let mut all = Imported::default();
    for (name, tokens) in entries(known) {
        let mut handed = syntax::parse_exported(tokens, diag).unwrap_or_default();
        let is_single = handed.iter().filter(|one| one.is_named && !one.is_of_bundle).count() == 1;
        if is_single && let Some(single) = handed.first().filter(|single| !is_of(&single.defined, tree.ambient)) {
            let word = plain(&single.defined.head().name);
            diag.refuse::<()>(&name, ValueFact::only_elsewhere(word, None, tree.ambient));
        }
        // Of a bundle, those of the other ambient are left out.
        handed.retain(|one| is_of(&one.defined, tree.ambient));
        let before = diag.refusals().len();
        let mut home = ComponentHome::default();
        for Handed { defined, tokens, is_named, origin, .. } in handed {
            let own = plain(&defined.head().name);
            let is_single = is_named && is_single;
            let called = Called { used: &name, word: if is_single { plain(&name) } else { own.clone() }, is_single };
            if is_named {
                all.brought.entry(name.to_string()).or_default().push(called.word.clone());
            }
            let text = format!("{origin} {tokens}");
            match defined {
                Defined::Constraint(definition) => {
                    if is_named {
                        all.constraint(called, &definition, text, diag);
                    }
                    home.definitions.insert(own, Rc::new(definition));
                }
                Defined::Component(component) => {
                    let item = all.component(tree, called, (component, text), diag);
                    if is_named && all.components.iter().all(|known| known.id() != item.id()) {
                        all.components.push(item.clone());
                    }
                    home.components.insert(own, item);
                }
            }
        }
        // One refusal of a `use` item is enough.
        diag.withdraw(diag.refusals().len().min(before + 1));
        all.homes.push(home);
    }
    all
}

/// True for a definition that mechanisms in this ambient can use.
fn is_of(defined: &Defined, ambient: Ambient) -> bool {
    defined.ambient().is_none_or(|own| own == ambient)
}

/// The name of a definition in the mechanism.
struct Called<'a> {
    /// The name in the `use` item.
    used: &'a Ident,
    word: String,
    /// True if both are the same.
    is_single: bool,
}

impl Imported {
    /// Adds a constraint under its name in the mechanism.
    fn constraint(&mut self, Called { used, word, is_single }: Called, definition: &Definition, text: String, diag: &mut Diag) {
        match self.kinds.get(&word) {
            // The resolver refuses a name in two `use` items.
            Some((other, is_also_single)) if *other != text && !(is_single && *is_also_single) => {
                diag.refuse::<()>(used, NameFact::Duplicate { name: word, first: "another `use`" });
            }
            Some(_) => {}
            None => {
                self.kinds.insert(word.clone(), (text, is_single));
                self.definitions.push((word, definition.clone()));
            }
        }
    }

    /// The component with a name in the mechanism: a new one, unless the same one has come along before.
    fn component(
        &mut self,
        tree: &Mechanism,
        Called { used, word, is_single }: Called,
        (component, text): (ComponentItem, String),
        diag: &mut Diag,
    ) -> Shared<ComponentItem> {
        let known = self.known.get(&word);
        if let Some((item, ..)) = known.filter(|(_, known, is_also_single)| *known == text || is_single && *is_also_single) {
            return item.clone();
        }
        let own = |item: &Item| match item {
            Item::Component(own) if plain(&own.head.name) == word => Some(own.clone()),
            _ => None,
        };
        let other = known.map(|(item, ..)| item.clone()).or_else(|| tree.items.iter().filter(|_| !is_single).find_map(own));
        if let Some(other) = other {
            diag.refuse::<()>(used, NameFact::BroughtAlong { name: word, by: used.to_string() });
            return other;
        }
        let mut component = ComponentItem { home: Some(self.homes.len()), ..component };
        component.head.name = Ident::new(&word, used.span());
        let item = Shared::new(component);
        self.known.insert(word, (item.clone(), text, is_single));
        item
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
