//! Stages as straight-line code: named steps before a block, inside its loop, and after it.

use super::routine::{Cost, Step};
use super::schedule::{Scheduler, cost};
use super::shape::Tracer;
use super::stage::{Iteration, Origin, Stage};
use super::words::Words;
use crate::expr::{Arena, Expr, Leaf, Node, Unary};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// Stages as straight-line code.
#[derive(Clone, Debug)]
pub struct StraightLine {
    /// Stages in order.
    pub parts: Vec<StageCode>,
    /// Names of nodes outside of loops.
    pub names: BTreeMap<Expr, String>,
    /// For each unknown, the names of its value, rate and acceleration.
    pub unknowns: Vec<[String; 3]>,
    /// Angles whose sine and cosine are given from outside, with their names.
    pub turned: Vec<(usize, [Option<String>; 2])>,
    /// Steps that depend on parameters only, computed once per set of parameters.
    pub fixed: Vec<Step>,
    /// Names of those results that other lines use.
    pub fixed_names: Vec<String>,
    /// Operations outside of loops.
    pub cost: Cost,
}

/// One stage with its steps.
#[derive(Clone, Debug)]
pub enum StageCode {
    /// A computed unknown.
    Explicit {
        /// Named steps before it.
        steps: Vec<Step>,
        /// Index in q.
        unknown: usize,
        /// Where it comes from.
        origin: Origin,
        /// Value, rate and acceleration.
        motion: [Expr; 3],
    },
    /// Unknowns that are solved together.
    Block(Box<Iterated>),
    /// An equation that is checked.
    Check {
        /// Named steps before it.
        steps: Vec<Step>,
        /// Index in Φ.
        equation: usize,
        /// Residual of the equation.
        residual: Expr,
        /// Rounding scales of the residual: sum of the magnitudes of its terms, and derivatives by lengths and by angles.
        sizes: [Expr; 3],
    },
}

/// A system solved by Newton's method, with its steps.
#[derive(Clone, Debug)]
pub struct Iterated {
    /// Named steps before the loop.
    pub before: Vec<Step>,
    /// The system.
    pub system: Iteration,
    /// For each unknown, the names of its sine and cosine, if used.
    pub turns: Vec<[Option<String>; 2]>,
    /// Named steps in the loop.
    pub inside: Vec<Step>,
    /// Names of nodes in the loop.
    pub names: BTreeMap<Expr, String>,
    /// Operations of one Newton step, without the solution of its linear system.
    pub cost: Cost,
    /// Named steps before the rates.
    pub rates: Vec<Step>,
    /// Named steps before the accelerations.
    pub accelerations: Vec<Step>,
    /// Named steps before the third derivatives.
    pub jerks: Vec<Step>,
}

/// Context of planning.
pub(super) struct PlanContext<'a> {
    pub(super) arena: &'a Arena,
    pub(super) tracer: &'a Tracer<'a>,
    pub(super) words: &'a Words,
    /// By unknown: true for an angle.
    pub(super) is_angle: &'a [bool],
    /// By equation: its joint.
    pub(super) joints: &'a [usize],
    /// The entries of the rotation matrix of each binary link.
    pub(super) links: &'a [Range<usize>],
}

/// Stages over `n` unknowns as straight-line code; sine and cosine of the `turned` unknowns are given.
///
/// If `is_apart`, steps that depend on parameters only come first.
pub(super) fn lines(arena: &Arena, stages: &[Stage], n: usize, turned: &BTreeSet<usize>, is_apart: bool, words: &Words) -> StraightLine {
    let moving: Vec<BTreeSet<Expr>> = stages.iter().map(|stage| moving(arena, stage)).collect();
    let mut roots = Vec::new();
    let mut hoisted = BTreeSet::new();
    for (stage, moving) in stages.iter().zip(&moving) {
        match stage {
            Stage::Explicit { motion, .. } => roots.extend(motion),
            Stage::Check { residual, sizes, .. } => roots.extend([residual].into_iter().chain(sizes)),
            Stage::Block(system) => {
                hoisted.extend(fixed(arena, system, moving));
                roots.extend(system.sizes.iter().chain(&system.rates).chain(&system.accelerations).chain(&system.jerks));
            }
        }
    }
    roots.extend(&hoisted);
    let mut apart = if is_apart { of_parameters(arena, &roots) } else { BTreeSet::new() };
    if !is_worth_keeping(arena, &apart) {
        apart.clear();
    }
    hoisted.extend(&apart);
    let mut work = Scheduler::new(arena, &roots, &hoisted, words, &|expr| since(arena, stages, expr));
    for expr in &apart {
        work.serve(*expr);
    }
    let fixed = work.take();
    let fixed_names = apart.iter().filter_map(|expr| work.names.get(expr).cloned()).collect();
    let turned = turned.iter().map(|unknown| (*unknown, known_turn(arena, &mut work, *unknown))).collect();
    let parts = stages.iter().zip(&moving).map(|(stage, moving)| part(arena, &mut work, stage, moving, words)).collect();
    let name = |index: usize| [Leaf::Coordinate, Leaf::Speed, Leaf::Acceleration].map(|leaf| words.leaf(leaf(index as u32)));
    let cost = cost(arena, &work.needed);
    StraightLine { parts, names: work.names, unknowns: (0..n).map(name).collect(), turned, fixed, fixed_names, cost }
}

/// Number of the moment from which on a node is known if it is a leaf: parameters come first, then time and what is given from outside, after a
/// stage its unknowns, then their rates and so on.
fn since(arena: &Arena, stages: &[Stage], expr: Expr) -> usize {
    let (derivative, unknown) = match arena.node(expr) {
        Node::Leaf(Leaf::Parameter(_)) => return 0,
        Node::Leaf(Leaf::Coordinate(unknown)) => (1, *unknown as usize),
        Node::Leaf(Leaf::Speed(unknown)) => (2, *unknown as usize),
        Node::Leaf(Leaf::Acceleration(unknown)) => (3, *unknown as usize),
        Node::Leaf(Leaf::Jerk(unknown)) => (4, *unknown as usize),
        Node::Leaf(_) => return 1,
        _ => return 0,
    };
    let stage = stages.iter().position(|stage| stage.unknowns().contains(&unknown));
    stage.map_or(1, |number| 4 * number + if matches!(stages[number], Stage::Explicit { .. }) { 2 } else { 1 + derivative })
}

/// Maximal subexpressions of some roots that depend on parameters and on nothing else.
fn of_parameters(arena: &Arena, roots: &[Expr]) -> BTreeSet<Expr> {
    let mut steady: BTreeSet<Expr> = BTreeSet::new();
    let mut found: BTreeSet<Expr> = BTreeSet::new();
    let all = arena.reachable(roots);
    for expr in &all {
        let node = arena.node(*expr);
        let is_steady = match node {
            Node::Constant(_) | Node::Leaf(Leaf::Parameter(_)) => true,
            Node::Leaf(_) => false,
            _ => node.children().all(|child| steady.contains(&child)),
        };
        if is_steady {
            steady.insert(*expr);
        } else {
            found.extend(node.children().filter(|child| steady.contains(child)));
        }
    }
    found.extend(roots.iter().filter(|root| steady.contains(root)));
    let has_parameter = |expr: &Expr| arena.leaves(*expr).iter().any(|leaf| matches!(leaf, Leaf::Parameter(_)));
    found.retain(|expr| !matches!(arena.node(*expr), Node::Leaf(_) | Node::Constant(_)) && has_parameter(expr));
    found
}

/// True if expressions of parameters alone are expensive enough to be kept from state to state.
fn is_worth_keeping(arena: &Arena, apart: &BTreeSet<Expr>) -> bool {
    let all = arena.reachable(&apart.iter().copied().collect::<Vec<Expr>>());
    let open: Vec<Expr> = all.into_iter().filter(|expr| !arena.leaves(*expr).is_empty()).collect();
    let Cost { flops, divisions, sines, calls } = cost(arena, &open);
    flops >= KEPT || divisions + sines + calls > 0
}

/// Number of additions and multiplications that is worth keeping.
const KEPT: usize = 20;

/// Names of the given sine and cosine of an unknown.
fn known_turn(arena: &Arena, work: &mut Scheduler, unknown: usize) -> [Option<String>; 2] {
    let leaf = Node::Leaf(Leaf::Coordinate(unknown as u32));
    let mut names = [None, None];
    let Some(angle) = arena.all().find(|expr| *arena.node(*expr) == leaf) else { return names };
    for (expr, function) in work.turned(angle) {
        let name = work.turn_name(angle, function);
        work.define(expr, name.clone());
        names[usize::from(function == Unary::Cos)] = Some(name);
    }
    names
}

fn part(arena: &Arena, work: &mut Scheduler, stage: &Stage, moving: &BTreeSet<Expr>, words: &Words) -> StageCode {
    match stage {
        Stage::Explicit { unknown, origin, motion } => {
            for expr in motion {
                work.serve(*expr);
            }
            StageCode::Explicit { steps: work.take(), unknown: *unknown, origin: *origin, motion: *motion }
        }
        Stage::Block(system) => StageCode::Block(Box::new(iterated(arena, work, system, moving, words))),
        Stage::Check { equation, residual, sizes } => {
            for expr in [residual].into_iter().chain(sizes) {
                work.serve(*expr);
            }
            StageCode::Check { steps: work.take(), equation: *equation, residual: *residual, sizes: *sizes }
        }
    }
}

fn iterated(arena: &Arena, work: &mut Scheduler, system: &Iteration, moving: &BTreeSet<Expr>, words: &Words) -> Iterated {
    for expr in fixed(arena, system, moving).iter().chain(&system.sizes) {
        work.serve(*expr);
    }
    let before = work.take();
    let results = results(system);
    let mut inner = work.inside(&results, moving);
    let turns = turns(arena, work, &mut inner, system, words);
    for expr in &results {
        inner.serve(*expr);
    }
    let serve_all = |work: &mut Scheduler, roots: &[Expr]| {
        for expr in roots {
            work.serve(*expr);
        }
        work.take()
    };
    let rates = serve_all(work, &system.rates);
    let accelerations = serve_all(work, &system.accelerations);
    let jerks = serve_all(work, &system.jerks);
    let cost = cost(arena, &inner.needed);
    Iterated { before, system: system.clone(), turns, inside: inner.take(), names: inner.names, cost, rates, accelerations, jerks }
}

/// Sine and cosine of the unknowns have the same names in the loop and after it: the loop stores them.
fn turns(arena: &Arena, outer: &mut Scheduler, inner: &mut Scheduler, system: &Iteration, words: &Words) -> Vec<[Option<String>; 2]> {
    let mut turns = Vec::new();
    for unknown in &system.unknowns {
        let mut names = [None, None];
        let leaf = Leaf::Coordinate(*unknown as u32);
        let Some(angle) = inner.needed.iter().chain(&outer.needed).copied().find(|expr| *arena.node(*expr) == Node::Leaf(leaf)) else {
            turns.push(names);
            continue;
        };
        outer.names.insert(angle, words.leaf(leaf));
        inner.names.insert(angle, words.leaf(leaf));
        let wanted: BTreeMap<Expr, Unary> = outer.turned(angle).into_iter().chain(inner.turned(angle)).collect();
        for (expr, function) in wanted {
            let name = outer.turn_name(angle, function);
            outer.define(expr, name.clone());
            inner.define(expr, name.clone());
            names[usize::from(function == Unary::Cos)] = Some(name);
        }
        turns.push(names);
    }
    turns
}

/// All results of the loop: residuals and Jacobian.
fn results(system: &Iteration) -> Vec<Expr> {
    system.residuals.iter().chain(system.jacobian.iter().flatten()).copied().collect()
}

/// Nodes in a block's loop that depend on its unknowns.
fn moving(arena: &Arena, stage: &Stage) -> BTreeSet<Expr> {
    let Stage::Block(system) = stage else { return BTreeSet::new() };
    let mut moving = BTreeSet::new();
    for expr in arena.reachable(&results(system)) {
        let node = arena.node(expr);
        let is_unknown = matches!(node, Node::Leaf(Leaf::Coordinate(index)) if system.unknowns.contains(&(*index as usize)));
        if is_unknown || node.children().any(|child| moving.contains(&child)) {
            moving.insert(expr);
        }
    }
    moving
}

/// Maximal subexpressions in a block's loop that do not depend on its unknowns; they are computed before it.
fn fixed(arena: &Arena, system: &Iteration, moving: &BTreeSet<Expr>) -> BTreeSet<Expr> {
    let results = results(system);
    let below = arena.reachable(&results).into_iter().filter(|expr| moving.contains(expr));
    let children = below.flat_map(|expr| arena.node(expr).children().collect::<Vec<_>>());
    children.chain(results.iter().copied()).filter(|expr| !moving.contains(expr)).collect()
}
