//! Numerical evaluation of a system at the declared defaults.
//!
//! In: a [`System`]. Out: a [`Numeric`]: residuals and derivatives at any configuration, and the numerical methods that other rooms share.
//! Not done here: refusing anything.
//!
//! 1. `least_squares`: configurations that satisfy the equations, by the Levenberg-Marquardt method.
//! 2. `search`: multi-start search for assemblies; whole `turns` of free angles are ignored.
//! 3. `samples`: configurations along the motion.
//! 4. `gap`: smallest gap of a joint when all others are closed.
//! 5. `arms`: universal joints that were given shafts.
//! 6. `basis`: linear dependence of the rows of Φ_q at several configurations at once.

pub(crate) mod arms;
pub(crate) mod basis;
pub(crate) mod gap;
pub(crate) mod least_squares;
pub(crate) mod orientation;
mod resting;
pub(crate) mod samples;
pub(crate) mod search;
pub(crate) mod turns;

use crate::expr::{Evaluator, Expr, Node, Values, evaluate};
use crate::model::{Function, Model, defaults, tabulated};
use crate::system::{Equation, System};
use least_squares::Problem;
use std::cell::{Cell, OnceCell};
use std::collections::BTreeSet;
use turns::Turns;

/// A system with the declared defaults substituted.
pub(crate) struct Numeric<'a> {
    pub(crate) model: &'a Model,
    pub(crate) system: &'a System,
    pub(crate) known: Values<'a>,
    /// Characteristic length: the longest distance of a point from the origin of its body, in m.
    pub(crate) size: f64,
    /// Declared start values, by unknown.
    pub(crate) declared: Vec<Option<f64>>,
    /// Computed on first use.
    turns: OnceCell<Turns>,
    /// Computed on first use.
    resting: OnceCell<BTreeSet<usize>>,
    /// Computed on first use.
    natural: OnceCell<Vec<f64>>,
    /// Number of operations spent.
    pub(crate) effort: Cell<u64>,
}

/// Runs `work` on the system at the declared defaults.
pub(crate) fn at_defaults<R>(model: &Model, system: &System, work: impl FnOnce(&Numeric) -> R) -> R {
    let functions = |number: u32, x: f64| tabulated(&model.functions, number, x);
    let parameters = defaults(model, &system.arena);
    let known = Values { time: 0.0, parameters: &parameters, coordinates: &[], speeds: &[], accelerations: &[], functions: &functions };
    let start = |start: Expr| evaluate(&system.arena, &[start], &known).pop().filter(|value| value.is_finite());
    let declared = system.coordinates.iter().map(|unknown| unknown.start.and_then(start)).collect();
    work(&Numeric::new(model, system, known, declared))
}

impl<'a> Numeric<'a> {
    pub(crate) fn new(model: &'a Model, system: &'a System, known: Values<'a>, declared: Vec<Option<f64>>) -> Numeric<'a> {
        let size = size(system, &known);
        Numeric {
            model,
            system,
            known,
            size,
            declared,
            turns: OnceCell::new(),
            resting: OnceCell::new(),
            natural: OnceCell::new(),
            effort: Cell::default(),
        }
    }
}

impl Numeric<'_> {
    /// A copy with other parameters and start values; the characteristic length stays.
    pub(crate) fn with<'b>(&'b self, known: Values<'b>, declared: Vec<Option<f64>>) -> Numeric<'b> {
        Numeric {
            known,
            declared,
            effort: Cell::default(),
            turns: OnceCell::new(),
            resting: OnceCell::new(),
            natural: OnceCell::new(),
            ..*self
        }
    }

    /// Angles that may differ by whole turns.
    pub(crate) fn turns(&self) -> &Turns {
        self.turns.get_or_init(|| Turns::new(self))
    }

    /// The declared start values, undeclared ones 0.
    pub(crate) fn unassembled(&self) -> Vec<f64> {
        self.declared.iter().map(|value| value.unwrap_or(0.0)).collect()
    }

    /// True if no equation contains a Rust function.
    pub(crate) fn is_known_throughout(&self) -> bool {
        !self.model.functions.iter().any(|function| matches!(function, Function::Rust(_)))
    }

    /// True if an equation contains no Rust function.
    pub(crate) fn is_known(&self, equation: usize) -> bool {
        self.system.equations[equation].phi().is_some_and(|phi| is_known(self.model, self.system, phi))
    }

    /// Scale of an unknown, in m or rad.
    pub(crate) fn scale(&self, unknown: usize) -> f64 {
        self.system.coordinates[unknown].role.scale(self.size)
    }

    /// Natural size of a row of Φ_q in scaled unknowns: that of its dimension, or the largest entry anywhere if that is smaller.
    pub(crate) fn natural(&self, equation: usize) -> f64 {
        self.natural.get_or_init(|| self.found_natural())[equation]
    }

    /// The problem of all equations in all unknowns.
    pub(crate) fn whole(&self) -> Problem<'_> {
        let (equations, unknowns): (Vec<usize>, Vec<usize>) =
            ((0..self.system.equations.len()).collect(), (0..self.declared.len()).collect());
        self.problem(&equations, unknowns, vec![0.0; self.declared.len()])
    }

    /// The problem of some equations in some unknowns; all other coordinates keep the given values.
    pub(crate) fn problem(&self, equations: &[usize], unknowns: Vec<usize>, coordinates: Vec<f64>) -> Problem<'_> {
        // A row that holds by the choice of the coordinates has no gradient.
        let holds = |equation: &usize| self.system.declared.is_some() && self.resting().contains(equation);
        let has_residual = |equation: &usize| self.system.equations[*equation].phi().is_some();
        let kept: Vec<usize> = equations.iter().copied().filter(|equation| !holds(equation) && has_residual(equation)).collect();
        let rows: Vec<&Equation> = kept.iter().map(|equation| &self.system.equations[*equation]).collect();
        let mut roots: Vec<Expr> = rows.iter().filter_map(|equation| equation.phi()).collect();
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
            is_known: rows.iter().map(|equation| equation.phi().is_some_and(|phi| is_known(self.model, self.system, phi))).collect(),
            natural: kept.iter().map(|equation| self.natural(*equation)).collect(),
            pattern,
            evaluator: Evaluator::new(&self.system.arena, &roots),
            shift: Vec::new(),
            known: self.known,
            closed: least_squares::CLOSED,
            effort: &self.effort,
            scales: unknowns.iter().map(scale).collect(),
            unknowns,
            coordinates,
        }
    }
}

/// Index of an unknown in a list; fast if the list contains all unknowns.
pub(crate) fn place(unknowns: &[usize], unknown: usize) -> Option<usize> {
    if unknowns.get(unknown) == Some(&unknown) { Some(unknown) } else { unknowns.iter().position(|other| *other == unknown) }
}

/// True if an expression contains no Rust function.
pub(crate) fn is_known(model: &Model, system: &System, root: Expr) -> bool {
    if !model.functions.iter().any(|function| matches!(function, Function::Rust(_))) {
        return true;
    }
    let is_rust = |expr: &Expr| {
        let Node::Call { function, .. } = system.arena.node(*expr) else { return false };
        matches!(model.functions.get(*function as usize), Some(Function::Rust(_)))
    };
    !system.arena.reachable(&[root]).iter().any(is_rust)
}

/// Longest finite length of the system, in m; 1 if there is none.
pub(crate) fn size(system: &System, known: &Values) -> f64 {
    let lengths = evaluate(&system.arena, &system.lengths, known);
    let longest = lengths.into_iter().filter(|length| length.is_finite()).fold(0.0, |longest: f64, length| longest.max(length.abs()));
    if longest > 0.0 { longest } else { 1.0 }
}
