//! Contenders: they follow a linkage from one time to the next.

use reuleaux::nalgebra::Vector2;
use reuleaux::{Mechanism, Motion, State};
use std::hint::black_box;

use crate::hand::Point;

/// The tracked point as a contender has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// Where it is, in m.
    pub place: [f64; 2],
    /// Its acceleration in m/s², if the contender computes accelerations.
    pub acceleration: Option<[f64; 2]>,
}

impl Seen {
    /// Place and acceleration of a point.
    #[must_use]
    pub fn of(point: &Point) -> Self {
        Self { place: point.p.into(), acceleration: Some(point.a.into()) }
    }
}

/// One way to follow a linkage in time.
pub trait Contender {
    /// Back to t = 0.
    fn restart(&mut self);

    /// From the time before to `t` (s).
    fn step(&mut self, t: f64);

    /// The tracked point after the last step.
    fn seen(&self) -> Seen;

    /// All these steps, compiled together for each contender; its memory is observed after each, so that none is left out.
    fn sweep(&mut self, times: &[f64]) {
        self.restart();
        for &t in times {
            self.step(black_box(t));
            black_box(&*self);
        }
    }
}

/// A contender with the words for it.
pub struct Entry {
    /// Its method.
    pub name: &'static str,
    /// The residual at which it stops iterating, if it was told one.
    pub tolerance: Option<f64>,
    /// Itself.
    pub contender: Box<dyn Contender>,
}

impl Entry {
    /// A contender that has no tolerance.
    pub fn new(name: &'static str, contender: impl Contender + 'static) -> Self {
        Self { name, tolerance: None, contender: Box::new(contender) }
    }

    /// The same method once for each tolerance.
    pub fn each<'a, C: Contender + 'static>(
        name: &'static str,
        tolerances: &'a [f64],
        contender: impl Fn(f64) -> C + 'a,
    ) -> impl Iterator<Item = Entry> + 'a {
        tolerances.iter().map(move |&tolerance| Entry { name, tolerance: Some(tolerance), contender: Box::new(contender(tolerance)) })
    }
}

/// What reads the tracked point off a state of a generated mechanism.
pub type Output<E, const N: usize> = fn(&E, &State<f64, N>) -> Motion<Vector2<f64>>;

/// A generated mechanism, whose state is taken along.
pub struct Generated<E, const N: usize> {
    mechanism: E,
    output: Output<E, N>,
    origin: State<f64, N>,
    state: State<f64, N>,
}

impl<E: Mechanism<f64, N>, const N: usize> Generated<E, N> {
    /// The mechanism assembled at t = 0; `output` is the tracked point.
    ///
    /// # Panics
    /// If it cannot be assembled, which would be the end of the benchmark.
    pub fn new(mechanism: E, output: Output<E, N>) -> Self {
        let origin = mechanism.solve(0.0).unwrap_or_else(|failure| panic!("{failure}"));
        Self { mechanism, output, state: origin.clone(), origin }
    }
}

impl<E: Mechanism<f64, N>, const N: usize> Contender for Generated<E, N> {
    fn restart(&mut self) {
        self.state.clone_from(&self.origin);
    }

    #[inline]
    fn step(&mut self, t: f64) {
        self.mechanism.advance(&mut self.state, t).unwrap_or_else(|failure| panic!("{failure}"));
    }

    fn seen(&self) -> Seen {
        let motion = (self.output)(&self.mechanism, &self.state);
        Seen { place: motion.value.into(), acceleration: Some(motion.acceleration.into()) }
    }
}
