//! Attributes by which generated structs are serialised, for `#[serde]`.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{quote, quote_spanned};

/// The longest array that serde reads and writes by itself.
const LONGEST_ARRAY: usize = 32;

/// `Serialize` and `Deserialize` of a struct over `T`. A field that is not given has the value that it has in the result of the function
/// `defaults`; without that function it must be given.
pub(super) fn derived(word: Option<&Ident>, defaults: Option<&Ident>) -> TokenStream {
    let Some(word) = word else { return quote!() };
    let default = defaults.map(|name| {
        // What serde declares at the place of the path it reads at that of the word `serde`. A mechanism with `use` items is written by another macro.
        let mut path = Literal::string(&format!("{name}::with_defaults"));
        path.set_span(word.span());
        quote_spanned!(word.span()=> , default = #path)
    });
    quote_spanned! {word.span()=>
        #[derive(::reuleaux::serde::Serialize, ::reuleaux::serde::Deserialize)]
        #[serde(
            crate = "::reuleaux::serde",
            bound(
                serialize = "T: ::reuleaux::Float + ::reuleaux::serde::Serialize",
                deserialize = "T: ::reuleaux::Float + ::reuleaux::serde::Deserialize<'de>"
            )
            #default
        )]
    }
}

/// The same of a stub.
pub(crate) fn promised(word: Option<&Ident>, name: &Ident, body: &TokenStream) -> TokenStream {
    let Some(word) = word else { return quote!() };
    quote_spanned! {word.span()=>
        impl<T> ::reuleaux::serde::Serialize for #name<T> {
            fn serialize<S: ::reuleaux::serde::Serializer>(&self, _: S) -> ::core::result::Result<S::Ok, S::Error> { #body }
        }
        impl<'de, T> ::reuleaux::serde::Deserialize<'de> for #name<T> {
            fn deserialize<D: ::reuleaux::serde::Deserializer<'de>>(_: D) -> ::core::result::Result<Self, D::Error> { #body }
        }
    }
}

/// The format of a field that is an array, if serde needs one.
pub(super) fn listed(word: Option<&Ident>, sizes: &[usize]) -> TokenStream {
    let Some(word) = word.filter(|_| sizes.iter().any(|size| *size > LONGEST_ARRAY)) else { return quote!() };
    let each = "::reuleaux::serial::Each".to_owned();
    let format = sizes.iter().fold(each, |inner, _| format!("::reuleaux::serial::Rows::<{inner}>"));
    quote_spanned!(word.span()=> #[serde(with = #format)])
}

/// The field without a value.
pub(super) fn skipped(word: Option<&Ident>) -> TokenStream {
    word.map_or(quote!(), |word| quote_spanned!(word.span()=> #[serde(skip)]))
}
