//! Tearing: divides the unknowns of a block into explicit and iterated ones.
//!
//! An equation that is linear in an unknown with a coefficient that is never zero gives this unknown as soon as its other unknowns are
//! known. The remaining unknowns are iterated: first those that never occur with such a coefficient, then, if that is not enough, one
//! after the other.

use super::matching::Matching;
use super::pattern::Pattern;
use super::{Block, Explicit};
use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// Divides the unknowns of a group of equations into explicit and iterated ones.
pub(super) fn tear(pattern: &Pattern, matching: &Matching, group: &[usize]) -> Block {
    let mut work = Tearing::new(pattern, matching, group);
    work.spread();
    while let Some(unknown) = work.best_guess() {
        work.iterate(unknown);
        work.spread();
    }
    work.block.residuals = group.iter().copied().filter(|equation| !work.used.contains(equation)).collect();
    work.block.iterated.sort_unstable();
    work.block
}

struct Tearing<'a> {
    pattern: &'a Pattern,
    /// Unknowns of the block that are not known yet.
    missing: BTreeSet<usize>,
    /// For each equation, the number of its missing unknowns.
    lacks: BTreeMap<usize, usize>,
    /// The equations of the block that contain an unknown.
    holders: BTreeMap<usize, Vec<usize>>,
    used: BTreeSet<usize>,
    /// Queue of equations that may give an unknown now; first come, first served keeps chains short.
    ready: VecDeque<usize>,
    block: Block,
}

impl<'a> Tearing<'a> {
    fn new(pattern: &'a Pattern, matching: &Matching, group: &[usize]) -> Tearing<'a> {
        let missing: BTreeSet<usize> = group.iter().filter_map(|equation| matching.of_equation[*equation]).collect();
        let mut holders: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        let mut lacks = BTreeMap::new();
        let mut can_be_explicit = BTreeSet::new();
        for equation in group {
            let inside = pattern.needed(*equation).filter(|entry| missing.contains(&entry.unknown));
            let mut count = 0;
            for entry in inside {
                count += 1;
                holders.entry(entry.unknown).or_default().push(*equation);
                if entry.is_pivot {
                    can_be_explicit.insert(entry.unknown);
                }
            }
            lacks.insert(*equation, count);
        }
        let ready = lacks.iter().filter(|(_, count)| **count == 1).map(|(equation, _)| *equation).collect();
        let mut work = Tearing { pattern, missing: missing.clone(), lacks, holders, used: BTreeSet::new(), ready, block: Block::default() };
        for unknown in missing.difference(&can_be_explicit) {
            work.iterate(*unknown);
        }
        work
    }

    fn iterate(&mut self, unknown: usize) {
        self.block.iterated.push(unknown);
        self.settle(unknown);
    }

    /// Takes every explicit unknown that is available now.
    fn spread(&mut self) {
        while let Some(equation) = self.ready.pop_front() {
            if self.used.contains(&equation) || self.lacks.get(&equation) != Some(&1) {
                continue;
            }
            let missing = self.pattern.needed(equation).find(|entry| self.missing.contains(&entry.unknown));
            let Some(entry) = missing.filter(|entry| entry.is_pivot) else { continue };
            self.used.insert(equation);
            self.block.explicit.push(Explicit { unknown: entry.unknown, equation });
            self.settle(entry.unknown);
        }
    }

    /// Marks an unknown as known.
    fn settle(&mut self, unknown: usize) {
        self.missing.remove(&unknown);
        for equation in self.holders.get(&unknown).into_iter().flatten() {
            if let Some(count) = self.lacks.get_mut(equation) {
                *count -= 1;
                if *count == 1 {
                    self.ready.push_back(*equation);
                }
            }
        }
    }

    /// The missing unknown that occurs in most equations: knowing it helps most.
    fn best_guess(&self) -> Option<usize> {
        let uses = |unknown: &usize| self.holders.get(unknown).map_or(0, Vec::len);
        self.missing.iter().copied().max_by_key(|unknown| (uses(unknown), std::cmp::Reverse(*unknown)))
    }
}
