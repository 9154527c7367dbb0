//! Studies of many mechanisms on all processors (feature `rayon`).
//!
//! In: mechanisms, and a function of one of them. Out: its results, in the order of the mechanisms. Each is computed on one thread from beginning to
//! end, so that its numbers are those of a program that computes it alone.

use core::sync::atomic::{AtomicUsize, Ordering};
use std::vec::Vec;

#[doc(no_inline)]
pub use rayon;
use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};

/// The number of mechanisms that are done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Progress {
    /// Mechanisms that are done, including this one.
    pub done: usize,
    /// All mechanisms.
    pub of: usize,
}

/// Calls `study` for each mechanism and collects its results, in the order of `mechanisms`.
///
/// * `mechanisms`: given, a list, or what [`rayon`] takes in its place: `(0..n).into_par_iter().map(…)` makes each mechanism when its turn comes.
/// * `study`: given, called once for each mechanism, on any thread. Only its result is kept, so that a sweep of a million times may leave a single
///   number.
/// * `progress`: given, called after each mechanism on its thread, possibly several times at once; each value of `done` from 1 to `of` occurs once.
///   Between calls the threads share nothing, neither a lock nor a counter.
///
/// With `indicatif`, use `|progress| bar.set_position(progress.done as u64)`. Without it:
///
/// ```
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
/// /// The largest acceleration of the piston in a turn, or why there is none.
/// fn peak(engine: &Engine) -> Result<f64, EngineFailure> {
///     let mut accelerations = engine.sweep((0..600).map(|step| f64::from(step) / 500.0)).map(|state| Ok(state?.piston().acceleration.x));
///     accelerations.try_fold(0.0_f64, |peak, next| next.map(|next: f64| peak.max(next.abs())))
/// }
///
/// let engines: Vec<Engine> = (0..20).map(|step| Engine { rod_length: 0.1 + 0.01 * f64::from(step) }).collect();
/// let peaks = reuleaux::parallel::each(&engines, peak, |progress| assert!(progress.done <= progress.of));
/// let peaks: Vec<f64> = peaks.into_iter().collect::<Result<_, _>>()?;
/// // The longer the rod, the gentler the piston.
/// assert!(peaks.windows(2).all(|pair| pair[0] > pair[1]));
/// # Ok::<(), EngineFailure>(())
/// ```
pub fn each<P, R>(mechanisms: P, study: impl Fn(P::Item) -> R + Sync, progress: impl Fn(Progress) + Sync) -> Vec<R>
where
    P: IntoParallelIterator<Iter: IndexedParallelIterator>,
    R: Send,
{
    let mechanisms = mechanisms.into_par_iter();
    let (done, of) = (AtomicUsize::new(0), mechanisms.len());
    let one = |mechanism: P::Item| {
        let result = study(mechanism);
        progress(Progress { done: done.fetch_add(1, Ordering::Relaxed) + 1, of });
        result
    };
    mechanisms.with_max_len(1).map(one).collect()
}
