//! Unknown kinds of joints, and the kinds that were probably meant.

use crate::diag::{Fact, Known, NameFact, Typed, ValueFact};
use crate::library;
use crate::quantity::Ambient;
use crate::words::{home, stem};

/// The refusal of an unknown kind of joint.
///
/// * `here`: given, the known kinds.
/// * `nearest`: given, finds the word most similar to another.
pub(crate) fn unknown_kind(word: String, here: &[&str], ambient: Ambient, nearest: impl Fn(&str, &[&str]) -> Option<String>) -> Fact {
    let home = home(&word, ambient).or_else(|| home(&stem(&word), ambient));
    // A kind of the other ambient is proposed only if this ambient has no equivalent and no kind that is as similar.
    let elsewhere = library::elsewhere(ambient).filter(|_| home.is_none());
    let known: Vec<&str> = here.iter().copied().chain(elsewhere).collect();
    let near = nearest_kind(&word, &known, nearest);
    if let Some(meant) = near.as_ref().filter(|near| !here.contains(&near.as_str())) {
        let typed = Typed { sort: "constraint", name: word };
        return ValueFact::only_elsewhere(meant.clone(), Some(typed), ambient).into();
    }
    let is_force = near.as_ref().is_some_and(|near| library::is_force(near));
    let begins_alike = |kind: &&str| kind.split('_').next() == word.split('_').next();
    let (alike, others): (Vec<&str>, Vec<&str>) = library::constraints(ambient).partition(begins_alike);
    let known = Known::of(alike.into_iter().chain(others));
    NameFact::UnknownConstraint { name: word, near, is_force, home, known }.into()
}

/// Known kind nearest to a mistyped word, or to its stem without the affixes of other programs.
pub(crate) fn nearest_kind(word: &str, known: &[&str], nearest: impl Fn(&str, &[&str]) -> Option<String>) -> Option<String> {
    nearest(word, known).or_else(|| nearest(&stem(word), known).filter(|_| stem(word) != word))
}
