//! Maximum matching of equations and unknowns.
//!
//! Depth-first augmenting paths with a cheap look-ahead, without recursion; linear in practice.
//! Reference: Duff (1981), On algorithms for obtaining a maximum transversal.

use super::pattern::Pattern;

/// Matched pairs of an equation and an unknown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Matching {
    /// The unknown matched to each equation.
    pub(crate) of_equation: Vec<Option<usize>>,
    /// The equation matched to each unknown.
    pub(crate) of_unknown: Vec<Option<usize>>,
}

impl Matching {
    /// Unmatched unknowns.
    pub(crate) fn free_unknowns(&self) -> Vec<usize> {
        (0..self.of_unknown.len()).filter(|unknown| self.of_unknown[*unknown].is_none()).collect()
    }

    /// Unmatched equations.
    pub(crate) fn free_equations(&self) -> Vec<usize> {
        (0..self.of_equation.len()).filter(|equation| self.of_equation[*equation].is_none()).collect()
    }

    fn pair(&mut self, equation: usize, unknown: usize) {
        self.of_equation[equation] = Some(unknown);
        self.of_unknown[unknown] = Some(equation);
    }
}

/// A maximum matching.
pub(crate) fn maximum(pattern: &Pattern) -> Matching {
    maximum_in(pattern, 0..pattern.rows.len())
}

/// A maximum matching with the equations in this order: of those that compete for an unknown the last ones stay unmatched.
pub(crate) fn maximum_in(pattern: &Pattern, order: impl Iterator<Item = usize>) -> Matching {
    let mut matching = Matching { of_equation: vec![None; pattern.rows.len()], of_unknown: vec![None; pattern.unknowns] };
    // For each equation, the number of entries searched for a free unknown. A matched unknown never becomes free again, so that this
    // number only grows: the look-ahead costs each entry once.
    let mut looked = vec![0; pattern.rows.len()];
    let mut visited = vec![usize::MAX; pattern.rows.len()];
    for root in order {
        augment(pattern, &mut matching, root, &mut looked, &mut visited);
    }
    matching
}

/// Searches for an augmenting path from an equation to a free unknown, and flips it.
fn augment(pattern: &Pattern, matching: &mut Matching, root: usize, looked: &mut [usize], visited: &mut [usize]) {
    // Each level of the path: an equation and the entry it is left by.
    let mut path: Vec<(usize, usize)> = vec![(root, 0)];
    visited[root] = root;
    while let Some((equation, next)) = path.last().copied() {
        let row = &pattern.rows[equation];
        while let Some(entry) = row.get(looked[equation]) {
            looked[equation] += 1;
            if matching.of_unknown[entry.unknown].is_none() {
                return turn(matching, &path, entry.unknown);
            }
        }
        let Some(entry) = row.get(next) else {
            path.pop();
            continue;
        };
        if let Some(level) = path.last_mut() {
            level.1 += 1;
        }
        if let Some(owner) = matching.of_unknown[entry.unknown]
            && visited[owner] != root
        {
            visited[owner] = root;
            path.push((owner, 0));
        }
    }
}

/// Flips an augmenting path: its last equation takes the free unknown, every other one the unknown of its successor.
fn turn(matching: &mut Matching, path: &[(usize, usize)], free: usize) {
    let mut unknown = free;
    for (equation, _) in path.iter().rev() {
        let previous = matching.of_equation[*equation];
        matching.pair(*equation, unknown);
        let Some(previous) = previous else { return };
        unknown = previous;
    }
}
