//! The assemblies of some equations, and which of them is meant.
//!
//! In: a [`Problem`] and the declared start. Out: the assemblies that were found from several guesses, the nearest first. Of two
//! the one is nearer whose declared coordinates are nearer to the declared values; where these do not tell, the one whose undeclared
//! angles are less turned; then the one whose undeclared places are nearer to the origin. Not done here: refusing.

use super::Numeric;
use super::least_squares::{Problem, minimise};
use super::turns::within_a_turn;
use crate::quantity::Role;
use std::cmp::Ordering;

/// How many guesses of what is not declared are tried.
pub(crate) const GUESSES: usize = 24;

/// Squared distances from the start agree when they differ by less than this part of themselves.
///
/// Assemblies that are images of each other agree to about 1e-9, what `minimise` leaves; an accident as near as this is not met.
const ALIKE: f64 = 1e-6;

/// Squared distances below this are nothing: it is what `minimise` leaves where assemblies are near each other.
const NOTHING: f64 = 1e-12;

/// Angles, in rad, and places, in sizes, that differ by less are those of one assembly.
const ONE_PLACE: f64 = 1e-4;

/// What a search has found.
pub(crate) struct SearchResult {
    /// Different assemblies, the nearest first; they are values of the problem's unknowns.
    pub(crate) assemblies: Vec<Vec<f64>>,
    /// The first guess, with the equations as small as they became from there.
    pub(crate) first: Vec<f64>,
}

/// Squared distances from the declared start: of what is declared, of undeclared angles from 0, of undeclared places from 0.
pub(crate) type Distance = [f64; 3];

impl Numeric<'_> {
    /// Looks for assemblies from the declared start, with guesses of what is not declared.
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
                // Angles tell assemblies apart.
                if is_told {
                    break;
                }
            }
        }
        found
    }

    /// Looks for assemblies from anywhere, whatever is declared.
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

    /// The assembly on the other side of the start, if there is one: each declared value is as far from it, and undeclared ones from 0.
    pub(crate) fn mirrored(&self, problem: &mut Problem, q: &[f64]) -> Option<Vec<f64>> {
        let shown = Shown::new(self, problem);
        let image = q.iter().zip(&shown.declared).map(|(value, declared)| declared.map_or(-value, |declared| 2.0 * declared - value));
        let (image, closes) = shown.descend(problem, image.collect());
        (closes && !shown.is_one(&image, q)).then_some(image)
    }

    /// Whether one assembly is as near to what is declared as another, as far as they differ.
    pub(crate) fn is_as_declared(&self, one: &[f64], other: &[f64]) -> bool {
        let differing = self.differing(one, other);
        let declared = |q: &[f64]| {
            let mut distance = [0.0; 3];
            differing.iter().for_each(|unknown| self.add_distance(&mut distance, *unknown, q[*unknown]));
            [distance[0], 0.0, 0.0]
        };
        compare(&declared(one), &declared(other)) == Ordering::Equal
    }

    /// Whether two assemblies are equally near to the start as far as they differ; values of all unknowns.
    pub(crate) fn are_equally_near(&self, one: &[f64], other: &[f64]) -> bool {
        let differing = self.differing(one, other);
        let part = |q: &[f64]| -> Distance {
            let mut distance = [0.0; 3];
            for unknown in &differing {
                self.add_distance(&mut distance, *unknown, q[*unknown]);
            }
            distance
        };
        compare(&part(one), &part(other)) == Ordering::Equal
    }

    /// The unknowns by which two assemblies differ.
    pub(crate) fn differing(&self, one: &[f64], other: &[f64]) -> Vec<usize> {
        (0..one.len()).filter(|unknown| !self.is_one_place(*unknown, one[*unknown], other[*unknown])).collect()
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

    /// How far a guess reaches for each radian that a guessed angle is turned.
    pub(crate) fn reach(&self, unknown: usize) -> f64 {
        self.scale(unknown) / if self.is_position(unknown) { core::f64::consts::PI } else { 1.0 }
    }

    /// Adds how far an unknown is from where it should start.
    pub(crate) fn add_distance(&self, distance: &mut Distance, unknown: usize, value: f64) {
        let level = match self.declared[unknown] {
            Some(_) => 0,
            None if self.is_angle(unknown) => 1,
            None => 2,
        };
        distance[level] += self.away(unknown, value).powi(2);
    }

    /// How far an unknown is from its declared value, or from 0, in rad or sizes; whole turns that nothing counts aside.
    pub(crate) fn away(&self, unknown: usize, value: f64) -> f64 {
        let away = value - self.declared[unknown].unwrap_or(0.0);
        if self.is_angle(unknown) && self.turns().is_free(unknown) { within_a_turn(away) } else { away / self.scale(unknown) }
    }

    /// How far some unknowns are from where they should start.
    pub(crate) fn distance(&self, unknowns: &[usize], values: &[f64]) -> Distance {
        let mut distance = [0.0; 3];
        unknowns.iter().zip(values).for_each(|(unknown, value)| self.add_distance(&mut distance, *unknown, *value));
        distance
    }
}

/// What is before it decides, unless it is alike.
pub(crate) fn compare(one: &Distance, other: &Distance) -> Ordering {
    let is_alike = |(a, b): (&f64, &f64)| (a - b).abs() <= ALIKE * a.max(*b) + NOTHING;
    one.iter().zip(other).find(|(a, b)| !is_alike((a, b))).map_or(Ordering::Equal, |(a, b)| a.total_cmp(b))
}

/// What is known of the unknowns of a problem.
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

    /// Makes the equations as small as they become from a guess; whether they vanish.
    fn descend(&self, problem: &mut Problem, mut q: Vec<f64>) -> (Vec<f64>, bool) {
        // With the angles given, the places follow from equations that are nearly linear in them.
        let places: Vec<bool> = self.declared.iter().zip(&self.is_angle).map(|(value, is_angle)| value.is_none() && !is_angle).collect();
        minimise(problem, &mut q, &places);
        let undeclared: Vec<bool> = self.declared.iter().map(Option::is_none).collect();
        minimise(problem, &mut q, &undeclared);
        let everything = vec![true; q.len()];
        let closes = minimise(problem, &mut q, &everything);
        (q, closes)
    }

    /// Keeps an assembly, unless it is there already; the nearest first.
    fn add(&self, assemblies: &mut Vec<Vec<f64>>, q: Vec<f64>) {
        let distance = self.distance(&q);
        if let Some(known) = assemblies.iter().position(|known| self.is_one(known, &q)) {
            // Of one assembly the less turned description is taken.
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

/// The guess of an undeclared angle: first 0, then spread evenly over a turn, each angle its own way; places likewise.
pub(crate) fn guess(attempt: usize, index: usize) -> f64 {
    // Fractions of the golden section never repeat and fill the circle evenly.
    let turns = (attempt as f64 * (index as f64 + 1.0) * 0.618_033_988_749_895).fract();
    let turns = if turns > 0.5 { turns - 1.0 } else { turns };
    if attempt == 0 { 0.0 } else { turns * core::f64::consts::TAU }
}
