//! The procedural macros of reuleaux, and the reference of its language.
//!
//! Users depend on the crate `reuleaux`, which re-exports both macros: [`mechanism!`] declares a mechanism and becomes a type that
//! can be solved, [`constraint!`] defines a kind of joint that mechanisms can use. The joints, drives and motion laws that are
//! always there are the modules of `reuleaux::library`, one manual page each.
//!
//! This crate is only doors: the compiler behind them is the ordinary library `reuleaux-compiler`.

use proc_macro::TokenStream;

#[doc = include_str!("reference/mechanism.md")]
#[proc_macro]
pub fn mechanism(tokens: TokenStream) -> TokenStream {
    reuleaux_compiler::mechanism(tokens.into()).into()
}

#[doc = include_str!("reference/constraint.md")]
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

/// The pages of the index of errors, as modules.
#[doc(hidden)]
#[proc_macro]
pub fn __error_pages(_: TokenStream) -> TokenStream {
    reuleaux_compiler::error_pages().into()
}

/// The Rust blocks of the README are compiled and run with those of the pages above.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;
