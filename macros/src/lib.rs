//! The procedural macros of reuleaux.

use proc_macro::TokenStream;

/// Declares a mechanism.
#[proc_macro]
pub fn mechanism(tokens: TokenStream) -> TokenStream {
    reuleaux_compiler::mechanism(tokens.into()).into()
}

/// Defines constraints.
#[proc_macro]
pub fn constraint(tokens: TokenStream) -> TokenStream {
    reuleaux_compiler::constraint(tokens.into()).into()
}

/// Goes on with a mechanism after a definition has been handed over.
#[doc(hidden)]
#[proc_macro]
pub fn __resume(tokens: TokenStream) -> TokenStream {
    reuleaux_compiler::resume(tokens.into()).into()
}

/// The manual pages of the standard library, as modules.
#[doc(hidden)]
#[proc_macro]
pub fn __library_pages(_: TokenStream) -> TokenStream {
    reuleaux_compiler::library_pages().into()
}
