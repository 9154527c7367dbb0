//! The sink into which every room puts its refusals, and where they lie.
//!
//! In: facts and the tokens they are about. Out: `compile_error!` tokens, one block per refusal.
//! Not done here: words. `message.rs` alone turns a fact into a sentence.

mod code;
mod fact;
mod message;
mod remedy;
mod shown;
mod suggest;
mod warning;

pub use code::PAGES;
pub use fact::{
    ArityFact, ArrayFact, AssemblyFact, Bound, Count, Demand, Driven, EquationFact, Fact, Forgotten, Gap, GrammarFact, Known, NameFact,
    SystemFact, ValueFact,
};
pub(crate) use message::{degrees, millimetres, significant};
pub(crate) use remedy::quantity;
pub(crate) use suggest::{nearest, nearest_unit};
pub use warning::{Doubt, Warning};

use proc_macro2::{Ident, Span, TokenStream};

/// The stretch of source a fact is about: from its first token to its last.
#[derive(Clone, Copy, Debug)]
pub struct Range {
    /// Span of the first token.
    pub first: Span,
    /// Span of the last token.
    pub last: Span,
}

impl Range {
    /// From the start of this range to the end of another.
    pub(crate) fn to(self, end: impl Into<Range>) -> Range {
        Range { first: self.first, last: end.into().last }
    }
}

impl From<Span> for Range {
    fn from(span: Span) -> Range {
        Range { first: span, last: span }
    }
}

impl From<&Ident> for Range {
    fn from(name: &Ident) -> Range {
        name.span().into()
    }
}

/// One refusal: a fact, and the smallest stretch of source that is to blame.
#[derive(Clone, Debug)]
pub struct Refusal {
    /// What is wrong, with its numbers.
    pub fact: Fact,
    /// Where.
    pub range: Range,
}

impl From<syn::Error> for Refusal {
    fn from(error: syn::Error) -> Refusal {
        Refusal { range: error.span().into(), fact: GrammarFact::Syntax { message: error.to_string() }.into() }
    }
}

impl From<syn::Error> for Box<Refusal> {
    fn from(error: syn::Error) -> Box<Refusal> {
        Box::new(error.into())
    }
}

impl Refusal {
    /// The refusal as a `syn` error whose underline covers the whole range.
    pub fn to_error(&self) -> syn::Error {
        // `Span::join` gives nothing on stable Rust; an error made from two tokens is underlined
        // from the first to the second.
        let ends = [Ident::new("a", self.range.first), Ident::new("b", self.range.last)];
        let tokens: TokenStream = ends.into_iter().map(proc_macro2::TokenTree::from).collect();
        syn::Error::new_spanned(tokens, self.fact.message())
    }
}

/// A keyword was found where a name or an expression should stand.
fn is_about(fact: &Fact, word: &str) -> bool {
    match fact {
        Fact::Grammar(GrammarFact::Keyword { word: other }) => other == word,
        Fact::Grammar(GrammarFact::Expected { found, .. }) => {
            found.strip_prefix('`').and_then(|found| found.strip_suffix('`')) == Some(word)
        }
        _ => false,
    }
}

/// Gathers refusals; a room stops at its door if there are any.
#[derive(Debug, Default)]
pub struct Diag {
    refusals: Vec<Refusal>,
    is_exhausted: bool,
}

impl Diag {
    /// Takes note of a refusal and gives `None`, so that a caller can return it at once.
    ///
    /// A word that cannot be a name is refused once, not wherever it stands.
    /// Nothing is taken note of any more once the sink is [exhausted](Diag::exhaust).
    pub fn refuse<T>(&mut self, range: impl Into<Range>, fact: impl Into<Fact>) -> Option<T> {
        let fact = fact.into();
        let is_known = |refusal: &Refusal| match &refusal.fact {
            Fact::Grammar(GrammarFact::Keyword { word }) => is_about(&fact, word),
            Fact::Grammar(GrammarFact::Expected { found, .. }) => found == "`_`" && is_about(&fact, "_"),
            _ => false,
        };
        if self.is_exhausted || self.refusals.iter().any(is_known) {
            return None;
        }
        if let Fact::Grammar(GrammarFact::Keyword { word }) = &fact {
            self.refusals.retain(|refusal| !is_about(&refusal.fact, word));
        }
        self.refusals.push(Refusal { fact, range: range.into() });
        None
    }

    /// A limit was met and refused: the rest is not looked at, so that nothing true could be said of it.
    pub fn exhaust(&mut self) {
        self.is_exhausted = true;
    }

    /// A limit was met.
    pub fn is_exhausted(&self) -> bool {
        self.is_exhausted
    }

    /// Nothing was refused so far.
    pub fn is_clean(&self) -> bool {
        self.refusals.is_empty()
    }

    /// Everything refused so far, in the order it was found.
    pub fn refusals(&self) -> &[Refusal] {
        &self.refusals
    }

    /// All refusals as `compile_error!` invocations.
    pub fn to_tokens(&self) -> TokenStream {
        self.refusals.iter().map(|refusal| refusal.to_error().to_compile_error()).collect()
    }
}
