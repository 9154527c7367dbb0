//! What a refusal is about, so that an item that stands many times is refused once.

use crate::syntax::ast::{Node, NodeId};

/// A part of the tree of what was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Key {
    /// An item as a whole.
    Item(NodeId),
    /// The name of an item.
    Name(NodeId),
    /// A formal parameter of a component, by its number.
    Formal(NodeId, usize),
    /// An argument of a part, by its number.
    Argument(NodeId, usize),
    /// The default of a formal parameter of a component.
    Default(NodeId, usize),
    /// A value of a point, an axis or a body, by its number.
    Value(NodeId, usize),
    /// A missing member of an array, by the declaration of its first member.
    Array(usize),
}

impl<T> From<&Node<T>> for Key {
    fn from(node: &Node<T>) -> Key {
        Key::Item(node.id())
    }
}
