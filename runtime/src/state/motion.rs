//! Points and bodies in motion, as a state shows them.

use nalgebra::Vector2;

use crate::number::Real;

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
