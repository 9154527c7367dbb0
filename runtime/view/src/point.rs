//! Types that can be traced as points.

use nalgebra::{Scalar, Vector2, Vector3};
use reuleaux_picture::Vector;

/// A point in ground, in m: two coordinates in the plane, three in space.
pub trait Point {
    /// Coordinates of the point.
    fn coordinates(&self) -> Vector;
}

impl<T: Copy + Into<f64>> Point for [T; 2] {
    fn coordinates(&self) -> Vector {
        self.map(Into::into).into()
    }
}

impl<T: Copy + Into<f64>> Point for [T; 3] {
    fn coordinates(&self) -> Vector {
        self.map(Into::into).into()
    }
}

impl<T: Scalar + Copy + Into<f64>> Point for Vector2<T> {
    fn coordinates(&self) -> Vector {
        [self.x, self.y].coordinates()
    }
}

impl<T: Scalar + Copy + Into<f64>> Point for Vector3<T> {
    fn coordinates(&self) -> Vector {
        [self.x, self.y, self.z].coordinates()
    }
}
