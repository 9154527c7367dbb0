//! From a system to an assembled configuration at the declared defaults, at t = 0: the initial assembly problem.
//!
//! In: a [`System`] and its [`Structure`]. Out: an [`Assembly`]: the configuration that the generated `solve` starts from. What the
//! declaration does not say of the start follows from the joints.
//!
//! 1. `nearest`: of small systems all assemblies that may be the nearest are gone through, block by block in the order of the
//!    [`Structure`]; `assemblies` finds those of a block, which is solved for what it iterates (`reduced`), from guesses and along
//!    `curve`s from what was found, for as long as one is missing by their `degree`.
//! 2. `order`: large systems are closed block by block, each with its nearest assembly, with others where a later block needs them.
//! 3. What did not close, or depends on functions that are not known here, is minimised from several guesses.
//! 4. `diagnose`: what does not close (`loops`, `links`, `shortest`), closes in two ways that are equally near, or is singular only here
//!    (`regular`) is refused.
//!
//! Not done here: emitting, redundancy.

mod assemblies;
mod curve;
mod degree;
mod diagnose;
mod far;
mod links;
pub(crate) mod loops;
mod nearest;
pub(crate) mod order;
mod poses;
mod reduced;
mod regular;
mod shortest;

pub(crate) use diagnose::bodies_in_line;
pub(crate) use poses::Poses;

use crate::diag::{Diag, Warning};
use crate::model::Model;
use crate::numeric::{Numeric, at_defaults, search};
use crate::redundancy;
use crate::structure::{SMALL, Structure};
use crate::syntax::ast::Closing;
use crate::system::System;
use nearest::Reach;
use order::Assembled;
use reduced::Reduced;

/// The configuration to start from.
#[derive(Clone, Debug)]
pub struct Assembly {
    /// One value for each unknown, in SI.
    pub start: Vec<f64>,
    /// All equations that could be evaluated hold to rounding there.
    pub is_closed: bool,
    /// What would be refused, had the mechanism not allowed it.
    pub remark: Option<String>,
    /// What may not be meant.
    pub warnings: Vec<Warning>,
    /// Operations of the interpreter that it took.
    pub effort: u64,
}

/// Looks for the assembled configuration nearest to the declared start.
pub(crate) fn assemble(model: &Model, system: &System, structure: &Structure, diag: &mut Diag) -> Option<Assembly> {
    at_defaults(model, system, |numeric| {
        if model.closing == Closing::Off {
            return Some(Assembly { start: numeric.unassembled(), is_closed: false, remark: None, warnings: Vec::new(), effort: 0 });
        }
        let mut assembled = numeric.assembled(structure);
        if model.closing == Closing::Deny && !model.equations_only {
            redundancy::drives_have_something_to_drive(numeric, structure, &assembled.start, assembled.open.is_some(), diag)?;
        }
        if assembled.is_closed && !model.equations_only {
            redundancy::equations_are_independent(numeric, structure, &assembled.start, diag)?;
        }
        let wrong = if model.equations_only { None } else { diagnose::judge(numeric, structure, &mut assembled) };
        let start = numeric.finished(structure, &assembled);
        let warnings = if assembled.is_closed && !model.equations_only { numeric.far_starts(structure, &start) } else { Vec::new() };
        let remark = match wrong {
            Some((range, fact)) if model.closing == Closing::Deny => return diag.refuse(range, fact),
            wrong => wrong.map(|(_, fact)| fact.to_string()),
        };
        Some(Assembly { start, is_closed: assembled.is_closed, remark, warnings, effort: numeric.effort.get() })
    })
}

impl Numeric<'_> {
    /// The assembly to start from, or how far an assembly was found.
    fn assembled(&self, structure: &Structure) -> Assembled {
        let is_small = self.system.coordinates.len() <= SMALL && !self.model.equations_only;
        if let Some(assembled) = is_small.then(|| self.nearest_of_all(structure, Reach::Nearest)).flatten() {
            return assembled;
        }
        if self.system.coordinates.len() <= SMALL || self.model.equations_only {
            let found = self.search(&mut self.whole(), if self.declared.iter().all(Option::is_some) { 1 } else { search::GUESSES });
            let is_closed = !found.assemblies.is_empty();
            if is_closed || self.model.equations_only {
                let mut assemblies = found.assemblies.into_iter();
                let start = assemblies.next().unwrap_or(found.first);
                return Assembled {
                    start,
                    is_closed,
                    open: None,
                    found: Vec::new(),
                    others: assemblies.collect(),
                    is_nearest: false,
                    is_settled: false,
                };
            }
        }
        self.in_order(structure)
    }

    /// The start at the rounding limit, with the whole turns that bring it nearest to what is declared.
    fn finished(&self, structure: &Structure, assembled: &Assembled) -> Vec<f64> {
        let mut start = assembled.start.clone();
        if assembled.is_closed && !self.model.equations_only {
            let has_turned = self.turn_to_start(&mut start);
            if has_turned || !assembled.is_settled {
                self.settle(structure, &mut start);
            }
        }
        // There is one zero only.
        start.iter().map(|value| value + 0.0).collect()
    }

    /// Takes an assembly to the rounding limit, block by block.
    fn settle(&self, structure: &Structure, start: &mut [f64]) {
        for block in structure.blocks.iter().filter(|block| block.parts().1.iter().all(|equation| self.is_known(*equation))) {
            let mut reduced = Reduced::new(self, block);
            let mut values: Vec<f64> = reduced.unknowns.iter().map(|unknown| start[*unknown]).collect();
            reduced.set_out_from(start);
            if reduced.settle(&mut values) {
                reduced.unknowns.iter().zip(values).for_each(|(unknown, value)| start[*unknown] = value);
            }
        }
    }
}
