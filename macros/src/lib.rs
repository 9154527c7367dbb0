//! The procedural macros of reuleaux, and the reference of its language.
//!
//! Users depend on the crate `reuleaux`, which re-exports both macros: [`mechanism!`] declares a mechanism and generates a type that
//! solves it, [`constraint!`] defines a kind of joint for use in mechanisms. The modules of `reuleaux::library` document the built-in
//! joints, drives and motion laws, one manual page each.
//!
//! This crate only forwards to the compiler, the ordinary library `reuleaux-compiler`. The examples of its reference are tests of `reuleaux`, since
//! they need the runtime.

use proc_macro::TokenStream;

#[cfg_attr(not(doctest), doc = include_str!("reference/mechanism.md"))]
#[proc_macro]
pub fn mechanism(tokens: TokenStream) -> TokenStream {
    reuleaux_compiler::mechanism(tokens.into()).into()
}

#[cfg_attr(not(doctest), doc = include_str!("reference/constraint.md"))]
#[proc_macro]
pub fn constraint(tokens: TokenStream) -> TokenStream {
    reuleaux_compiler::constraint(tokens.into()).into()
}

/// Resumes the compilation of a mechanism after a definition has been handed over.
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

/// The pages of the error index, as modules.
#[doc(hidden)]
#[proc_macro]
pub fn __error_pages(_: TokenStream) -> TokenStream {
    reuleaux_compiler::error_pages().into()
}
