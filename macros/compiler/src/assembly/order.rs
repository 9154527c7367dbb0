//! Closing block by block, each from those before it.
//!
//! In: a [`Structure`]. Out: an [`Assembled`]. A later block may close with one assembly of an earlier block and not with another;
//! where it does not close with the nearest one, the others are tried, the last block first.

use super::reduced::Reduced;
use crate::numeric::Numeric;
use crate::numeric::least_squares::Problem;
use crate::numeric::search::{GUESSES, SearchResult};
use crate::structure::{Block, Structure};
use crate::syntax::ast::Closing;
use std::collections::BTreeSet;

/// How often another assembly of an earlier block is tried before a block counts as open.
const MOST_TRIES: usize = 48;

/// How many guesses are made where the declared start leads nowhere.
const WIDE: usize = 48;

/// The assembly to start from, or how far an assembly was found.
pub(crate) struct Assembled {
    /// One value for each unknown.
    pub(crate) start: Vec<f64>,
    /// All rows that could be evaluated hold.
    pub(crate) is_closed: bool,
    /// The first block that did not close, and that should.
    pub(crate) open: Option<usize>,
    /// Of each block closed on its own, the assemblies that were found.
    pub(crate) found: Vec<Vec<Vec<f64>>>,
    /// Where all was closed at once, the assemblies that are not as near.
    pub(crate) others: Vec<Vec<f64>>,
    /// Whether all assemblies that may be as near were looked at.
    pub(crate) is_nearest: bool,
    /// Each block was taken to the rounding limit.
    pub(crate) is_settled: bool,
}

/// What each block depends on.
pub(crate) struct Upstream {
    of_block: Vec<BTreeSet<usize>>,
}

impl Upstream {
    pub(crate) fn new(numeric: &Numeric, structure: &Structure) -> Upstream {
        let mut owner = vec![None; numeric.declared.len()];
        for (index, block) in structure.blocks.iter().enumerate() {
            block.parts().0.into_iter().for_each(|unknown| owner[unknown] = Some(index));
        }
        let direct = |(index, block): (usize, &Block)| {
            let unknowns = block.parts().1.into_iter().flat_map(|equation| numeric.system.equations[equation].jacobian.iter());
            unknowns.filter_map(|(unknown, _)| owner[*unknown]).filter(|other| *other != index).collect()
        };
        Upstream { of_block: structure.blocks.iter().enumerate().map(direct).collect() }
    }

    /// The blocks on which a block depends itself.
    pub(crate) fn direct(&self, block: usize) -> impl Iterator<Item = usize> {
        self.of_block[block].iter().copied()
    }

    /// All blocks on which a block depends, through others too.
    pub(crate) fn all(&self, block: usize) -> BTreeSet<usize> {
        let mut found = BTreeSet::new();
        let mut open = vec![block];
        while let Some(next) = open.pop() {
            open.extend(self.of_block[next].iter().filter(|other| found.insert(**other)));
        }
        found
    }

    /// Of each block, whether every number it depends on is known in the compiler.
    pub(crate) fn surety(&self, numeric: &Numeric, structure: &Structure) -> Vec<bool> {
        let mut is_sure: Vec<bool> = Vec::new();
        for (index, block) in structure.blocks.iter().enumerate() {
            // Blocks stand in order: what is upstream has been looked at.
            let sure = self.of_block[index].iter().all(|other| is_sure.get(*other) == Some(&true));
            is_sure.push(sure && block.parts().1.iter().all(|equation| numeric.is_known(*equation)));
        }
        is_sure
    }
}

impl Numeric<'_> {
    /// Block by block, each from those before it.
    pub(crate) fn in_order(&self, structure: &Structure) -> Assembled {
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
            let (unknowns, _) = structure.blocks[block].parts();
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
    pub(crate) fn forward(&self, structure: &Structure, mut start: Vec<f64>, first: usize, should_close: &[bool]) -> Assembled {
        let mut is_closed = true;
        let mut found = vec![Vec::new(); structure.blocks.len()];
        for (index, block) in structure.blocks.iter().enumerate().skip(first) {
            let SearchResult { assemblies, first } = self.close_block(block, &start);
            let closes = !assemblies.is_empty();
            let (unknowns, _) = block.parts();
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
    pub(crate) fn nearest(&self, block: &Block, start: &[f64]) -> (Vec<f64>, bool) {
        let SearchResult { assemblies, first } = self.close_block(block, start);
        let closes = !assemblies.is_empty();
        (assemblies.into_iter().next().unwrap_or(first), closes)
    }

    /// The assemblies of a block, the nearest first.
    fn close_block(&self, block: &Block, start: &[f64]) -> SearchResult {
        if block.parts().1.iter().all(|equation| self.is_known(*equation)) {
            let mut reduced = Reduced::new(self, block);
            if let Some(alone) = self.alone(&mut reduced, block, start).filter(|alone| alone.is_nearest()) {
                return SearchResult { first: alone.values.clone(), assemblies: vec![alone.values] };
            }
            let assemblies = self.assemblies(&mut reduced, block, start);
            if let Some(first) = assemblies.first().cloned() {
                return SearchResult { assemblies, first };
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
    pub(crate) fn other_assemblies(&self, structure: &Structure, block: usize, start: &[f64]) -> Vec<Vec<f64>> {
        let block = &structure.blocks[block];
        if block.iterated.is_empty() {
            return Vec::new();
        }
        let (unknowns, _) = block.parts();
        let mut all = self.search_widely(&mut self.block_problem(block, start), GUESSES);
        all.retain(|values| {
            let mut other = start.to_vec();
            unknowns.iter().zip(values).for_each(|(unknown, value)| other[*unknown] = *value);
            !self.differing(start, &other).is_empty()
        });
        all
    }

    /// The equations of a block for its own unknowns.
    pub(crate) fn block_problem(&self, block: &Block, start: &[f64]) -> Problem<'_> {
        let (unknowns, equations) = block.parts();
        self.problem(&equations, unknowns, start.to_vec())
    }
}
