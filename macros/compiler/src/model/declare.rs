//! Names for items: which space they belong to, with which indices, and whether they are taken.

use super::Name;
use super::builtin::BUILTINS;
use super::elaborate::{Elaborator, Scope};
use super::key::Key;
use super::names::{Context, Declared, Entity, EntityId, GroupId, NamedItems, Progress, RESERVED, Sort, SpaceId};
use super::register::MOST;
use super::value::Value;
use crate::diag::{ArrayFact, Fact, NameFact, Range};
use crate::syntax::ast;
use proc_macro2::Ident;

/// A name as it was written.
#[derive(Clone, Copy)]
pub(super) struct Written<'a> {
    /// The name of which item it is.
    pub(super) key: Key,
    pub(super) name: &'a Ident,
    pub(super) indices: &'a [ast::Expr],
}

impl Elaborator<'_> {
    /// Gives an item its name in the space where it stands.
    pub(super) fn declare(
        &mut self,
        Written { key, name, indices }: Written,
        entity: Entity,
        progress: Progress,
        sort: Sort,
        context: &Context,
    ) -> Option<EntityId> {
        let indices = self.written_indices(indices, key, context)?;
        let word = name.to_string();
        if is_reserved(&word) {
            // The item is there all the same, so that nobody misses it.
            self.names.misused.insert(word.clone());
            self.once(key, |this| this.refuse::<()>(name, NameFact::Reserved { name: word.clone() }));
        }
        let full = self.full_name(context.space, key, name, &indices);
        let shown = if indices.is_empty() { word.clone() } else { full.path.clone() };
        let id = self.insert(Declared { entity, progress, name: full, context: context.clone() });
        match self.join(context.space, &word, sort, indices, id) {
            Ok(()) => Some(id),
            Err(first) => {
                let fact = duplicate(shown, first.noun(), context.bound.last().filter(|_| first == sort));
                self.once(key, |this| this.refuse(name, fact))
            }
        }
    }

    pub(super) fn insert(&mut self, declared: Declared) -> EntityId {
        self.charge(1, &declared.name);
        self.names.declared.push(declared);
        EntityId(self.names.declared.len() - 1)
    }

    /// Counts items or rounds of loops, and gives up where there are too many.
    pub(super) fn charge(&mut self, number: usize, range: impl Into<Range>) -> Option<()> {
        self.count += number;
        if self.count > MOST { self.give_up(range, ArrayFact::TooManyItems { limit: MOST }) } else { Some(()) }
    }

    /// Puts an item among those of its name, or says what has the name already.
    pub(super) fn join(&mut self, space: SpaceId, word: &str, sort: Sort, indices: Vec<usize>, id: EntityId) -> Result<(), Sort> {
        let Some(group) = self.names.find(space, word) else {
            let path = format!("{}{word}", self.names.spaces[space.0].prefix);
            let (ranks, number) = (indices.len(), GroupId(self.names.groups.len()));
            self.names.groups.push(NamedItems { word: word.to_owned(), path, sort, ranks, members: [(indices, id)].into() });
            self.names.spaces[space.0].groups.insert(word.to_owned(), number);
            self.names.spaces[space.0].order.push(number);
            return Ok(());
        };
        let group = &mut self.names.groups[group.0];
        if group.sort != sort || group.ranks != indices.len() || group.members.contains_key(&indices) {
            // Which of the two is meant where the name is used, nobody knows: that is not to be told as a second mistake.
            for member in group.members.values() {
                self.names.declared[member.0].progress = Progress::Failed;
            }
            return Err(group.sort);
        }
        group.members.insert(indices, id);
        Ok(())
    }

    pub(super) fn written_indices(&mut self, indices: &[ast::Expr], key: impl Into<Key>, context: &Context) -> Option<Vec<usize>> {
        if indices.is_empty() {
            return Some(Vec::new());
        }
        let scope = Scope::of(context).timeless("an index");
        self.at(self.situation(context), |this| this.once(key, |this| this.indices(indices, &scope)))
    }

    /// The name from outside; items with the same `key` are of one declaration.
    pub(super) fn full_name(&mut self, space: SpaceId, key: Key, word: &Ident, indices: &[usize]) -> Name {
        let next = self.names.declarations.len();
        let declaration = *self.names.declarations.entry(key).or_insert(next);
        Name::within(&self.names.spaces[space.0].prefix, word, declaration, indices)
    }

    /// Which of many is being registered, in words.
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

/// A name is taken, perhaps by the same item in another round of a loop.
pub(super) fn duplicate(name: String, first: &'static str, in_loop: Option<&(String, Value)>) -> Fact {
    match in_loop {
        Some((variable, _)) => ArrayFact::DuplicateInLoop { name, variable: variable.clone() }.into(),
        None => NameFact::Duplicate { name, first }.into(),
    }
}

pub(super) fn is_reserved(word: &str) -> bool {
    RESERVED.contains(&word) || BUILTINS.contains(&word)
}
