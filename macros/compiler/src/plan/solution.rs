//! Stages as straight lines: what is named before a block, inside its loop, and after it.

use super::kernels::Kernels;
use super::rolled::STRAIGHT;
use super::schedule::{Work, cost};
use super::shape::Tracer;
use super::stages::{Iteration, Stage};
use super::{Cost, Elimination, Step, Words};
use crate::expr::{Arena, Binary, Expr, Leaf, Node, Unary};
use std::collections::{BTreeMap, BTreeSet};

/// How q, q̇ and q̈ are found.
#[derive(Clone, Debug)]
pub struct Solution {
    /// What is found, in order.
    pub stages: Vec<Summary>,
    /// Indices in q of unknowns that may be found to be no finite numbers, or to have no finite rates.
    pub unsure: Vec<usize>,
    /// Operations outside of loops, once for each state.
    pub cost: Cost,
    /// The code that does it.
    pub solving: Solving,
}

/// A stage in short.
#[derive(Clone, Debug)]
pub enum Summary {
    /// An unknown that is computed.
    Explicit {
        /// Its index in q.
        unknown: usize,
        /// It is no constant.
        moves: bool,
    },
    /// Unknowns that are found together.
    Block {
        /// Indices in q.
        unknowns: Vec<usize>,
        /// Indices in Φ.
        equations: Vec<usize>,
        /// Operations of one Newton step, without the solution of its system.
        cost: Cost,
        /// How its system is eliminated, if not in closed form.
        elimination: Option<Box<Elimination>>,
        /// The number of its shape: blocks with the same number do the same operations.
        shape: usize,
    },
    /// An equation that is checked, by its index in Φ.
    Check(usize),
}

/// How the stages are written.
#[derive(Clone, Debug)]
pub enum Solving {
    /// One after the other.
    Straight(Lines),
    /// As one function for each shape of stage.
    Shared(Kernels),
}

/// Stages as straight lines.
#[derive(Clone, Debug)]
pub struct Lines {
    /// In order.
    pub parts: Vec<Part>,
    /// Names of the nodes that have one outside of loops.
    pub names: BTreeMap<Expr, String>,
    /// For each unknown, the names of its value, rate and acceleration.
    pub unknowns: Vec<[String; 3]>,
    /// Angles whose sine and cosine are taken from outside, with the names of these.
    pub turned: Vec<(usize, [Option<String>; 2])>,
    /// What depends on parameters only, once for each set of them.
    pub fixed: Vec<Step>,
    /// The names of what the other lines need of it.
    pub fixed_names: Vec<String>,
    /// Operations outside of loops.
    pub cost: Cost,
}

/// One stage with the steps it needs.
#[derive(Clone, Debug)]
pub enum Part {
    /// An unknown that is computed.
    Explicit {
        /// What is named before it.
        steps: Vec<Step>,
        /// Its index in q.
        unknown: usize,
        /// Index in Φ of the equation that gives it.
        equation: usize,
        /// Value, rate and acceleration.
        motion: [Expr; 3],
    },
    /// Unknowns that are found together.
    Block(Box<Iterated>),
    /// An equation that is checked.
    Check {
        /// What is named before it.
        steps: Vec<Step>,
        /// Its index in Φ.
        equation: usize,
        /// Its residual.
        residual: Expr,
        /// What rounding errors of that are a share of: its terms, its slope by lengths, and by angles.
        sizes: [Expr; 3],
    },
}

/// A system that Newton's method solves, with the steps it needs.
#[derive(Clone, Debug)]
pub struct Iterated {
    /// What is named before the loop.
    pub before: Vec<Step>,
    /// The system itself.
    pub system: Iteration,
    /// For each unknown the names of its sine and cosine, where needed.
    pub turns: Vec<[Option<String>; 2]>,
    /// What is named in the loop.
    pub inside: Vec<Step>,
    /// Names of the nodes that have one in the loop.
    pub names: BTreeMap<Expr, String>,
    /// Operations of one Newton step, without the solution of its system.
    pub cost: Cost,
    /// What is named before the rates.
    pub rates: Vec<Step>,
    /// What is named before the accelerations.
    pub accelerations: Vec<Step>,
}

/// What is known of the numbers in stages.
pub(super) struct Frame<'a> {
    pub(super) arena: &'a Arena,
    pub(super) tracer: &'a Tracer<'a>,
    pub(super) words: &'a Words,
    /// By unknown.
    pub(super) is_angle: &'a [bool],
    /// By equation.
    pub(super) joints: &'a [usize],
}

/// Schedules stages.
///
/// What depends on parameters only is set apart where that `is_apart`.
pub(super) fn solution(frame: &Frame, stages: &[Stage], is_apart: bool) -> Solution {
    let Frame { arena, words, .. } = *frame;
    let kernels = Kernels::new(frame, stages);
    let (of_kernels, all) = (kernels.size(), size(arena, stages));
    let mut blocks = kernels.blocks.iter().copied();
    let summaries = stages.iter().map(|stage| summary(arena, stage, &mut blocks)).collect();
    let (cost, solving) = if all <= STRAIGHT || 2 * of_kernels > all && all <= LONGEST {
        let lines = lines(arena, stages, frame.is_angle.len(), &BTreeSet::new(), is_apart, words);
        (lines.cost, Solving::Straight(lines))
    } else {
        (kernels.cost(), Solving::Shared(kernels))
    };
    Solution { stages: summaries, unsure: unsure(arena, stages), cost, solving }
}

/// Beyond this many operations in one function rustc takes more than its time.
const LONGEST: usize = 16_000;

/// The number of operations of all stages.
fn size(arena: &Arena, stages: &[Stage]) -> usize {
    let roots: Vec<Expr> = stages.iter().flat_map(Stage::results).collect();
    arena.reachable(&roots).len()
}

/// The unknowns that may be found to be no finite numbers, or to have no finite rates.
///
/// What Newton's method finds is finite, and so are its rates if their right sides are. What is computed from finite unknowns by sums,
/// products and sines is finite as well. All else has to be looked at: parameters, which anyone may set, time, and functions that
/// have poles or end somewhere.
fn unsure(arena: &Arena, stages: &[Stage]) -> Vec<usize> {
    let is_given = |node: &Node| matches!(node, Node::Leaf(Leaf::Time | Leaf::Parameter(_) | Leaf::Datum(_)));
    let has = |roots: &[Expr], is_risk: &dyn Fn(&Node) -> bool| arena.reachable(roots).iter().any(|expr| is_risk(arena.node(*expr)));
    let is_unsure = |stage: &&Stage| match stage {
        Stage::Explicit { motion, .. } => has(motion, &|node| is_given(node) || has_poles(arena, node)),
        Stage::Block(_) => has(&stage.results(), &|node| has_poles(arena, node)),
        Stage::Check { .. } => false,
    };
    stages.iter().filter(is_unsure).flat_map(Stage::unknowns).copied().collect()
}

/// An operation that does not give a finite number for every finite operand.
fn has_poles(arena: &Arena, node: &Node) -> bool {
    match *node {
        Node::Binary(Binary::Div, _, divisor) => arena.as_constant(divisor).is_none(),
        Node::Unary(function, _) => matches!(function, Unary::Sqrt | Unary::Tan | Unary::Asin | Unary::Acos | Unary::Exp | Unary::Ln),
        Node::Call { .. } => true,
        Node::Constant(_) | Node::Leaf(_) | Node::Binary(..) | Node::Select { .. } => false,
    }
}

/// A stage in short; the next block has this shape and costs this.
fn summary(arena: &Arena, stage: &Stage, blocks: &mut impl Iterator<Item = (usize, Cost)>) -> Summary {
    match stage {
        Stage::Explicit { unknown, motion, .. } => {
            Summary::Explicit { unknown: *unknown, moves: motion.iter().any(|expr| arena.as_constant(*expr).is_none()) }
        }
        Stage::Block(Iteration { unknowns, equations, elimination, .. }) => {
            let (shape, cost) = blocks.next().unwrap_or_default();
            Summary::Block { unknowns: unknowns.clone(), equations: equations.clone(), cost, elimination: elimination.clone(), shape }
        }
        Stage::Check { equation, .. } => Summary::Check(*equation),
    }
}

/// Stages over `n` unknowns as straight lines; sine and cosine of the `turned` unknowns are known.
///
/// What depends on parameters only comes before all else where that `is_apart`.
pub(super) fn lines(arena: &Arena, stages: &[Stage], n: usize, turned: &BTreeSet<usize>, is_apart: bool, words: &Words) -> Lines {
    let moving: Vec<BTreeSet<Expr>> = stages.iter().map(|stage| moving(arena, stage)).collect();
    let mut roots = Vec::new();
    let mut hoisted = BTreeSet::new();
    for (stage, moving) in stages.iter().zip(&moving) {
        match stage {
            Stage::Explicit { motion, .. } => roots.extend(motion),
            Stage::Check { residual, sizes, .. } => roots.extend([residual].into_iter().chain(sizes)),
            Stage::Block(system) => {
                hoisted.extend(fixed(arena, system, moving));
                roots.extend(system.sizes.iter().chain(&system.rates).chain(&system.accelerations));
            }
        }
    }
    roots.extend(&hoisted);
    let mut apart = if is_apart { of_parameters(arena, &roots) } else { BTreeSet::new() };
    if !is_worth_keeping(arena, &apart) {
        apart.clear();
    }
    hoisted.extend(&apart);
    let mut work = Work::new(arena, &roots, &hoisted, words);
    for expr in &apart {
        work.serve(*expr);
    }
    let fixed = work.take();
    let fixed_names = apart.iter().filter_map(|expr| work.names.get(expr).cloned()).collect();
    let turned = turned.iter().map(|unknown| (*unknown, known_turn(arena, &mut work, *unknown))).collect();
    let parts = stages.iter().zip(&moving).map(|(stage, moving)| part(arena, &mut work, stage, moving, words)).collect();
    let name = |index: usize| [Leaf::Coordinate, Leaf::Velocity, Leaf::Acceleration].map(|leaf| words.leaf(leaf(index as u32)));
    let cost = cost(arena, &work.needed);
    Lines { parts, names: work.names, unknowns: (0..n).map(name).collect(), turned, fixed, fixed_names, cost }
}

/// The largest expressions under some roots that depend on parameters and on nothing else.
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

/// What is computed from parameters alone takes so long that it is kept from state to state.
fn is_worth_keeping(arena: &Arena, apart: &BTreeSet<Expr>) -> bool {
    let all = arena.reachable(&apart.iter().copied().collect::<Vec<Expr>>());
    let open: Vec<Expr> = all.into_iter().filter(|expr| !arena.leaves(*expr).is_empty()).collect();
    let Cost { flops, divisions, sines, calls } = cost(arena, &open);
    flops >= KEPT || divisions + sines + calls > 0
}

/// As many sums and products as this are worth keeping.
const KEPT: usize = 20;

/// Names for sine and cosine of an unknown that are known before anything else.
fn known_turn(arena: &Arena, work: &mut Work, unknown: usize) -> [Option<String>; 2] {
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

fn part(arena: &Arena, work: &mut Work, stage: &Stage, moving: &BTreeSet<Expr>, words: &Words) -> Part {
    match stage {
        Stage::Explicit { unknown, equation, motion } => {
            for expr in motion {
                work.serve(*expr);
            }
            Part::Explicit { steps: work.take(), unknown: *unknown, equation: *equation, motion: *motion }
        }
        Stage::Block(system) => Part::Block(Box::new(iterated(arena, work, system, moving, words))),
        Stage::Check { equation, residual, sizes } => {
            for expr in [residual].into_iter().chain(sizes) {
                work.serve(*expr);
            }
            Part::Check { steps: work.take(), equation: *equation, residual: *residual, sizes: *sizes }
        }
    }
}

fn iterated(arena: &Arena, work: &mut Work, system: &Iteration, moving: &BTreeSet<Expr>, words: &Words) -> Iterated {
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
    let serve_all = |work: &mut Work, roots: &[Expr]| {
        for expr in roots {
            work.serve(*expr);
        }
        work.take()
    };
    let rates = serve_all(work, &system.rates);
    let accelerations = serve_all(work, &system.accelerations);
    let cost = cost(arena, &inner.needed);
    Iterated { before, system: system.clone(), turns, inside: inner.take(), names: inner.names, cost, rates, accelerations }
}

/// Sine and cosine of the unknowns have the same names in the loop and after it: the loop keeps them.
fn turns(arena: &Arena, outer: &mut Work, inner: &mut Work, system: &Iteration, words: &Words) -> Vec<[Option<String>; 2]> {
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

/// Everything that is computed in the loop.
fn results(system: &Iteration) -> Vec<Expr> {
    system.residuals.iter().chain(system.jacobian.iter().flatten()).copied().collect()
}

/// The nodes of a block's loop that depend on its unknowns.
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

/// The largest parts of a block's loop that do not depend on its unknowns; they are computed before it.
fn fixed(arena: &Arena, system: &Iteration, moving: &BTreeSet<Expr>) -> BTreeSet<Expr> {
    let results = results(system);
    let below = arena.reachable(&results).into_iter().filter(|expr| moving.contains(expr));
    let children = below.flat_map(|expr| arena.node(expr).children().collect::<Vec<_>>());
    children.chain(results.iter().copied()).filter(|expr| !moving.contains(expr)).collect()
}
