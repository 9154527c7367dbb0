//! Points and bodies in motion, as a state shows them.

use nalgebra::{Matrix3, Quaternion, SVector, Unit, UnitQuaternion, Vector2, Vector3};

use crate::number::{Real, Scalar};

/// A quantity with its first and second derivative by time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Motion<V> {
    /// The quantity.
    pub value: V,
    /// Its first derivative, per s.
    pub rate: V,
    /// Its second derivative, per s².
    pub acceleration: V,
}

/// A quantity that contains velocities, with its first derivative by time: the second one would need the third derivatives of the
/// coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ValueAndRate<V> {
    /// The quantity.
    pub value: V,
    /// Its first derivative, per s.
    pub rate: V,
}

/// A quantity with its first three derivatives by time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct MotionWithJerk<V> {
    /// The quantity.
    pub value: V,
    /// Its first derivative, per s.
    pub rate: V,
    /// Its second derivative, per s².
    pub acceleration: V,
    /// Its third derivative, per s³.
    pub jerk: V,
}

impl<V> MotionWithJerk<V> {
    /// The same without the third derivative.
    #[must_use]
    pub fn motion(self) -> Motion<V> {
        Motion { value: self.value, rate: self.rate, acceleration: self.acceleration }
    }
}

impl<V> Motion<V> {
    /// The same with a third derivative.
    #[must_use]
    pub fn with_jerk(self, jerk: V) -> MotionWithJerk<V> {
        MotionWithJerk { value: self.value, rate: self.rate, acceleration: self.acceleration, jerk }
    }

    /// The rate as a quantity of its own, whose rate is the acceleration.
    #[must_use]
    pub fn of_rate(self) -> ValueAndRate<V> {
        ValueAndRate { value: self.rate, rate: self.acceleration }
    }
}

impl<T: Real> Motion<T> {
    /// A quantity at rest.
    #[must_use]
    pub fn at(value: T) -> Self {
        Self::moving(value, T::of(0.0))
    }

    /// A quantity that changes at a constant rate (per s).
    #[must_use]
    pub fn moving(value: T, rate: T) -> Self {
        Self::new(value, rate, T::of(0.0))
    }

    /// A quantity with its first and second derivative by time.
    #[must_use]
    pub const fn new(value: T, rate: T, acceleration: T) -> Self {
        Self { value, rate, acceleration }
    }

    /// On a smooth way: the polynomial of fifth degree that has the value, the rate and the acceleration of `from` at its begin and those
    /// of `to` at its end, after the share `share` of its duration `h` (s).
    /// Rates and accelerations at the ends count as those over the time `felt`: h, or 0 for a way from rest to rest.
    ///
    /// ```text
    /// x = x₀ + h ẋ₀ s + h² ẍ₀ s² / 2 + s³ (c₃ + s (c₄ + s c₅))
    /// ```
    #[doc(hidden)]
    #[must_use]
    pub fn between(from: &Self, to: &Self, [h, felt]: [T; 2], share: T) -> Self {
        let (of, s) = (T::of, share);
        let (first, second) = (felt * from.rate, felt * felt * from.acceleration);
        let value = ((to.value - from.value) - first) - of(0.5) * second;
        let rate = felt * (to.rate - from.rate) - second;
        let acceleration = felt * felt * (to.acceleration - from.acceleration);
        let c3 = of(10.0) * value - of(4.0) * rate + of(0.5) * acceleration;
        let c4 = of(7.0) * rate - of(15.0) * value - acceleration;
        let c5 = of(6.0) * value - of(3.0) * rate + of(0.5) * acceleration;
        Self {
            value: from.value + s * (first + s * (of(0.5) * second + s * (c3 + s * (c4 + s * c5)))),
            rate: (first + s * (second + s * (of(3.0) * c3 + s * (of(4.0) * c4 + s * of(5.0) * c5)))) / h,
            acceleration: (second + s * (of(6.0) * c3 + s * (of(12.0) * c4 + s * of(20.0) * c5))) / (h * h),
        }
    }
}

impl<T: Real, const D: usize> Motion<SVector<T, D>> {
    /// A vector at rest.
    #[must_use]
    pub fn fixed(value: SVector<T, D>) -> Self {
        let zero = SVector::from_element(T::of(0.0));
        Self { value, rate: zero, acceleration: zero }
    }
}

impl<T: Scalar> Motion<T> {
    /// The same angle with as many whole turns as bring it nearest to `other` (rad): for an encoder that begins anew after each turn.
    ///
    /// ```
    /// use core::f64::consts::TAU;
    /// use reuleaux::Motion;
    ///
    /// let read = Motion::moving(0.1, 5.0);            // just after the encoder began anew
    /// let angle = read.nearest_turn(TAU - 0.05);      // where the crank was before
    /// assert!((angle.value - (TAU + 0.1)).abs() < 1e-15 && angle.rate == 5.0);
    /// ```
    #[must_use]
    pub fn nearest_turn(self, other: T) -> Self {
        let turn = T::of(core::f64::consts::TAU);
        let turns = libm::rint(((other - self.value) / turn).to_f64());
        Self { value: self.value + T::of(turns) * turn, ..self }
    }
}

impl<T: Real> From<T> for Motion<T> {
    /// A quantity at rest.
    fn from(value: T) -> Self {
        Self::at(value)
    }
}

impl<V> From<[V; 3]> for Motion<V> {
    /// A quantity by its value, its rate and its acceleration.
    ///
    /// ```
    /// let theta: reuleaux::Motion<f64> = [0.1, 5.0, 0.0].into();
    /// assert_eq!(theta, reuleaux::Motion::moving(0.1, 5.0));
    /// ```
    fn from([value, rate, acceleration]: [V; 3]) -> Self {
        Self { value, rate, acceleration }
    }
}

/// The motion of a planar body: of its frame's origin and of its angle, in ground.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "T: Real + serde::Serialize", deserialize = "T: Real + serde::Deserialize<'de>")))]
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
        let arm = self.vector(local);
        let sum = |a: &Vector2<T>, b: Vector2<T>| Vector2::new(a[0] + b[0], a[1] + b[1]);
        Motion {
            value: sum(&self.position, arm.value),
            rate: sum(&self.velocity, arm.rate),
            acceleration: sum(&self.acceleration, arm.acceleration),
        }
    }

    /// The motion of a vector fixed in this body, from its local components v'.
    ///
    /// ```text
    /// v = A v',   v̇ = B v' φ̇,   v̈ = B v' φ̈ − A v' φ̇²
    /// ```
    #[must_use]
    pub fn vector(&self, local: Vector2<T>) -> Motion<Vector2<T>> {
        let (sine, cosine) = self.angle.sin_cos();
        let turned = [cosine * local[0] - sine * local[1], sine * local[0] + cosine * local[1]];
        let across = [-turned[1], turned[0]];
        let square = self.angular_velocity * self.angular_velocity;
        let vector = |entry: &dyn Fn(usize) -> T| Vector2::new(entry(0), entry(1));
        Motion {
            value: vector(&|i| turned[i]),
            rate: vector(&|i| across[i] * self.angular_velocity),
            acceleration: vector(&|i| across[i] * self.angular_acceleration - turned[i] * square),
        }
    }
}

/// The motion of a body in space: of its frame's origin and of its orientation, in ground.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "T: Real + serde::Serialize", deserialize = "T: Real + serde::Deserialize<'de>")))]
pub struct SpatialBody<T> {
    /// (x, y, z) in m.
    pub position: Vector3<T>,
    /// A, whose columns are the axes of the body's frame.
    pub rotation: Matrix3<T>,
    /// (ẋ, ẏ, ż) in m/s.
    pub velocity: Vector3<T>,
    /// ω in rad/s.
    pub angular_velocity: Vector3<T>,
    /// (ẍ, ÿ, z̈) in m/s².
    pub acceleration: Vector3<T>,
    /// ω̇ in rad/s².
    pub angular_acceleration: Vector3<T>,
}

impl<T: Real> SpatialBody<T> {
    /// The motion of the point of this body with the local coordinates s' (m).
    ///
    /// ```text
    /// r_P = r + A s'
    /// ṙ_P = ṙ + ω × A s'
    /// r̈_P = r̈ + ω̇ × A s' + ω × (ω × A s')
    /// ```
    #[must_use]
    pub fn point(&self, local: Vector3<T>) -> Motion<Vector3<T>> {
        let arm = self.turned(local);
        let swing = cross(self.angular_velocity, arm);
        let (along, inward) = (cross(self.angular_acceleration, arm), cross(self.angular_velocity, swing));
        let sum = |a: &Vector3<T>, b: Vector3<T>| Vector3::new(a[0] + b[0], a[1] + b[1], a[2] + b[2]);
        Motion {
            value: sum(&self.position, arm),
            rate: sum(&self.velocity, swing),
            acceleration: sum(&sum(&self.acceleration, along), inward),
        }
    }

    /// The motion of a vector fixed in this body, from its local components v'.
    ///
    /// ```text
    /// v = A v',   v̇ = ω × v,   v̈ = ω̇ × v + ω × (ω × v)
    /// ```
    #[must_use]
    pub fn vector(&self, local: Vector3<T>) -> Motion<Vector3<T>> {
        let value = self.turned(local);
        let rate = cross(self.angular_velocity, value);
        let (along, inward) = (cross(self.angular_acceleration, value), cross(self.angular_velocity, rate));
        Motion { value, rate, acceleration: Vector3::new(along[0] + inward[0], along[1] + inward[1], along[2] + inward[2]) }
    }

    /// A v'
    fn turned(&self, local: Vector3<T>) -> Vector3<T> {
        let row = |i: usize| self.rotation[(i, 0)] * local[0] + self.rotation[(i, 1)] * local[1] + self.rotation[(i, 2)] * local[2];
        Vector3::new(row(0), row(1), row(2))
    }
}

impl<T: Scalar> SpatialBody<T> {
    /// The orientation as a unit quaternion whose real part is not negative: Shepperd's method, which divides by the largest component.
    #[must_use]
    pub fn orientation(&self) -> UnitQuaternion<T> {
        let a = |i: usize, j: usize| self.rotation[(i, j)];
        let (one, half) = (T::of(1.0), T::of(0.5));
        let trace = a(0, 0) + a(1, 1) + a(2, 2);
        // 4 e² of each component.
        let squares =
            [one + trace, one + a(0, 0) - a(1, 1) - a(2, 2), one - a(0, 0) + a(1, 1) - a(2, 2), one - a(0, 0) - a(1, 1) + a(2, 2)];
        let largest = (1..4).fold(0, |largest, k| if squares[k] > squares[largest] { k } else { largest });
        let root = squares[largest].sqrt();
        let (own, factor) = (half * root, half / root);
        let (sums, differences) =
            ([a(2, 1) + a(1, 2), a(0, 2) + a(2, 0), a(1, 0) + a(0, 1)], [a(2, 1) - a(1, 2), a(0, 2) - a(2, 0), a(1, 0) - a(0, 1)]);
        let [w, x, y, z] = match largest {
            0 => [own, factor * differences[0], factor * differences[1], factor * differences[2]],
            1 => [factor * differences[0], own, factor * sums[2], factor * sums[1]],
            2 => [factor * differences[1], factor * sums[2], own, factor * sums[0]],
            _ => [factor * differences[2], factor * sums[1], factor * sums[0], own],
        };
        let sign = if w < T::of(0.0) { T::of(-1.0) } else { one };
        Unit::new_unchecked(Quaternion::new(sign * w, sign * x, sign * y, sign * z))
    }
}

/// a × b
fn cross<T: Real>(a: Vector3<T>, b: Vector3<T>) -> Vector3<T> {
    Vector3::new(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
}
