//! The compiler behind reuleaux's macros.

pub mod diag;
pub mod expr;
pub mod library;
pub mod model;
pub mod syntax;
