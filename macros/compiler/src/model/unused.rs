//! Components of which there is no part: a mistake in them is found all the same.
//!
//! Each is gone through once with arguments of which nothing is known but their kind, apart from everything else, and nothing of
//! it is kept. What depends on arguments that may be whole numbers is not looked at: these say how often something stands.

use super::Dim;
use super::elaborate::Elaborator;
use super::layout::Place;
use super::names::{Context, Entity, Progress};
use super::register::Register;
use crate::syntax::ast::{self, Kind};
use std::collections::BTreeSet;
use std::rc::Rc;

impl Elaborator<'_> {
    /// Looks at the components that are not used.
    pub(super) fn unused_components(&mut self, register: &Register) {
        let used: BTreeSet<*const ast::Component> =
            register.places.iter().filter_map(|place| place.component.as_ref()).map(Rc::as_ptr).collect();
        let components: Vec<Rc<ast::Component>> = self.names.components.values().cloned().collect();
        for component in components {
            let key = Rc::as_ptr(&component);
            if !used.contains(&key) && !self.refused.contains(&(key as usize)) && !counts(&component) {
                self.is_unused = true;
                let (functions, requirements) = (self.functions.len(), self.requirements.len());
                self.unused(&component, register);
                self.functions.truncate(functions);
                self.requirements.truncate(requirements);
                self.requirement_places.truncate(requirements);
                self.is_unused = false;
            }
        }
    }

    fn unused(&mut self, component: &Rc<ast::Component>, register: &Register) -> Option<()> {
        let word = component.head.name.to_string();
        let context = Context { space: self.names.new_space(format!("{word}.")), bound: Rc::default() };
        // Its parameters are numbered after those of the mechanism, which it sees.
        let known = register.parameters.len();
        let mut own = Register::default();
        own.parameters.clone_from(&register.parameters);
        own.places.push(Place { component: Some(component.clone()), ..Place::default() });
        let definitions: Vec<ast::Definition> = self.names.definitions.values().map(|definition| (**definition).clone()).collect();
        for formal in &component.head.parameters {
            let value = self.unknown(&formal.kind, &definitions)?;
            self.declare((&formal.name, &[]), Entity::Known, Progress::Done(value), "an argument", &context, &mut own);
        }
        own.open.push(word);
        self.items(&component.items, &context, 0, &mut own);
        own.parameters.drain(..known);
        self.parameters(&own);
        self.lets_and_functions(&own);
        self.bodies(&own);
        self.marks(&own);
        self.joints(&own);
        self.outputs(&own);
        Some(())
    }
}

/// It takes a number that may be one of how many.
fn counts(component: &ast::Component) -> bool {
    component.head.parameters.iter().any(|formal| match &formal.kind {
        Kind::Scalar(written) => Dim::of(written) == Some(Dim::NUMBER),
        kind => matches!(kind, Kind::Quantity),
    })
}
