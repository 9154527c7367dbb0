//! What a mechanism promises by the items in its tree: inputs of its states, and loads.

use crate::syntax::ast::{Item, Mechanism};

/// True if some item, also of a loop, of a component, or rejected, is of this kind.
fn has(items: &[Item], is_meant: fn(&Item) -> bool) -> bool {
    items.iter().any(|item| match item {
        Item::For(repeated) => has(&repeated.items, is_meant),
        Item::Component(component) => has(&component.items, is_meant),
        Item::Refused(item) => has(std::slice::from_ref(item), is_meant),
        item => is_meant(item),
    })
}

/// True if states hold inputs.
pub(crate) fn has_inputs(tree: &Mechanism) -> bool {
    tree.task.is_solved() && has(&tree.items, |item| matches!(item, Item::Input(_)))
}

/// True if masses or forces are declared, so that there are loads.
pub(crate) fn has_forces(tree: &Mechanism) -> bool {
    let is_heavy = |item: &Item| match item {
        Item::Body(body) => !body.masses.is_empty(),
        Item::Force(_) => true,
        _ => false,
    };
    tree.task.is_determined() && (tree.mentions_masses || has(&tree.items, is_heavy))
}
