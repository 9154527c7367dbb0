//! Collects the errors of all rooms with their source ranges.
//!
//! In: facts and the tokens they concern. Out: `compile_error!` tokens, one block per error. Not done here: sentences. `message.rs`
//! alone turns a fact into a sentence.

mod code;
mod fact;
mod kind;
mod message;
mod remedy;
mod shown;
mod warning;

pub use crate::words::Home;
pub use code::PAGES;
pub use fact::{
    ArityFact, ArrayFact, AssemblyFact, Bound, Count, Demand, Driven, EquationFact, Fact, Forgotten, Gap, GrammarFact, JerkObstacle,
    JointValue, Known, MeantFor, MotionFact, NameFact, Neglected, NoPosition, Note, SystemFact, Typed, ValueFact, Word,
};
pub use kind::{Kind, Wanted};
pub(crate) use message::{degrees, millimetres, significant};
pub(crate) use remedy::quantity;
pub(crate) use warning::of_unused;
pub use warning::{AngleOf, Doubt, Warning};

use crate::quantity::Dim;
use proc_macro2::{Ident, Span, TokenStream};

/// Source range of a fact: from its first token to its last.
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

/// One error: a fact, and the smallest source range at fault.
#[derive(Clone, Debug)]
pub struct Refusal {
    /// The fact, with its numbers.
    pub fact: Fact,
    /// Source range.
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
    /// Converts to a `syn` error whose underline covers the whole range.
    pub(crate) fn to_error(&self) -> syn::Error {
        // `Span::join` returns `None` on stable Rust; an error made from two tokens is underlined from the first to the second.
        let ends = [Ident::new("a", self.range.first), Ident::new("b", self.range.last)];
        let tokens: TokenStream = ends.into_iter().map(proc_macro2::TokenTree::from).collect();
        syn::Error::new_spanned(tokens, self.fact.message())
    }
}

/// True if the fact is that the keyword `word` was found instead of a name or an expression.
fn is_about(fact: &Fact, word: &str) -> bool {
    match fact {
        Fact::Grammar(GrammarFact::Keyword { word: other }) => other == word,
        Fact::Grammar(GrammarFact::Expected { found, .. }) => {
            found.strip_prefix('`').and_then(|found| found.strip_suffix('`')) == Some(word)
        }
        _ => false,
    }
}

/// All errors so far. A room runs only if there are none.
#[derive(Debug, Default)]
pub struct Diag {
    refusals: Vec<Refusal>,
    is_exhausted: bool,
}

impl Diag {
    /// Reports an error and returns `None`, so that a caller can return it at once.
    ///
    /// A word that cannot be a name is reported once, not for each use. No error is reported after [`exhaust`](Diag::exhaust).
    pub fn refuse<T>(&mut self, range: impl Into<Range>, fact: impl Into<Fact>) -> Option<T> {
        self.add(range.into(), fact.into());
        None
    }

    fn add(&mut self, range: Range, fact: Fact) {
        let is_known = |refusal: &Refusal| match &refusal.fact {
            Fact::Grammar(GrammarFact::Keyword { word }) => is_about(&fact, word),
            Fact::Grammar(GrammarFact::Expected { found, .. }) => found == "`_`" && is_about(&fact, "_"),
            _ => false,
        };
        if self.is_exhausted || self.refusals.iter().any(is_known) {
            return;
        }
        // Of an array whose elements are missing, no use of one is reported.
        if let Fact::Array(ArrayFact::MissingIndex { known, .. }) = &fact {
            let stem = known.split('[').next().unwrap_or(known);
            self.refusals.retain(|refusal| refusal.fact.element_missing().is_none_or(|name| name != stem));
        }
        if let Some(name) = fact.element_missing()
            && self.refusals.iter().any(|refusal| matches!(&refusal.fact, Fact::Array(ArrayFact::MissingIndex { known, .. }) if known.split('[').next() == Some(name)))
        {
            return;
        }
        if let Fact::Grammar(GrammarFact::Keyword { word }) = &fact {
            self.refusals.retain(|refusal| !is_about(&refusal.fact, word));
        }
        self.refusals.push(Refusal { fact, range });
    }

    /// Names the first doubt beside errors about lengths, or about joints, of which it is likely the cause.
    pub(crate) fn explain(&mut self, doubts: &[Warning]) {
        if let Some(Warning { doubt, .. }) = doubts.iter().find(|warning| matches!(warning.doubt, Doubt::ShaftsForArms { .. })) {
            for refusal in &mut self.refusals {
                let Doubt::ShaftsForArms { joint } = doubt else { continue };
                if matches!(refusal.fact, Fact::System(_)) && refusal.fact.to_string().contains(&format!("`{joint}")) {
                    refusal.fact = Fact::Doubtful { fact: Box::new(refusal.fact.clone()), doubt: Box::new(doubt.clone()) };
                }
            }
        }
        let is_of_size = |doubt: &&Warning| matches!(doubt.doubt, Doubt::BareLength { .. } | Doubt::BareAngle { .. });
        let Some(Warning { doubt, .. }) = doubts.iter().find(is_of_size) else { return };
        for refusal in &mut self.refusals {
            if matches!(refusal.fact, Fact::Assembly(_) | Fact::System(SystemFact::CannotHold { .. })) {
                refusal.fact = Fact::Doubtful { fact: Box::new(refusal.fact.clone()), doubt: Box::new(doubt.clone()) };
            }
        }
    }

    /// Says energy instead of torque, which has the same unit, in the errors after the first `known`.
    pub(crate) fn of_energy<T>(&mut self, known: usize) -> Option<T> {
        for refusal in &mut self.refusals[known..] {
            let fact = if let Fact::InInstance { fact, .. } = &mut refusal.fact { fact } else { &mut refusal.fact };
            let fact = if let Fact::Noted { fact, .. } = fact { fact } else { fact };
            if let Fact::Value(ValueFact::WrongDimension { wanted: Dim::TORQUE, found }) = *fact {
                *fact = ValueFact::NotAnEnergy { found }.into();
            }
        }
        None
    }

    /// Drops all errors but the first `kept`; a single better one takes their place.
    pub(crate) fn withdraw(&mut self, kept: usize) {
        self.refusals.truncate(kept);
    }

    /// Of the errors of one call, those after the first `known`: if one proposes another force, drops all others.
    pub(crate) fn keep_other_force(&mut self, known: usize) {
        let names_other = |refusal: &Refusal| {
            let fact = if let Fact::InInstance { fact, .. } = &refusal.fact { fact } else { &refusal.fact };
            matches!(fact, Fact::Value(ValueFact::WrongArgument { definition, found, .. }) if remedy::about_an_axis(definition, found).is_some())
        };
        if let Some(place) = self.refusals[known..].iter().position(names_other) {
            self.refusals.swap(known, known + place);
            self.withdraw(known + 1);
        }
    }

    /// Suppresses all further errors: a limit was exceeded, and the rest of the declaration is not checked.
    pub fn exhaust(&mut self) {
        self.is_exhausted = true;
    }

    /// True if a limit was exceeded.
    pub(crate) fn is_exhausted(&self) -> bool {
        self.is_exhausted
    }

    /// True if there are no errors so far.
    pub(crate) fn is_clean(&self) -> bool {
        self.refusals.is_empty()
    }

    /// True if all errors are of joints that do not close.
    pub(crate) fn is_of_open_joints(&self) -> bool {
        let is_open = |refusal: &Refusal| match &refusal.fact {
            Fact::Assembly(fact) => matches!(fact, AssemblyFact::StaysOpen { .. } | AssemblyFact::NeverCloses { .. }),
            Fact::System(fact) => matches!(fact, SystemFact::Contradicts { .. } | SystemFact::CannotHold { .. }),
            _ => false,
        };
        self.refusals.iter().all(is_open)
    }

    /// All errors so far, in the order reported.
    pub fn refusals(&self) -> &[Refusal] {
        &self.refusals
    }

    /// All errors as `compile_error!` invocations.
    pub(crate) fn to_tokens(&self) -> TokenStream {
        self.refusals.iter().map(|refusal| refusal.to_error().to_compile_error()).collect()
    }
}
