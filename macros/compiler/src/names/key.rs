//! Keys of parts of the syntax tree, so that a declaration that is expanded several times is rejected once.

use crate::syntax::ast::{ItemId, Shared};

/// Key of a part of the syntax tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Key {
    /// An item as a whole.
    Item(ItemId),
    /// The name of an item.
    Name(ItemId),
    /// A formal parameter of a component, by its number.
    Formal(ItemId, usize),
    /// An argument of a part, by its number.
    Argument(ItemId, usize),
    /// The default of a formal parameter of a component.
    Default(ItemId, usize),
    /// A value of a point, an axis or a body, by its number.
    Value(ItemId, usize),
    /// A missing element of an array, by the declaration of its first element.
    Array(usize),
}

impl<T> From<&Shared<T>> for Key {
    fn from(node: &Shared<T>) -> Key {
        Key::Item(node.id())
    }
}
