//! Composition of the mechanism and its components, from which the generated types are made.
//!
//! All parts of a component are alike: the same names with the same sizes, and the bodies in the same order.

use crate::syntax::ast::Docs;
use proc_macro2::Ident;

/// Components and their parts; the first of each is the mechanism itself.
#[derive(Clone, Debug, Default)]
pub struct Layout {
    /// The mechanism, and every component that is used.
    pub components: Vec<Component>,
    /// The mechanism, and all parts in the order of expansion.
    pub parts: Vec<Part>,
}

/// Properties that all parts of a component share.
#[derive(Clone, Debug)]
pub struct Component {
    /// Name; `None` for the mechanism itself.
    pub name: Option<Ident>,
    /// Doc attributes of the generated struct of parameters.
    pub docs: Docs,
    /// Fields, in the order declared.
    pub fields: Vec<Field>,
}

/// A name in the generated types.
#[derive(Clone, Debug)]
pub struct Field {
    /// Name.
    pub name: Ident,
    /// Doc attributes of the field, the accessor or the method.
    pub docs: Docs,
    /// Kind of item.
    pub of: Of,
    /// Size for each index; empty for a single item.
    pub sizes: Vec<usize>,
}

/// Kind of item that a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Of {
    /// A parameter.
    Parameter,
    /// An input, by the number of the parameter that is its value at the start; its rate and its acceleration follow.
    Input,
    /// A body.
    Body,
    /// A part of the component of this number.
    Part(usize),
    /// An output.
    Output,
}

/// One part.
#[derive(Clone, Debug)]
pub struct Part {
    /// Number of its component.
    pub component: usize,
    /// Number of its first body.
    pub first: usize,
    /// For each field the numbers of its elements; the last index varies fastest.
    pub members: Vec<Vec<usize>>,
}
