//! Whether the motion goes on from the start over the whole range of time.
//!
//! In: a start that is closed and regular. Out: what is remarkable on the way: where a loop cannot stay closed, with the time and what
//! the drive has come to, which is refused where a range is declared; and where two branches cross. The range is the declared one, or as long as it takes until
//! all laws repeat themselves or rest.
//!
//! 1. `law`: how long that is.
//! 2. `chain`: blocks are solved one after the other, as the generated code does, by the interpreter.
//! 3. `walk`: step by step, each short enough that the branch is sure.
//! 4. `turn`: where no step succeeds the block is followed along its own curve, which shows where it turns back.
//! 5. `blame`: what is said.
//! 6. `corners`: the same with parameters at the ends of their bounds.
//!
//! Nothing is refused that was not seen: where a step can be made neither on the path nor along the curve, where a Rust function is
//! needed, or where it would take too many operations, nothing is said.

mod blame;
mod chain;
mod corners;
mod law;
mod turn;
mod walk;

use crate::assembly::Assembly;
use crate::diag::{AssemblyFact, Diag, Doubt, Range, Warning};
use crate::model::Model;
use crate::numeric::{Numeric, at_defaults};
use crate::structure::Structure;
use crate::syntax::ast::{Closing, Following};
use crate::system::System;
use blame::EndReport;
use chain::{Chain, MotionPath};
use walk::Way;

/// Operations that are spent in any case: a start that is declared exactly is found in no time.
const LEAST: u64 = 200_000;

/// The same for each coordinate: reading and deriving its equations takes far longer.
const LEAST_EACH: u64 = 1_000;

/// Times that are nearer to each other than this part of the range are one.
const ONE_TIME: f64 = 1e-9;

/// How the motion goes on from the start.
#[derive(Clone, Debug, Default)]
pub struct Motion {
    /// The times, in s, between which it goes on throughout; both 0 where that is not known.
    pub reached: [f64; 2],
    /// Where it ends, or could go on in two ways, and where it does so at the bounds of parameters.
    pub remarks: Vec<String>,
    /// It ends where no range is declared, so that less may be meant.
    pub warning: Option<Warning>,
    /// Operations of the interpreter that it took to follow it.
    pub effort: u64,
}

/// Follows the motion from the start, over the declared range or as long as it takes until it repeats itself.
pub(crate) fn follow(model: &Model, system: &System, structure: &Structure, assembly: &Assembly, diag: &mut Diag) -> Option<Motion> {
    if !assembly.is_closed || assembly.remark.is_some() || model.following == Following::Off || model.equations_only {
        return Some(Motion::default());
    }
    let Travel { reached, end, notes: mut remarks, spent: effort } =
        at_defaults(model, system, |numeric| Travel::new(numeric, structure, assembly));
    // Who says for how long it moves means it; where that is inferred, less may be meant.
    let is_meant = model.range.is_some() || model.following == Following::Strict;
    let mut warning = None;
    if let Some((range, fact)) = end {
        if model.closing == Closing::Deny && is_meant {
            return diag.refuse(range, fact);
        }
        remarks.insert(0, fact.to_string());
        warning = (model.closing == Closing::Deny).then(|| Warning { doubt: Doubt::MotionEnds(Box::new(fact.into())), range });
    }
    Some(Motion { reached, remarks, warning, effort })
}

/// What following the motion has shown so far.
#[derive(Default)]
struct Travel {
    /// The first and the last time that were reached.
    reached: [f64; 2],
    /// Where the motion ends within the range.
    end: Option<(Range, AssemblyFact)>,
    /// What is worth a line on the page of the type.
    notes: Vec<String>,
    /// Operations of the interpreter.
    spent: u64,
}

impl Travel {
    /// The motion at the declared parameters and, unless it ends, at the ends of their bounds.
    fn new(numeric: &Numeric, structure: &Structure, assembly: &Assembly) -> Travel {
        let most = assembly.effort.max(LEAST + LEAST_EACH * assembly.start.len() as u64);
        let mut travel = Travel::default();
        travel.both_ways(numeric, structure, &assembly.start, most);
        if travel.end.is_none() && travel.reached != [0.0; 2] {
            corners::visit(&mut travel, numeric, structure, &assembly.start, most);
        }
        travel
    }

    /// Forwards and backwards from t = 0 at the parameters of a numeric, as far as the range goes.
    fn both_ways(&mut self, numeric: &Numeric, structure: &Structure, start: &[f64], most: u64) {
        for sign in [1.0, -1.0] {
            let path = MotionPath { sign, from: numeric.known.parameters.to_vec(), to: None };
            let Some(mut chain) = Chain::new(numeric, structure, start, path, most.saturating_sub(self.spent)) else { return };
            self.along(&mut chain, structure, start);
            self.spent = most - chain.left;
            if self.end.is_some() || chain.left == 0 {
                return;
            }
        }
    }

    /// One way from t = 0.
    fn along(&mut self, chain: &mut Chain, structure: &Structure, start: &[f64]) {
        let (numeric, sign) = (chain.numeric, chain.path.sign);
        let blocks: Vec<usize> = chain.members.iter().map(|member| member.block).collect();
        let span = law::span(numeric, structure, blocks.into_iter(), start);
        let stops = span.as_ref().map(|span| span.stops.clone()).unwrap_or_default();
        let declared = numeric.model.range.map(|range| sign * if sign > 0.0 { range.to } else { range.from });
        let until = match (declared, span) {
            // What repeats itself is followed once.
            (Some(declared), Some(span)) if sign > 0.0 => declared.min(span.until),
            (Some(declared), _) => declared,
            (None, Some(span)) if sign > 0.0 => span.until,
            _ => return,
        };
        if until <= 0.0 || !until.is_finite() {
            return;
        }
        let Some(begin) = chain.begin(start) else { return };
        let way = chain.follow(begin, until, &stops);
        let blame = EndReport { numeric, structure, chain, until };
        match way {
            Way::Through(_) => self.reached[usize::from(sign > 0.0)] = sign * until,
            Way::End(place) if place.at < until * (1.0 - ONE_TIME) => self.end = blame.end(&place),
            Way::Crossing(place) if place.at < until * (1.0 - ONE_TIME) => self.notes.extend(blame.crossing(&place)),
            Way::End(_) | Way::Crossing(_) | Way::Lost => {}
        }
    }
}
