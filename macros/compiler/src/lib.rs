//! The compiler behind reuleaux's macros, as an ordinary library. It translates the declaration of a mechanism into Rust code for its
//! constraint equations, their Jacobian, ν and γ.
//!
//! ```text
//! tokens ─parse─▶ Ast ─resolve─▶ Model ─assemble─▶ System ─find─▶ redundant rows ─analyze─▶ Structure
//!        ─assemble─▶ Assembly ─follow─▶ Motion ─derive─▶ Dynamics ─schedule─▶ Plan ─emit─▶ tokens
//! ```
//!
//! Each room reads only the results of earlier rooms; `compile.rs` shows all rooms on one page. Users depend on the crate
//! `reuleaux`, which re-exports the macros. This crate is for tests, fuzzers, benchmarks and build scripts; its interface may change in
//! any version.

pub mod assembly;
mod compile;
mod connectivity;
pub mod diag;
mod docs;
pub mod dynamics;
mod emit;
mod expansion;
mod export;
pub mod expr;
pub mod geometry;
mod hints;
mod import;
pub mod library;
mod linear;
mod mobility;
pub mod model;
mod names;
mod numeric;
pub mod picture;
pub mod plan;
mod profile;
pub mod quantity;
mod redundancy;
mod resolve;
pub mod structure;
mod stub;
pub mod syntax;
pub mod system;
pub mod travel;
mod words;

pub use compile::{Compiled, check_constraint, compile, constraint, error_pages, library_pages, mechanism, resume};
