//! Closing block by block, each from those before it.
//!
//! In: a [`Structure`]. Out: an [`Assembled`]. A later block may close with one assembly of an earlier block and not with another;
//! where it does not close with the nearest one, the others are tried, the last block first.

use super::Room;
use super::levenberg::Problem;
use super::reduced::Reduced;
use super::search::{Found, GUESSES};
use crate::structure::{Block, Structure};
use crate::syntax::ast::Closing;
use std::collections::BTreeSet;

/// How often another assembly of an earlier block is tried before a block counts as open.
const MOST_TRIES: usize = 48;

/// How many guesses are made where the declared start leads nowhere.
const WIDE: usize = 48;

/// The assembly to start from, or how far an assembly was found.
pub(super) struct Assembled {
    /// One value for each unknown.
    pub(super) start: Vec<f64>,
    /// All rows that could be evaluated hold.
    pub(super) is_closed: bool,
    /// The first block that did not close, and that should.
    pub(super) open: Option<usize>,
    /// Of each block closed on its own, the assemblies that were found.
    pub(super) found: Vec<Vec<Vec<f64>>>,
    /// Where all was closed at once, the assemblies that are not as near.
    pub(super) others: Vec<Vec<f64>>,
    /// Whether all assemblies that may be as near were looked at.
    pub(super) is_nearest: bool,
    /// Each block was taken to the rounding limit.
    pub(super) is_settled: bool,
}

/// The unknowns and equations of a block, the explicit ones last.
pub(super) fn parts(block: &Block) -> (Vec<usize>, Vec<usize>) {
    let Block { explicit, iterated, residuals } = block;
    let unknowns = iterated.iter().copied().chain(explicit.iter().map(|explicit| explicit.unknown)).collect();
    let equations = residuals.iter().copied().chain(explicit.iter().map(|explicit| explicit.equation)).collect();
    (unknowns, equations)
}

/// What each block depends on.
pub(super) struct Upstream {
    of_block: Vec<BTreeSet<usize>>,
}

impl Upstream {
    pub(super) fn new(room: &Room, structure: &Structure) -> Upstream {
        let mut owner = vec![None; room.declared.len()];
        for (index, block) in structure.blocks.iter().enumerate() {
            parts(block).0.into_iter().for_each(|unknown| owner[unknown] = Some(index));
        }
        let direct = |(index, block): (usize, &Block)| {
            let unknowns = parts(block).1.into_iter().flat_map(|equation| room.system.equations[equation].jacobian.iter());
            unknowns.filter_map(|(unknown, _)| owner[*unknown]).filter(|other| *other != index).collect()
        };
        Upstream { of_block: structure.blocks.iter().enumerate().map(direct).collect() }
    }

    /// The blocks on which a block depends itself.
    pub(super) fn direct(&self, block: usize) -> impl Iterator<Item = usize> {
        self.of_block[block].iter().copied()
    }

    /// All blocks on which a block depends, through others too.
    pub(super) fn all(&self, block: usize) -> BTreeSet<usize> {
        let mut found = BTreeSet::new();
        let mut open = vec![block];
        while let Some(next) = open.pop() {
            open.extend(self.of_block[next].iter().filter(|other| found.insert(**other)));
        }
        found
    }

    /// Of each block, whether every number it depends on is known in the compiler.
    pub(super) fn surety(&self, room: &Room, structure: &Structure) -> Vec<bool> {
        let mut is_sure: Vec<bool> = Vec::new();
        for (index, block) in structure.blocks.iter().enumerate() {
            // Blocks stand in order: what is upstream has been looked at.
            let sure = self.of_block[index].iter().all(|other| is_sure.get(*other) == Some(&true));
            is_sure.push(sure && parts(block).1.iter().all(|equation| room.is_known(*equation)));
        }
        is_sure
    }
}

impl Room<'_> {
    /// Block by block, each from those before it.
    pub(super) fn in_order(&self, structure: &Structure) -> Assembled {
        let upstream = Upstream::new(self, structure);
        let is_sure = upstream.surety(self, structure);
        let mut assembled = self.forward(structure, self.unassembled(), 0, &is_sure);
        let Some(open) = assembled.open else { return assembled };
        // What is left to try in each block, as far as it was asked for.
        let mut others: Vec<Option<Vec<Vec<f64>>>> = vec![None; structure.blocks.len()];
        let (mut start, mut failed) = (assembled.start.clone(), open);
        for _ in 0..MOST_TRIES {
            let next = upstream.all(failed).into_iter().rev().find_map(|block| {
                let others = others[block].get_or_insert_with(|| self.other_assemblies(structure, block, &start));
                if others.is_empty() { None } else { Some((block, others.remove(0))) }
            });
            let Some((block, values)) = next else { break };
            let (unknowns, _) = parts(&structure.blocks[block]);
            unknowns.iter().zip(values).for_each(|(unknown, value)| start[*unknown] = value);
            others[block + 1..].fill(None);
            let tried = self.forward(structure, start, block + 1, &is_sure);
            match tried.open {
                None => return tried,
                Some(block) => (start, failed) = (tried.start, block),
            }
        }
        if self.model.closing == Closing::Allow {
            // What can be closed after it is.
            assembled.start = self.forward(structure, assembled.start, open + 1, &[]).start;
        }
        assembled
    }

    /// Closes all blocks from `first` on, each with its nearest assembly, up to the first one that should close and stays open.
    pub(super) fn forward(&self, structure: &Structure, mut start: Vec<f64>, first: usize, should_close: &[bool]) -> Assembled {
        let mut is_closed = true;
        let mut found = vec![Vec::new(); structure.blocks.len()];
        for (index, block) in structure.blocks.iter().enumerate().skip(first) {
            let Found { assemblies, first } = self.close_block(block, &start);
            let closes = !assemblies.is_empty();
            let (unknowns, _) = parts(block);
            unknowns.iter().zip(assemblies.first().unwrap_or(&first)).for_each(|(unknown, value)| start[*unknown] = *value);
            found[index] = assemblies;
            is_closed &= closes;
            if !closes && should_close.get(index) == Some(&true) {
                return Assembled {
                    start,
                    is_closed,
                    open: Some(index),
                    found,
                    others: Vec::new(),
                    is_nearest: false,
                    is_settled: self.is_known_throughout(),
                };
            }
        }
        Assembled { start, is_closed, open: None, found, others: Vec::new(), is_nearest: false, is_settled: self.is_known_throughout() }
    }

    /// The nearest assembly of a block, or what comes nearest to one.
    pub(super) fn nearest(&self, block: &Block, start: &[f64]) -> (Vec<f64>, bool) {
        let Found { assemblies, first } = self.close_block(block, start);
        let closes = !assemblies.is_empty();
        (assemblies.into_iter().next().unwrap_or(first), closes)
    }

    /// The assemblies of a block, the nearest first.
    fn close_block(&self, block: &Block, start: &[f64]) -> Found {
        if parts(block).1.iter().all(|equation| self.is_known(*equation)) {
            let mut reduced = Reduced::new(self, block);
            if let Some(alone) = self.alone(&mut reduced, block, start).filter(|alone| alone.is_nearest()) {
                return Found { first: alone.values.clone(), assemblies: vec![alone.values] };
            }
            let assemblies = self.assemblies(&mut reduced, block, start);
            if let Some(first) = assemblies.first().cloned() {
                return Found { assemblies, first };
            }
        }
        let mut problem = self.block_problem(block, start);
        // What is computed has one value only.
        let is_open = block.iterated.iter().any(|unknown| self.declared[*unknown].is_none());
        let mut found = self.search(&mut problem, if is_open { GUESSES } else { 1 });
        if found.assemblies.is_empty() {
            found.assemblies = self.search_widely(&mut problem, WIDE);
        }
        found
    }

    /// All other assemblies of a block, the nearest first.
    pub(super) fn other_assemblies(&self, structure: &Structure, block: usize, start: &[f64]) -> Vec<Vec<f64>> {
        let block = &structure.blocks[block];
        if block.iterated.is_empty() {
            return Vec::new();
        }
        let (unknowns, _) = parts(block);
        let mut all = self.search_widely(&mut self.block_problem(block, start), GUESSES);
        all.retain(|values| {
            let mut other = start.to_vec();
            unknowns.iter().zip(values).for_each(|(unknown, value)| other[*unknown] = *value);
            !self.differing(start, &other).is_empty()
        });
        all
    }

    /// The equations of a block for its own unknowns.
    pub(super) fn block_problem(&self, block: &Block, start: &[f64]) -> Problem<'_> {
        let (unknowns, equations) = parts(block);
        self.problem(&equations, unknowns, start.to_vec())
    }
}
