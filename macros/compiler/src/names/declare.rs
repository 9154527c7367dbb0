//! Declared names: an item joins the namespace of its context, under a name with its full path.

use super::{EntityId, GroupId, Key, NamedItems, Names, Progress, Sort, SpaceId};
use crate::model::Name;
use proc_macro2::Ident;

impl Names {
    /// Adds an item under its name. If the name is taken, returns the sort of item that has it.
    pub(crate) fn join(&mut self, space: SpaceId, word: &str, sort: Sort, indices: Vec<usize>, id: EntityId) -> Result<(), Sort> {
        let Some(group) = self.find(space, word) else {
            let path = format!("{}{word}", self.spaces[space.0].prefix);
            let (ranks, number) = (indices.len(), GroupId(self.groups.len()));
            self.groups.push(NamedItems { word: word.to_owned(), path, sort, ranks, members: [(indices, id)].into() });
            self.spaces[space.0].groups.insert(word.to_owned(), number);
            self.spaces[space.0].order.push(number);
            return Ok(());
        };
        let group = &mut self.groups[group.0];
        if group.sort != sort || group.ranks != indices.len() || group.members.contains_key(&indices) {
            // A use of the name is ambiguous; it is not to be reported as a second error.
            for member in group.members.values() {
                self.declared[member.0].progress = Progress::Failed;
            }
            return Err(group.sort);
        }
        group.members.insert(indices, id);
        Ok(())
    }

    /// The name with its full path; items with the same `key` have one declaration.
    pub(crate) fn full_name(&mut self, space: SpaceId, key: Key, word: &Ident, indices: &[usize]) -> Name {
        let next = self.declarations.len();
        let declaration = *self.declarations.entry(key).or_insert(next);
        Name::within(&self.spaces[space.0].prefix, word, declaration, indices)
    }

    /// Name of an array element, or of an array with some of its indices: `leg[3]`.
    pub(crate) fn member_name(&self, group: GroupId, at: &[usize]) -> String {
        let indices: String = at.iter().map(|index| format!("[{index}]")).collect();
        format!("{}{indices}", self.group(group).path)
    }
}
