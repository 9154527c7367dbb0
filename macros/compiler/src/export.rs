//! How a definition crosses from one macro call to another.
//!
//! `constraint!` emits a hidden macro that hands the definition's tokens to whatever macro its
//! caller names; `mechanism!` calls it by the path of its `use` item and goes on in `__resume!`.
//!
//! ```text
//! mechanism! { … use path::rolling; … }
//!   ─▶ path::rolling! { [::reuleaux::__resume] { known } rolling { … } }
//!   ─▶ ::reuleaux::__resume! { { constraint rolling … } { known } rolling { … } }
//! ```

use crate::diag::{Diag, EquationFact, NameFact};
use crate::quantity::Ambient;
use crate::syntax::ast::{ComponentItem, Defined, Definitions, Export, Use};
use crate::syntax::{self, plain};
use proc_macro2::{Group, Ident, Punct, Spacing, Span, TokenStream, TokenTree};
use quote::{format_ident, quote, quote_spanned};
use std::collections::BTreeSet;

/// Reports duplicate names among the exports, and empty bundles.
pub(crate) fn check_names(definitions: &Definitions, diag: &mut Diag) {
    let unique = |names: Vec<&Ident>, diag: &mut Diag| {
        for (position, name) in names.iter().enumerate() {
            if names[..position].contains(name) {
                diag.refuse::<()>(*name, NameFact::Duplicate { name: name.to_string(), first: "another definition" });
            }
        }
    };
    unique(definitions.exports.iter().map(|export| &export.name).collect(), diag);
    for bundle in definitions.exports.iter().filter(|export| export.is_bundle) {
        if bundle.definitions.is_empty() {
            diag.refuse::<()>(&bundle.name, EquationFact::EmptyBundle { name: bundle.name.to_string() });
        }
        unique(bundle.own_names(), diag);
    }
}

/// The macros that stand for definitions; `is_broken` ones hand over nothing, so that a mistake is
/// reported once.
pub(crate) fn export(definitions: &Definitions, is_broken: bool) -> TokenStream {
    let exports = &definitions.exports;
    // A name that is exported twice has been refused; rustc need not say so again.
    let is_first = |position: usize, export: &Export| !exports[..position].iter().any(|before| before.name == export.name);
    exports
        .iter()
        .enumerate()
        .filter(|(position, export)| is_first(*position, export))
        .map(|(_, export)| exported(export, &Beside { export, exports, is_broken }))
        .collect()
}

/// The definitions that a component can call: those of its own bundle first, then all others of the same `constraint!`.
struct Beside<'a> {
    export: &'a Export,
    exports: &'a [Export],
    is_broken: bool,
}

impl Beside<'_> {
    /// The tokens handed over for definitions called `own`: theirs, behind `bundle` if they are those of one, and in braces those of others that
    /// their components call, after the name of the crate.
    fn handed(&self, own: &[&Ident], (bundle, tokens): (Option<TokenStream>, &TokenStream)) -> TokenStream {
        let (mut fellows, mut called) = (TokenStream::new(), called_by_components(tokens));
        let mut pending: Vec<(&Ident, &TokenStream)> = self.all().filter(|(name, _)| !own.contains(name)).collect();
        // A fellow may call others.
        while let Some(at) = pending.iter().position(|(name, _)| called.contains(&plain(name))) {
            let (name, definition) = pending.remove(at);
            pending.retain(|(other, _)| *other != name);
            called.extend(called_by_components(definition));
            fellows.extend(definition.clone());
        }
        let origin = has_component(tokens)
            .then(|| ["CARGO_PKG_NAME", "CARGO_PKG_VERSION"].map(|name| std::env::var(name).unwrap_or_default()).join(" "));
        let fellows = (!fellows.is_empty()).then(|| quote!({ #fellows }));
        quote!(#origin #bundle #tokens #fellows)
    }

    fn all(&self) -> impl Iterator<Item = (&Ident, &TokenStream)> {
        let own = self.export.members.iter();
        let single = self.exports.iter().filter(|export| !export.is_bundle).map(|export| (&export.name, &export.tokens));
        let others = self.exports.iter().flat_map(|export| &export.members);
        own.map(|(name, tokens)| (name, tokens)).chain(single).chain(others.map(|(name, tokens)| (name, tokens)))
    }
}

/// Words that are called, if there is a component among the definitions.
fn called_by_components(tokens: &TokenStream) -> BTreeSet<String> {
    if has_component(tokens) { syntax::called(tokens.clone()) } else { BTreeSet::new() }
}

fn has_component(tokens: &TokenStream) -> bool {
    tokens.clone().into_iter().any(|token| matches!(token, TokenTree::Ident(word) if word == "component"))
}

/// Components, each with the tokens that are handed over for it.
pub(crate) fn components(definitions: &Definitions) -> Vec<(&ComponentItem, TokenStream)> {
    let exports = &definitions.exports;
    let mut found = Vec::new();
    for export in exports {
        let beside = Beside { export, exports, is_broken: false };
        for defined in &export.definitions {
            if let Defined::Component(component) = defined {
                let name = &component.head.name;
                let tokens = export.members.iter().find(|(member, _)| member == name).map_or(&export.tokens, |(_, tokens)| tokens);
                found.push((component, beside.handed(&[name], (None, tokens))));
            }
        }
    }
    found
}

fn exported(export: &Export, beside: &Beside) -> TokenStream {
    let Export { docs, visibility, name, tokens, .. } = export;
    let docs = &docs.tokens;
    let bundle = export.is_bundle.then(|| quote!(bundle));
    let (hidden, macro_) = handing_over(beside, name, &export.own_names(), (bundle, tokens));
    let members = (!export.members.is_empty()).then(|| members(export, beside));
    quote! {
        #macro_
        #docs
        #[doc(inline)]
        #[allow(unused_imports)]
        #visibility use #hidden as #name;
        #members
    }
}

/// The hidden macro that hands tokens over, and its name.
///
/// * `bundle`: given, the word before the definitions of a bundle.
fn handing_over(
    beside: &Beside,
    name: &Ident,
    own: &[&Ident],
    (bundle, tokens): (Option<TokenStream>, &TokenStream),
) -> (Ident, TokenStream) {
    let Beside { export, is_broken, .. } = *beside;
    let handed = if is_broken { TokenStream::new() } else { at_home(beside.handed(own, (bundle, tokens))) };
    let hidden = format_ident!("__reuleaux_{}_{}", plain(name), fingerprint(export), span = Span::call_site());
    let exported = is_public(export).then(|| quote!(#[macro_export]));
    let macro_ = quote! {
        #[doc(hidden)]
        #exported
        macro_rules! #hidden {
            ([$($callback:tt)*] $($rest:tt)*) => { $($callback)* ! { { #handed } $($rest)* } };
        }
    };
    (hidden, macro_)
}

fn is_public(export: &Export) -> bool {
    export.visibility.to_string() == "pub"
}

/// The definitions of a bundle one by one, in a module of the bundle's name.
fn members(export: &Export, beside: &Beside) -> TokenStream {
    let Export { visibility, name, .. } = export;
    let handed = export.members.iter().map(|(member, tokens)| (member, handing_over(beside, member, &[member], (None, tokens))));
    let (macros, uses): (Vec<TokenStream>, Vec<TokenStream>) = handed
        .map(|(member, (hidden, macro_))| {
            let visibility = if is_public(export) { quote!(pub) } else { quote!(pub(crate)) };
            (macro_, quote!(#visibility use #hidden as #member;))
        })
        .unzip();
    let page = format!("The definitions of the bundle `{name}`, to be used one by one.");
    quote! {
        #(#macros)*
        #[doc = #page]
        #[allow(unused_imports)]
        #visibility mod #name { #(#uses)* }
    }
}

/// Paths that begin with `crate` mean the crate of the definition, wherever it is used.
fn at_home(tokens: TokenStream) -> TokenStream {
    let inner = |tree: TokenTree| match tree {
        TokenTree::Group(group) => {
            let mut anew = Group::new(group.delimiter(), at_home(group.stream()));
            anew.set_span(group.span());
            TokenTree::Group(anew).into()
        }
        TokenTree::Ident(name) if name == "crate" => {
            let dollar = Punct::new('$', Spacing::Joint);
            quote!(#dollar #name)
        }
        other => TokenStream::from(other),
    };
    tokens.into_iter().map(inner).collect()
}

/// Keeps apart exports of the same name in different modules. FNV-1a over text and place.
fn fingerprint(export: &Export) -> String {
    let place = export.name.span().start();
    let text = format!("{}{}:{}", export.tokens, place.line, place.column);
    let hash = text.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3));
    format!("{hash:016x}")
}

/// The call that asks for one more definition.
pub(crate) fn resume(wanted: &Use, known: &TokenStream, mechanism: &TokenStream) -> TokenStream {
    let (path, name) = (&wanted.path.tokens, &wanted.name);
    // A macro that is no constraint is blamed for its first tokens: they lie in the `use` item.
    let span = wanted.path.last.span();
    let call = quote_spanned!(span=> [::reuleaux::__resume] { #known } #name { #mechanism });
    quote! { #path! { #call } }
}

/// The manual pages of the library as modules that rustdoc shows.
pub(crate) fn library_pages() -> TokenStream {
    let page = |(name, text): (&str, &str)| {
        let module = Ident::new(name, Span::call_site());
        let (docs, code): (Vec<&str>, Vec<&str>) = text.lines().partition(|line| line.starts_with("///"));
        let docs: Vec<&str> = docs.iter().map(|line| line.trim_start_matches("///").strip_prefix(' ').unwrap_or("")).collect();
        let page = format!("{}\n\n# Definition\n\n```text\n{}\n```\n", docs.join("\n"), code.join("\n"));
        quote! { #[doc = #page] pub mod #module {} }
    };
    let plane: TokenStream = crate::library::pages().map(page).collect();
    let space = crate::library::spatial_pages().map(page);
    let forces = crate::library::force_pages(Ambient::Plane).map(page);
    let spatial_forces = crate::library::force_pages(Ambient::Space).map(page);
    quote! {
        #plane
        /// Constraints of mechanisms `in space`.
        pub mod space { #(#space)* }
        /// Forces, in the plane and in space.
        pub mod force {
            #(#forces)*
            /// Forces of mechanisms `in space`.
            pub mod space { #(#spatial_forces)* }
        }
    }
}

/// The pages of the index of errors as modules that rustdoc shows.
///
/// Wrong models are no doc tests: `tests/errors` compiles each, and compares the code and the message of its refusal with the page.
pub(crate) fn error_pages() -> TokenStream {
    let page = |(code, page): &(&str, &str)| {
        let (module, tested) = (Ident::new(code, Span::call_site()), page.replace("```compile_fail", "```text"));
        quote! { #[cfg_attr(not(doctest), doc = #page)] #[cfg_attr(doctest, doc = #tested)] pub mod #module {} }
    };
    crate::diag::PAGES.iter().map(page).collect()
}
