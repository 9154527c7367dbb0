//! Schedules one routine: names nodes and orders their computation.

use super::choices::Choices;
use super::routine::{Branch, Cost, Routine, Step};
use super::words::Words;
use crate::expr::{Arena, Binary, Expr, Leaf, Node, Unary};
use std::collections::{BTreeMap, BTreeSet};
use std::mem::take;
use std::rc::Rc;

/// Deeper expressions are cut into named parts, so that lines stay short enough for a reader and for rustc's parser.
const DEPTH: usize = 12;

/// Schedules the computation of `results`; each is written once, right after its steps.
pub(super) fn routine(arena: &Arena, results: Vec<Expr>, words: &Words) -> Routine {
    let mut work = Scheduler::new(arena, &results, &BTreeSet::new(), words, &|_| 0);
    let mut after = Vec::with_capacity(results.len());
    for result in &results {
        work.serve(*result);
        after.push(work.steps.len());
    }
    let leaves = leaves(arena, &work.needed);
    let cost = cost(arena, &work.needed);
    Routine { steps: work.steps, results, after, names: work.names, leaves, cost }
}

/// Leaves among some nodes.
pub(super) fn leaves(arena: &Arena, nodes: &[Expr]) -> Vec<(Expr, Leaf)> {
    nodes.iter().filter_map(|expr| if let Node::Leaf(leaf) = arena.node(*expr) { Some((*expr, *leaf)) } else { None }).collect()
}

/// State of scheduling: nodes named and computed so far.
pub(super) struct Scheduler<'a> {
    arena: &'a Arena,
    /// Nodes under the results, children first, without constant subexpressions.
    pub(super) needed: Vec<Expr>,
    /// Nodes that get a name.
    named: BTreeSet<Expr>,
    choices: Rc<Choices>,
    pub(super) names: BTreeMap<Expr, String>,
    taken: BTreeSet<String>,
    pub(super) steps: Vec<Step>,
    done: BTreeSet<Expr>,
    counter: usize,
}

impl<'a> Scheduler<'a> {
    /// Initial state; `forced` nodes get a name even if used only once. `since` says from which moment on a leaf is known: steps that need it are
    /// added later than those that do not.
    pub(super) fn new(
        arena: &'a Arena,
        results: &[Expr],
        forced: &BTreeSet<Expr>,
        words: &Words,
        since: &dyn Fn(Expr) -> usize,
    ) -> Scheduler<'a> {
        let mut needed = arena.reachable_to_values(results);
        needed.retain(|expr| arena.value(*expr).is_none());
        let mut named = named(arena, &needed, results);
        named.extend(forced.iter().filter(|expr| !has_own_name(arena.node(**expr))));
        let roots = results.iter().chain(forced).copied().collect();
        let choices = Rc::new(Choices::new(arena, &needed, &roots, since));
        let mut work = Scheduler {
            arena,
            needed,
            named,
            choices,
            names: BTreeMap::new(),
            taken: words.taken(),
            steps: Vec::new(),
            done: BTreeSet::new(),
            counter: 0,
        };
        work.names = leaves(arena, &work.needed).into_iter().map(|(expr, leaf)| (expr, words.leaf(leaf))).collect();
        work
    }

    /// Scheduler for a loop over some unknowns: computes only nodes that depend on them; nodes computed outside keep their names.
    pub(super) fn inside(&self, results: &[Expr], moving: &BTreeSet<Expr>) -> Scheduler<'a> {
        let all = self.arena.reachable_to_values(results);
        let needed: Vec<Expr> = all.into_iter().filter(|expr| moving.contains(expr)).collect();
        let named = named(self.arena, &needed, results);
        let choices = Rc::new(Choices::new(self.arena, &needed, &results.iter().copied().collect(), &|_| 0));
        Scheduler {
            arena: self.arena,
            needed,
            named,
            choices,
            names: self.names.clone(),
            taken: self.taken.clone(),
            steps: Vec::new(),
            done: self.done.clone(),
            counter: self.counter,
        }
    }

    /// Marks a node as computed under this name.
    pub(super) fn define(&mut self, expr: Expr, name: String) {
        self.names.insert(expr, name);
        self.done.insert(expr);
    }

    /// Returns the steps added since the last call.
    pub(super) fn take(&mut self) -> Vec<Step> {
        take(&mut self.steps)
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

    /// Adds the missing steps of a result.
    pub(super) fn serve(&mut self, result: Expr) {
        self.serve_all(&[result]);
    }

    fn serve_all(&mut self, results: &[Expr]) {
        let done = |expr: Expr| self.done.contains(&expr);
        for expr in self.arena.reachable_down_to(results, done, |expr| self.arena.value(expr).is_some()) {
            let is_elsewhere = self.needed.binary_search(&expr).is_err() || self.choices.hides(expr);
            if is_elsewhere || !self.done.insert(expr) {
                continue;
            }
            if self.choices.of(expr).is_some() {
                self.choose(expr);
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

    /// Adds one step for all values of a choice, after the steps on which they depend.
    fn choose(&mut self, expr: Expr) {
        let choices = self.choices.clone();
        let (Some(choice), Node::Select { lhs, rhs, .. }) = (choices.of(expr), *self.arena.node(expr)) else { return };
        self.done.extend(&choice.members);
        let below: Vec<Expr> = choice.members.iter().flat_map(|member| self.arena.node(*member).children()).collect();
        self.serve_all(&below);
        let branches = [0, 1].map(|number| self.branch(&choice.inside[number], choice.results(self.arena, number)));
        for member in &choice.members {
            let name = self.next("v");
            self.names.insert(*member, name);
        }
        self.steps.push(Step::Choice { lhs, rhs, members: choice.members.clone(), branches });
    }

    /// Steps of a branch for the nodes `inside` of it.
    fn branch(&mut self, inside: &[Expr], results: Vec<Expr>) -> Branch {
        let mut work = Scheduler {
            arena: self.arena,
            needed: inside.to_vec(),
            named: named(self.arena, inside, &results),
            choices: Rc::new(Choices::new(self.arena, inside, &results.iter().copied().collect(), &|_| 0)),
            names: take(&mut self.names),
            taken: take(&mut self.taken),
            steps: Vec::new(),
            done: take(&mut self.done),
            counter: self.counter,
        };
        work.serve_all(&results);
        let steps = work.take();
        (self.names, self.taken, self.done, self.counter) = (work.names, work.taken, work.done, work.counter);
        Branch { steps, results }
    }

    /// Adds one step for both sine and cosine of an angle.
    fn sine_cosine(&mut self, angle: Expr) {
        let (mut sine, mut cosine) = (None, None);
        for (expr, function) in self.turned(angle) {
            let name = self.turn_name(angle, function);
            self.define(expr, name.clone());
            *(if function == Unary::Sin { &mut sine } else { &mut cosine }) = Some(name);
        }
        self.steps.push(Step::SineCosine { angle, sine, cosine });
    }

    /// Sine and cosine nodes of an angle, as far as they are used.
    pub(super) fn turned(&self, angle: Expr) -> Vec<(Expr, Unary)> {
        let wanted = self.needed.iter().filter_map(|expr| match *self.arena.node(*expr) {
            Node::Unary(function @ (Unary::Sin | Unary::Cos), of) if of == angle => Some((*expr, function)),
            _ => None,
        });
        wanted.collect()
    }

    /// `sin_crank_angle`, or a numbered name if the angle has none.
    pub(super) fn turn_name(&mut self, angle: Expr, function: Unary) -> String {
        let prefix = if function == Unary::Sin { "sin" } else { "cos" };
        match self.names.get(&angle) {
            Some(name) => {
                // Inputs and parameters of parts are fields of fields.
                let plain = name.trim_start_matches("self.").replace(|letter: char| !letter.is_alphanumeric(), "_");
                self.unique(format!("{prefix}_{plain}"))
            }
            None => self.next(&format!("{prefix}_")),
        }
    }

    /// Adds one step per argument, for all derivatives that are used.
    fn call(&mut self, function: u32, argument: Expr) {
        let mut names = [None, None, None];
        let wanted = self.needed.iter().filter_map(|expr| match *self.arena.node(*expr) {
            Node::Call { function: other, order, argument: of } if other == function && of == argument => Some((*expr, usize::from(order))),
            _ => None,
        });
        for (expr, order) in wanted.collect::<Vec<_>>() {
            let name = self.next(["f", "f_rate", "f_second"][order.min(2)]);
            self.define(expr, name.clone());
            names[order.min(2)] = Some(name);
        }
        self.steps.push(Step::Call { function, argument, names });
    }
}

/// True for nodes named elsewhere: leaves have the user's names; calls, sines and cosines are named in groups.
fn has_own_name(node: &Node) -> bool {
    matches!(node, Node::Leaf(_) | Node::Constant(_) | Node::Call { .. } | Node::Unary(Unary::Sin | Unary::Cos, _))
}

/// Nodes used more than once, and cuts in deep expressions.
fn named(arena: &Arena, needed: &[Expr], results: &[Expr]) -> BTreeSet<Expr> {
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
        let has_name = has_own_name(node);
        let below = node
            .children()
            .filter(|child| arena.value(*child).is_none())
            .map(|child| depth.get(&child).copied().unwrap_or(0))
            .max()
            .unwrap_or(0);
        let is_cut = below >= DEPTH;
        if !has_name && (uses.get(expr).copied().unwrap_or(0) > 1 || is_cut) {
            named.insert(*expr);
        }
        depth.insert(*expr, if has_name || named.contains(expr) { 0 } else { below + 1 });
    }
    named
}

/// Operation counts of some nodes; one sine-cosine pair per angle, one call per argument.
pub(super) fn cost(arena: &Arena, needed: &[Expr]) -> Cost {
    let mut cost = Cost::default();
    let (mut angles, mut arguments) = (BTreeSet::new(), BTreeSet::new());
    for expr in needed {
        match *arena.node(*expr) {
            Node::Binary(Binary::Add | Binary::Sub | Binary::Mul, ..) | Node::Unary(Unary::Neg | Unary::Abs | Unary::Sign, _) => {
                cost.flops += 1
            }
            Node::Binary(Binary::Div, ..) | Node::Unary(Unary::Sqrt, _) => cost.divisions += 1,
            Node::Select { .. } => cost.flops += 2,
            Node::Constant(_) | Node::Leaf(_) | Node::Marked { .. } => {}
            Node::Unary(Unary::Sin | Unary::Cos, angle) => cost.sines += usize::from(angles.insert(angle)),
            Node::Call { function, argument, .. } => cost.calls += usize::from(arguments.insert((function, argument))),
            Node::Unary(..) | Node::Binary(Binary::Atan2, ..) => cost.calls += 1,
        }
    }
    cost
}
