//! Names of kinds that are not known, and what they were meant to be.

use crate::diag::{Fact, Known, NameFact, Typed, ValueFact, home, stem};
use crate::library;
use crate::quantity::Ambient;

/// What is said of a kind of joint that is not known; `here` are those that are, and `nearest` finds the one that is most similar.
pub(crate) fn unknown_kind(word: String, here: &[&str], ambient: Ambient, nearest: impl Fn(&str, &[&str]) -> Option<String>) -> Fact {
    let home = home(&word, ambient).or_else(|| home(&stem(&word), ambient));
    // A word of the other ambient is meant only where this one has no equivalent of it and none that is as near.
    let elsewhere = library::elsewhere(ambient).filter(|_| home.is_none());
    let known: Vec<&str> = here.iter().copied().chain(elsewhere).collect();
    let near = nearest_kind(&word, &known, nearest);
    if let Some(meant) = near.as_ref().filter(|near| !here.contains(&near.as_str())) {
        let typed = Typed { sort: "constraint", name: word };
        return ValueFact::only_elsewhere(meant.clone(), Some(typed), ambient).into();
    }
    let is_force = near.as_ref().is_some_and(|near| library::is_force(near));
    let known = Known::of(library::constraints(ambient));
    NameFact::UnknownConstraint { name: word, near, is_force, home, known }.into()
}

/// Known kind nearest to a mistyped one, also where that has words of another program about it.
pub(crate) fn nearest_kind(word: &str, known: &[&str], nearest: impl Fn(&str, &[&str]) -> Option<String>) -> Option<String> {
    nearest(word, known).or_else(|| nearest(&stem(word), known).filter(|_| stem(word) != word))
}
