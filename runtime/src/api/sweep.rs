//! States at many times.

use core::iter::FusedIterator;

use super::Mechanism;
use crate::explain::Failure;
use crate::number::{Float, Time, Times};
use crate::state::State;

/// The states of a mechanism at these [`Times`] (s), as [`Mechanism::sweep`] gives them, by an iterator that owns the mechanism.
pub fn sweep<E, T, const N: usize>(mechanism: E, times: impl Times<T>) -> impl Iterator<Item = Result<State<T, N>, Failure<T, N>>>
where
    E: Mechanism<T, N>,
    T: Float,
{
    let mut progress = Progress::Fresh;
    let mut times = times.into_iter();
    core::iter::from_fn(move || next(&mechanism, &mut times, &mut progress))
}

/// Iterator over the states of a mechanism at given times; see [`Mechanism::sweep`].
#[derive(Clone, Debug)]
pub struct Sweep<'a, E: ?Sized, I, T, const N: usize> {
    mechanism: &'a E,
    times: I,
    progress: Progress<State<T, N>>,
}

/// Progress of a sweep.
#[derive(Clone, Debug)]
enum Progress<S> {
    Fresh,
    At(S),
    Ended,
}

impl<'a, E: ?Sized, I, T, const N: usize> Sweep<'a, E, I, T, N> {
    pub(crate) fn new(mechanism: &'a E, times: I) -> Self {
        Self { mechanism, times, progress: Progress::Fresh }
    }
}

impl<E, I, T, const N: usize> Iterator for Sweep<'_, E, I, T, N>
where
    E: Mechanism<T, N>,
    I: Iterator<Item: Time<T>>,
    T: Float,
{
    type Item = Result<State<T, N>, Failure<T, N>>;

    fn next(&mut self) -> Option<Self::Item> {
        next(self.mechanism, &mut self.times, &mut self.progress)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        match self.progress {
            Progress::Ended => (0, Some(0)),
            // A failure may end the sweep at once after the next state.
            _ => (self.times.size_hint().0.min(1), self.times.size_hint().1),
        }
    }
}

impl<E, I, T, const N: usize> FusedIterator for Sweep<'_, E, I, T, N>
where
    E: Mechanism<T, N>,
    I: Iterator<Item: Time<T>>,
    T: Float,
{
}

/// The next state of a sweep; ends after a failure.
fn next<E, T, const N: usize>(
    mechanism: &E,
    times: &mut impl Iterator<Item: Time<T>>,
    progress: &mut Progress<State<T, N>>,
) -> Option<Result<State<T, N>, Failure<T, N>>>
where
    E: Mechanism<T, N>,
    T: Float,
{
    if matches!(progress, Progress::Ended) {
        return None;
    }
    let Some(t) = times.next().map(Time::time) else {
        *progress = Progress::Ended;
        return None;
    };
    if let Progress::At(state) = progress {
        if let Err(failure) = mechanism.advance(state, t) {
            *progress = Progress::Ended;
            return Some(Err(failure));
        }
        return Some(Ok(state.clone()));
    }
    let result = mechanism.solve(t);
    *progress = result.as_ref().map_or(Progress::Ended, |state| Progress::At(state.clone()));
    Some(result)
}
