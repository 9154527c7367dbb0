//! Items that are declared once and expanded several times: components, their parts, and loops.

use super::{Argument, Definition, Docs, Expression, FormalKind, Item, Shared};
use crate::quantity::Dim;
use proc_macro2::Ident;
use std::collections::BTreeMap;
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
    /// For one that was defined in `constraint!`, the number of its home in the mechanism: it sees no name of the mechanism itself.
    pub home: Option<usize>,
}

/// The definitions of `constraint!` that the components of one `use` item see, under the names that they have there.
#[derive(Clone, Debug, Default)]
pub struct ComponentHome {
    /// Constraints and forces.
    pub definitions: BTreeMap<String, Rc<Definition>>,
    /// Components.
    pub components: BTreeMap<String, Shared<ComponentItem>>,
}

/// Items in the order written, with those of loops and components after their own; rejected items are not entered.
pub(crate) fn every_item(items: &[Item]) -> impl Iterator<Item = &Item> {
    let mut pending: Vec<&Item> = items.iter().rev().collect();
    std::iter::from_fn(move || {
        let item = pending.pop()?;
        match item {
            Item::For(repeated) => pending.extend(repeated.items.iter().rev()),
            Item::Component(component) => pending.extend(component.items.iter().rev()),
            _ => {}
        }
        Some(item)
    })
}

/// True if some item is of this kind, also one of a loop or a component, or a rejected one.
pub(crate) fn has_item(items: &[Item], is_meant: fn(&Item) -> bool) -> bool {
    every_item(items).any(|item| match item {
        Item::Refused(rejected) => has_item(std::slice::from_ref(rejected), is_meant),
        item => is_meant(item),
    })
}

impl ComponentItem {
    /// Names of the components of the parts in the component.
    fn kinds_of_parts(&self) -> Vec<&Ident> {
        let (mut kinds, mut pending): (Vec<&Ident>, Vec<&Item>) = (Vec::new(), self.items.iter().collect());
        while let Some(item) = pending.pop() {
            match item {
                Item::For(repeated) => pending.extend(&repeated.items),
                Item::Part(part) => kinds.push(&part.kind),
                _ => {}
            }
        }
        kinds
    }

    /// True if an argument of the component may be a number of items.
    pub(crate) fn counts(&self) -> bool {
        self.head.parameters.iter().any(|formal| match &formal.kind {
            FormalKind::Scalar(written) => written.dim() == Some(Dim::NUMBER),
            kind => matches!(kind, FormalKind::Quantity),
        })
    }
}

/// Sorts components: those with parts before the components of the parts.
pub(crate) fn outermost_first(components: Vec<Shared<ComponentItem>>) -> Vec<Shared<ComponentItem>> {
    let (mut visited, mut order) = (vec![false; components.len()], Vec::new());
    for at in 0..components.len() {
        let mut pending = vec![(at, false)];
        while let Some((at, is_done)) = pending.pop() {
            if is_done {
                order.push(at);
            } else if !std::mem::replace(&mut visited[at], true) {
                pending.push((at, true));
                let inner = |kind: &&Ident| components.binary_search_by(|known| known.head.name.cmp(kind)).ok();
                pending.extend(components[at].kinds_of_parts().iter().filter_map(inner).map(|inner| (inner, false)));
            }
        }
    }
    order.into_iter().rev().map(|at| components[at].clone()).collect()
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
