//! What is measured: something that is computed in each of many states.

use std::cell::LazyCell;
use std::hint::black_box;

use reuleaux_benches::multibody::Model;

/// States in which each contender computes.
pub(crate) const STATES: usize = 256;

/// A problem and everything that computes it.
pub(crate) struct Case {
    pub(crate) name: String,
    pub(crate) exact: Exact,
    /// Contenders; ratios are to the first.
    pub(crate) entries: Vec<Entry>,
    /// The same for other people's programs, if there are any.
    pub(crate) given: Option<Given>,
}

/// Exact numbers in some states, which are computed when they are asked for.
pub(crate) type Exact = LazyCell<Vec<(usize, Vec<f64>)>, Box<dyn FnOnce() -> Vec<(usize, Vec<f64>)>>>;

/// The exact numbers in one state of `every` so many.
pub(crate) fn exact_in(every: usize, of: impl Fn(usize) -> Vec<f64> + 'static) -> Exact {
    LazyCell::new(Box::new(move || (0..STATES).step_by(every).map(|k| (k, of(k))).collect()))
}

/// A problem as data.
pub(crate) struct Given {
    pub(crate) model: Model,
    /// Coordinates and rates in each state; accelerations as well if it is asked what drives them.
    pub(crate) states: Vec<Vec<Vec<f64>>>,
}

/// A contender.
pub(crate) struct Entry {
    pub(crate) name: &'static str,
    pub(crate) contender: Box<dyn Contender>,
}

impl Entry {
    /// `compute` in each of these states; `seen` is what is compared, in the order of the exact numbers. Empty if nothing is.
    pub(crate) fn new<I: 'static, O: 'static>(
        name: &'static str,
        states: Vec<I>,
        compute: impl Fn(&mut I) -> O + 'static,
        seen: impl Fn(&I, &O) -> Vec<f64> + 'static,
    ) -> Self {
        Self { name, contender: Box::new(Batch { states, compute, seen }) }
    }
}

/// What can be repeated.
pub(crate) trait Contender {
    /// This many evaluations, in all states in turn.
    fn evaluate(&mut self, count: usize);

    /// What is compared in this state.
    fn seen(&mut self, state: usize) -> Vec<f64>;
}

struct Batch<I, C, S> {
    states: Vec<I>,
    compute: C,
    seen: S,
}

impl<I, O, C: Fn(&mut I) -> O, S: Fn(&I, &O) -> Vec<f64>> Contender for Batch<I, C, S> {
    fn evaluate(&mut self, count: usize) {
        let states = self.states.len();
        for k in 0..count {
            black_box((self.compute)(black_box(&mut self.states[k % states])));
        }
    }

    fn seen(&mut self, state: usize) -> Vec<f64> {
        let found = (self.compute)(&mut self.states[state]);
        (self.seen)(&self.states[state], &found)
    }
}

/// Generated from the declaration.
pub(crate) const ACCELERATIONS: &str = "reuleaux, accelerations in closed form";
/// The forces in all joints.
pub(crate) const LOADS: &str = "reuleaux, loads";
/// Both.
pub(crate) const BOTH: &str = "reuleaux, the state and its loads";
/// By hand.
pub(crate) const HAND: &str = "by hand, accelerations and loads";
/// By hand, where all is driven.
pub(crate) const HAND_DRIVEN: &str = "by hand, motion and loads";
/// By hand, where all is driven, with what a state holds.
pub(crate) const HAND_ANGLES: &str = "by hand, motion with angles, and loads";
/// Where all is driven.
pub(crate) const STEP: &str = "reuleaux, a step and its loads";
/// Loads by hand.
pub(crate) const HAND_LOADS: &str = "by hand, loads";
/// Accelerations by hand.
pub(crate) const HAND_ACCELERATIONS: &str = "by hand, accelerations";
