//! Declares the names of items: namespaces, indices, and conflicts between names.

use super::elaborate::Elaborator;
use crate::diag::{ArrayFact, NameFact, Range};
use crate::names::{Context, Declared, Entity, EntityId, Key, Progress, Scope, Sort, Value, Written, duplicate, is_reserved};
use crate::syntax::ast;

/// Largest number of items, with loops unrolled and parts expanded, plus the number of loop iterations.
const MOST: usize = 100_000;

impl Elaborator<'_> {
    /// Declares an item in the namespace of its context.
    pub(super) fn declare(
        &mut self,
        Written { key, name, indices }: Written,
        entity: Entity,
        progress: Progress,
        sort: Sort,
        context: &Context,
    ) -> Option<EntityId> {
        let written = indices;
        let indices = self.written_indices(written, key, context)?;
        let word = name.to_string();
        if is_reserved(&word) {
            // The item is declared all the same, so that its uses are not reported as well.
            self.names.misused.insert(word.clone());
            self.unless_refused(key, |this| this.refuse::<()>(name, NameFact::Reserved { name: word.clone() }));
        }
        let full = self.names.full_name(context.space, key, name, &indices);
        let shown = if indices.is_empty() { word.clone() } else { full.path.clone() };
        let id = self.insert(Declared { entity, progress, name: full, context: context.clone() });
        match self.names.join(context.space, &word, sort, indices, id) {
            Ok(()) => Some(id),
            Err(first) => {
                let fact = duplicate(shown, first.noun(), if first == sort { &context.bound } else { &[] }, written);
                self.unless_refused(key, |this| this.refuse(name, fact))
            }
        }
    }

    pub(super) fn insert(&mut self, declared: Declared) -> EntityId {
        self.charge(1, &declared.name);
        self.names.declared.push(declared);
        EntityId(self.names.declared.len() - 1)
    }

    /// Counts items or loop iterations; gives up if there are too many.
    pub(super) fn charge(&mut self, number: usize, range: impl Into<Range>) -> Option<()> {
        self.count += number;
        if self.count > MOST { self.give_up(range, ArrayFact::TooManyItems { limit: MOST }) } else { Some(()) }
    }

    pub(super) fn written_indices(&mut self, indices: &[ast::Expression], key: impl Into<Key>, context: &Context) -> Option<Vec<usize>> {
        if indices.is_empty() {
            return Some(Vec::new());
        }
        let scope = Scope::of(context).timeless("an index");
        self.with_place(self.situation(context), |this| this.unless_refused(key, |this| this.indices(indices, &scope)))
    }

    /// Describes the enclosing part and loop variables, for messages; `None` outside of both.
    pub(super) fn situation(&self, context: &Context) -> Option<String> {
        let owner = self.names.spaces[context.space.0].prefix.trim_end_matches('.');
        let value = |value: &Value| match value {
            Value::Scalar(scalar) => self.arena.as_constant(scalar.expr).map_or(0, |value| value.numerator()),
            _ => 0,
        };
        let bound: Vec<String> = context.bound.iter().map(|(name, known)| format!("`{name}` is {}", value(known))).collect();
        match (owner.is_empty(), bound.is_empty()) {
            (true, true) => None,
            (true, false) => Some(format!("here {}", bound.join(" and "))),
            (false, true) => Some(format!("in `{owner}`")),
            (false, false) => Some(format!("in `{owner}`, where {}", bound.join(" and "))),
        }
    }
}
