//! Branches of `if` that are computed only where they hold.

use super::routine::Cost;
use super::schedule::cost;
use crate::expr::{Arena, Expr, Node, Unary};
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// A choice computes only the branch that holds if both branches of all its values have at least this many operations together. A division or
/// a root counts half of it, a sine or a call all of it.
const WORTH: usize = 20;

/// Values that one comparison chooses, and nodes that only its branches need.
#[derive(Clone, Debug)]
pub(super) struct Branching {
    /// The values, `if lhs < rhs { then } else { otherwise }`.
    pub(super) members: Vec<Expr>,
    /// Nodes that only the first and that only the second branch needs, children first.
    pub(super) inside: [Vec<Expr>; 2],
}

/// All choices of some nodes, apart from those inside their branches.
#[derive(Debug, Default)]
pub(super) struct Choices {
    pub(super) all: Vec<Branching>,
    /// By value, the number of its choice.
    of: BTreeMap<Expr, usize>,
    /// Nodes inside branches.
    inside: BTreeSet<Expr>,
}

/// Where a node is needed.
#[derive(Clone, Copy, PartialEq, Eq)]
enum NeededIn {
    Outside,
    /// In the first or the second branch of a choice only.
    Branch(usize, usize),
}

impl Choices {
    /// Choices among `needed` nodes, children first. `roots` are needed outside; `since` says from which moment on a leaf is known.
    pub(super) fn new(arena: &Arena, needed: &[Expr], roots: &BTreeSet<Expr>, since: &dyn Fn(Expr) -> usize) -> Choices {
        let mut of = groups(arena, needed, since);
        while !of.is_empty() {
            let places = places(arena, needed, roots, &of);
            let mut all: Vec<Branching> = Vec::new();
            all.resize(of.values().max().map_or(0, |last| last + 1), Branching { members: Vec::new(), inside: [Vec::new(), Vec::new()] });
            for expr in needed {
                match (places.get(expr), of.get(expr)) {
                    (Some(NeededIn::Branch(group, branch)), _) => all[*group].inside[*branch].push(*expr),
                    (_, Some(group)) => all[*group].members.push(*expr),
                    _ => {}
                }
            }
            let before = of.len();
            of.retain(|_, group| all[*group].members.is_empty() || all[*group].is_worth_it(arena));
            if of.len() == before {
                let inside = all.iter().flat_map(|choice| &choice.inside).flatten().copied().collect();
                of.retain(|expr, group| all[*group].members.binary_search(expr).is_ok());
                return Choices { all, of, inside };
            }
        }
        Choices::default()
    }

    /// The choice of a value.
    pub(super) fn of(&self, expr: Expr) -> Option<&Branching> {
        self.of.get(&expr).map(|group| &self.all[*group])
    }

    /// True for a node that only a branch needs.
    pub(super) fn hides(&self, expr: Expr) -> bool {
        self.inside.contains(&expr)
    }
}

impl Branching {
    /// The values of one branch.
    pub(super) fn results(&self, arena: &Arena, branch: usize) -> Vec<Expr> {
        let of_branch = |member: &Expr| match *arena.node(*member) {
            Node::Select { then, otherwise, .. } => [then, otherwise][branch],
            _ => *member,
        };
        self.members.iter().map(of_branch).collect()
    }

    fn is_worth_it(&self, arena: &Arena) -> bool {
        let [Cost { flops, divisions, sines, calls }, other] = self.inside.each_ref().map(|nodes| cost(arena, nodes));
        let slow = divisions + other.divisions + 2 * (sines + other.sines + calls + other.calls);
        flops + other.flops + WORTH / 2 * slow >= WORTH
    }
}

/// Groups by number of those values that the same comparison chooses, once all their leaves are known. No group depends on itself.
fn groups(arena: &Arena, needed: &[Expr], since: &dyn Fn(Expr) -> usize) -> BTreeMap<Expr, usize> {
    let mut of: BTreeMap<Expr, usize> = BTreeMap::new();
    let mut latest: BTreeMap<(Expr, Expr, usize), usize> = BTreeMap::new();
    let mut below: Vec<BTreeSet<usize>> = Vec::new();
    // By node: the groups on which it depends without another one between.
    let mut nearest: BTreeMap<Expr, Rc<BTreeSet<usize>>> = BTreeMap::new();
    if !needed.iter().any(|expr| matches!(arena.node(*expr), Node::Select { .. })) {
        return of;
    }
    let mut known: BTreeMap<Expr, usize> = BTreeMap::new();
    for expr in needed {
        let node = arena.node(*expr);
        let moment = node.children().filter_map(|child| known.get(&child).copied()).max().unwrap_or(0).max(since(*expr));
        known.insert(*expr, moment);
        let direct = together_nearest(node.children().filter_map(|child| nearest.get(&child).cloned()));
        let Node::Select { lhs, rhs, .. } = *node else {
            nearest.extend(direct.map(|direct| (*expr, direct)));
            continue;
        };
        let direct = direct.unwrap_or_default();
        let group = match latest.get(&(lhs, rhs, moment)) {
            Some(group) if !all_below(&below, &direct).contains(group) => *group,
            _ => below.len(),
        };
        below.resize_with(below.len().max(group + 1), BTreeSet::new);
        below[group].extend(direct.iter());
        nearest.insert(*expr, Rc::new(BTreeSet::from([group])));
        latest.insert((lhs, rhs, moment), group);
        of.insert(*expr, group);
    }
    of
}

/// All groups of some sets, in one of these where that has them all.
fn together_nearest(mut sets: impl Iterator<Item = Rc<BTreeSet<usize>>>) -> Option<Rc<BTreeSet<usize>>> {
    let mut all = sets.next()?;
    for set in sets {
        if !set.is_subset(&all) {
            Rc::make_mut(&mut all).extend(set.iter());
        }
    }
    Some(all)
}

/// Some groups and all on which they depend.
fn all_below(below: &[BTreeSet<usize>], groups: &BTreeSet<usize>) -> BTreeSet<usize> {
    let (mut found, mut open) = (groups.clone(), groups.iter().copied().collect::<Vec<usize>>());
    while let Some(group) = open.pop() {
        open.extend(below[group].iter().filter(|next| found.insert(**next)));
    }
    found
}

/// For each node, where it is needed.
fn places(arena: &Arena, needed: &[Expr], roots: &BTreeSet<Expr>, groups: &BTreeMap<Expr, usize>) -> BTreeMap<Expr, NeededIn> {
    let mut places: BTreeMap<Expr, NeededIn> = roots.iter().map(|root| (*root, NeededIn::Outside)).collect();
    for expr in needed.iter().rev() {
        let own = *places.entry(*expr).or_insert(NeededIn::Outside);
        let node = arena.node(*expr);
        let mut need = |child: Expr, at: NeededIn| {
            let place = places.entry(child).or_insert(at);
            *place = if *place == at { at } else { NeededIn::Outside };
        };
        match (*node, groups.get(expr), own) {
            (Node::Select { lhs, rhs, then, otherwise }, Some(group), NeededIn::Outside) => {
                [lhs, rhs].into_iter().for_each(|child| need(child, NeededIn::Outside));
                [then, otherwise].into_iter().enumerate().for_each(|(branch, child)| need(child, NeededIn::Branch(*group, branch)));
            }
            _ => node.children().for_each(|child| need(child, own)),
        }
    }
    for together in together(arena, needed) {
        if together.iter().any(|expr| places[expr] != places[&together[0]]) {
            places.extend(together.into_iter().map(|expr| (expr, NeededIn::Outside)));
        }
    }
    places.retain(|expr, _| !matches!(arena.node(*expr), Node::Leaf(_) | Node::Constant(_)));
    places
}

/// Sines and cosines of the same angle, and derivatives of the same function, which one step computes.
fn together(arena: &Arena, needed: &[Expr]) -> Vec<Vec<Expr>> {
    let mut turns: BTreeMap<Expr, Vec<Expr>> = BTreeMap::new();
    let mut calls: BTreeMap<(u32, Expr), Vec<Expr>> = BTreeMap::new();
    for expr in needed {
        match *arena.node(*expr) {
            Node::Unary(Unary::Sin | Unary::Cos, angle) => turns.entry(angle).or_default().push(*expr),
            Node::Call { function, argument, .. } => calls.entry((function, argument)).or_default().push(*expr),
            _ => {}
        }
    }
    turns.into_values().chain(calls.into_values()).collect()
}
