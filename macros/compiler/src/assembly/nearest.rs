//! The assembly that is nearest to the declared start, of all there are.
//!
//! In: a [`Structure`] of a mechanism that is not too large. Out: the nearest assembly, and another one where it is as near.
//!
//! Blocks are gone through in their order, each with all of its `assemblies` for each choice before it. What is summed up of the
//! distance is only ever more: a choice that is farther than a whole assembly that is known is not gone on with (branch and bound, Land
//! and Doig 1960). The nearest is taken first, so that mostly nothing else is gone through to its end.

use super::assemblies::Alone;
use super::order::{Assembled, Upstream};
use super::reduced::Reduced;
use crate::expr::{Expr, Values, evaluate};
use crate::numeric::Numeric;
use crate::numeric::search::{Distance, compare};
use crate::structure::Structure;
use core::f64::consts::TAU;
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// An equation holds that is off by less than a step of this, in rad and sizes.
const HOLDS: f64 = 1e-6;

/// So many choices are looked at.
const MOST: usize = 20_000;

/// So many blocks are searched.
const MOST_SEARCHED: usize = 400;

impl Numeric<'_> {
    /// The nearest assembly of all; none if none closes.
    pub(super) fn nearest_of_all(&self, structure: &Structure, reach: Reach) -> Option<Assembled> {
        let upstream = Upstream::new(self, structure);
        let mut tree = SearchTree {
            numeric: self,
            structure,
            above: (0..structure.blocks.len()).map(|block| upstream.all(block).into_iter().collect()).collect(),
            is_sure: upstream.surety(self, structure),
            blocks: structure.blocks.iter().map(|_| Looked::default()).collect(),
            choices: vec![0; structure.blocks.len()],
            looks: 0,
            searched: 0,
            reach,
            found: Vec::new(),
        };
        tree.descend(0, &mut self.unassembled(), [0.0; 3]);
        let mut found = tree.found.into_iter().map(|(q, _)| q);
        let start = found.next()?;
        Some(Assembled {
            start,
            is_closed: true,
            open: None,
            found: Vec::new(),
            others: found.collect(),
            is_nearest: true,
            is_settled: true,
        })
    }

    /// The equations that are checked instead of solved hold.
    pub(super) fn is_as_checked(&self, structure: &Structure, q: &[f64]) -> bool {
        let values = Values { coordinates: q, ..self.known };
        structure.checked.iter().all(|equation| {
            let equation = &self.system.equations[*equation];
            let roots: Vec<Expr> = equation.phi().into_iter().chain(equation.jacobian.iter().map(|(_, entry)| *entry)).collect();
            let values = evaluate(&self.system.arena, &roots, &values);
            let Some((phi, slopes)) = values.split_first() else { return true };
            let steps = slopes.iter().zip(&equation.jacobian).map(|(slope, (unknown, _))| (slope * self.scale(*unknown)).abs());
            // What is no number here is not judged.
            phi.is_nan() || phi.abs() <= HOLDS * steps.fold(0.0, f64::max)
        })
    }

    /// Gives all angles the whole turns that bring them nearest to what is declared of them; whether any was missing.
    pub(super) fn turn_to_start(&self, q: &mut [f64]) -> bool {
        let mut has_turned = false;
        for group in self.turns().free() {
            let turns = self.turns_to_start(group.members.iter().map(|unknown| (*unknown, q[*unknown])));
            group.members.iter().for_each(|unknown| q[*unknown] += TAU * turns);
            has_turned |= turns != 0.0;
        }
        has_turned
    }
}

/// Which assemblies are gone through.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Reach {
    /// Those that may be the nearest, or as near.
    Nearest,
    /// All.
    All,
}

struct SearchTree<'a> {
    numeric: &'a Numeric<'a>,
    structure: &'a Structure,
    /// The blocks that each one depends on.
    above: Vec<Vec<usize>>,
    is_sure: Vec<bool>,
    blocks: Vec<Looked<'a>>,
    /// Which of its assemblies each block has.
    choices: Vec<usize>,
    looks: usize,
    searched: usize,
    reach: Reach,
    /// The nearest first.
    found: Vec<(Vec<f64>, Distance)>,
}

/// A block, and what is known of it after choices in the blocks that it depends on.
#[derive(Default)]
struct Looked<'a> {
    reduced: Option<Reduced<'a>>,
    alone: BTreeMap<Vec<usize>, Option<Alone>>,
    all: BTreeMap<Vec<usize>, Vec<Vec<f64>>>,
}

impl SearchTree<'_> {
    /// Goes through the blocks from one on, with those before it as they are.
    fn descend(&mut self, index: usize, q: &mut [f64], distance: Distance) {
        self.looks += 1;
        if index == self.structure.blocks.len() {
            return self.arrive(q.to_vec(), distance);
        }
        let key: Vec<usize> = self.above[index].iter().map(|block| self.choices[*block]).collect();
        let alone = if self.reach == Reach::Nearest { self.alone(index, &key, q) } else { None };
        if let Some(alone) = &alone {
            self.choose(index, 0, q, &alone.values, distance);
            let [declared, ..] = distance;
            if self.is_too_far(&[declared + alone.others, 0.0, 0.0]) {
                return;
            }
        }
        let (unknowns, _) = self.structure.blocks[index].parts();
        for (choice, values) in self.all(index, key, q).into_iter().enumerate() {
            if alone.as_ref().is_none_or(|alone| !self.numeric.is_one(&unknowns, &alone.values, &values)) {
                self.choose(index, choice + 1, q, &values, distance);
            }
        }
    }

    /// Goes on with an assembly of a block, unless that leads too far.
    fn choose(&mut self, index: usize, choice: usize, q: &mut [f64], values: &[f64], mut distance: Distance) {
        let (unknowns, _) = self.structure.blocks[index].parts();
        for (unknown, value) in unknowns.iter().zip(values) {
            q[*unknown] = *value;
            self.numeric.add_distance(&mut distance, *unknown, *value);
        }
        let is_enough = self.looks > MOST && !self.found.is_empty();
        if !is_enough && !self.is_too_far(&distance) {
            self.choices[index] = choice;
            self.descend(index + 1, q, distance);
        }
    }

    /// An assembly is known that is nearer than this.
    fn is_too_far(&self, distance: &Distance) -> bool {
        let is_nearer = |(_, known): &(Vec<f64>, Distance)| compare(known, distance) == Ordering::Less;
        self.reach == Reach::Nearest && self.found.first().is_some_and(is_nearer)
    }

    /// All blocks have an assembly.
    fn arrive(&mut self, q: Vec<f64>, distance: Distance) {
        let is_known = |(known, far): &(Vec<f64>, Distance)| {
            compare(far, &distance) == Ordering::Equal && self.numeric.differing(known, &q).is_empty()
        };
        if self.found.iter().any(is_known) || !self.numeric.is_as_checked(self.structure, &q) {
            return;
        }
        let place = self.found.iter().position(|(_, known)| compare(&distance, known) == Ordering::Less);
        self.found.insert(place.unwrap_or(self.found.len()), (q, distance));
    }

    /// The assembly of a block near which there is no other, if it can be told without looking for others.
    fn alone(&mut self, index: usize, key: &[usize], q: &[f64]) -> Option<Alone> {
        let (numeric, block, looked) = (self.numeric, &self.structure.blocks[index], &mut self.blocks[index]);
        if !self.is_sure[index] {
            return None;
        }
        if let Some(known) = looked.alone.get(key) {
            return known.clone();
        }
        let reduced = looked.reduced.get_or_insert_with(|| Reduced::new(numeric, block));
        let alone = numeric.alone(reduced, block, q);
        looked.alone.insert(key.to_vec(), alone.clone());
        alone
    }

    /// All assemblies of a block.
    fn all(&mut self, index: usize, key: Vec<usize>, q: &[f64]) -> Vec<Vec<f64>> {
        let (numeric, block, looked) = (self.numeric, &self.structure.blocks[index], &mut self.blocks[index]);
        if let Some(known) = looked.all.get(&key) {
            return known.clone();
        }
        if self.searched > MOST_SEARCHED && !self.found.is_empty() {
            return Vec::new();
        }
        self.searched += usize::from(!block.iterated.is_empty());
        let all = if self.is_sure[index] {
            let reduced = looked.reduced.get_or_insert_with(|| Reduced::new(numeric, block));
            numeric.assemblies(reduced, block, q)
        } else {
            // Of what is not known in the compiler an assembly is only a guess.
            let (values, closes) = numeric.nearest(block, q);
            if closes { vec![values] } else { Vec::new() }
        };
        looked.all.insert(key, all.clone());
        all
    }
}
