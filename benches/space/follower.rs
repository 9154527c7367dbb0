//! What is measured: something that follows a mechanism from one time to the next and knows all of every body.

use std::hint::black_box;

use reuleaux::nalgebra::{Matrix3, Vector3};
use reuleaux::{SimdReal, SpatialBody};
use reuleaux_benches::multibody::exact::Numbers;

/// One way to follow a mechanism.
pub(crate) trait Follower {
    /// Back to t = 0.
    fn restart(&mut self);

    /// From the time before to `t` (s).
    fn step(&mut self, t: f64);

    /// All bodies after the last step, with their mass centres as origins.
    fn bodies(&self) -> Vec<SpatialBody<f64>>;

    /// All these steps, compiled together for each follower; its memory is observed after each, so that nothing is left out.
    fn sweep(&mut self, times: &[f64]) {
        self.restart();
        for &t in times {
            self.step(black_box(t));
            black_box(&*self);
        }
    }
}

/// A follower with the words for it.
pub(crate) struct Entry {
    pub(crate) name: &'static str,
    pub(crate) follower: Box<dyn Follower>,
}

impl Entry {
    pub(crate) fn new(name: &'static str, follower: impl Follower + 'static) -> Self {
        Self { name, follower: Box::new(follower) }
    }
}

/// A mechanism generated from its declaration, whose state is taken along.
pub(crate) struct Declared<M, S, A, R> {
    pub(crate) mechanism: M,
    pub(crate) origin: S,
    pub(crate) state: S,
    pub(crate) advance: A,
    pub(crate) read: R,
}

impl<M, S: Clone, A: Fn(&mut M, &mut S, f64), R: Fn(&S) -> Vec<SpatialBody<f64>>> Follower for Declared<M, S, A, R> {
    fn restart(&mut self) {
        self.state.clone_from(&self.origin);
    }

    #[inline]
    fn step(&mut self, t: f64) {
        (self.advance)(&mut self.mechanism, &mut self.state, t);
    }

    fn bodies(&self) -> Vec<SpatialBody<f64>> {
        (self.read)(&self.state)
    }
}

/// The follower of a declared mechanism; bodies are those of the expression, by the name of the state.
macro_rules! declared {
    ($mechanism:ident, $type:ident, |$state:ident| $bodies:expr) => {
        $crate::follower::declared!($mechanism, $type, |_, _| (), |$state| $bodies)
    };
    // With something that is set before each step.
    ($mechanism:ident, $type:ident, $set:expr, |$state:ident| $bodies:expr) => {{
        let mechanism = $mechanism::default();
        let origin = mechanism.solve(0.0).unwrap_or_else(|failure| panic!("{failure}"));
        let set: fn(&mut $mechanism, f64) = $set;
        $crate::follower::Entry::new(
            $crate::follower::DECLARED,
            $crate::follower::Declared {
                state: origin.clone(),
                mechanism,
                origin,
                advance: move |mechanism: &mut $mechanism, state: &mut $type<f64>, t| {
                    set(mechanism, t);
                    mechanism.advance(state, t).unwrap_or_else(|failure| panic!("{failure}"));
                },
                read: |$state: &$type<f64>| $bodies,
            },
        )
    }};
}
pub(crate) use declared;

/// What was written by hand: something that gives all bodies at a time, from what it remembers.
pub(crate) struct Hand<M, F, const B: usize> {
    origin: M,
    memory: M,
    step: F,
    bodies: [SpatialBody<f64>; B],
}

impl<M: Clone, F: Fn(&mut M, f64) -> [SpatialBody<f64>; B], const B: usize> Hand<M, F, B> {
    /// With what it remembers at t = 0.
    pub(crate) fn new(memory: M, step: F) -> Self {
        let bodies = step(&mut memory.clone(), 0.0);
        Self { origin: memory.clone(), memory, step, bodies }
    }
}

impl<M: Clone, F: Fn(&mut M, f64) -> [SpatialBody<f64>; B], const B: usize> Follower for Hand<M, F, B> {
    fn restart(&mut self) {
        self.memory.clone_from(&self.origin);
    }

    #[inline]
    fn step(&mut self, t: f64) {
        self.bodies = (self.step)(&mut self.memory, t);
    }

    fn bodies(&self) -> Vec<SpatialBody<f64>> {
        self.bodies.to_vec()
    }
}

/// Generated from the declaration.
pub(crate) const DECLARED: &str = "reuleaux";
/// By hand, with sines and cosines of the standard library.
pub(crate) const HAND: &str = "by hand";
/// By hand, with sines and cosines as generated code takes them.
pub(crate) const HAND_FAST: &str = "by hand, sine and cosine of the runtime";

/// How sine and cosine are computed.
pub(crate) trait Trigonometry: 'static {
    /// Both.
    fn of(angle: f64) -> (f64, f64);

    /// Both of several angles.
    #[inline(always)]
    fn of_each<const K: usize>(angles: [f64; K]) -> [(f64, f64); K] {
        angles.map(Self::of)
    }
}

/// `f64::sin_cos`.
pub(crate) struct Standard;

impl Trigonometry for Standard {
    #[inline(always)]
    fn of(angle: f64) -> (f64, f64) {
        angle.sin_cos()
    }
}

/// That of generated code.
pub(crate) struct Runtime;

impl Trigonometry for Runtime {
    #[inline(always)]
    fn of(angle: f64) -> (f64, f64) {
        angle.fast_sin_cos()
    }
}

/// A body in the order of the exact numbers.
pub(crate) fn numbers(body: &SpatialBody<f64>) -> Numbers {
    let rotation: [f64; 9] = std::array::from_fn(|k| body.rotation[(k / 3, k % 3)]);
    let vectors = [&body.position, &body.velocity, &body.angular_velocity, &body.acceleration, &body.angular_acceleration];
    let mut numbers = [0.0; 24];
    numbers[..9].copy_from_slice(&rotation);
    for (chunk, vector) in numbers[9..].chunks_mut(3).zip(vectors) {
        chunk.copy_from_slice(vector.as_slice());
    }
    numbers
}

/// How a frame moves: its axes as columns, angular velocity and acceleration.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turning {
    pub(crate) axes: [Vector3<f64>; 3],
    pub(crate) omega: Vector3<f64>,
    pub(crate) alpha: Vector3<f64>,
}

/// How a point moves.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point {
    pub(crate) p: Vector3<f64>,
    pub(crate) v: Vector3<f64>,
    pub(crate) a: Vector3<f64>,
}

impl Point {
    /// The point of a frame at this place from this one.
    #[inline(always)]
    pub(crate) fn beside(&self, turning: &Turning, arm: Vector3<f64>) -> Self {
        let swing = turning.omega.cross(&arm);
        Self { p: self.p + arm, v: self.v + swing, a: self.a + turning.alpha.cross(&arm) + turning.omega.cross(&swing) }
    }
}

/// A body that does not move, as ground.
pub(crate) fn resting() -> SpatialBody<f64> {
    let still = Turning { axes: [Vector3::x(), Vector3::y(), Vector3::z()], omega: Vector3::zeros(), alpha: Vector3::zeros() };
    still.body(&Point { p: Vector3::zeros(), v: Vector3::zeros(), a: Vector3::zeros() })
}

impl Turning {
    /// The body with this mass centre.
    #[inline(always)]
    pub(crate) fn body(&self, center: &Point) -> SpatialBody<f64> {
        SpatialBody {
            position: center.p,
            rotation: Matrix3::from_columns(&self.axes),
            velocity: center.v,
            angular_velocity: self.omega,
            acceleration: center.a,
            angular_acceleration: self.alpha,
        }
    }
}
