//! A solved state, and the ways to look at it.

use core::ops::{Deref, DerefMut};

use nalgebra::{SVector, Vector2};

use crate::continuation::Stride;
use crate::{Coordinates, Float, Lanes, Mask, Real};

/// Position, velocity and acceleration of a mechanism at one instant.
///
/// Its fields are those of [`Values`]: `state.q`, `state.t` and so on. They may be written to, and what was written is where the next
/// step sets out from; but nothing of such a state is taken for solved any more.
#[derive(Clone, Debug, PartialEq)]
pub struct State<T, const N: usize> {
    pub(crate) values: Values<T, N>,
    /// Of the parameters that it was solved with; 0 if it was not.
    pub(crate) mark: u64,
    pub(crate) trend: Trend<T, N>,
}

/// What a [`State`] tells.
#[derive(Clone, Debug, PartialEq)]
pub struct Values<T, const N: usize> {
    /// Time in s.
    pub t: T,
    /// Coordinates in m and rad.
    pub q: SVector<T, N>,
    /// Their rates q̇ in m/s and rad/s.
    pub qd: SVector<T, N>,
    /// Their accelerations q̈ in m/s² and rad/s².
    pub qdd: SVector<T, N>,
    /// The name of the branch: for each block the sign of the determinant of its Jacobian, at the index of the block's first
    /// unknown. A sign changes only where the block is singular.
    pub branch: [Orientation; N],
    /// How near to singular Φ_q is, of the blocks that were solved for this state (not those that rest): rounding errors are
    /// multiplied in q by about as much. 1 at best; its decimal logarithm is the number of digits that q has lost. Near a dead point
    /// q̇ loses twice as many, and q̈ three times as many; `error_bound` says how many, and `polish` wins them back.
    pub condition: T,
    /// How often Φ_q was formed and factored to get here from the predicted or guessed position.
    pub iterations: usize,
}

impl<T, const N: usize> Deref for State<T, N> {
    type Target = Values<T, N>;

    #[inline(always)]
    fn deref(&self) -> &Values<T, N> {
        &self.values
    }
}

impl<T, const N: usize> DerefMut for State<T, N> {
    /// What is written to was not solved.
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut Values<T, N> {
        self.mark = 0;
        &mut self.values
    }
}

/// What the step to a state tells about the next, beyond the state itself: a help for predictions, and no part of what the state is,
/// so that all of them are equal.
///
/// ```text
/// e = 31 (q − q₀) − s (17 q̇ + 14 q̇₀) + s² (7 q̈ / 2 − 2 q̈₀)      s: length of the step, from q₀, q̇₀, q̈₀
/// ```
///
/// is what q + s q̇ + s² q̈ / 2 leaves out one such step further on, by the polynomial of fifth degree through both states, their
/// rates and their accelerations; it is wrong by s⁶ / 90 times the sixth derivative.
#[derive(Clone, Debug)]
pub(crate) struct Trend<T, const N: usize> {
    /// s, in s; 0 if there was no step.
    pub(crate) span: T,
    /// e but for the term with q̈, in m and rad.
    pub(crate) rest: SVector<T, N>,
}

/// The sign of a determinant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Orientation {
    /// Above zero.
    Positive,
    /// Below zero.
    Negative,
}

/// A quantity with its first and second derivative by time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<V> {
    /// The quantity.
    pub value: V,
    /// Its first derivative, per s.
    pub rate: V,
    /// Its second derivative, per s².
    pub acceleration: V,
}

/// The motion of a planar body: of its frame's origin and of its angle, in ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarBody<T> {
    /// (x, y) in m.
    pub position: Vector2<T>,
    /// φ in rad, not wrapped.
    pub angle: T,
    /// (ẋ, ẏ) in m/s.
    pub velocity: Vector2<T>,
    /// φ̇ in rad/s.
    pub angular_velocity: T,
    /// (ẍ, ÿ) in m/s².
    pub acceleration: Vector2<T>,
    /// φ̈ in rad/s².
    pub angular_acceleration: T,
}

impl<T: Real, const N: usize> State<T, N> {
    /// The motion of coordinate `index`; NaN where there is none with this index.
    #[must_use]
    pub fn coordinate(&self, index: usize) -> Motion<T> {
        let of = |vector: &SVector<T, N>| vector.get(index).copied().unwrap_or(T::of(f64::NAN));
        Motion { value: of(&self.q), rate: of(&self.qd), acceleration: of(&self.qdd) }
    }

    /// The motion of the point whose x and y begin at index `first`; NaN where there is none.
    #[must_use]
    pub fn point(&self, first: usize) -> Motion<Vector2<T>> {
        let [x, y] = [0, 1].map(|offset| self.coordinate(first.saturating_add(offset)));
        let vector = |of: fn(&Motion<T>) -> T| Vector2::new(of(&x), of(&y));
        Motion { value: vector(|part| part.value), rate: vector(|part| part.rate), acceleration: vector(|part| part.acceleration) }
    }

    /// The state of these coordinates alone.
    pub(crate) fn part<const P: usize>(&self, held: &[usize; P]) -> State<T, P> {
        let pick = |vector: &SVector<T, N>| SVector::from_fn(|k, _| vector.get(held[k]).copied().unwrap_or(T::of(f64::NAN)));
        let branch = held.map(|i| self.branch.get(i).copied().unwrap_or(Orientation::Positive));
        let trend = Trend { span: self.trend.span, rest: pick(&self.trend.rest) };
        let Values { t, condition, iterations, .. } = self.values;
        let values = Values { t, q: pick(&self.q), qd: pick(&self.qd), qdd: pick(&self.qdd), branch, condition, iterations };
        State { values, mark: 0, trend }
    }

    /// Takes back what became of a part; the rest rests.
    pub(crate) fn take<const P: usize>(&mut self, held: &[usize; P], part: &State<T, P>) {
        for (k, &i) in held.iter().enumerate() {
            if i < N {
                let there = &mut self.values;
                (there.q[i], there.qd[i], there.qdd[i]) = (part.q[k], part.qd[k], part.qdd[k]);
                self.trend.rest[i] = part.trend.rest[k];
            }
        }
        let there = &mut self.values;
        (there.t, there.condition, there.iterations) = (part.t, part.condition, part.iterations);
        self.trend.span = part.trend.span;
    }

    /// The motion of the body whose x, y and φ begin at index `first`.
    #[must_use]
    pub fn planar_body(&self, first: usize) -> PlanarBody<T> {
        let [x, y, angle] = [0, 1, 2].map(|offset| self.coordinate(first.saturating_add(offset)));
        PlanarBody {
            position: Vector2::new(x.value, y.value),
            angle: angle.value,
            velocity: Vector2::new(x.rate, y.rate),
            angular_velocity: angle.rate,
            acceleration: Vector2::new(x.acceleration, y.acceleration),
            angular_acceleration: angle.acceleration,
        }
    }
}

impl<T: Real> PlanarBody<T> {
    /// The motion of the point of this body with the local coordinates s' (m).
    ///
    /// ```text
    /// r_P = r + A s'      A = [cos φ  −sin φ; sin φ  cos φ],  B = dA/dφ
    /// ṙ_P = ṙ + B s' φ̇
    /// r̈_P = r̈ + B s' φ̈ − A s' φ̇²
    /// ```
    #[must_use]
    pub fn point(&self, local: Vector2<T>) -> Motion<Vector2<T>> {
        let (sine, cosine) = self.angle.sin_cos();
        let turned = [cosine * local[0] - sine * local[1], sine * local[0] + cosine * local[1]];
        let across = [-turned[1], turned[0]];
        let square = self.angular_velocity * self.angular_velocity;
        let vector = |entry: &dyn Fn(usize) -> T| Vector2::new(entry(0), entry(1));
        Motion {
            value: vector(&|i| self.position[i] + turned[i]),
            rate: vector(&|i| self.velocity[i] + across[i] * self.angular_velocity),
            acceleration: vector(&|i| self.acceleration[i] + (across[i] * self.angular_acceleration - turned[i] * square)),
        }
    }
}

impl<T: Real, const N: usize> State<T, N> {
    /// A state that was not solved for: a moment (s), positions (m, rad), rates and accelerations.
    #[must_use]
    pub fn new(t: T, q: SVector<T, N>, qd: SVector<T, N>, qdd: SVector<T, N>) -> Self {
        let (branch, condition) = ([Orientation::Positive; N], T::of(1.0));
        Self::solved(Values { t, q, qd, qdd, branch, condition, iterations: 0 }, 0)
    }

    /// A state that was solved for, with parameters of this mark.
    pub(crate) fn solved(values: Values<T, N>, mark: u64) -> Self {
        Self { values, mark, trend: Trend::none() }
    }

    /// The values, to write to without the state being any the wiser: for tests of what a step leaves as it is.
    #[doc(hidden)]
    pub fn in_secret(&mut self) -> &mut Values<T, N> {
        &mut self.values
    }
}

impl<T, const N: usize> PartialEq for Trend<T, N> {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl<T: Real, const N: usize> Trend<T, N> {
    /// Nothing is known.
    pub(crate) fn none() -> Self {
        Self { span: T::of(0.0), rest: SVector::from_element(T::of(0.0)) }
    }
}

impl<T: Lanes, const N: usize> Trend<T, N> {
    /// What q̇, q̈ and `rest` are multiplied by in a step of length `h`: e counts with the cube of the quotient of the lengths, and not
    /// at all where the step is more than twice as long, as far as one cannot see.
    #[inline(always)]
    pub(crate) fn weights(&self, h: T) -> [T; 3] {
        let quotient = h / self.span;
        let weight = T::pick(quotient.abs().at_most(T::of(2.0)), quotient * quotient * quotient, T::of(0.0));
        [h, T::of(0.5) * (h * h) + weight * (T::of(3.5) * (self.span * self.span)), weight]
    }
}

impl<T: Lanes, const N: usize> State<T, N> {
    /// Takes note of what a step of `h` (s) tells about the next, in the lanes in which it was found; the sum of the accelerations of
    /// the `iterated` unknowns.
    #[inline(always)]
    pub(crate) fn extrapolate(&mut self, h: T, found: T::Mask, there: &Coordinates<T, N>, iterated: &[usize]) -> T {
        let twice = T::of(2.0) * (h * h);
        let mut sum = T::of(0.0);
        for &i in iterated {
            if i < N {
                let rates = T::of(17.0) * there.qd[i] + T::of(14.0) * self.qd[i];
                let rest = (T::of(31.0) * (there.q[i] - self.q[i]) - twice * self.qdd[i]) - h * rates;
                self.trend.rest[i] = T::pick(found, rest, self.trend.rest[i]);
                sum = sum + there.qdd[i];
            }
        }
        sum
    }

    /// Nothing is known any more in the lanes in which a step was not found.
    #[cold]
    pub(crate) fn forget_trend(&mut self, found: T::Mask) {
        self.trend.span = T::pick(found, self.trend.span, T::of(0.0));
    }

    /// Becomes the state at `t`, on the same branch, in the lanes in which it was found.
    #[inline(always)]
    pub(crate) fn follow_on(&mut self, t: T, stride: &Stride<T>, there: &Coordinates<T, N>) {
        let (&Stride { h, found, condition, iterations }, Coordinates { q, qd, qdd }) = (stride, there);
        let here = &mut self.values;
        here.iterations = iterations;
        if found.all() {
            (self.trend.span, here.condition) = (h, condition);
            (here.t, here.q, here.qd, here.qdd) = (t, *q, *qd, *qdd);
        } else {
            let pick = |then, otherwise| T::pick(found, then, otherwise);
            (self.trend.span, here.condition) = (pick(h, self.trend.span), pick(condition, here.condition));
            here.t = pick(t, here.t);
            (here.q, here.qd, here.qdd) = (q.zip_map(&here.q, pick), qd.zip_map(&here.qd, pick), qdd.zip_map(&here.qdd, pick));
        }
    }
}

impl<T: Float, const N: usize> State<T, N> {
    /// Where the mechanism is at `t` (s) as far as this state knows: q + h q̇ + h² q̈ / 2, h = `t` − `self.t`.
    pub(crate) fn predict(&self, t: T) -> SVector<T, N> {
        let h = t - self.t;
        SVector::from_fn(|i, _| self.q[i] + h * (self.qd[i] + h * T::of(0.5) * self.qdd[i]))
    }
}
