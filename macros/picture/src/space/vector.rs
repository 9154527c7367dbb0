//! Points and vectors in space.

use core::ops::{Add, Mul, Neg, Sub};

/// A point or a vector: in m before scaling, in picture units afterwards.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Vec3 {
    pub(crate) x: f64,
    pub(crate) y: f64,
    pub(crate) z: f64,
}

/// Upwards.
pub(crate) const UP: Vec3 = Vec3 { x: 0.0, y: 0.0, z: 1.0 };

pub(crate) fn vec3(x: f64, y: f64, z: f64) -> Vec3 {
    Vec3 { x, y, z }
}

impl Vec3 {
    pub(crate) fn dot(self, other: Vec3) -> f64 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    pub(crate) fn cross(self, other: Vec3) -> Vec3 {
        vec3(self.y * other.z - self.z * other.y, self.z * other.x - self.x * other.z, self.x * other.y - self.y * other.x)
    }

    pub(crate) fn norm(self) -> f64 {
        libm::hypot(libm::hypot(self.x, self.y), self.z)
    }

    /// Unit vector, unless the vector vanishes or is not finite.
    pub(crate) fn direction(self) -> Option<Vec3> {
        let largest = self.x.abs().max(self.y.abs()).max(self.z.abs());
        if !(largest > 0.0 && self.is_finite()) {
            return None;
        }
        // The norm of a very large vector is infinite, and so is the reciprocal of a very small norm.
        let is_usual = (1e-150..1e150).contains(&largest);
        let scaled = if is_usual { self } else { vec3(self.x / largest, self.y / largest, self.z / largest) };
        Some(scaled * (1.0 / scaled.norm()))
    }

    /// Unit vector; upwards if the vector vanishes.
    pub(crate) fn unit(self) -> Vec3 {
        self.direction().unwrap_or(UP)
    }

    /// Component perpendicular to the unit vector `along`.
    pub(crate) fn across(self, along: Vec3) -> Vec3 {
        self - along * self.dot(along)
    }

    /// Two unit vectors that complete this unit vector to an orthogonal frame; the first is horizontal.
    pub(crate) fn frame(self) -> (Vec3, Vec3) {
        let level = UP.cross(self);
        let one = if level.norm() > 1e-6 { level.unit() } else { vec3(1.0, 0.0, 0.0) };
        (one, self.cross(one))
    }

    pub(crate) fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }

    /// Mean of points.
    pub(crate) fn middle(places: &[Vec3]) -> Vec3 {
        places.iter().fold(Vec3::default(), |sum, at| sum + *at) * (1.0 / places.len().max(1) as f64)
    }
}

impl Add for Vec3 {
    type Output = Vec3;
    fn add(self, other: Vec3) -> Vec3 {
        vec3(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl Sub for Vec3 {
    type Output = Vec3;
    fn sub(self, other: Vec3) -> Vec3 {
        vec3(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl Mul<f64> for Vec3 {
    type Output = Vec3;
    fn mul(self, factor: f64) -> Vec3 {
        vec3(self.x * factor, self.y * factor, self.z * factor)
    }
}

impl Neg for Vec3 {
    type Output = Vec3;
    fn neg(self) -> Vec3 {
        self * -1.0
    }
}
