//! Items with an identity.

use std::cell::Cell;
use std::ops::Deref;
use std::rc::Rc;

/// Identity of an item of the syntax tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ItemId(u32);

thread_local! {
    static NEXT: Cell<u32> = const { Cell::new(0) };
}

impl ItemId {
    /// A new id.
    fn fresh() -> ItemId {
        NEXT.with(|next| ItemId(next.replace(next.get().wrapping_add(1))))
    }
}

/// An item that may be repeated: shared, never copied. All clones have the same id.
#[derive(Debug)]
pub struct Shared<T> {
    id: ItemId,
    item: Rc<T>,
}

impl<T> Shared<T> {
    /// Gives an item an id of its own.
    pub(crate) fn new(item: T) -> Shared<T> {
        Shared { id: ItemId::fresh(), item: Rc::new(item) }
    }

    /// Identity of the item.
    #[must_use]
    pub fn id(&self) -> ItemId {
        self.id
    }
}

impl<T> Clone for Shared<T> {
    fn clone(&self) -> Shared<T> {
        Shared { id: self.id, item: self.item.clone() }
    }
}

impl<T> Deref for Shared<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.item
    }
}
