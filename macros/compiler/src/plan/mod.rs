//! From expressions to straight lines: every decision on names and order is taken here.
//!
//! In: a [`System`] and what is to be computed. Out: [`Routine`]s: named steps, each used more than
//! once, and results that refer to them. Not done here: printing.

mod elimination;
mod magnitude;
mod schedule;
mod solution;
mod stages;

pub use elimination::Elimination;
pub use solution::{Iterated, Part, Solution};
pub use stages::{Iteration, Stage};

use crate::closure::{Closure, Poses};
use crate::expr::{Arena, Expr, Leaf};
use crate::model::Model;
use crate::structure::Structure;
use crate::system::System;
use std::collections::{BTreeMap, BTreeSet};

/// Everything that is generated, as straight lines.
#[derive(Clone, Debug)]
pub struct Plan {
    /// All expressions of the system and those that its solution needs.
    pub arena: Arena,
    /// How q, q̇ and q̈ are found; none for equations that are not solved.
    pub solution: Option<Solution>,
    /// Φ(q, t), one result for each row.
    pub phi: Routine,
    /// The entries of Φ_q that are not identically zero, row by row.
    pub jacobian: Routine,
    /// Φ, then the entries of Φ_q.
    pub linearize: Routine,
    /// ν(q, t)
    pub nu: Routine,
    /// γ(q, q̇, t)
    pub gamma: Routine,
    /// Row and column of each entry of Φ_q.
    pub pattern: Vec<(usize, usize)>,
    /// For each output: value, rate and acceleration of each component.
    pub outputs: Vec<Routine>,
    /// The declared start values, by unknown; those not declared have no result.
    pub start: Routine,
    /// The local coordinates of points that depend on parameters or are constants.
    pub lengths: Routine,
    /// Left and right side of each requirement.
    pub requirements: Routine,
}

/// Straight lines: steps in order, then results.
#[derive(Clone, Debug)]
pub struct Routine {
    /// What is named on the way.
    pub steps: Vec<Step>,
    /// What is computed. Each is written once, after the steps with a smaller or equal index.
    pub results: Vec<Expr>,
    /// How many steps stand before each result.
    pub after: Vec<usize>,
    /// Names of the nodes that have one.
    pub names: BTreeMap<Expr, String>,
    /// The leaves it reads, with their place in the arena.
    pub leaves: Vec<(Expr, Leaf)>,
    /// How often each kind of operation is done.
    pub cost: Cost,
}

/// One step.
#[derive(Clone, Debug)]
pub enum Step {
    /// A value that is used more than once.
    Value(Expr),
    /// Sine and cosine of an angle; a name is missing where the value is not needed.
    SineCosine {
        /// The angle.
        angle: Expr,
        /// Name of its sine.
        sine: Option<String>,
        /// Name of its cosine.
        cosine: Option<String>,
    },
    /// A function known by number, with its derivatives.
    Call {
        /// Its number.
        function: u32,
        /// Its argument.
        argument: Expr,
        /// Names of value, first and second derivative, where needed.
        names: [Option<String>; 3],
    },
}

/// Operation counts of a routine.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Additions, subtractions and multiplications.
    pub flops: usize,
    /// Divisions and square roots.
    pub divisions: usize,
    /// Pairs of sine and cosine.
    pub sines: usize,
    /// Other functions.
    pub calls: usize,
}

/// Schedules everything that is generated.
pub(crate) fn schedule(model: &Model, system: &System, structure: &Structure, closure: &Closure) -> Plan {
    let mut arena = system.arena.clone();
    let stages = (!model.equations_only).then(|| stages::stages(&mut arena, system, structure));
    let words = Words::new(model, system);
    let line = |results: Vec<Expr>| schedule::routine(&arena, results, &words);
    let phi: Vec<Expr> = system.equations.iter().filter_map(|equation| equation.phi).collect();
    let entries: Vec<Expr> = system.equations.iter().flat_map(|equation| equation.jacobian.iter().map(|(_, entry)| *entry)).collect();
    let row =
        |(row, equation): (usize, &crate::system::Equation)| equation.jacobian.iter().map(|(column, _)| (row, *column)).collect::<Vec<_>>();
    let pattern = system.equations.iter().enumerate().flat_map(row).collect();
    let sides = model.requirements.iter().flat_map(|requirement| [requirement.lhs, requirement.rhs]).collect();
    Plan {
        linearize: line(phi.iter().chain(&entries).copied().collect()),
        phi: line(phi),
        jacobian: line(entries),
        nu: line(system.equations.iter().map(|equation| equation.nu).collect()),
        gamma: line(system.equations.iter().map(|equation| equation.gamma).collect()),
        pattern,
        outputs: system.outputs.iter().map(|output| line(output.components.iter().flatten().copied().collect())).collect(),
        start: line(system.unknowns.iter().filter_map(|unknown| unknown.start).collect()),
        lengths: line(distinct(&arena, &model.lengths)),
        requirements: line(sides),
        solution: stages.map(|stages| {
            let mut solution = solution::solution(&arena, &stages, system.unknowns.len(), &words);
            eliminations(&arena, model, system, closure, &mut solution);
            solution
        }),
        arena,
    }
}

/// Chooses how large blocks are eliminated; most mechanisms have none.
fn eliminations(arena: &Arena, model: &Model, system: &System, closure: &Closure, solution: &mut Solution) {
    let mut poses = None;
    for part in &mut solution.parts {
        if let Part::Block(block) = part
            && block.system.unknowns.len() > elimination::CLOSED_FORM
        {
            let poses = poses.get_or_insert_with(|| Poses::new(model, system, closure));
            block.elimination = Some(elimination::elimination(arena, system, &block.system, poses));
        }
    }
}

/// Each length once, zeros left out.
fn distinct(arena: &Arena, lengths: &[Expr]) -> Vec<Expr> {
    let mut distinct = lengths.to_vec();
    distinct.sort();
    distinct.dedup();
    distinct.retain(|length| !arena.as_constant(*length).is_some_and(|value| value.is_zero()));
    distinct
}

/// The user's words for leaves.
pub(crate) struct Words {
    coordinates: Vec<String>,
    parameters: Vec<String>,
}

impl Words {
    /// From the names of bodies, coordinates and parameters.
    pub(crate) fn new(model: &Model, system: &System) -> Words {
        let plain = |name: &proc_macro2::Ident| name.to_string().trim_start_matches("r#").to_owned();
        let coordinate = |unknown: &crate::system::Unknown| format!("{}_{}", plain(&model.bodies[unknown.body].name), unknown.name);
        Words {
            coordinates: system.unknowns.iter().map(coordinate).collect(),
            parameters: model.parameters.iter().map(|parameter| parameter.name.to_string()).collect(),
        }
    }

    /// The names of all leaves but parameters, which no step may have.
    fn taken(&self) -> BTreeSet<String> {
        let motion = [Leaf::Coordinate, Leaf::Velocity, Leaf::Acceleration];
        let of_unknown = |index: usize| motion.map(|leaf| self.leaf(leaf(index as u32)));
        (0..self.coordinates.len()).flat_map(of_unknown).chain([self.leaf(Leaf::Time)]).collect()
    }

    /// The name of a leaf in generated code.
    pub(crate) fn leaf(&self, leaf: Leaf) -> String {
        let coordinate = |index: u32| self.coordinates.get(index as usize).cloned().unwrap_or_default();
        match leaf {
            Leaf::Time => "t".to_owned(),
            Leaf::Parameter(index) => self.parameters.get(index as usize).map_or(String::new(), |name| format!("self.{name}")),
            Leaf::Coordinate(index) => coordinate(index),
            Leaf::Velocity(index) => coordinate(index) + "_rate",
            Leaf::Acceleration(index) => coordinate(index) + "_acceleration",
        }
    }
}
