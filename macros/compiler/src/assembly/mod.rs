//! The initial assembly problem: from a system to an assembled configuration at the declared defaults, at t = 0.
//!
//! In: a [`System`] and its [`Structure`]. Out: an [`Assembly`]: the configuration from which the generated `solve` starts. Start values
//! that are not declared follow from the joints.
//!
//! 1. `nearest`: for small systems, tree search over all assemblies that may be the nearest, block by block in the order of the
//!    [`Structure`]. `assemblies` finds those of a block, reduced to its iterated unknowns (`reduced`), from guesses and along `curve`s,
//!    while one is missing by their `degree`.
//! 2. `order`: large systems are closed block by block, each with its nearest assembly, or with another one if a later block needs it.
//! 3. Systems that did not close, or that depend on Rust functions, are minimised from several guesses.
//! 4. `diagnose`: refuses an assembly that does not close (`loops`, `links`, `shortest`), is ambiguous, or is singular at this
//!    configuration only (`regular`).
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
mod orientation;
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

/// The start configuration.
#[derive(Clone, Debug)]
pub struct Assembly {
    /// Value of each unknown, in SI units.
    pub start: Vec<f64>,
    /// True if all equations that could be evaluated hold to rounding.
    pub is_closed: bool,
    /// The refusal that the mechanism has allowed, as text.
    pub remark: Option<String>,
    /// Starts that may not be intended.
    pub warnings: Vec<Warning>,
    /// Number of interpreter operations spent.
    pub effort: u64,
}

/// Finds the assembled configuration nearest to the declared start.
pub(crate) fn assemble(model: &Model, system: &System, structure: &Structure, diag: &mut Diag) -> Option<Assembly> {
    at_defaults(model, system, |numeric| {
        if model.closing == Closing::Off {
            return Some(Assembly { start: numeric.unassembled(), is_closed: false, remark: None, warnings: Vec::new(), effort: 0 });
        }
        let mut assembled = numeric.assembled(structure);
        if model.closing == Closing::Deny && model.task.is_determined() {
            redundancy::drives_have_something_to_drive(numeric, structure, &assembled.start, assembled.open.is_some(), diag)?;
        }
        if assembled.is_closed && model.task.is_determined() {
            redundancy::equations_are_independent(numeric, structure, &assembled.start, diag)?;
        }
        let wrong = if !model.task.is_determined() { None } else { diagnose::judge(numeric, structure, &mut assembled) };
        let start = numeric.finished(structure, &assembled);
        let warnings = if assembled.is_closed && model.task.is_determined() { numeric.far_starts(structure, &start) } else { Vec::new() };
        let remark = match wrong {
            Some((range, fact)) if model.closing == Closing::Deny => return diag.refuse(range, fact),
            wrong => wrong.map(|(_, fact)| fact.to_string()),
        };
        Some(Assembly { start, is_closed: assembled.is_closed, remark, warnings, effort: numeric.effort.get() })
    })
}

impl Numeric<'_> {
    /// The assembly to start from, or a partial one.
    fn assembled(&self, structure: &Structure) -> Assembled {
        let is_small = self.system.coordinates.len() <= SMALL && self.model.task.is_determined();
        if let Some(assembled) = is_small.then(|| self.nearest_of_all(structure, Reach::Nearest)).flatten() {
            return assembled;
        }
        if self.system.coordinates.len() <= SMALL || !self.model.task.is_determined() {
            let found = self.search(&mut self.whole(), if self.declared.iter().all(Option::is_some) { 1 } else { search::GUESSES });
            let is_closed = !found.assemblies.is_empty();
            if is_closed || !self.model.task.is_determined() {
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

    /// The start refined to rounding, with the whole turns that bring it nearest to the declared values.
    fn finished(&self, structure: &Structure, assembled: &Assembled) -> Vec<f64> {
        let mut start = assembled.start.clone();
        if assembled.is_closed && self.model.task.is_determined() {
            let has_turned = self.turn_to_start(&mut start);
            if has_turned || !assembled.is_settled {
                self.settle(structure, &mut start);
            }
        }
        // Turns −0 into 0.
        start.iter().map(|value| value + 0.0).collect()
    }

    /// Refines an assembly to rounding, block by block.
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
