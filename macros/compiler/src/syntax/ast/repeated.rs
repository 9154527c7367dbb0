//! What is declared once and stands many times: components, their parts, and loops.

use super::{Argument, Definition, Docs, Expr, Item};
use proc_macro2::Ident;
use std::rc::Rc;

/// `component Name(parameters) { items }`
#[derive(Clone, Debug)]
pub struct Component {
    /// Doc attributes of the generated struct of parameters.
    pub docs: Docs,
    /// Its name and what it takes; a component takes what a constraint takes.
    pub head: Definition,
    /// Everything between the braces, in the order written.
    pub items: Vec<Item>,
}

/// `part name = Component(arguments);`
#[derive(Clone, Debug)]
pub struct Part {
    /// Doc attributes of the accessor.
    pub docs: Docs,
    /// Its name.
    pub name: Ident,
    /// Its indices, if it is one of an array.
    pub indices: Vec<Expr>,
    /// Which component.
    pub kind: Ident,
    /// What it is made with; shared, since a part that is declared in a loop is bound many times.
    pub arguments: Rc<Vec<Argument>>,
}

/// `for variable in from..to { items }`
#[derive(Clone, Debug)]
pub struct For<Items> {
    /// The loop variable.
    pub variable: Ident,
    /// What it runs over.
    pub bounds: Bounds,
    /// What is repeated.
    pub items: Items,
}

/// `from..to` or `from..=to`
#[derive(Clone, Debug)]
pub struct Bounds {
    /// The first whole number.
    pub from: Expr,
    /// The end.
    pub to: Expr,
    /// The end belongs to it.
    pub is_inclusive: bool,
}
