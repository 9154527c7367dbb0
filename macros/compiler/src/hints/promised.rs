//! What a mechanism promises by the items in its tree: inputs of its states, and loads.

use crate::syntax::ast::{Item, Mechanism};

/// True if states hold inputs.
pub(crate) fn has_inputs(tree: &Mechanism) -> bool {
    fn has(items: &[Item]) -> bool {
        items.iter().any(|item| match item {
            Item::Input(_) => true,
            Item::For(repeated) => has(&repeated.items),
            _ => false,
        })
    }
    tree.task.is_solved() && has(&tree.items)
}

/// True if masses or forces are declared, so that there are loads.
pub(crate) fn has_forces(tree: &Mechanism) -> bool {
    let has = |item: &Item| match item {
        Item::Body(body) => !body.masses.is_empty(),
        Item::Force(_) => true,
        _ => false,
    };
    tree.task.is_determined() && tree.items.iter().any(has)
}
