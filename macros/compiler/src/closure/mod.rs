//! From a system to an assembled configuration at the declared defaults, at t = 0.
//!
//! In: a [`System`] and the defaults. Out: a [`Closure`]: the configuration that the generated
//! `solve` starts from. What the declaration does not say of the start follows from the joints:
//! the equations are minimised by the method of Levenberg and Marquardt from the declared start
//! values and, for angles that are not declared, from several guesses; of the assemblies found the
//! one nearest to what was declared is taken. Large systems are closed block by block, in the order of the [`Structure`].
//! Not done here: emitting, refusing.

mod contradiction;
mod levenberg;
mod poses;
mod rank;
mod redundancy;
mod rows;
mod tour;

pub(crate) use poses::Poses;
pub(crate) use redundancy::{equations_are_independent, surplus};

use crate::expr::{Evaluator, Expr, Node, Values, evaluate};
use crate::model::{Dim, Function, Model};
use crate::structure::{Block, Structure};
use crate::system::{Equation, System};
use levenberg::{Problem, minimise};

/// Beyond this many coordinates the minimisation of all equations at once would be felt in `cargo check`.
const LARGEST: usize = 60;

/// How many guesses of what is not declared are tried.
const GUESSES: usize = 24;

/// The configuration to start from.
#[derive(Clone, Debug)]
pub struct Closure {
    /// One value for each unknown, in SI.
    pub start: Vec<f64>,
    /// All equations that could be evaluated hold to rounding there.
    pub is_closed: bool,
}

/// Looks for the assembled configuration nearest to the declared start.
pub(crate) fn close(model: &Model, system: &System, structure: &Structure) -> Closure {
    let functions = |number: u32, x: f64| call(model, number, x);
    let defaults: Vec<Expr> = model.parameters.iter().map(|parameter| parameter.default).collect();
    let nothing = Values { time: 0.0, parameters: &[], coordinates: &[], velocities: &[], accelerations: &[], functions: &functions };
    let parameters = evaluate(&system.arena, &defaults, &nothing);
    let known = Values { parameters: &parameters, ..nothing };
    let declared: Vec<Option<f64>> = system
        .unknowns
        .iter()
        .map(|unknown| unknown.start.and_then(|start| evaluate(&system.arena, &[start], &known).pop()).filter(|value| value.is_finite()))
        .collect();
    let size = size(model, system, &known);
    let room = Room { model, system, known, size, declared };
    if system.unknowns.len() <= LARGEST || model.equations_only { room.at_once() } else { room.in_order(structure) }
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
}

impl Room<'_> {
    /// All equations together.
    fn at_once(&self) -> Closure {
        let mut problem = self.whole();
        let guesses = if self.declared.iter().all(Option::is_some) { 1 } else { GUESSES };
        let (start, is_closed) = self.search(&mut problem, guesses);
        Closure { start, is_closed }
    }

    /// Block by block, each from those before it.
    fn in_order(&self, structure: &Structure) -> Closure {
        let mut start: Vec<f64> = self.declared.iter().map(|value| value.unwrap_or(0.0)).collect();
        let mut is_closed = true;
        for Block { explicit, iterated, residuals } in &structure.blocks {
            let unknowns: Vec<usize> = iterated.iter().copied().chain(explicit.iter().map(|explicit| explicit.unknown)).collect();
            let equations: Vec<usize> = residuals.iter().copied().chain(explicit.iter().map(|explicit| explicit.equation)).collect();
            // What is computed has one value only.
            let is_open = iterated.iter().any(|unknown| self.declared[*unknown].is_none());
            let mut problem = self.problem(&equations, unknowns, start);
            let (found, closed) = self.search(&mut problem, if is_open { GUESSES } else { 1 });
            start = problem.coordinates;
            for (unknown, value) in problem.unknowns.iter().zip(found) {
                start[*unknown] = value;
            }
            is_closed &= closed;
        }
        Closure { start, is_closed }
    }

    /// Tries guesses until every declared value is as near as it can be.
    fn search(&self, problem: &mut Problem, guesses: usize) -> (Vec<f64>, bool) {
        let declared: Vec<Option<f64>> = problem.unknowns.iter().map(|unknown| self.declared[*unknown]).collect();
        let is_angle: Vec<bool> = problem.unknowns.iter().map(|unknown| self.system.unknowns[*unknown].dim == Dim::ANGLE).collect();
        let size = self.size;
        let mut best: Option<(f64, Vec<f64>)> = None;
        let mut first = None;
        for attempt in 0..guesses {
            let free =
                |index: usize| guess(attempt, problem.unknowns[index]) * if is_angle[index] { 1.0 } else { size / core::f64::consts::PI };
            let mut q: Vec<f64> = (0..declared.len()).map(|index| declared[index].unwrap_or_else(|| free(index))).collect();
            // With the angles given, the places follow from equations that are nearly linear in them.
            let free: Vec<bool> = declared.iter().zip(&is_angle).map(|(value, is_angle)| value.is_none() && !is_angle).collect();
            minimise(problem, &mut q, &free);
            first.get_or_insert_with(|| q.clone());
            let free: Vec<bool> = declared.iter().map(Option::is_none).collect();
            minimise(problem, &mut q, &free);
            let everything = vec![true; q.len()];
            if !minimise(problem, &mut q, &everything) {
                continue;
            }
            let distance = distance(&q, &declared, &is_angle, size);
            if best.as_ref().is_none_or(|(least, _)| distance < *least * 0.999) {
                best = Some((distance, q));
            }
            // Angles tell assemblies apart.
            if declared.iter().zip(&is_angle).all(|(value, is_angle)| value.is_some() || !is_angle) {
                break;
            }
        }
        match best {
            Some((_, start)) => (start.iter().zip(&problem.scales).map(|(value, scale)| without_noise(*value, *scale)).collect(), true),
            None => (first.unwrap_or_default(), false),
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
        let scale = |unknown: &usize| if self.system.unknowns[*unknown].dim == Dim::ANGLE { 1.0 } else { self.size };
        Problem {
            rows: rows.len(),
            is_known: rows.iter().map(|equation| equation.phi.is_some_and(|phi| is_known(self.model, self.system, phi))).collect(),
            pattern,
            evaluator: Evaluator::new(&self.system.arena, &roots),
            known: self.known,
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

/// What is zero to rounding is zero, for the eye that reads generated code.
fn without_noise(value: f64, scale: f64) -> f64 {
    if value.abs() <= 1e-13 * scale { 0.0 } else { value }
}

/// How far a configuration is from the declared start; undeclared angles count a little, so that
/// of two assemblies the less turned one is taken.
fn distance(q: &[f64], declared: &[Option<f64>], is_angle: &[bool], size: f64) -> f64 {
    let part = |index: usize| {
        let scale = if is_angle[index] { 1.0 } else { 1.0 / size };
        match declared[index] {
            Some(value) => ((q[index] - value) * scale).powi(2),
            None if is_angle[index] => 1e-6 * q[index].powi(2),
            None => 0.0,
        }
    };
    (0..q.len()).map(part).sum()
}

/// The guess of an undeclared angle: first 0, then spread evenly over a turn, each angle its own way; places likewise.
fn guess(attempt: usize, index: usize) -> f64 {
    // Fractions of the golden section never repeat and fill the circle evenly.
    let turns = (attempt as f64 * (index as f64 + 1.0) * 0.618_033_988_749_895).fract();
    let turns = if turns > 0.5 { turns - 1.0 } else { turns };
    if attempt == 0 { 0.0 } else { turns * core::f64::consts::TAU }
}

/// An expression without Rust functions.
fn is_known(model: &Model, system: &System, root: Expr) -> bool {
    let is_rust = |expr: &Expr| {
        let Node::Call { function, .. } = system.arena.node(*expr) else { return false };
        matches!(model.functions.get(*function as usize), Some(Function::Rust(_)))
    };
    !system.arena.reachable(&[root]).iter().any(is_rust)
}

/// The longest distance of a point from the origin of its body.
fn size(model: &Model, system: &System, known: &Values) -> f64 {
    let lengths = evaluate(&system.arena, &model.lengths, known);
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
