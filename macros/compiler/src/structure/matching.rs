//! Maximum matching of equations and unknowns.
//!
//! Depth-first augmenting paths with a cheap look-ahead, without recursion; linear in practice.
//! Reference: Duff (1981), On algorithms for obtaining a maximum transversal.

use super::pattern::Pattern;

/// Pairs of an equation and the unknown it determines.
#[derive(Clone, Debug)]
pub(crate) struct Matching {
    /// The unknown of each equation.
    pub(crate) of_equation: Vec<Option<usize>>,
    /// The equation of each unknown.
    pub(crate) of_unknown: Vec<Option<usize>>,
}

impl Matching {
    /// Unknowns that got no equation.
    pub(crate) fn free_unknowns(&self) -> Vec<usize> {
        (0..self.of_unknown.len()).filter(|unknown| self.of_unknown[*unknown].is_none()).collect()
    }

    /// Equations that got no unknown.
    pub(crate) fn free_equations(&self) -> Vec<usize> {
        (0..self.of_equation.len()).filter(|equation| self.of_equation[*equation].is_none()).collect()
    }

    fn pair(&mut self, equation: usize, unknown: usize) {
        self.of_equation[equation] = Some(unknown);
        self.of_unknown[unknown] = Some(equation);
    }
}

/// As many pairs as there can be.
pub(crate) fn maximum(pattern: &Pattern) -> Matching {
    maximum_in(pattern, 0..pattern.rows.len())
}

/// The same, with equations in this order: of those that contend for an unknown the last ones get none.
pub(crate) fn maximum_in(pattern: &Pattern, order: impl Iterator<Item = usize>) -> Matching {
    let mut matching = Matching { of_equation: vec![None; pattern.rows.len()], of_unknown: vec![None; pattern.unknowns] };
    // For each equation, how many of its entries have been looked at for a free unknown. An unknown
    // never becomes free again, so this only grows: the look-ahead costs each entry once.
    let mut looked = vec![0; pattern.rows.len()];
    let mut visited = vec![usize::MAX; pattern.rows.len()];
    for root in order {
        augment(pattern, &mut matching, root, &mut looked, &mut visited);
    }
    matching
}

/// Looks for a path of alternating pairs from an equation to a free unknown, and turns it round.
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

/// The last equation of the path takes the free unknown, every other one that of the next.
fn turn(matching: &mut Matching, path: &[(usize, usize)], free: usize) {
    let mut unknown = free;
    for (equation, _) in path.iter().rev() {
        let previous = matching.of_equation[*equation];
        matching.pair(*equation, unknown);
        let Some(previous) = previous else { return };
        unknown = previous;
    }
}
