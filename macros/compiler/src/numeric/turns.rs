//! Angles that can be changed by whole turns without changing any residual.
//!
//! In: a [`System`]. Out: [`Turns`]. An equation that contains angles only under sines and cosines is periodic in them. An equation that
//! contains an angle itself, as in a gear pair or a drive, counts turns and links its angles: they can only be turned together, if at all.

use super::Numeric;
use crate::expr::{Evaluator, Expr, Values, magnitudes};
use core::f64::consts::TAU;

/// A difference of residuals below this fraction of their terms is rounding.
const ROUNDING: f64 = 1e-9;

/// Two unrelated sets of numbers of turns; a change that cancels in one shows in the other.
const SETS: [[u32; 7]; 2] = [[1, 3, 8, 17, 29, 41, 59], [5, 2, 13, 7, 31, 19, 47]];

/// Groups of linked angles.
#[derive(Default)]
pub(crate) struct Turns {
    /// Group of each angle, by unknown.
    group: Vec<Option<usize>>,
    groups: Vec<LinkedAngles>,
    /// For each equation, true if it links its angles.
    links: Vec<bool>,
}

/// Angles linked to each other.
#[derive(Clone, Default)]
pub(crate) struct LinkedAngles {
    pub(crate) members: Vec<usize>,
    /// Equations that change when the group is turned.
    pub(crate) counted_by: Vec<usize>,
}

impl Turns {
    pub(crate) fn new(numeric: &Numeric) -> Turns {
        let system = numeric.system;
        let angles =
            |equation: usize| system.equations[equation].jacobian.iter().map(|(unknown, _)| *unknown).filter(|u| numeric.is_angle(*u));
        let mut leader: Vec<usize> = (0..system.coordinates.len()).collect();
        let links = counting(numeric, |set, unknown| SETS[set][unknown % 7] + (unknown as u32 / 7) % 100);
        for equation in (0..system.equations.len()).filter(|equation| links[*equation]) {
            let linked: Vec<usize> = angles(equation).collect();
            for pair in linked.windows(2) {
                let ends = [find(&mut leader, pair[0]), find(&mut leader, pair[1])];
                leader[ends[0].max(ends[1])] = ends[0].min(ends[1]);
            }
        }
        let mut turns = Turns { group: vec![None; system.coordinates.len()], groups: Vec::new(), links };
        for unknown in (0..system.coordinates.len()).filter(|unknown| numeric.is_angle(*unknown)) {
            let first = find(&mut leader, unknown);
            let group = turns.group[first].unwrap_or(turns.groups.len());
            if group == turns.groups.len() {
                turns.groups.push(LinkedAngles::default());
            }
            turns.groups[group].members.push(unknown);
            turns.group[unknown] = Some(group);
        }
        let group = turns.group.clone();
        let counts = counting(numeric, |set, unknown| group[unknown].map_or(0, |group| SETS[set][group % 7]));
        for equation in (0..system.equations.len()).filter(|equation| counts[*equation]) {
            if let Some(group) = angles(equation).next().and_then(|unknown| turns.group[unknown]) {
                turns.groups[group].counted_by.push(equation);
            }
        }
        turns
    }

    /// The group of an angle, which includes the angle itself.
    pub(crate) fn linked(&self, unknown: usize) -> Option<&LinkedAngles> {
        self.groups.get((*self.group.get(unknown)?)?)
    }

    /// True if an equation holds an angle itself, so that its angles can only be turned together.
    pub(crate) fn are_linked_by(&self, equation: usize) -> bool {
        self.links.get(equation).copied().unwrap_or(false)
    }

    /// True if an angle can be changed by whole turns, together with its group.
    pub(crate) fn is_free(&self, unknown: usize) -> bool {
        self.linked(unknown).is_some_and(|group| group.counted_by.is_empty())
    }

    /// Groups that can be turned.
    pub(crate) fn free(&self) -> impl Iterator<Item = &LinkedAngles> {
        self.groups.iter().filter(|group| group.counted_by.is_empty())
    }
}

/// True for equations whose residual changes when each angle is changed by its own number of turns, in either set.
fn counting(numeric: &Numeric, turns: impl Fn(usize, usize) -> u32) -> Vec<bool> {
    let system = numeric.system;
    let roots: Vec<(usize, Expr)> =
        system.equations.iter().enumerate().filter_map(|(number, equation)| Some((number, equation.phi()?))).collect();
    let phi: Vec<Expr> = roots.iter().map(|(_, phi)| *phi).collect();
    let begin = numeric.anywhere(0);
    let known = Values { coordinates: &begin, ..numeric.known };
    let mut evaluator = Evaluator::new(&system.arena, &phi);
    let mut before = vec![f64::NAN; phi.len()];
    evaluator.run(&known, &mut before);
    let sizes = magnitudes(&system.arena, &phi, &known);
    let mut counts = vec![false; system.equations.len()];
    let mut after = before.clone();
    for set in 0..SETS.len() {
        let mut turned = begin.clone();
        for unknown in (0..turned.len()).filter(|unknown| numeric.is_angle(*unknown)) {
            turned[unknown] += TAU * f64::from(turns(set, unknown));
        }
        evaluator.run(&Values { coordinates: &turned, ..numeric.known }, &mut after);
        for (index, (equation, _)) in roots.iter().enumerate() {
            // A residual that is not finite counts as changed.
            let is_same = (after[index] - before[index]).abs() <= ROUNDING * sizes[index];
            counts[*equation] |= !is_same;
        }
    }
    counts
}

fn find(leader: &mut [usize], mut of: usize) -> usize {
    while leader[of] != of {
        leader[of] = leader[leader[of]];
        of = leader[of];
    }
    of
}

/// The angle modulo 2π, in (−π, π].
pub(crate) fn within_a_turn(angle: f64) -> f64 {
    angle + TAU * turns_to_zero(-angle / TAU)
}

/// The nearest whole number of turns; the greater one of two equally near.
pub(crate) fn turns_to_zero(turns: f64) -> f64 {
    (turns + 0.5 + 1e-9).floor()
}
