//! Follows the motion from the start over the whole range of time.
//!
//! In: a start that is closed and regular. Out: events on the way. At an end of travel a loop cannot stay closed; its time and the position
//! of the drive are reported, and it is refused if a range is declared. At a crossing two branches meet. The range is the declared one, or
//! lasts until all laws repeat or rest.
//!
//! 1. `law`: length of the inferred range.
//! 2. `chain`: solves the blocks in order, as the generated code does, by the interpreter.
//! 3. `walk`: step control; each step is short enough that the branch is certain.
//! 4. `turn`: if no step succeeds, follows the block along its own curve, which shows the point where it turns back.
//! 5. `blame`: reports.
//! 6. `corners`: the same with parameters at the ends of their bounds.
//! 7. `cams` and `gears`: whether cams can be made, and gears mesh.
//!
//! Only observed events are refused: nothing is reported if a step is possible neither on the path nor along the curve, if a Rust function is
//! needed, or if it would take too many operations.

mod blame;
mod cams;
mod chain;
mod corners;
mod gears;
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

/// Minimum budget of operations, for a start that is declared exactly and takes hardly any to find.
const LEAST: u64 = 200_000;

/// Additional budget per coordinate: reading and differentiating its equations takes far longer.
const LEAST_EACH: u64 = 1_000;

/// Times closer to each other than this fraction of the range are equal.
const ONE_TIME: f64 = 1e-9;

/// Motion from the start.
#[derive(Clone, Debug, Default)]
pub struct Motion {
    /// Times, in s, between which the motion continues; both 0 if unknown.
    pub reached: [f64; 2],
    /// Ends of travel and crossings of branches, also at the bounds of parameters.
    pub remarks: Vec<String>,
    /// An end of travel without a declared range: a shorter motion may be meant.
    pub warning: Option<Warning>,
    /// Cams that are undercut, and gears that do not mesh.
    pub flaws: Vec<Warning>,
    /// Number of interpreter operations spent.
    pub effort: u64,
}

/// Follows the motion from the start, over the declared range or until it repeats.
pub(crate) fn follow(model: &Model, system: &System, structure: &Structure, assembly: &Assembly, diag: &mut Diag) -> Option<Motion> {
    let flaws = || [cams::undercut(model, system), gears::apart(model, system), gears::inside_out(model, system)].concat();
    let flaws = if model.closing == Closing::Deny { flaws() } else { Vec::new() };
    if !assembly.is_closed || assembly.remark.is_some() || model.following == Following::Off || !model.task.is_solved() {
        return Some(Motion { flaws, ..Motion::default() });
    }
    let Travel { reached, end, notes: mut remarks, spent: effort } =
        at_defaults(model, system, |numeric| Travel::new(numeric, structure, assembly));
    // A declared range is meant; with an inferred range a shorter motion may be meant.
    let is_meant = model.range.is_some() || model.following == Following::Strict;
    let mut warning = None;
    if let Some((range, fact)) = end {
        if model.closing == Closing::Deny && is_meant {
            return diag.refuse(range, fact);
        }
        remarks.insert(0, fact.to_string());
        warning = (model.closing == Closing::Deny).then(|| Warning { doubt: Doubt::MotionEnds(Box::new(fact.into())), range });
    }
    Some(Motion { reached, remarks, warning, flaws, effort })
}

/// Findings while the motion is followed.
#[derive(Default)]
struct Travel {
    /// First and last time reached, in s.
    reached: [f64; 2],
    /// End of travel within the range.
    end: Option<(Range, AssemblyFact)>,
    /// Lines for the documentation of the type.
    notes: Vec<String>,
    /// Number of interpreter operations spent.
    spent: u64,
}

impl Travel {
    /// Follows the motion at the declared parameters and, unless it ends, at the ends of their bounds.
    fn new(numeric: &Numeric, structure: &Structure, assembly: &Assembly) -> Travel {
        let most = assembly.effort.max(LEAST + LEAST_EACH * assembly.start.len() as u64);
        let mut travel = Travel::default();
        travel.both_ways(numeric, structure, &assembly.start, most);
        if travel.end.is_none() && travel.reached != [0.0; 2] {
            corners::visit(&mut travel, numeric, structure, &assembly.start, most);
        }
        travel
    }

    /// Follows the motion forwards and backwards from t = 0 at the parameters of `numeric`, as far as the range goes.
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

    /// Follows the motion in one direction from t = 0.
    fn along(&mut self, chain: &mut Chain, structure: &Structure, start: &[f64]) {
        let (numeric, sign) = (chain.numeric, chain.path.sign);
        let blocks: Vec<usize> = chain.members.iter().map(|member| member.block).collect();
        let span = law::span(numeric, structure, blocks.into_iter(), start);
        let stops = span.as_ref().map(|span| span.stops.clone()).unwrap_or_default();
        let declared = numeric.model.range.map(|range| sign * if sign > 0.0 { range.to } else { range.from });
        let until = match (declared, span) {
            // A motion that repeats is followed once.
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
