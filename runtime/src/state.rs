//! A solved state, and the ways to look at it.

use nalgebra::{SVector, Vector2};

use crate::{Float, Real};

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

impl<T: Float, const N: usize> State<T, N> {
    /// Where the mechanism is at `t` (s) as far as this state knows: q + h q̇ + h² q̈ / 2, h = `t` − `self.t`.
    pub(crate) fn predict(&self, t: T) -> SVector<T, N> {
        let h = t - self.t;
        SVector::from_fn(|i, _| self.q[i] + h * (self.qd[i] + h * T::of(0.5) * self.qdd[i]))
    }
}
