//! Which joints and bodies close together with a block.
//!
//! In: a [`Structure`]. Out: a [`Loop`]. A block holds the coordinates that must be found together; the places of its bodies are
//! often computed in blocks of one unknown before and after it, and the joints that give them belong to the loop as well.

use super::order::Upstream;
use crate::numeric::Numeric;
use crate::structure::{Block, Structure};
use std::collections::BTreeSet;

/// What has to close together.
pub(crate) struct Loop {
    pub(crate) unknowns: Vec<usize>,
    pub(crate) equations: Vec<usize>,
    /// The bodies that are not placed by what comes before.
    pub(crate) moving: BTreeSet<usize>,
}

/// Finds the loops of a mechanism.
pub(crate) struct Loops<'a> {
    pub(crate) numeric: &'a Numeric<'a>,
    pub(crate) structure: &'a Structure,
    pub(crate) upstream: &'a Upstream,
}

impl Loops<'_> {
    /// A loop: a block, and what places its bodies and those next to them without being iterated.
    ///
    /// A body that is held by a loop closed before is left where it is: to open one of its joints would open that loop.
    pub(crate) fn around(&self, index: usize) -> Loop {
        let blocks = &self.structure.blocks;
        let is_computed = |block: usize| blocks[block].iterated.is_empty();
        let of_equations = |block: usize| -> BTreeSet<usize> {
            let equations = blocks[block].parts().1.into_iter().map(|equation| &self.numeric.system.equations[equation]);
            equations
                .flat_map(|equation| equation.jacobian.iter())
                .map(|(unknown, _)| self.numeric.system.coordinates[*unknown].body)
                .collect()
        };
        let held: BTreeSet<usize> = (0..index).filter(|block| !is_computed(*block)).flat_map(of_equations).collect();
        // Nothing is known of what needs a loop that comes later.
        let upstream = self.upstream.all(index);
        let is_known = |block: &usize| {
            is_computed(*block)
                && self.upstream.all(*block).iter().all(|other| is_computed(*other) || *other == index || upstream.contains(other))
        };
        let known: Vec<(usize, BTreeSet<usize>)> =
            (0..blocks.len()).filter(is_known).map(|block| (block, self.bodies(&blocks[block]))).collect();
        let mut bodies: BTreeSet<usize> = of_equations(index).difference(&held).copied().collect();
        bodies.extend(self.bodies(&blocks[index]));
        let mut members = BTreeSet::from([index]);
        loop {
            let more: Vec<usize> =
                known.iter().filter(|(block, own)| !members.contains(block) && own.is_subset(&bodies)).map(|(block, _)| *block).collect();
            if more.is_empty() {
                break;
            }
            bodies.extend(more.iter().flat_map(|block| of_equations(*block)).filter(|body| !held.contains(body)));
            members.extend(more);
        }
        let moving = |block: &&usize| **block == index || self.upstream.all(**block).contains(&index);
        let moving = members.iter().filter(moving).flat_map(|block| self.bodies(&blocks[*block])).collect();
        let (unknowns, equations): (Vec<_>, Vec<_>) = members.into_iter().map(|block| blocks[block].parts()).unzip();
        Loop { unknowns: unknowns.concat(), equations: equations.concat(), moving }
    }

    /// Computes what comes later in the order and does not need a block that stays open.
    pub(crate) fn complete(&self, index: usize, start: &mut [f64]) {
        for (later, block) in self.structure.blocks.iter().enumerate().skip(index + 1) {
            let all = self.upstream.all(later);
            let is_known = all.iter().all(|other| *other < index || self.structure.blocks[*other].iterated.is_empty());
            if block.iterated.is_empty() && is_known && !all.contains(&index) {
                let (values, _) = self.numeric.nearest(block, start);
                block.parts().0.iter().zip(values).for_each(|(unknown, value)| start[*unknown] = value);
            }
        }
    }

    /// The bodies that move with a block.
    pub(crate) fn bodies(&self, block: &Block) -> BTreeSet<usize> {
        block.parts().0.iter().map(|unknown| self.numeric.system.coordinates[*unknown].body).collect()
    }
}
