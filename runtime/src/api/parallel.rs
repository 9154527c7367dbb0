//! Sweeps of many mechanisms on all processors (feature `rayon`).
//!
//! In: parameter sets, times, and a function of each sweep. Out: its results, in the order of the parameter sets. Each sweep runs
//! on one thread from beginning to end, so that its numbers are those of a sweep alone.

use core::sync::atomic::{AtomicUsize, Ordering};
use std::vec::Vec;

use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};

use super::{Mechanism, Sweep};
use crate::number::Float;

/// The number of completed sweeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Completed sweeps, including this one.
    pub done: usize,
    /// All sweeps.
    pub of: usize,
}

/// Sweeps each mechanism over the same times (s) and collects the results of `each`, in the order of `mechanisms`.
///
/// * `each`: given, called once for each mechanism with its sweep, on any thread. Only its result is kept, so that a sweep of a million
///   times may leave a single number.
/// * `progress`: given, called after each sweep on the thread of that sweep, possibly several times at once; each value of `done` from 1
///   to `of` occurs once. Between calls the threads share nothing, neither a lock nor a counter.
///
/// With `indicatif`, use `|progress| bar.set_position(progress.done as u64)`. Without it:
///
/// ```
/// use reuleaux::parallel::sweeps;
///
/// reuleaux::mechanism! {
///     /// A slider-crank.
///     mechanism Engine {
///         param rod_length: Length = 150mm;
///         ground { point O = (0mm, 0mm);  axis u = (1, 0); }
///         body crank  { point O = (0mm, 0mm);  point A = (50mm, 0mm); }
///         body rod    { point A = (0mm, 0mm);  point B = (rod_length, 0mm);  start angle = 0deg; }
///         body piston { point B = (0mm, 0mm); }
///         joint o = revolute(ground.O, crank.O);
///         joint a = revolute(crank.A, rod.A);
///         joint b = revolute(rod.B, piston.B);
///         joint guide = translational(ground.u, ground.O, piston.B);
///         drive input = drive_angle(crank, 50rpm * t);
///     }
/// }
///
/// let engines: Vec<Engine> = (0..20).map(|step| Engine { rod_length: 0.1 + 0.01 * f64::from(step) }).collect();
/// let times: Vec<f64> = (0..600).map(|step| f64::from(step) / 500.0).collect();
/// let peaks = sweeps(
///     &engines,
///     &times,
///     // The largest acceleration of the piston, or why there is none.
///     |engine| engine.map(|state| Ok(state?.qdd[6].abs())).try_fold(0.0_f64, |peak, next| next.map(|next| peak.max(next))),
///     |progress| assert!(progress.done <= progress.of),
/// );
/// let peaks: Vec<f64> = peaks.into_iter().collect::<Result<_, reuleaux::Failure<f64, 9>>>()?;
/// // The longer the rod, the gentler the piston.
/// assert!(peaks.windows(2).all(|pair| pair[0] > pair[1]));
/// # Ok::<(), reuleaux::Failure<f64, 9>>(())
/// ```
pub fn sweeps<M, T, R, const N: usize>(
    mechanisms: &[M],
    times: &[T],
    each: impl Fn(Sweep<'_, M, core::iter::Copied<core::slice::Iter<'_, T>>, T, N>) -> R + Sync,
    progress: impl Fn(Progress) + Sync,
) -> Vec<R>
where
    M: Mechanism<T, N> + Sync,
    T: Float + Sync,
    R: Send,
{
    let (done, of) = (AtomicUsize::new(0), mechanisms.len());
    let one = |mechanism: &M| {
        let result = each(mechanism.sweep(times.iter().copied()));
        progress(Progress { done: done.fetch_add(1, Ordering::Relaxed) + 1, of });
        result
    };
    mechanisms.par_iter().with_max_len(1).map(one).collect()
}
