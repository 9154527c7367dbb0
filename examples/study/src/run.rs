//! A study by several processes, in rounds.
//!
//! In each round a process solves a share of the next sets, as large as it can solve in the time between two checkpoints, judged by its
//! speed in the round before. Then the tallies are added, and the first process writes a checkpoint. A process that is lost costs one
//! round at most.

use std::error::Error;
use std::ops::Range;
use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

use crate::{Checkpoint, Study, Tally};

/// Sets for each process in the first round, when nobody knows how fast it is.
const FIRST: u64 = 256;
/// A share is at most this many times as large as the one before, because a short round says little about the speed.
const GROWTH: f64 = 16.0;
/// No share is larger.
const LARGEST: f64 = 1e12;
/// Where one share ends and the next one begins is a multiple of this.
const GRAIN: u64 = 4;

/// The processes that share a study. In MPI's terms, the ranks of a communicator.
pub trait Ranks {
    /// The number of this process, from 0.
    fn rank(&self) -> usize;

    /// The number of processes.
    fn size(&self) -> usize;

    /// Replaces every word by its sum over all processes. All of them call it, with as many words.
    fn sum(&self, words: &mut [i64]);
}

/// One process.
#[derive(Clone, Copy, Debug)]
pub struct Alone;

impl Ranks for Alone {
    fn rank(&self) -> usize {
        0
    }

    fn size(&self) -> usize {
        1
    }

    fn sum(&self, _: &mut [i64]) {}
}

/// A study that is to be done.
#[derive(Clone, Debug)]
pub struct Run {
    /// The study.
    pub study: Study,
    /// The number of its sets. A checkpoint with more is not reduced.
    pub sets: u64,
    /// The file to go on from and to write to.
    pub checkpoint: Option<PathBuf>,
    /// The time between two checkpoints, in s.
    pub interval: f64,
}

impl Run {
    /// Does the study together with all other processes of `ranks`, each on all of its threads. Returns the tally of all sets in each of
    /// them.
    ///
    /// * `progress`: given, called with a number of sets that are done, on any thread: those of the rounds before and those that this
    ///   process has solved since, a few numbers late or early.
    ///
    /// # Errors
    /// In the first process, if the checkpoint is not of this study, or cannot be read or written. The others still wait for it then:
    /// the caller has to end them.
    pub fn on(&self, ranks: &impl Ranks, progress: impl Fn(u64) + Sync) -> Result<Tally, Box<dyn Error>> {
        let mut tally = self.begin(ranks)?;
        let mut shares = vec![FIRST; ranks.size()];
        while tally.sets < self.sets {
            let own = share(tally.sets..self.sets, &shares, ranks.rank());
            let (begin, done) = (Instant::now(), AtomicU64::new(tally.sets));
            let count = own.end - own.start;
            let part = self.study.tally_on_all_processors(own, |count| {
                progress(done.fetch_add(count, Ordering::Relaxed) + count);
            })?;
            let speed = count as f64 / begin.elapsed().as_secs_f64();

            let mut words = part.to_words();
            let tallied = words.len();
            words.resize(tallied + ranks.size(), 0);
            words[tallied + ranks.rank()] = (speed * self.interval).min(GROWTH * count as f64).min(LARGEST) as i64;
            ranks.sum(&mut words);
            tally = tally + &Tally::from_words(&words);
            for (share, next) in shares.iter_mut().zip(&words[tallied..]) {
                // A process that had nothing to do keeps its share.
                *share = if *next > 0 { (*next as u64).next_multiple_of(GRAIN) } else { *share };
            }
            self.keep(ranks, &tally)?;
            progress(tally.sets);
        }
        Ok(tally)
    }

    /// The tally of the checkpoint, which the first process reads for all.
    fn begin(&self, ranks: &impl Ranks) -> Result<Tally, Box<dyn Error>> {
        let mut words = Tally::default().to_words();
        if let (0, Some(path)) = (ranks.rank(), &self.checkpoint) {
            words = Checkpoint::load(path, &self.study)?.to_words();
        }
        ranks.sum(&mut words);
        Ok(Tally::from_words(&words))
    }

    fn keep(&self, ranks: &impl Ranks, tally: &Tally) -> Result<(), Box<dyn Error>> {
        if let (0, Some(path)) = (ranks.rank(), &self.checkpoint) {
            Checkpoint::new(self.study, tally.clone()).save(path).map_err(|error| format!("{}: {error}", path.display()))?;
        }
        Ok(())
    }
}

/// The share of process `rank` in the sets that are left: adjacent ranges of the sizes `shares`, or of a part of each if there are not as
/// many sets. Together the shares are a beginning of `left`.
pub(crate) fn share(left: Range<u64>, shares: &[u64], rank: usize) -> Range<u64> {
    let count = left.end - left.start;
    let all: u64 = shares.iter().sum();
    let end = |rank: usize| {
        let before: u64 = shares[..rank].iter().sum();
        let scaled = if all <= count { before } else { (u128::from(before) * u128::from(count) / u128::from(all)) as u64 };
        let end = left.start + scaled;
        if rank == shares.len() { end } else { (end - end % GRAIN).max(left.start) }
    };
    end(rank)..end(rank + 1)
}
