//! One routine: which nodes get a name, in which order they are computed.

use super::{Cost, Routine, Step, Words};
use crate::expr::{Arena, Binary, Expr, Leaf, Node, Unary};
use std::collections::{BTreeMap, BTreeSet};

/// Expressions deeper than this are cut into named parts, so that a reader and rustc's parser both
/// get lines of bearable length.
const DEPTH: usize = 12;

/// Schedules the computation of `results`, each written once, its steps just before it.
pub(super) fn routine(arena: &Arena, results: Vec<Expr>, words: &Words) -> Routine {
    let mut work = Work::new(arena, &results, words);
    let mut after = Vec::with_capacity(results.len());
    for result in &results {
        work.serve(*result);
        after.push(work.steps.len());
    }
    let leaves = work.needed.iter().filter_map(|expr| if let Node::Leaf(leaf) = arena.node(*expr) { Some((*expr, *leaf)) } else { None }).collect();
    let cost = cost(arena, &work.needed, &work.steps);
    Routine { steps: work.steps, results, after, names: work.names, leaves, cost }
}

struct Work<'a> {
    arena: &'a Arena,
    /// All nodes under the results, children first, constants' insides left out.
    needed: Vec<Expr>,
    /// Nodes that depend on constants only; they are evaluated in the compiler.
    constants: BTreeSet<Expr>,
    /// Nodes that get a name.
    named: BTreeSet<Expr>,
    names: BTreeMap<Expr, String>,
    taken: BTreeSet<String>,
    steps: Vec<Step>,
    done: BTreeSet<Expr>,
    counter: usize,
}

impl<'a> Work<'a> {
    fn new(arena: &'a Arena, results: &[Expr], words: &Words) -> Work<'a> {
        let all = arena.reachable(results);
        let mut constants = BTreeSet::new();
        for expr in &all {
            let node = arena.node(*expr);
            let is_constant = match node {
                Node::Constant(_) => true,
                Node::Leaf(_) | Node::Call { .. } => false,
                _ => node.children().all(|child| constants.contains(&child)),
            };
            if is_constant {
                constants.insert(*expr);
            }
        }
        let needed: Vec<Expr> = all.into_iter().filter(|expr| !constants.contains(expr)).collect();
        let named = named(arena, &needed, &constants, results);
        let mut work = Work {
            arena,
            needed,
            constants,
            named,
            names: BTreeMap::new(),
            taken: BTreeSet::new(),
            steps: Vec::new(),
            done: BTreeSet::new(),
            counter: 0,
        };
        for expr in work.needed.clone() {
            if let Node::Leaf(leaf) = arena.node(expr) {
                let name = words.leaf(*leaf);
                let name = if matches!(leaf, Leaf::Parameter(_)) { name } else { work.unique(name) };
                work.names.insert(expr, name);
            }
        }
        work
    }

    fn unique(&mut self, mut name: String) -> String {
        while !self.taken.insert(name.clone()) {
            name.push('_');
        }
        name
    }

    fn next(&mut self, stem: &str) -> String {
        self.counter += 1;
        let name = format!("{stem}{}", self.counter);
        self.unique(name)
    }

    /// Adds the steps that one result still lacks.
    fn serve(&mut self, result: Expr) {
        for expr in self.arena.reachable(&[result]) {
            if self.constants.contains(&expr) || !self.done.insert(expr) {
                continue;
            }
            match *self.arena.node(expr) {
                Node::Unary(Unary::Sin | Unary::Cos, angle) => self.sine_cosine(angle),
                Node::Call { function, argument, .. } => self.call(function, argument),
                _ if self.named.contains(&expr) => {
                    let name = self.next("v");
                    self.names.insert(expr, name);
                    self.steps.push(Step::Value(expr));
                }
                _ => {}
            }
        }
    }

    /// One sine and cosine for each angle, whichever of them is asked for first.
    fn sine_cosine(&mut self, angle: Expr) {
        let stem = match self.names.get(&angle) {
            Some(name) => name.replace("self.", ""),
            None => self.next("a"),
        };
        let wanted = self.needed.iter().filter_map(|expr| match *self.arena.node(*expr) {
            Node::Unary(function @ (Unary::Sin | Unary::Cos), of) if of == angle => Some((*expr, function)),
            _ => None,
        });
        let (mut sine, mut cosine) = (None, None);
        for (expr, function) in wanted.collect::<Vec<_>>() {
            self.done.insert(expr);
            let prefix = if function == Unary::Sin { "sin" } else { "cos" };
            let name = self.unique(format!("{prefix}_{stem}"));
            self.names.insert(expr, name.clone());
            *(if function == Unary::Sin { &mut sine } else { &mut cosine }) = Some(name);
        }
        self.steps.push(Step::SineCosine { angle, sine, cosine });
    }

    /// One call for each argument, giving all derivatives that are asked for.
    fn call(&mut self, function: u32, argument: Expr) {
        let mut names = [None, None, None];
        let wanted = self.needed.iter().filter_map(|expr| match *self.arena.node(*expr) {
            Node::Call { function: other, order, argument: of } if other == function && of == argument => Some((*expr, usize::from(order))),
            _ => None,
        });
        for (expr, order) in wanted.collect::<Vec<_>>() {
            self.done.insert(expr);
            let name = self.next(["f", "f_rate", "f_second"][order.min(2)]);
            self.names.insert(expr, name.clone());
            names[order.min(2)] = Some(name);
        }
        self.steps.push(Step::Call { function, argument, names });
    }
}

/// Nodes used more than once, and cuts in deep expressions.
fn named(arena: &Arena, needed: &[Expr], constants: &BTreeSet<Expr>, results: &[Expr]) -> BTreeSet<Expr> {
    let mut uses: BTreeMap<Expr, usize> = BTreeMap::new();
    for expr in needed {
        for child in arena.node(*expr).children() {
            *uses.entry(child).or_default() += 1;
        }
    }
    for result in results {
        *uses.entry(*result).or_default() += 1;
    }
    let mut named = BTreeSet::new();
    let mut depth: BTreeMap<Expr, usize> = BTreeMap::new();
    for expr in needed {
        let node = arena.node(*expr);
        let has_name = matches!(node, Node::Leaf(_) | Node::Call { .. } | Node::Unary(Unary::Sin | Unary::Cos, _));
        let below = node.children().filter(|child| !constants.contains(child)).map(|child| depth.get(&child).copied().unwrap_or(0)).max().unwrap_or(0);
        let is_cut = below >= DEPTH;
        if !has_name && (uses.get(expr).copied().unwrap_or(0) > 1 || is_cut) {
            named.insert(*expr);
        }
        depth.insert(*expr, if has_name || named.contains(expr) { 0 } else { below + 1 });
    }
    named
}

fn cost(arena: &Arena, needed: &[Expr], steps: &[Step]) -> Cost {
    let mut cost = Cost::default();
    for expr in needed {
        match arena.node(*expr) {
            Node::Binary(Binary::Add | Binary::Sub | Binary::Mul, ..) | Node::Unary(Unary::Neg | Unary::Abs | Unary::Sign, _) => cost.flops += 1,
            Node::Binary(Binary::Div, ..) | Node::Unary(Unary::Sqrt, _) => cost.divisions += 1,
            Node::Select { .. } => cost.flops += 2,
            Node::Constant(_) | Node::Leaf(_) | Node::Unary(Unary::Sin | Unary::Cos, _) | Node::Call { .. } => {}
            Node::Unary(..) | Node::Binary(Binary::Atan2, ..) => cost.calls += 1,
        }
    }
    cost.sines = steps.iter().filter(|step| matches!(step, Step::SineCosine { .. })).count();
    cost.calls += steps.iter().filter(|step| matches!(step, Step::Call { .. })).count();
    cost
}
