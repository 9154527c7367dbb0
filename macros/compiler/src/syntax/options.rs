//! Parses attributes: before a mechanism doc comments, `#[equations_only]`, `#[integrated]`, `#[closure(…)]`, `#[allow(far_start)]`,
//! `#[picture]`, `#[serde]`, `#[outputs]`, `#[points]`, and those that are passed to the generated struct; before a parameter, a part and a
//! component those that are passed.

use super::ast::{Closing, Docs, Following, Requests, Task};
use super::tokens::{Attribute, Parsed, attributes, wrong};
use crate::diag::GrammarFact;
use crate::words::nearest;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};

/// Options for the mechanism as a whole.
pub(super) struct Options {
    pub(super) task: Task,
    pub(super) closing: Closing,
    pub(super) allows_far_start: bool,
    pub(super) following: Following,
    pub(super) requests: Requests,
}

/// Doc comments and options, in any order.
pub(super) fn options(input: ParseStream) -> Parsed<(Docs, Options)> {
    let (mut docs, attributes) = attributes(input)?;
    let (mut task, mut closing, mut far_start) = (None, None, None);
    let mut requests = Requests::default();
    for attribute in attributes {
        let name = attribute.name.to_string();
        let again = match name.as_str() {
            "equations_only" => task.replace(Task::EquationsOnly).is_some(),
            "integrated" => task.replace(Task::Motion).is_some(),
            "closure" => closing.replace(self::closing(&attribute)?).is_some(),
            "allow" => far_start.replace(allowed(&attribute)?).is_some(),
            "picture" => requests.picture.replace(attribute.name.clone()).is_some(),
            "outputs" => requests.outputs.replace(attribute.name.clone()).is_some(),
            "points" => requests.points.replace(attribute.name.clone()).is_some(),
            "serde" if attribute.rest.is_empty() => requests.serde.replace(attribute.name.clone()).is_some(),
            _ if OF_STRUCTS.contains(&name.as_str()) => {
                docs.passed.extend(attribute.tokens);
                false
            }
            _ => return wrong(&attribute.name, GrammarFact::UnknownAttribute { name }),
        };
        if again {
            return wrong(
                &attribute.name,
                if is_task(&name) { GrammarFact::SecondTask { name } } else { GrammarFact::AttributeTwice { name } },
            );
        }
    }
    let allows_far_start = far_start.is_some();
    let (closing, following) = closing.unwrap_or_default();
    Ok((docs, Options { task: task.unwrap_or_default(), closing, following, allows_far_start, requests }))
}

/// True for the attributes that say what is generated.
fn is_task(name: &str) -> bool {
    matches!(name, "equations_only" | "integrated")
}

/// Attributes of generated structs, for derived traits.
const OF_STRUCTS: [&str; 3] = ["derive", "serde", "cfg_attr"];

/// Attributes that mean something before a mechanism only, or would remove a field that other code reads.
const NOT_OF_FIELDS: [&str; 8] = ["equations_only", "integrated", "closure", "picture", "outputs", "points", "cfg", "derive"];

/// The attributes of an item that begins with `keyword`: a field may have any attribute of Rust, a component those of structs, and other
/// items have doc comments only.
pub(super) fn passing(mut docs: Docs, others: Vec<Attribute>, keyword: &str) -> Parsed<Docs> {
    for attribute in others {
        let name = attribute.name.to_string();
        let is_passed = match keyword {
            "param" | "input" | "part" => !NOT_OF_FIELDS.contains(&name.as_str()),
            "component" => OF_STRUCTS.contains(&name.as_str()) && !attribute.rest.is_empty(),
            _ => false,
        };
        if !is_passed {
            return wrong(&attribute.name, GrammarFact::UnknownAttribute { name });
        }
        docs.passed.extend(attribute.tokens);
    }
    Ok(docs)
}

/// Takes `#[velocity]` from the attributes of a joint.
pub(super) fn velocity(others: &mut Vec<Attribute>) -> Parsed<Option<syn::Ident>> {
    let is_meant = |attribute: &Attribute| attribute.name == "velocity" && attribute.rest.is_empty();
    let found = others.iter().position(is_meant).map(|at| others.remove(at).name);
    match others.iter().find(|attribute| is_meant(attribute)) {
        Some(second) => wrong(&second.name, GrammarFact::AttributeTwice { name: "velocity".to_owned() }),
        None => Ok(found),
    }
}

/// `#[allow(far_start)]`
fn allowed(attribute: &Attribute) -> Parsed<()> {
    match word(attribute) {
        Some(word) if word == "far_start" => Ok(()),
        Some(word) => wrong(&word, GrammarFact::AllowedWord { near: nearest(&word.to_string(), ["far_start"].into_iter()) }),
        None => wrong(&attribute.name, GrammarFact::AllowedWord { near: None }),
    }
}

/// The one word in the parentheses of an attribute.
fn word(attribute: &Attribute) -> Option<syn::Ident> {
    let word = |content: ParseStream| {
        let inner;
        syn::parenthesized!(inner in content);
        let word = syn::Ident::parse_any(&inner)?;
        if inner.is_empty() { Ok(word) } else { Err(inner.error("one word")) }
    };
    word.parse2(attribute.rest.clone()).ok()
}

/// `#[closure(deny)]`, `#[closure(start)]`, `#[closure(allow)]`, `#[closure(off)]`: policies for the assembly and for the motion.
fn closing(attribute: &Attribute) -> Parsed<(Closing, Following)> {
    let Some(word) = word(attribute) else {
        return wrong(&attribute.name, GrammarFact::ClosingWord { near: None });
    };
    match word.to_string().as_str() {
        "deny" => Ok((Closing::Deny, Following::Strict)),
        "start" => Ok((Closing::Deny, Following::Off)),
        "allow" => Ok((Closing::Allow, Following::Declared)),
        "off" => Ok((Closing::Off, Following::Off)),
        other => wrong(&word, GrammarFact::ClosingWord { near: nearest(other, ["deny", "start", "allow", "off"].into_iter()) }),
    }
}
