//! Assemblies of some equations, and the choice among them.
//!
//! In: a [`Problem`] and the declared start. Out: the assemblies found from several guesses, nearest to the start first. Distance compares,
//! in this order: declared coordinates with their declared values; undeclared angles with 0; undeclared positions with the origin. Not done
//! here: refusing.

use super::Numeric;
use super::least_squares::{Problem, minimise};
use super::turns::within_a_turn;
use crate::quantity::Role;
use std::cmp::Ordering;

/// Number of guesses for undeclared coordinates.
pub(crate) const GUESSES: usize = 24;

/// Relative difference below which squared distances from the start are equal.
///
/// Mirror-image assemblies agree to about 1e-9, the accuracy of `minimise`; different ones are practically never this close.
const ALIKE: f64 = 1e-6;

/// Squared distances below this are zero: the accuracy of `minimise` where assemblies are close to each other.
const NOTHING: f64 = 1e-12;

/// Two values of an angle, in rad, or of a position, in characteristic lengths, are equal if they differ by less than this.
const ONE_PLACE: f64 = 1e-4;

/// Result of a search.
pub(crate) struct SearchResult {
    /// Different assemblies as values of the problem's unknowns, nearest to the start first.
    pub(crate) assemblies: Vec<Vec<f64>>,
    /// Local minimum of the residual reached from the first guess.
    pub(crate) first: Vec<f64>,
}

/// Squared distances from the start: declared coordinates, undeclared angles from 0, undeclared positions from 0.
pub(crate) type Distance = [f64; 3];

impl Numeric<'_> {
    /// Finds assemblies from the declared start and guesses for undeclared coordinates.
    pub(crate) fn search(&self, problem: &mut Problem, guesses: usize) -> SearchResult {
        let shown = Shown::new(self, problem);
        let is_told = (0..shown.declared.len()).all(|index| shown.declared[index].is_some() || !shown.is_angle[index]);
        let mut found = SearchResult { assemblies: Vec::new(), first: Vec::new() };
        for attempt in 0..guesses {
            let q = (0..shown.declared.len()).map(|index| shown.declared[index].unwrap_or_else(|| shown.guess(problem, attempt, index)));
            let (q, closes) = shown.descend(problem, q.collect());
            if attempt == 0 {
                found.first.clone_from(&q);
            }
            if closes {
                shown.add(&mut found.assemblies, q);
                // Assemblies differ in their angles: if all are declared, one assembly is enough.
                if is_told {
                    break;
                }
            }
        }
        found
    }

    /// Finds assemblies from guesses of all coordinates, declared or not.
    pub(crate) fn search_widely(&self, problem: &mut Problem, guesses: usize) -> Vec<Vec<f64>> {
        let shown = Shown::new(self, problem);
        let mut assemblies = Vec::new();
        for attempt in 0..guesses {
            let q = (0..shown.declared.len()).map(|index| shown.guess(problem, attempt, index)).collect();
            let (q, closes) = shown.descend(problem, q);
            if closes {
                shown.add(&mut assemblies, q);
            }
        }
        assemblies
    }

    /// The assembly found from the mirror image of `q` about the declared values, 0 for undeclared ones; `None` if it is `q` itself or does
    /// not close.
    pub(crate) fn mirrored(&self, problem: &mut Problem, q: &[f64]) -> Option<Vec<f64>> {
        let shown = Shown::new(self, problem);
        let image = q.iter().zip(&shown.declared).map(|(value, declared)| declared.map_or(-value, |declared| 2.0 * declared - value));
        let (image, closes) = shown.descend(problem, image.collect());
        (closes && !shown.is_one(&image, q)).then_some(image)
    }

    /// True if two assemblies are equally near to the declared values, counting only unknowns and orientations in which they differ.
    pub(crate) fn is_as_declared(&self, one: &[f64], other: &[f64]) -> bool {
        let differing = self.differing(one, other);
        let declared = |q: &[f64], other: &[f64]| {
            let mut distance = [0.0; 3];
            differing.iter().for_each(|unknown| self.add_distance(&mut distance, *unknown, q[*unknown]));
            self.add_orientations(&mut distance, q, Some(other));
            [distance[0], 0.0, 0.0]
        };
        compare(&declared(one, other), &declared(other, one)) == Ordering::Equal
    }

    /// True if two assemblies, given as values of all unknowns, are equally near to the start by the unknowns and orientations in which they
    /// differ.
    pub(crate) fn are_equally_near(&self, one: &[f64], other: &[f64]) -> bool {
        let differing = self.differing(one, other);
        let part = |q: &[f64], other: &[f64]| -> Distance {
            let mut distance = [0.0; 3];
            for unknown in &differing {
                self.add_distance(&mut distance, *unknown, q[*unknown]);
            }
            self.add_orientations(&mut distance, q, Some(other));
            distance
        };
        compare(&part(one, other), &part(other, one)) == Ordering::Equal
    }

    /// Unknowns in which two assemblies differ.
    pub(crate) fn differing(&self, one: &[f64], other: &[f64]) -> Vec<usize> {
        let differs = |unknown: &usize| !self.is_one_place(*unknown, one[*unknown], other[*unknown]);
        (0..one.len()).filter(|unknown| differs(unknown) && !self.is_opposite(*unknown, one, other)).collect()
    }

    /// True for a component of a quaternion whose opposite describes the same orientation in the other assembly.
    fn is_opposite(&self, unknown: usize, one: &[f64], other: &[f64]) -> bool {
        let Role::Quaternion(component) = self.system.coordinates[unknown].role else { return false };
        let first = unknown - usize::from(component);
        (first..first + 4).all(|component| (one[component] + other[component]).abs() < ONE_PLACE)
    }

    pub(crate) fn is_one_place(&self, unknown: usize, one: f64, other: f64) -> bool {
        match self.system.coordinates[unknown].role.period() {
            Some(period) => {
                let turns = (one - other) / period;
                (turns - turns.round()).abs() * period < ONE_PLACE
            }
            None => (one - other).abs() < ONE_PLACE * self.scale(unknown),
        }
    }

    pub(crate) fn is_angle(&self, unknown: usize) -> bool {
        self.system.coordinates[unknown].role == Role::Angle
    }

    pub(crate) fn is_position(&self, unknown: usize) -> bool {
        self.system.coordinates[unknown].role.is_position()
    }

    /// Range of a guess per radian of guessed angle, in m or rad.
    pub(crate) fn reach(&self, unknown: usize) -> f64 {
        self.scale(unknown) / if self.is_position(unknown) { core::f64::consts::PI } else { 1.0 }
    }

    /// Adds the squared distance of an unknown from its start.
    pub(crate) fn add_distance(&self, distance: &mut Distance, unknown: usize, value: f64) {
        let level = match self.declared[unknown] {
            Some(_) => 0,
            None if self.is_angle(unknown) => 1,
            None => 2,
        };
        distance[level] += self.away(unknown, value).powi(2);
    }

    /// Signed distance of an unknown from its declared value, or from 0, in rad or characteristic lengths, modulo whole turns if the angle
    /// is free to turn.
    pub(crate) fn away(&self, unknown: usize, value: f64) -> f64 {
        let away = value - self.declared[unknown].unwrap_or(0.0);
        if self.is_angle(unknown) && self.turns().is_free(unknown) { within_a_turn(away) } else { away / self.scale(unknown) }
    }

    /// Squared distances of some unknowns from their start.
    pub(crate) fn distance(&self, unknowns: &[usize], values: &[f64]) -> Distance {
        let mut distance = [0.0; 3];
        unknowns.iter().zip(values).for_each(|(unknown, value)| self.add_distance(&mut distance, *unknown, *value));
        distance
    }
}

/// Lexicographic comparison with a tolerance.
pub(crate) fn compare(one: &Distance, other: &Distance) -> Ordering {
    let is_alike = |(a, b): (&f64, &f64)| (a - b).abs() <= ALIKE * a.max(*b) + NOTHING;
    one.iter().zip(other).find(|(a, b)| !is_alike((a, b))).map_or(Ordering::Equal, |(a, b)| a.total_cmp(b))
}

/// The unknowns of a problem, with their declared values.
struct Shown<'a> {
    numeric: &'a Numeric<'a>,
    unknowns: Vec<usize>,
    declared: Vec<Option<f64>>,
    is_angle: Vec<bool>,
}

impl<'a> Shown<'a> {
    fn new(numeric: &'a Numeric<'a>, problem: &Problem) -> Shown<'a> {
        let declared = problem.unknowns.iter().map(|unknown| numeric.declared[*unknown]).collect();
        let is_angle = problem.unknowns.iter().map(|unknown| numeric.is_angle(*unknown)).collect();
        Shown { numeric, unknowns: problem.unknowns.clone(), declared, is_angle }
    }

    /// Minimises the residual from a guess: undeclared positions first, then all undeclared unknowns, then all; true if it vanishes.
    fn descend(&self, problem: &mut Problem, mut q: Vec<f64>) -> (Vec<f64>, bool) {
        // For given angles the equations are nearly linear in the positions.
        let places: Vec<bool> = self.declared.iter().zip(&self.is_angle).map(|(value, is_angle)| value.is_none() && !is_angle).collect();
        minimise(problem, &mut q, &places);
        let undeclared: Vec<bool> = self.declared.iter().map(Option::is_none).collect();
        minimise(problem, &mut q, &undeclared);
        let everything = vec![true; q.len()];
        let closes = minimise(problem, &mut q, &everything);
        (q, closes)
    }

    /// Inserts an assembly in order of distance, unless it is already known.
    fn add(&self, assemblies: &mut Vec<Vec<f64>>, q: Vec<f64>) {
        let distance = self.distance(&q);
        if let Some(known) = assemblies.iter().position(|known| self.is_one(known, &q)) {
            // Of two descriptions of one assembly, which differ by whole turns, keep the one nearer to the start.
            if compare(&distance, &self.distance(&assemblies[known])) != Ordering::Less {
                return;
            }
            assemblies.remove(known);
        }
        let place = assemblies.iter().position(|known| compare(&distance, &self.distance(known)) == Ordering::Less);
        assemblies.insert(place.unwrap_or(assemblies.len()), q);
    }

    fn is_one(&self, one: &[f64], other: &[f64]) -> bool {
        self.unknowns.iter().enumerate().all(|(index, unknown)| self.numeric.is_one_place(*unknown, one[index], other[index]))
    }

    fn distance(&self, q: &[f64]) -> Distance {
        self.numeric.distance(&self.unknowns, q)
    }

    fn guess(&self, problem: &Problem, attempt: usize, index: usize) -> f64 {
        let turn = guess(attempt, problem.unknowns[index]);
        turn * self.numeric.reach(self.unknowns[index])
    }
}

/// Guess of an undeclared coordinate in rad: first 0, then spread evenly over a turn, with a different sequence for each index.
pub(crate) fn guess(attempt: usize, index: usize) -> f64 {
    // Multiples of the golden section modulo 1 never repeat and fill the circle evenly.
    let turns = (attempt as f64 * (index as f64 + 1.0) * 0.618_033_988_749_895).fract();
    let turns = if turns > 0.5 { turns - 1.0 } else { turns };
    if attempt == 0 { 0.0 } else { turns * core::f64::consts::TAU }
}
