//! Names for items: which space they belong to, with which indices, and whether they are taken.

use super::Name;
use super::builtin::BUILTINS;
use super::elaborate::{Elaborator, Scope};
use super::names::{Context, Declared, Entity, EntityId, GroupId, NamedItems, Progress, RESERVED, SpaceId};
use super::register::MOST;
use super::value::Value;
use crate::diag::{ArrayFact, Fact, NameFact, Range};
use crate::syntax::ast;
use proc_macro2::Ident;

impl Elaborator<'_> {
    /// Gives an item its name in the space where it stands.
    pub(super) fn declare(
        &mut self,
        (name, indices): (&Ident, &[ast::Expr]),
        entity: Entity,
        progress: Progress,
        what: &'static str,
        context: &Context,
    ) -> Option<EntityId> {
        let item = std::ptr::from_ref(name);
        let indices = self.written_indices(indices, item, context)?;
        let word = name.to_string();
        if is_reserved(&word) {
            // The item is there all the same, so that nobody misses it.
            self.names.misused.insert(word.clone());
            self.once(item, |this| this.refuse::<()>(name, NameFact::Reserved { name: word.clone() }));
        }
        let full = self.full_name(context.space, name, &indices);
        let shown = if indices.is_empty() { word.clone() } else { full.path.clone() };
        let id = self.insert(Declared { entity, progress, name: full, context: context.clone() });
        match self.join(context.space, &word, what, indices, id) {
            Ok(()) => Some(id),
            Err(first) => {
                let fact = duplicate(shown, first, context.bound.last().filter(|_| first == what));
                self.once(item, |this| this.refuse(name, fact))
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
    pub(super) fn join(
        &mut self,
        space: SpaceId,
        word: &str,
        what: &'static str,
        indices: Vec<usize>,
        id: EntityId,
    ) -> Result<(), &'static str> {
        let Some(group) = self.names.find(space, word) else {
            let path = format!("{}{word}", self.names.spaces[space.0].prefix);
            let (ranks, number) = (indices.len(), GroupId(self.names.groups.len()));
            self.names.groups.push(NamedItems { word: word.to_owned(), path, what, ranks, members: [(indices, id)].into() });
            self.names.spaces[space.0].groups.insert(word.to_owned(), number);
            self.names.spaces[space.0].order.push(number);
            return Ok(());
        };
        let group = &mut self.names.groups[group.0];
        if group.what != what || group.ranks != indices.len() || group.members.contains_key(&indices) {
            // Which of the two is meant where the name is used, nobody knows: that is not to be told as a second mistake.
            for member in group.members.values() {
                self.names.declared[member.0].progress = Progress::Failed;
            }
            return Err(group.what);
        }
        group.members.insert(indices, id);
        Ok(())
    }

    pub(super) fn written_indices<I>(&mut self, indices: &[ast::Expr], item: *const I, context: &Context) -> Option<Vec<usize>> {
        if indices.is_empty() {
            return Some(Vec::new());
        }
        let scope = Scope::of(context).timeless("an index");
        self.at(self.situation(context), |this| this.once(item, |this| this.indices(indices, &scope)))
    }

    /// `word`: given, the very one of the item in the tree.
    pub(super) fn full_name(&mut self, space: SpaceId, word: &Ident, indices: &[usize]) -> Name {
        let next = self.names.declarations.len();
        let declaration = *self.names.declarations.entry(std::ptr::from_ref(word)).or_insert(next);
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
