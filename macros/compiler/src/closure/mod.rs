//! From a system to an assembled configuration at the declared defaults, at t = 0.
//!
//! In: a [`System`] and the defaults. Out: a [`Closure`]: the configuration that the generated
//! `solve` starts from. What the declaration does not say of the start follows from the joints.
//!
//! 1. `nearest`: of small systems all assemblies that may be the nearest are gone through, block by block in the order of the
//!    [`Structure`]; `assemblies` finds those of a block, which is solved for what it iterates (`reduced`), from guesses and along
//!    `curve`s from what was found, for as long as one is missing by their `degree`; whole turns that nothing counts (`turns`) are
//!    taken away.
//! 2. `order`: large systems are closed block by block, each with its nearest assembly, with others where a later block needs them.
//! 3. `search`: what did not close, or depends on functions that are not known here, is minimised from several guesses by the method
//!    of Levenberg and Marquardt (`levenberg`).
//! 4. `verdict`: what does not close (`loops`, `gap`, `links`, `shortest`), closes in two ways that are equally near, or is singular only here
//!    (`regular`) is refused.
//!
//! Not done here: emitting, redundancy.

mod assemblies;
mod contradiction;
mod curve;
mod degree;
mod far;
mod gap;
mod identity;
mod levenberg;
mod links;
mod loops;
mod nearest;
mod order;
mod poses;
mod rank;
mod reduced;
mod redundancy;
mod regular;
mod rows;
mod search;
mod shortest;
mod tour;
mod travel;
mod turns;
mod verdict;

pub(crate) use identity::rows_depend_on_positions;
pub(crate) use poses::Poses;
pub(crate) use redundancy::surplus;

use crate::diag::{Diag, Doubt, Warning};
use crate::expr::{Evaluator, Expr, Node, Values, evaluate};
use crate::model::{Function, Model};
use crate::quantity::Dim;
use crate::structure::Structure;
use crate::syntax::ast::{Closing, Following};
use crate::system::{Equation, System};
use levenberg::Problem;
use nearest::Reach;
use order::Assembled;
use reduced::Reduced;
use std::cell::{Cell, OnceCell};
use turns::Turns;

/// Beyond this many coordinates the minimisation of all equations at once would be felt in `cargo check`.
const LARGEST: usize = 60;

/// The configuration to start from.
#[derive(Clone, Debug)]
pub struct Closure {
    /// One value for each unknown, in SI.
    pub start: Vec<f64>,
    /// All equations that could be evaluated hold to rounding there.
    pub is_closed: bool,
    /// What would be refused, had the mechanism not allowed it.
    pub remark: Option<String>,
    /// What may not be meant.
    pub warnings: Vec<Warning>,
    /// What was found where the motion was followed.
    pub followed: Followed,
    /// Operations of the interpreter: for the start, and for following the motion from there.
    pub effort: [u64; 2],
}

/// What following the motion from the start has shown.
#[derive(Clone, Debug, Default)]
pub struct Followed {
    /// The times, in s, between which the motion goes on throughout; both 0 where that is not known.
    pub reached: [f64; 2],
    /// Where it ends, or could go on in two ways, and where it does so at the bounds of parameters.
    pub remarks: Vec<String>,
    /// It ends where no range is declared, so that less may be meant.
    pub warning: Option<Warning>,
}

/// Looks for the assembled configuration nearest to the declared start.
pub(crate) fn close(model: &Model, system: &System, structure: &Structure, diag: &mut Diag) -> Option<Closure> {
    with_room(model, system, |room| {
        if model.closing == Closing::Off {
            let (start, followed) = (room.unassembled(), Followed::default());
            return Some(Closure { start, is_closed: false, remark: None, warnings: Vec::new(), followed, effort: [0; 2] });
        }
        let mut assembled = room.assembled(structure);
        if model.closing == Closing::Deny && !model.equations_only {
            redundancy::drives_have_something_to_drive(room, structure, &assembled, diag)?;
        }
        if assembled.is_closed && !model.equations_only {
            redundancy::equations_are_independent(room, structure, &assembled.start, diag)?;
        }
        let verdict = if model.equations_only { None } else { verdict::judge(room, structure, &mut assembled) };
        let start = room.finished(structure, &assembled);
        let warnings = if assembled.is_closed && !model.equations_only { room.far_starts(structure, &start) } else { Vec::new() };
        let is_fine = assembled.is_closed && verdict.is_none();
        let (followed, effort) = (Followed::default(), [room.effort.get(), 0]);
        let mut closure = Closure { start, is_closed: assembled.is_closed, remark: None, warnings, followed, effort };
        match verdict {
            Some((range, fact)) if model.closing == Closing::Deny => return diag.refuse(range, fact),
            Some((_, fact)) => closure.remark = Some(fact.to_string()),
            None => {}
        }
        if is_fine && model.following != Following::Off && !model.equations_only {
            // Who says for how long it moves means it; where that is inferred, less may be meant.
            let is_meant = model.range.is_some() || model.following == Following::Strict;
            let travel = travel::travel(room, structure, &closure.start, room.effort.get());
            closure.effort[1] = travel.spent;
            closure.followed = Followed { reached: travel.reached, remarks: travel.notes, warning: None };
            match travel.end {
                Some((range, fact)) if model.closing == Closing::Deny && is_meant => return diag.refuse(range, fact),
                Some((range, fact)) if model.closing == Closing::Deny => {
                    closure.followed.remarks.insert(0, fact.to_string());
                    closure.followed.warning = Some(Warning { doubt: Doubt::MotionEnds(Box::new(fact)), range });
                }
                Some((_, fact)) => closure.followed.remarks.insert(0, fact.to_string()),
                None => {}
            }
        }
        Some(closure)
    })
}

/// Does something with what is known before anything is closed.
fn with_room<R>(model: &Model, system: &System, work: impl FnOnce(&Room) -> R) -> R {
    let functions = |number: u32, x: f64| call(model, number, x);
    let defaults: Vec<Expr> = model.parameters.iter().map(|parameter| parameter.default).collect();
    let nothing = Values { time: 0.0, parameters: &[], coordinates: &[], velocities: &[], accelerations: &[], functions: &functions };
    let parameters = evaluate(&system.arena, &defaults, &nothing);
    let known = Values { parameters: &parameters, ..nothing };
    let start = |start: Expr| evaluate(&system.arena, &[start], &known).pop().filter(|value| value.is_finite());
    let declared = system.unknowns.iter().map(|unknown| unknown.start.and_then(start)).collect();
    let size = size(system, &known);
    work(&Room { model, system, known, size, declared, turns: OnceCell::new(), effort: Cell::default() })
}

/// What is known before anything is closed.
struct Room<'a> {
    model: &'a Model,
    system: &'a System,
    known: Values<'a>,
    /// The longest distance of a point from the origin of its body.
    size: f64,
    /// Declared start values, by unknown.
    declared: Vec<Option<f64>>,
    /// Found when first asked for.
    turns: OnceCell<Turns>,
    /// Operations that were spent.
    effort: Cell<u64>,
}

impl Room<'_> {
    /// Which angles may be whole turns more or less.
    fn turns(&self) -> &Turns {
        self.turns.get_or_init(|| Turns::new(self))
    }

    /// The declared start as it stands.
    fn unassembled(&self) -> Vec<f64> {
        self.declared.iter().map(|value| value.unwrap_or(0.0)).collect()
    }

    /// The assembly to start from, or how far an assembly was found.
    fn assembled(&self, structure: &Structure) -> Assembled {
        let is_small = self.system.unknowns.len() <= LARGEST && !self.model.equations_only;
        if let Some(assembled) = is_small.then(|| self.nearest_of_all(structure, Reach::Nearest)).flatten() {
            return assembled;
        }
        if self.system.unknowns.len() <= LARGEST || self.model.equations_only {
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

    /// No equation has a Rust function in it.
    fn is_known_throughout(&self) -> bool {
        !self.model.functions.iter().any(|function| matches!(function, Function::Rust(_)))
    }

    /// An equation without Rust functions.
    fn is_known(&self, equation: usize) -> bool {
        self.system.equations[equation].phi.is_some_and(|phi| is_known(self.model, self.system, phi))
    }

    /// What a unit step of an unknown is.
    fn scale(&self, unknown: usize) -> f64 {
        if self.system.unknowns[unknown].dim == Dim::ANGLE { 1.0 } else { self.size }
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
        for block in structure.blocks.iter().filter(|block| order::parts(block).1.iter().all(|equation| self.is_known(*equation))) {
            let mut reduced = Reduced::new(self, block);
            let mut values: Vec<f64> = reduced.unknowns.iter().map(|unknown| start[*unknown]).collect();
            reduced.set_out_from(start);
            if reduced.settle(&mut values) {
                reduced.unknowns.iter().zip(values).for_each(|(unknown, value)| start[*unknown] = value);
            }
        }
    }

    /// All equations for all unknowns.
    fn whole(&self) -> Problem<'_> {
        let (equations, unknowns): (Vec<usize>, Vec<usize>) =
            ((0..self.system.equations.len()).collect(), (0..self.declared.len()).collect());
        self.problem(&equations, unknowns, vec![0.0; self.declared.len()])
    }

    /// Some equations and their derivatives at the defaults, as functions of some unknowns alone.
    fn problem(&self, equations: &[usize], unknowns: Vec<usize>, coordinates: Vec<f64>) -> Problem<'_> {
        let rows: Vec<&Equation> =
            equations.iter().map(|equation| &self.system.equations[*equation]).filter(|equation| equation.phi.is_some()).collect();
        let mut roots: Vec<Expr> = rows.iter().filter_map(|equation| equation.phi).collect();
        let mut pattern = Vec::new();
        for (row, equation) in rows.iter().enumerate() {
            for (unknown, entry) in &equation.jacobian {
                if let Some(column) = place(&unknowns, *unknown) {
                    pattern.push((row, column));
                    roots.push(*entry);
                }
            }
        }
        let scale = |unknown: &usize| self.scale(*unknown);
        Problem {
            rows: rows.len(),
            is_known: rows.iter().map(|equation| equation.phi.is_some_and(|phi| is_known(self.model, self.system, phi))).collect(),
            pattern,
            evaluator: Evaluator::new(&self.system.arena, &roots),
            shift: Vec::new(),
            known: self.known,
            closed: levenberg::CLOSED,
            effort: &self.effort,
            scales: unknowns.iter().map(scale).collect(),
            unknowns,
            coordinates,
        }
    }
}

/// Where an unknown stands in a list; in the list of all it stands at its own place.
fn place(unknowns: &[usize], unknown: usize) -> Option<usize> {
    if unknowns.get(unknown) == Some(&unknown) { Some(unknown) } else { unknowns.iter().position(|other| *other == unknown) }
}

/// An expression without Rust functions.
fn is_known(model: &Model, system: &System, root: Expr) -> bool {
    if !model.functions.iter().any(|function| matches!(function, Function::Rust(_))) {
        return true;
    }
    let is_rust = |expr: &Expr| {
        let Node::Call { function, .. } = system.arena.node(*expr) else { return false };
        matches!(model.functions.get(*function as usize), Some(Function::Rust(_)))
    };
    !system.arena.reachable(&[root]).iter().any(is_rust)
}

/// The characteristic length.
fn size(system: &System, known: &Values) -> f64 {
    let lengths = evaluate(&system.arena, &system.lengths, known);
    let longest = lengths.into_iter().filter(|length| length.is_finite()).fold(0.0, |longest: f64, length| longest.max(length.abs()));
    if longest > 0.0 { longest } else { 1.0 }
}

/// Tables are known here; Rust functions are not, and their rows are left out.
fn call(model: &Model, number: u32, x: f64) -> [f64; 3] {
    match model.functions.get(number as usize) {
        Some(Function::Table(table)) => table.evaluate(x),
        _ => [f64::NAN; 3],
    }
}
