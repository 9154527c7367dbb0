//! Items that are declared once and expanded several times: components, their parts, and loops.

use super::{Argument, Definition, Docs, Expression, Item};
use proc_macro2::Ident;
use std::rc::Rc;

/// `component Name(parameters) { items }`
#[derive(Clone, Debug)]
pub struct ComponentItem {
    /// Doc attributes of the generated struct of parameters.
    pub docs: Docs,
    /// Name and parameters; a component takes the same kinds of arguments as a constraint.
    pub head: Definition,
    /// Items between the braces, in the order written.
    pub items: Vec<Item>,
}

/// `part name = Component(arguments);`
#[derive(Clone, Debug)]
pub struct PartItem {
    /// Doc attributes of the accessor.
    pub docs: Docs,
    /// Name.
    pub name: Ident,
    /// Indices, if it is an element of an array.
    pub indices: Vec<Expression>,
    /// Name of the component.
    pub kind: Ident,
    /// Arguments; shared, since a part declared in a loop is expanded several times.
    pub arguments: Rc<Vec<Argument>>,
}

/// `for variable in from..to { items }`
#[derive(Clone, Debug)]
pub struct For<Items> {
    /// The loop variable.
    pub variable: Ident,
    /// Range of the loop variable.
    pub bounds: IndexRange,
    /// Repeated items.
    pub items: Items,
}

/// `from..to` or `from..=to`
#[derive(Clone, Debug)]
pub struct IndexRange {
    /// First value.
    pub from: Expression,
    /// End of the range.
    pub to: Expression,
    /// True if the end belongs to the range.
    pub is_inclusive: bool,
}
