//! Checks components without parts, so that errors in them are found as well.
//!
//! Each outermost one of them is expanded once, together with the components it uses, with unknown arguments; the result is discarded.
//! A component with arguments that may be whole numbers is not checked: they may determine the number of items.

use super::elaborate::Elaborator;
use crate::names::{Context, Entity, Key, OpenPart, Progress, Register, Sort, Written};
use crate::syntax::ast;
use std::collections::BTreeSet;
use std::rc::Rc;

impl Elaborator<'_> {
    /// Checks the components that have no parts.
    pub(super) fn unused_components(&mut self, register: &Register) {
        let mut seen: BTreeSet<ast::ItemId> = places(register).collect();
        for component in ast::outermost_first(self.names.components.values().cloned().collect()) {
            if !seen.contains(&component.id()) && !self.refused.contains(&Key::from(&component)) && !component.counts() {
                self.is_unused = true;
                let (functions, requirements, energies) = (self.functions.len(), self.requirements.len(), self.energies.len());
                seen.extend(self.unused(&component, register));
                self.functions.truncate(functions);
                self.requirements.truncate(requirements);
                self.energies.truncate(energies);
                self.requirement_places.truncate(requirements);
                self.is_unused = false;
            }
        }
    }

    /// Checks one component; returns the components that were expanded.
    fn unused(&mut self, component: &ast::Shared<ast::ComponentItem>, register: &Register) -> Vec<ast::ItemId> {
        let word = component.head.name.to_string();
        let context = Context { space: self.names.new_space(format!("{word}."), component.home), bound: Rc::default() };
        // Its parameters are numbered after those of the mechanism, which it can use.
        let known = register.parameters.len();
        let mut own = Register::default();
        own.parameters.clone_from(&register.parameters);
        own.places.push(OpenPart { component: Some(component.clone()), ..OpenPart::default() });
        self.names.home = component.home;
        let definitions: Vec<ast::Definition> = self.names.definitions().values().map(|definition| (**definition).clone()).collect();
        self.names.home = None;
        for (number, formal) in component.head.parameters.iter().enumerate() {
            let Some(value) = self.unknown(&formal.kind, &definitions) else { return Vec::new() };
            self.declare(
                Written { key: Key::Formal(component.id(), number), name: &formal.name, indices: &[] },
                Entity::Known,
                Progress::Done(value),
                Sort::Argument,
                &context,
            );
        }
        own.open.push(word);
        self.items(&component.items, &context, 0, &mut own);
        own.joints.sort_by_key(|(_, joint)| joint.is_freedom());
        own.parameters.drain(..known);
        self.parameters(&own);
        self.lets_and_functions(&own);
        self.bodies(&own);
        self.marks(&own);
        self.joints(&own);
        self.joint_starts(&own);
        self.forces(&own);
        self.outputs(&own);
        places(&own).collect()
    }
}

fn places(register: &Register) -> impl Iterator<Item = ast::ItemId> {
    register.places.iter().filter_map(|place| place.component.as_ref()).map(ast::Shared::id)
}
