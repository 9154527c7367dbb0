//! Items with an identity.

use std::cell::Cell;
use std::ops::Deref;
use std::rc::Rc;

/// Tells items of one tree apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(u32);

thread_local! {
    static NEXT: Cell<u32> = const { Cell::new(0) };
}

impl NodeId {
    /// An id that no other item has.
    fn fresh() -> NodeId {
        NEXT.with(|next| NodeId(next.replace(next.get().wrapping_add(1))))
    }
}

/// An item that may be repeated: shared, never copied, with an id that its clones have in common.
#[derive(Debug)]
pub struct Node<T> {
    id: NodeId,
    item: Rc<T>,
}

impl<T> Node<T> {
    /// A new item of a tree.
    pub(crate) fn new(item: T) -> Node<T> {
        Node { id: NodeId::fresh(), item: Rc::new(item) }
    }

    /// Which item it is.
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
