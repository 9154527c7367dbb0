//! The assembly nearest to the declared start, among all there are.
//!
//! In: a [`Structure`] of a mechanism that is not too large. Out: the nearest assembly, and the others that are equally near.
//!
//! Branch and bound (Land and Doig 1960) over the blocks in their order: each block has a branch for each of its `assemblies`, given the
//! choices before it. Partial distances only grow, so that a branch ends when it is farther than the best complete assembly. The nearest
//! branch comes first, so that usually no other is completed.

use super::assemblies::Alone;
use super::order::{Assembled, Upstream};
use super::reduced::Reduced;
use crate::expr::{Expr, Values, evaluate, magnitudes};
use crate::numeric::Numeric;
use crate::numeric::search::{Distance, compare};
use crate::structure::Structure;
use core::f64::consts::TAU;
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// Largest residual of a checked equation, divided by its largest derivative, in rad and characteristic lengths.
const HOLDS: f64 = 1e-6;

/// Largest residual of a checked equation without slopes at an assembly, as a fraction of its terms: that of axes that other joints keep parallel,
/// for example, is nothing but rounding.
const ROUNDING: f64 = 1e4 * f64::EPSILON;

/// Largest number of choices.
const MOST: usize = 20_000;

/// Largest number of blocks searched.
const MOST_SEARCHED: usize = 400;

impl Numeric<'_> {
    /// The nearest assembly; `None` if none closes.
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

    /// True if the equations that are checked instead of solved hold.
    pub(super) fn is_as_checked(&self, structure: &Structure, q: &[f64]) -> bool {
        let known = Values { coordinates: q, ..self.known };
        structure.checked.iter().all(|equation| {
            let equation = &self.system.equations[*equation];
            let roots: Vec<Expr> = equation.phi().into_iter().chain(equation.jacobian.iter().map(|(_, entry)| *entry)).collect();
            let values = evaluate(&self.system.arena, &roots, &known);
            let Some((phi, slopes)) = values.split_first() else { return true };
            let steps = slopes.iter().zip(&equation.jacobian).map(|(slope, (unknown, _))| (slope * self.scale(*unknown)).abs());
            let holds = phi.abs() <= HOLDS * steps.fold(0.0, f64::max);
            // A row that is NaN here is ignored.
            let is_rounding = || magnitudes(&self.system.arena, &roots[..1], &known).iter().all(|size| phi.abs() <= ROUNDING * size);
            holds || phi.is_nan() || is_rounding()
        })
    }

    /// Adds to all angles the whole turns that bring them nearest to their declared values; true if any angle changed.
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

/// Assemblies to be visited.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Reach {
    /// Those that may be the nearest, or equally near.
    Nearest,
    /// All assemblies.
    All,
}

struct SearchTree<'a> {
    numeric: &'a Numeric<'a>,
    structure: &'a Structure,
    /// Blocks on which each block depends.
    above: Vec<Vec<usize>>,
    is_sure: Vec<bool>,
    blocks: Vec<Looked<'a>>,
    /// Index of the chosen assembly of each block.
    choices: Vec<usize>,
    looks: usize,
    searched: usize,
    reach: Reach,
    /// Assemblies found, the nearest first.
    found: Vec<(Vec<f64>, Distance)>,
}

/// A block, and its assemblies for each choice in the blocks upstream of it.
#[derive(Default)]
struct Looked<'a> {
    reduced: Option<Reduced<'a>>,
    alone: BTreeMap<Vec<usize>, Option<Alone>>,
    all: BTreeMap<Vec<usize>, Vec<Vec<f64>>>,
}

impl SearchTree<'_> {
    /// Visits the blocks from `index` on; the earlier ones are fixed.
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

    /// Continues with an assembly of a block unless the distance exceeds the bound.
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

    /// True if a nearer complete assembly is known.
    fn is_too_far(&self, distance: &Distance) -> bool {
        let is_nearer = |(_, known): &(Vec<f64>, Distance)| compare(known, distance) == Ordering::Less;
        self.reach == Reach::Nearest && self.found.first().is_some_and(is_nearer)
    }

    /// Records a complete assembly.
    fn arrive(&mut self, q: Vec<f64>, mut distance: Distance) {
        self.numeric.add_orientations(&mut distance, &q, None);
        let is_known = |(known, far): &(Vec<f64>, Distance)| {
            compare(far, &distance) == Ordering::Equal && self.numeric.differing(known, &q).is_empty()
        };
        if self.found.iter().any(is_known) || !self.numeric.is_as_checked(self.structure, &q) {
            return;
        }
        let place = self.found.iter().position(|(_, known)| compare(&distance, known) == Ordering::Less);
        self.found.insert(place.unwrap_or(self.found.len()), (q, distance));
    }

    /// The isolated assembly of a block, if it is found without searching for others.
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
            // A block with Rust functions cannot be searched: take its approximate assembly.
            let (values, closes) = numeric.nearest(block, q);
            if closes { vec![values] } else { Vec::new() }
        };
        looked.all.insert(key, all.clone());
        all
    }
}
