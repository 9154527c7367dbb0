//! What a mechanism promises by the items in its tree: inputs of its states, and loads.

use crate::syntax::ast::{Item, Mechanism, has_item};

/// True if states hold inputs.
pub(crate) fn has_inputs(tree: &Mechanism) -> bool {
    tree.task.is_solved() && has_item(&tree.items, |item| matches!(item, Item::Input(_)))
}

/// True if masses or forces are declared, so that there are loads.
pub(crate) fn has_forces(tree: &Mechanism) -> bool {
    let is_heavy = |item: &Item| match item {
        Item::Body(body) => !body.masses.is_empty(),
        Item::Force(_) => true,
        _ => false,
    };
    tree.task.is_determined() && (tree.mentions_masses || has_item(&tree.items, is_heavy))
}
