//! Strongly connected components: unknowns that can only be found together, in the order of solution (block triangular form).
//!
//! The nodes of the graph are matched pairs; an edge leads to every pair whose unknown the equation of the first pair needs.
//! Reference: Tarjan (1972), Depth-first search and linear graph algorithms; here without recursion.

use super::matching::Matching;
use super::pattern::Pattern;

/// Groups of matched equations; each needs only its own unknowns and those of earlier groups.
pub(crate) fn in_order(pattern: &Pattern, matching: &Matching) -> Vec<Vec<usize>> {
    let mut work = Tarjan {
        pattern,
        matching,
        order: vec![None; pattern.rows.len()],
        low: vec![0; pattern.rows.len()],
        is_open: vec![false; pattern.rows.len()],
        open: Vec::new(),
        counter: 0,
        groups: Vec::new(),
    };
    for equation in 0..pattern.rows.len() {
        if matching.of_equation[equation].is_some() && work.order[equation].is_none() {
            work.visit(equation);
        }
    }
    work.groups
}

struct Tarjan<'a> {
    pattern: &'a Pattern,
    matching: &'a Matching,
    order: Vec<Option<usize>>,
    low: Vec<usize>,
    is_open: Vec<bool>,
    open: Vec<usize>,
    counter: usize,
    groups: Vec<Vec<usize>>,
}

impl Tarjan<'_> {
    fn visit(&mut self, root: usize) {
        let mut path = vec![(root, 0)];
        self.enter(root);
        while let Some((equation, next)) = path.last().copied() {
            let Some(entry) = self.pattern.needed(equation).nth(next) else {
                path.pop();
                self.leave(equation);
                if let Some((above, _)) = path.last() {
                    self.low[*above] = self.low[*above].min(self.low[equation]);
                }
                continue;
            };
            if let Some(level) = path.last_mut() {
                level.1 += 1;
            }
            let Some(owner) = self.matching.of_unknown[entry.unknown] else { continue };
            match self.order[owner] {
                None => {
                    self.enter(owner);
                    path.push((owner, 0));
                }
                Some(number) if self.is_open[owner] => self.low[equation] = self.low[equation].min(number),
                Some(_) => {}
            }
        }
    }

    fn enter(&mut self, equation: usize) {
        self.order[equation] = Some(self.counter);
        self.low[equation] = self.counter;
        self.counter += 1;
        self.is_open[equation] = true;
        self.open.push(equation);
    }

    fn leave(&mut self, equation: usize) {
        if Some(self.low[equation]) != self.order[equation] {
            return;
        }
        let mut group = Vec::new();
        while let Some(member) = self.open.pop() {
            self.is_open[member] = false;
            group.push(member);
            if member == equation {
                break;
            }
        }
        group.sort_unstable();
        self.groups.push(group);
    }
}
