//! What is declared of the start, and configurations beside it.

use super::position::HOLDS;
use std::f64::consts::PI;

/// Largest changes of the angles and of the components of quaternions that lead to configurations beside the declared start.
pub(super) const SWAYS: [f64; 6] = [0.1, 0.2, 0.3, 0.5, 0.7, 1.0];

/// Attempts with changes of up to half a turn, where none closes nearer to the declared start.
pub(super) const WIDE: usize = 24;

/// A place is as declared within this part of the farthest one, a turn within so many radians.
const AS_DECLARED: f64 = 1e-9;

/// Declared start values, at the defaults.
pub(super) struct DeclaredStart {
    /// 0 where none is declared.
    pub(super) values: Vec<f64>,
    pub(super) are_declared: Vec<bool>,
    /// True of angles and of components of quaternions.
    pub(super) are_turns: Vec<bool>,
    /// The unknowns whose rate alone is given.
    pub(super) rates: Vec<usize>,
    /// Those of them whose rate a drive gives.
    pub(super) driven: Vec<usize>,
}

impl DeclaredStart {
    /// Declared values, with others for the turns of which nothing is declared.
    pub(super) fn swayed(&self, attempt: usize) -> Vec<f64> {
        let change = |(unknown, value): (usize, &f64)| if self.is_told_nothing(unknown) { value + sway(unknown, attempt) } else { *value };
        self.values.iter().enumerate().map(change).collect()
    }

    /// True of a declared place.
    pub(super) fn is_place(&self, unknown: usize) -> bool {
        self.are_declared[unknown] && !self.are_turns[unknown]
    }

    /// True of an angle or a component of a quaternion without a declared start.
    pub(super) fn is_told_nothing(&self, unknown: usize) -> bool {
        self.are_turns[unknown] && !self.are_declared[unknown]
    }

    /// The declared place farthest from the origin, or 1 m.
    pub(super) fn size(&self) -> f64 {
        let farthest = (0..self.values.len()).filter(|unknown| self.is_place(*unknown)).map(|unknown| self.values[unknown].abs());
        Some(farthest.fold(0.0, f64::max)).filter(|size| *size > 0.0).unwrap_or(1.0)
    }

    /// Unit in which a coordinate counts: the size for places, 1 rad for turns.
    pub(super) fn unit(&self, unknown: usize) -> f64 {
        if self.are_turns[unknown] { 1.0 } else { self.size() }
    }

    /// Distance of a configuration from what is declared.
    pub(super) fn distance(&self, q: &[f64]) -> f64 {
        let declared = (0..q.len()).filter(|unknown| self.are_declared[*unknown]);
        declared.map(|unknown| ((q[unknown] - self.values[unknown]) / self.unit(unknown)).powi(2)).sum::<f64>().sqrt()
    }

    /// Distance within which all is as declared.
    pub(super) fn exact(&self) -> f64 {
        AS_DECLARED + 10.0 * HOLDS / self.size()
    }

    pub(super) fn is_kept(&self, unknown: usize, value: f64) -> bool {
        (value - self.values[unknown]).abs() <= self.exact() * self.unit(unknown)
    }

    /// Those of some unknowns, by a mark for each, that have no declared start.
    pub(super) fn undeclared(&self, marks: &[bool]) -> Vec<usize> {
        (0..marks.len()).filter(|unknown| marks[*unknown] && !self.are_declared[*unknown]).collect()
    }
}

/// Change of an unknown in an attempt; none in attempt 0.
fn sway(unknown: usize, attempt: usize) -> f64 {
    // Multiples of the golden section modulo 1 are unrelated.
    let share = |attempts: usize| 2.0 * ((unknown * attempts + attempt) as f64 * 0.618_033_988_749_895).fract() - 1.0;
    match attempt.checked_sub(1) {
        None => 0.0,
        Some(one) if one < SWAYS.len() => SWAYS[one] * share(SWAYS.len()),
        Some(_) => PI * share(SWAYS.len() + WIDE),
    }
}
