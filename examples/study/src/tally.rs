//! Sums over sets that do not depend on the order of the sets.
//!
//! Numbers in m are rounded to multiples of 2⁻⁴⁶ m (14 fm) and added as integers. Integers add up to the same sum in any order; doubles
//! do not.

use std::ops::Add;

use reuleaux::nalgebra::Vector2;
use serde::{Deserialize, Serialize};

use crate::{POSITIONS, Study};

/// Units in a metre. An error of 0.1 m, more than this linkage can have, squared and in these units is less than 2⁸⁶: 2⁴¹ sets fit.
const UNITS: f64 = (1_u64 << 46) as f64;
/// Intervals of path errors in a standard deviation of the lengths.
const FINENESS: f64 = 64.0;
/// Intervals of path errors, the last without an end.
const INTERVALS: usize = 2048;
/// Integers of 32 bits in a sum, so that sums of them over two thousand million ranks fit in 64.
const LIMBS: usize = 4;

/// Sums of a number and of its square, in units and units².
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Moments {
    first: i128,
    second: i128,
}

impl Moments {
    fn count(&mut self, x: f64) {
        let units = (x * UNITS).round() as i128;
        self.first += units;
        self.second += units * units;
    }

    /// Mean (m) of `count` numbers.
    #[must_use]
    pub fn mean(&self, count: u64) -> f64 {
        self.first as f64 / count as f64 / UNITS
    }

    /// Standard deviation (m) of `count` numbers, at least two.
    #[must_use]
    pub fn deviation(&self, count: u64) -> f64 {
        let (count, first) = (count as f64, self.first as f64);
        ((self.second as f64 - first * first / count) / (count - 1.0)).sqrt() / UNITS
    }
}

impl Add for Moments {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { first: self.first + other.first, second: self.second + other.second }
    }
}

/// What is known about a number of sets.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Tally {
    /// Sets that were tried.
    pub sets: u64,
    /// Those of them that cannot be turned. All that follows is about the others.
    pub failed: u64,
    /// Sets with a path error within the limit.
    pub accepted: u64,
    /// The path error.
    pub error: Moments,
    /// The deviation of the tip in x and y, in each position.
    pub tips: Vec<[Moments; 2]>,
    /// Numbers of sets by path error.
    errors: Vec<u64>,
}

impl Default for Tally {
    fn default() -> Self {
        let tips = vec![[Moments::default(); 2]; POSITIONS];
        Self { sets: 0, failed: 0, accepted: 0, error: Moments::default(), tips, errors: vec![0; INTERVALS] }
    }
}

impl Tally {
    /// Counts one set by its path (m), the deviations from the nominal tip; nothing stands for a linkage that cannot be turned.
    pub(crate) fn count(&mut self, path: Option<&[Vector2<f64>; POSITIONS]>, study: &Study) {
        self.sets += 1;
        let Some(path) = path else {
            self.failed += 1;
            return;
        };
        let error = path.iter().map(Vector2::norm).fold(0.0, f64::max);
        self.accepted += u64::from(error <= study.limit);
        self.error.count(error);
        self.errors[((error * FINENESS / study.deviation) as usize).min(INTERVALS - 1)] += 1;
        for ([x, y], off) in self.tips.iter_mut().zip(path) {
            x.count(off.x);
            y.count(off.y);
        }
    }

    /// Whether there are as many numbers as this program counts.
    pub(crate) fn has_all_numbers(&self) -> bool {
        (self.tips.len(), self.errors.len()) == (POSITIONS, INTERVALS)
    }

    /// Sets that can be turned.
    #[must_use]
    pub const fn turning(&self) -> u64 {
        self.sets - self.failed
    }

    /// The path error (m) that is not exceeded by this part of the sets that can be turned, to a 64th of the standard deviation of the
    /// lengths; infinite where too many lie beyond the last interval.
    #[must_use]
    pub fn quantile(&self, part: f64, study: &Study) -> f64 {
        let rank = part * self.turning() as f64;
        let mut below = 0.0;
        for (index, &count) in self.errors[..INTERVALS - 1].iter().enumerate() {
            let count = count as f64;
            if count > 0.0 && below + count >= rank {
                return (index as f64 + (rank - below) / count) * study.deviation / FINENESS;
            }
            below += count;
        }
        f64::INFINITY
    }

    /// The tally as integers whose sums over ranks are those of the tallies.
    #[must_use]
    pub fn to_words(&self) -> Vec<i64> {
        let mut words = vec![self.sets as i64, self.failed as i64, self.accepted as i64];
        words.extend(self.errors.iter().map(|&count| count as i64));
        for moments in self.tips.iter().flatten().chain([&self.error]) {
            words.extend(limbs(moments.first));
            words.extend(limbs(moments.second));
        }
        words
    }

    /// The tally of integers made by [`to_words`](Self::to_words), or of sums of them. More integers may follow.
    #[must_use]
    pub fn from_words(words: &[i64]) -> Self {
        let mut words = words.iter().copied();
        let mut next = || words.next().unwrap_or(0);
        let mut tally = Self { sets: next() as u64, failed: next() as u64, accepted: next() as u64, ..Self::default() };
        tally.errors.iter_mut().for_each(|count| *count = next() as u64);
        let mut sum = || (0..LIMBS).fold(0, |sum: i128, limb| sum + (i128::from(next()) << (32 * limb)));
        for moments in tally.tips.iter_mut().flatten().chain([&mut tally.error]) {
            *moments = Moments { first: sum(), second: sum() };
        }
        tally
    }
}

impl Add<&Self> for Tally {
    type Output = Self;

    fn add(mut self, other: &Self) -> Self {
        self.sets += other.sets;
        self.failed += other.failed;
        self.accepted += other.accepted;
        self.error = self.error + other.error;
        for (own, other) in self.tips.iter_mut().flatten().zip(other.tips.iter().flatten()) {
            *own = *own + *other;
        }
        for (own, other) in self.errors.iter_mut().zip(&other.errors) {
            *own += other;
        }
        self
    }
}

/// The 32-bit digits of a number, lowest first; the highest has its sign.
fn limbs(number: i128) -> [i64; LIMBS] {
    std::array::from_fn(|limb| {
        let shifted = number >> (32 * limb);
        if limb + 1 == LIMBS { shifted as i64 } else { shifted as u32 as i64 }
    })
}
