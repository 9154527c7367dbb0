//! What refuses nothing and is said nevertheless.
//!
//! Stable Rust lets no macro warn. What the ecosystem does instead is done here: a deprecated constant is used under the tokens in
//! question, so that the compiler warns with its note. It is silent under `#[allow(deprecated)]`.

use super::{Fact, Range};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

/// A doubt, and the stretch of source that it is about.
#[derive(Clone, Debug)]
pub struct Warning {
    /// What is doubtful, with its numbers.
    pub doubt: Doubt,
    /// Where.
    pub range: Range,
}

/// What may not be meant as it is.
#[derive(Clone, Debug, PartialEq)]
pub enum Doubt {
    /// The nearest assembly is far from a declared start.
    FarStart {
        /// The body, as called from outside.
        body: String,
        /// `angle` or `position`.
        coordinate: &'static str,
        /// Where it is assembled, with units.
        found: String,
        /// Where it was declared to be.
        declared: String,
        /// How far that is.
        apart: String,
        /// The drive that puts it there, whatever is declared.
        drive: Option<String>,
        /// What to declare instead.
        instead: String,
    },
    /// The motion ends before everything has repeated itself.
    MotionEnds(Box<Fact>),
}

impl Warning {
    /// A warning of the lint `deprecated`.
    pub(crate) fn to_tokens(&self) -> TokenStream {
        let name = match self.doubt {
            Doubt::FarStart { .. } => "far_start",
            Doubt::MotionEnds(_) => "motion_ends",
        };
        let (name, words) = (Ident::new(name, self.range.first), self.doubt.to_string());
        quote! {
            const _: () = {
                #[deprecated(note = #words)]
                #[allow(non_upper_case_globals)]
                const #name: () = ();
                #name
            };
        }
    }
}
