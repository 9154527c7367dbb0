//! Items with an identity.

use std::cell::Cell;
use std::ops::Deref;
use std::rc::Rc;

/// Identity of an item of the syntax tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(u32);

thread_local! {
    static NEXT: Cell<u32> = const { Cell::new(0) };
}

impl NodeId {
    /// A new id.
    fn fresh() -> NodeId {
        NEXT.with(|next| NodeId(next.replace(next.get().wrapping_add(1))))
    }
}

/// An item that may be repeated: shared, never copied. All clones have the same id.
#[derive(Debug)]
pub struct Node<T> {
    id: NodeId,
    item: Rc<T>,
}

impl<T> Node<T> {
    /// Gives an item an id of its own.
    pub(crate) fn new(item: T) -> Node<T> {
        Node { id: NodeId::fresh(), item: Rc::new(item) }
    }

    /// Identity of the item.
    #[must_use]
    pub fn id(&self) -> NodeId {
        self.id
    }
}

impl<T> Clone for Node<T> {
    fn clone(&self) -> Node<T> {
        Node { id: self.id, item: self.item.clone() }
    }
}

impl<T> Deref for Node<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.item
    }
}
