//! All assemblies of a block.
//!
//! In: a block and the coordinates upstream of it. Out: its assemblies, each once, with the whole turns that bring it nearest to the
//! declared start. The search is a multi-start: guesses fill the space of the iterated unknowns evenly, half of them with declared values
//! kept, until many in a row yield nothing new. Then `curve`s are followed from the assemblies found to others. The search continues while,
//! by their `degree`, an assembly is missing.

use super::curve::Curve;
use super::degree::side;
use super::reduced::Reduced;
use crate::expr::{Expr, Values, evaluate};
use crate::linear::dense::Factors;
use crate::numeric::Numeric;
use crate::numeric::search::compare;
use crate::numeric::turns::turns_to_zero;
use crate::structure::Block;
use core::f64::consts::{PI, TAU};
use core::ops::RangeInclusive;
use std::collections::BTreeSet;

/// Number of guesses in a row without a new assembly before the search ends: per iterated unknown, and per assembly found.
const IDLE: [usize; 2] = [5, 3];

/// The same if curves are followed from the assemblies found.
const IDLE_JOINED: [usize; 2] = [3, 3];

/// Largest number of guesses per iterated unknown.
const MOST: usize = 40;

/// A block with more iterated unknowns than this is not searched completely: compilation would slow down noticeably.
const LARGE: usize = 12;

/// Number of guesses for such a block: if some iterated unknowns are undeclared, and if all are declared.
const FEW: [usize; 2] = [24, 8];

/// Number of turns to either side tried for angles that count turns.
const TURNS: i32 = 2;

/// Blocks with this many iterated unknowns may have assemblies that few guesses reach: curves are always followed. With fewer unknowns,
/// curves are followed only if an assembly is missing.
const JOINED: RangeInclusive<usize> = 3..=6;

/// Largest number of steps along curves, per block.
const ALONG: usize = 4000;

/// Radii within which an assembly is tested for being the only one, in rad and characteristic lengths.
const AROUND: [f64; 3] = [0.5, 0.2, 0.05];

/// A Jacobian is regular if its relative difference from that at an assembly has a smaller norm.
const SHARE: f64 = 0.5;

/// An assembly of a block whose iterated unknowns are all declared.
#[derive(Clone, Debug)]
pub(super) struct Alone {
    pub(super) values: Vec<f64>,
    /// Squared distance from the declared values.
    near: f64,
    /// Lower bound of the squared distance of any other assembly.
    pub(super) others: f64,
}

impl Alone {
    /// True if no other assembly is nearer.
    pub(super) fn is_nearest(&self) -> bool {
        self.near < self.others
    }
}

impl Numeric<'_> {
    /// The assembly that Newton's method finds from the declared values, and a lower bound of the distance of any other; `None` unless all
    /// iterated unknowns are declared. Within a radius where the Jacobian stays near its value at the assembly there is no other (mean
    /// value theorem).
    pub(super) fn alone(&self, reduced: &mut Reduced, block: &Block, start: &[f64]) -> Option<Alone> {
        let k = block.iterated.len();
        let declared: Option<Vec<f64>> = block.iterated.iter().map(|unknown| self.declared[*unknown]).collect();
        let mut values = declared?;
        if k == 0 || k > LARGE {
            return None;
        }
        reduced.set_out_from(start);
        values.extend(reduced.unknowns[k..].iter().map(|unknown| self.declared[*unknown].unwrap_or(0.0)));
        if !reduced.close(&mut values) || self.is_turned_over(block, reduced, start, &values) {
            return None;
        }
        let here = reduced.linearize(&values)?;
        let is_regular = |reduced: &mut Reduced, around: f64| {
            (0..2 * k + 2).all(|look| {
                let sign = if look % 2 == 0 { around } else { -around };
                let step: Vec<f64> = (0..k)
                    .map(|index| if look >= 2 * k || look / 2 == index { sign } else { sign * 0.3 * (index as f64 - look as f64).sin() })
                    .collect();
                let there = reduced.moved(&values, &here, &step);
                let Some(there) = reduced.linearize(&there) else { return false };
                strays(&here.r, &there.r).is_some_and(|share| share < SHARE)
            })
        };
        let around = AROUND.into_iter().find(|around| is_regular(reduced, *around))?;
        let [near, ..] = self.distance(&reduced.unknowns, &values);
        let [own, ..] = self.distance(&block.iterated, &values[..k]);
        let others = (around - own.sqrt()).max(0.0).powi(2);
        Some(Alone { values, near, others })
    }

    /// All assemblies of a block, with upstream coordinates from `start`, as values of its unknowns.
    pub(super) fn assemblies(&self, reduced: &mut Reduced, block: &Block, start: &[f64]) -> Vec<Vec<f64>> {
        reduced.set_out_from(start);
        let k = block.iterated.len();
        let mut found: Vec<Vec<f64>> = Vec::new();
        let declared: Vec<f64> = reduced.unknowns.iter().map(|unknown| self.declared[*unknown].unwrap_or(0.0)).collect();
        if k == 0 {
            let mut x = declared;
            if reduced.close(&mut x) && !self.is_turned_over(block, reduced, start, &x) {
                found.push(x);
            }
            return found;
        }
        let counts = self.counting_turns(block);
        let mut is_even = None;
        let is_open = block.iterated.iter().any(|unknown| self.declared[*unknown].is_none());
        let shares = shares(k);
        let guess = |attempt: usize, index: usize| {
            let (unknown, share) = (block.iterated[index], 2.0 * (0.5 + attempt as f64 * shares[index]).fract() - 1.0);
            let is_held = attempt.is_multiple_of(2) && is_open && self.declared[unknown].is_some();
            match self.is_angle(unknown) {
                _ if is_held => declared[index],
                true => share * PI * if counts[index] { f64::from(TURNS) } else { 1.0 },
                false => declared[index] + share * self.size,
            }
        };
        let most = match k {
            ..=LARGE => MOST * k.min(6),
            _ if is_open => FEW[0],
            _ => FEW[1],
        };
        let (mut idle, mut steps, mut left_out) = (0, ALONG, Vec::new());
        for attempt in 0..most {
            let mut x = declared.clone();
            if attempt > 0 {
                x[..k].iter_mut().enumerate().for_each(|(index, value)| *value = guess(attempt, index));
            }
            let is_new = reduced.close(&mut x) && self.keep(block, &counts, reduced, &mut found, x).1;
            idle = if is_new { 0 } else { idle + 1 };
            let [of_unknown, of_found] = if JOINED.contains(&k) && !found.is_empty() { IDLE_JOINED } else { IDLE };
            if k > LARGE || idle < of_unknown * k + of_found * found.len() {
                continue;
            }
            if JOINED.contains(&k) {
                self.join(block, &counts, reduced, &mut found, &mut left_out, &mut steps);
            }
            let balance: i32 = found.iter().map(|x| reduced.linearize(x).map_or(0, |linear| side(linear.r))).sum();
            if balance == 0 || found.is_empty() || !*is_even.get_or_insert_with(|| self.has_degree_zero(block, &counts, start)) {
                break;
            }
            if k < *JOINED.start() {
                self.join(block, &counts, reduced, &mut found, &mut left_out, &mut steps);
            }
        }
        self.with_turns(block, &counts, reduced, &mut found);
        found.retain(|x| !self.is_turned_over(block, reduced, start, x));
        found.sort_by(|one, other| {
            let distance = |x: &[f64]| self.distance(&reduced.unknowns, x);
            compare(&distance(one), &distance(other))
        });
        found
    }

    /// True if the unknown that stands for the angle of a joint is half a turn away from that angle.
    fn is_turned_over(&self, block: &Block, reduced: &Reduced, start: &[f64], x: &[f64]) -> bool {
        if self.system.space.further_angles.is_empty() {
            return false;
        }
        let own: Vec<Expr> = block.parts().1.into_iter().filter_map(|equation| self.system.equations[equation].phi()).collect();
        let angles = self.system.space.further_angles.iter().filter(|angle| own.contains(&angle.phi));
        let cosines: Vec<Expr> = angles.map(|angle| angle.cosine).collect();
        let mut q = start.to_vec();
        reduced.unknowns.iter().zip(x).for_each(|(unknown, value)| q[*unknown] = *value);
        evaluate(&self.system.arena, &cosines, &Values { coordinates: &q, ..self.known }).into_iter().any(|cosine| cosine < 0.0)
    }

    /// Adds an assembly unless it is already known; of two descriptions that differ by whole turns the nearer one is kept. Returns its
    /// index, and true if it is new.
    fn keep(&self, block: &Block, counts: &[bool], reduced: &mut Reduced, found: &mut Vec<Vec<f64>>, mut x: Vec<f64>) -> (usize, bool) {
        self.turn(block, counts, reduced, &mut x);
        let unknowns = &reduced.unknowns;
        let Some(known) = found.iter().position(|known| self.is_one(unknowns, known, &x)) else {
            found.push(x);
            return (found.len() - 1, true);
        };
        if self.distance(unknowns, &x) < self.distance(unknowns, &found[known]) {
            found[known] = x;
        }
        (known, false)
    }

    /// Adds the assemblies connected to those found, by one curve or several.
    ///
    /// * `left_out`: for each assembly, the residuals left out on curves followed through it.
    /// * `steps`: number of steps left.
    fn join(
        &self,
        block: &Block,
        counts: &[bool],
        reduced: &mut Reduced,
        found: &mut Vec<Vec<f64>>,
        left_out: &mut Vec<Vec<bool>>,
        steps: &mut usize,
    ) {
        let (k, unknowns) = (reduced.iterated, reduced.unknowns.clone());
        let mut from = 0;
        while let Some(begin) = found.get(from).cloned() {
            left_out.resize(found.len(), vec![false; k]);
            for residual in 0..k {
                if std::mem::replace(&mut left_out[from][residual], true) {
                    continue;
                }
                let is_back = |x: &[f64]| self.is_one(&unknowns, &begin, x);
                for x in (Curve { reduced, left_out: residual }).follow(&begin, &is_back, steps) {
                    let (place, _) = self.keep(block, counts, reduced, found, x);
                    left_out.resize(found.len(), vec![false; k]);
                    left_out[place][residual] = true;
                }
            }
            from += 1;
        }
    }

    /// For each iterated unknown, true if an equation of the block changes when it is turned together with those linked angles that are
    /// unknowns of the block, too.
    fn counting_turns(&self, block: &Block) -> Vec<bool> {
        let (unknowns, own) = block.parts();
        let [unknowns, own] = [unknowns, own].map(|parts| parts.into_iter().collect::<BTreeSet<usize>>());
        // The angles that are known stay where they are.
        let holds = |equation: &usize, members: &[usize]| {
            let angles = self.system.equations[*equation].jacobian.iter().map(|(unknown, _)| *unknown);
            let mut are_own = angles.filter(|unknown| members.binary_search(unknown).is_ok()).map(|unknown| unknowns.contains(&unknown));
            let Some(first) = are_own.next() else { return false };
            self.turns().are_linked_by(*equation) && are_own.any(|is_own| is_own != first)
        };
        let counts = |unknown: &usize| {
            self.turns()
                .linked(*unknown)
                .is_none_or(|group| group.counted_by.iter().any(|by| own.contains(by)) || own.iter().any(|row| holds(row, &group.members)))
        };
        block.iterated.iter().map(counts).collect()
    }

    /// Removes whole turns from iterated unknowns that do not count them, and from their linked angles.
    fn turn(&self, block: &Block, counts: &[bool], reduced: &mut Reduced, x: &mut Vec<f64>) {
        let mut has_turned = false;
        for unknown in block.iterated.iter().zip(counts).filter(|(_, counts)| !**counts).map(|(unknown, _)| *unknown) {
            let members = self.linked(reduced, unknown);
            let turns = self.turns_to_start(members.iter().map(|index| (reduced.unknowns[*index], x[*index])));
            if turns != 0.0 {
                members.iter().for_each(|index| x[*index] += TAU * turns);
                has_turned = true;
            }
        }
        if has_turned {
            reduced.settle(x);
        }
    }

    /// Indices of the angles of a block that are linked to an angle, which is included.
    fn linked(&self, reduced: &Reduced, unknown: usize) -> Vec<usize> {
        let members = self.turns().linked(unknown).map_or(&[][..], |group| &group.members);
        (0..reduced.unknowns.len()).filter(|index| members.binary_search(&reduced.unknowns[*index]).is_ok()).collect()
    }

    /// Adds copies of the assemblies that differ by whole turns, if later blocks count these turns.
    fn with_turns(&self, block: &Block, counts: &[bool], reduced: &mut Reduced, found: &mut Vec<Vec<f64>>) {
        for (unknown, counts) in block.iterated.iter().zip(counts) {
            if *counts || self.is_position(*unknown) || self.turns().is_free(*unknown) {
                continue;
            }
            let members = self.linked(reduced, *unknown);
            for x in found.clone() {
                for turns in (1..=TURNS).flat_map(|turns| [turns, -turns]) {
                    let mut other = x.clone();
                    members.iter().for_each(|index| other[*index] += TAU * f64::from(turns));
                    if reduced.close(&mut other) {
                        found.push(other);
                    }
                }
            }
        }
    }

    /// Number of turns that brings linked angles nearest to their declared values, or to 0 if none is declared.
    pub(super) fn turns_to_start(&self, values: impl Iterator<Item = (usize, f64)>) -> f64 {
        let all: Vec<(Option<f64>, f64)> = values.map(|(unknown, value)| (self.declared[unknown], value)).collect();
        let is_told = all.iter().any(|(declared, _)| declared.is_some());
        let counted = all.iter().filter(|(declared, _)| declared.is_some() == is_told);
        let away: Vec<f64> = counted.map(|(declared, value)| (declared.unwrap_or(0.0) - value) / TAU).collect();
        turns_to_zero(away.iter().sum::<f64>() / away.len().max(1) as f64)
    }

    /// True if two assemblies are equal up to whole turns.
    pub(super) fn is_one(&self, unknowns: &[usize], one: &[f64], other: &[f64]) -> bool {
        let mut pairs = unknowns.iter().zip(one.iter().zip(other));
        pairs.all(|(unknown, (one, other))| self.is_one_place(*unknown, *one, *other))
    }
}

/// ‖A⁻¹ B − 1‖ in the maximum row sum norm; `None` if A is singular.
pub(super) fn strays(a: &[Vec<f64>], b: &[Vec<f64>]) -> Option<f64> {
    let mut sums = vec![0.0; a.len()];
    let factors = Factors::new(a.to_vec())?;
    for column in 0..a.len() {
        let solved = factors.solve(&b.iter().map(|row| row[column]).collect::<Vec<f64>>())?;
        for (row, (sum, value)) in sums.iter_mut().zip(solved).enumerate() {
            *sum += (value - if row == column { 1.0 } else { 0.0 }).abs();
        }
    }
    Some(sums.into_iter().fold(0.0, f64::max))
}

/// Increments of a point in the unit cube from guess to guess, so that the points fill the cube evenly: powers of 1/φ, where
/// φ^(n + 1) = φ + 1, the generalisation of the golden section to n dimensions by Roberts (2018).
fn shares(dimensions: usize) -> Vec<f64> {
    let phi = (0..24).fold(1.5_f64, |phi, _| (phi + 1.0).powf(1.0 / (dimensions as f64 + 1.0)));
    (1..=dimensions).map(|index| phi.powi(-(index as i32))).collect()
}
