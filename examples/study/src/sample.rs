//! Parameter sets, and the paths of their tips.

use std::ops::Range;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use reuleaux::Real;
use reuleaux::nalgebra::Vector2;
use reuleaux_wide::{F64x4, Lockstep, Wide};
use serde::{Deserialize, Serialize};

use crate::{Linkage, LinkageFailure, LinkageState, POSITIONS, Tally, lengths, linkage, positions};

/// Sets that are solved side by side.
const LANES: u64 = 4;
/// Sets between two reports of progress: about a millisecond of work.
const CHUNK: u64 = 256;

/// What is varied, and what is accepted.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Study {
    /// The seed of all random numbers.
    pub seed: u64,
    /// The standard deviation of each length, in m.
    pub deviation: f64,
    /// The largest path error of an acceptable linkage, in m: the largest distance between its tip and the tip of the nominal linkage, over
    /// all positions.
    pub limit: f64,
}

impl Default for Study {
    /// Holes drilled by hand: a quarter of a millimetre.
    fn default() -> Self {
        Self { seed: 1875, deviation: 0.25e-3, limit: 1.5e-3 }
    }
}

impl Study {
    /// The linkage with the number `number`: the nominal one with a normal deviation of every length, from a stream of its own.
    #[must_use]
    pub fn set(&self, number: u64) -> Linkage {
        self.drawn(&mut ChaCha8Rng::seed_from_u64(self.seed), number)
    }

    fn drawn(&self, random: &mut ChaCha8Rng, number: u64) -> Linkage {
        random.set_stream(number);
        random.set_word_pos(0);
        let deviation = |random: &mut ChaCha8Rng| -> f64 { StandardNormal.sample(random) };
        linkage(lengths(&Linkage::default()).map(|length| length + self.deviation * deviation(random)))
    }

    /// The part of the sets that cannot be turned, in closed form: ground and crank must not be longer than coupler and rocker together, and
    /// the difference of these sums is normal with the deviation 2 σ. The other conditions of Grashof are 37 deviations away.
    #[must_use]
    pub fn failing(&self) -> f64 {
        let [ground, crank, coupler, rocker, ..] = lengths(&Linkage::default());
        let margin = (coupler + rocker - ground - crank) / (2.0 * self.deviation);
        libm::erfc(margin / std::f64::consts::SQRT_2) / 2.0
    }

    /// The tips (m) of the nominal linkage.
    ///
    /// # Errors
    /// If it cannot be turned.
    pub fn nominal(&self) -> Result<[Vector2<f64>; POSITIONS], Box<LinkageFailure>> {
        let nominal = Linkage::default();
        let mut tips = [Vector2::zeros(); POSITIONS];
        for (tip, state) in tips.iter_mut().zip(nominal.sweep(positions())) {
            *tip = nominal.tip(&state?).value;
        }
        Ok(tips)
    }

    /// Solves these sets on this thread.
    ///
    /// Sets are solved in fours that begin at multiples of four, whatever the range, so that every set has the same numbers in any range that
    /// contains it: the tallies of two adjacent ranges add up to that of both.
    ///
    /// # Errors
    /// If the nominal linkage cannot be turned.
    pub fn tally(&self, sets: Range<u64>) -> Result<Tally, Box<LinkageFailure>> {
        let nominal = self.nominal()?;
        let mut tally = Tally::default();
        self.add(&nominal, sets, &mut tally);
        Ok(tally)
    }

    /// Solves these sets on all processors.
    ///
    /// * `progress`: given, called with a number of sets whenever so many have been solved, on any thread.
    ///
    /// # Errors
    /// If the nominal linkage cannot be turned.
    pub fn tally_on_all_processors(&self, sets: Range<u64>, progress: impl Fn(u64) + Sync) -> Result<Tally, Box<LinkageFailure>> {
        let nominal = self.nominal()?;
        let chunk = |index: u64| (index * CHUNK).max(sets.start)..((index + 1) * CHUNK).min(sets.end);
        let one = |mut tally: Tally, index: u64| {
            let sets = chunk(index);
            let count = sets.end - sets.start;
            self.add(&nominal, sets, &mut tally);
            progress(count);
            tally
        };
        let chunks = sets.start / CHUNK..sets.end.max(sets.start).div_ceil(CHUNK);
        Ok(chunks.into_par_iter().fold(Tally::default, one).reduce(Tally::default, |one, other| one + &other))
    }

    fn add(&self, nominal: &[Vector2<f64>; POSITIONS], sets: Range<u64>, to: &mut Tally) {
        let mut random = ChaCha8Rng::seed_from_u64(self.seed);
        let mut first = sets.start - sets.start % LANES;
        while first < sets.end {
            let four = [0, 1, 2, 3].map(|lane| self.drawn(&mut random, first + lane));
            let paths = paths(four, nominal);
            for (number, path) in (first..).zip(paths) {
                if sets.contains(&number) {
                    to.count(path.as_ref(), self);
                }
            }
            first += LANES;
        }
    }
}

/// By how much (m) each tip is off the nominal one in every position, or nothing for a linkage that cannot be turned.
fn paths(four: [Linkage; 4], nominal: &[Vector2<f64>; POSITIONS]) -> [Option<[Vector2<f64>; POSITIONS]>; 4] {
    let mut paths = [[Vector2::zeros(); POSITIONS]; 4];
    let times = positions();
    let mut together = Lockstep::<Linkage, F64x4, 4, 9>::new(four, [times[0]; 4]);
    for (position, (t, nominal)) in times.into_iter().zip(nominal).enumerate() {
        if position > 0 {
            together.advance([t; 4]);
        }
        let tip = together.mechanism().tip(&LinkageState(together.state().clone())).value;
        let off = [tip.x - F64x4::of(nominal.x), tip.y - F64x4::of(nominal.y)].map(F64x4::to_lanes);
        for (lane, path) in paths.iter_mut().enumerate() {
            path[position] = Vector2::new(off[0][lane], off[1][lane]);
        }
    }
    std::array::from_fn(|lane| together.lane(lane).is_ok().then_some(paths[lane]))
}
