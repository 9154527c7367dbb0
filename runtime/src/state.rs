//! A solved state, and the ways to look at it.

use nalgebra::{SVector, Vector2};

use crate::{Coordinates, Float, Lanes, Real};

/// Position, velocity and acceleration of a mechanism at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct State<T, const N: usize> {
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
    /// How near to singular Φ_q is: by about how much rounding errors are multiplied in q, q̇ and q̈. 1 at best; its decimal
    /// logarithm is the number of digits lost. It grows without bound towards a dead point.
    pub condition: T,
    /// How often Φ_q was formed and factored to get here from the predicted or guessed position.
    pub iterations: usize,
    pub(crate) trend: Trend<T, N>,
}

/// What the step to a state tells about the next, beyond the state itself: a share of a prediction, and no part of what the state is,
/// so that all of them are equal.
#[derive(Clone, Debug)]
pub(crate) struct Trend<T, const N: usize> {
    /// Length of the step, in s; 0 if there was none.
    span: T,
    /// What q + h q̇ + h² q̈ / 2 leaves out in a step of the same length, in m and rad.
    pub(crate) beyond: SVector<T, N>,
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
        let (branch, condition, trend) = ([Orientation::Positive; N], T::of(1.0), Trend::none());
        Self { t, q, qd, qdd, branch, condition, iterations: 0, trend }
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
        Self { span: T::of(0.0), beyond: SVector::from_element(T::of(0.0)) }
    }
}

impl<T: Lanes, const N: usize> Trend<T, N> {
    /// How much of `beyond` there is in a step of length `h`: the cube of the quotient of the lengths. Nothing in one that is more
    /// than twice as long, as far as one cannot see.
    #[inline(always)]
    pub(crate) fn weight(&self, h: T) -> T {
        let quotient = h / self.span;
        T::pick(quotient.abs().at_most(T::of(2.0)), quotient * quotient * quotient, T::of(0.0))
    }
}

impl<T: Lanes, const N: usize> State<T, N> {
    /// Becomes the state there, `h` later, on the same branch.
    ///
    /// The trend is the polynomial of fifth degree through this state and that one, each with its rates and accelerations, less the
    /// part up to the second degree, at `h` beyond. It leaves out h⁶ / 90 times the sixth derivative.
    #[inline(always)]
    pub(crate) fn follow_on(&mut self, t: T, h: T, there: Coordinates<T, N>) {
        let square = h * h;
        for i in 0..N {
            let way = T::of(31.0) * (there.q[i] - self.q[i]);
            let rates = h * (T::of(17.0) * there.qd[i] + T::of(14.0) * self.qd[i]);
            let accelerations = square * (T::of(3.5) * there.qdd[i] - T::of(2.0) * self.qdd[i]);
            self.trend.beyond[i] = (way - rates) + accelerations;
        }
        self.trend.span = h;
        (self.t, self.q, self.qd, self.qdd) = (t, there.q, there.qd, there.qdd);
    }
}

impl<T: Float, const N: usize> State<T, N> {
    /// Where the mechanism is at `t` (s) as far as this state knows: q + h q̇ + h² q̈ / 2, h = `t` − `self.t`.
    pub(crate) fn predict(&self, t: T) -> SVector<T, N> {
        let h = t - self.t;
        SVector::from_fn(|i, _| self.q[i] + h * (self.qd[i] + h * T::of(0.5) * self.qdd[i]))
    }
}
