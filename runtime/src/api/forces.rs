//! Actions of single forces.

use nalgebra::{Vector2, Vector3};

use super::loads::Loads;
use crate::number::Scalar;

/// Action of a force in the plane, in the axes of ground: its vectors in the order in which they are declared, those on ground among them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarForce<T, const P: usize, const B: usize> {
    /// Forces at its points, in N.
    pub forces: [Vector2<T>; P],
    /// Torques on bodies, in N m.
    pub torques: [T; B],
    /// Power that it puts into the mechanism, in W.
    pub power: T,
}

/// Action of a force in space, in the axes of ground: its vectors in the order in which they are declared, those on ground among them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpatialForce<T, const P: usize, const B: usize> {
    /// Forces at its points, in N.
    pub forces: [Vector3<T>; P],
    /// Torques on bodies, in N m.
    pub torques: [Vector3<T>; B],
    /// Power that it puts into the mechanism, in W.
    pub power: T,
}

impl<T: Scalar, const M: usize, const A: usize> Loads<T, M, A> {
    /// A force in the plane, by the places of its numbers.
    #[doc(hidden)]
    #[must_use]
    pub fn planar_force<const P: usize, const B: usize>(
        &self,
        forces: [usize; P],
        torques: [usize; B],
        power: usize,
    ) -> PlanarForce<T, P, B> {
        PlanarForce {
            forces: forces.map(|at| Vector2::from(self.actions_from(at))),
            torques: torques.map(|at| self.action(at)),
            power: self.action(power),
        }
    }

    /// The same in space.
    #[doc(hidden)]
    #[must_use]
    pub fn spatial_force<const P: usize, const B: usize>(
        &self,
        forces: [usize; P],
        torques: [usize; B],
        power: usize,
    ) -> SpatialForce<T, P, B> {
        SpatialForce {
            forces: forces.map(|at| Vector3::from(self.actions_from(at))),
            torques: torques.map(|at| Vector3::from(self.actions_from(at))),
            power: self.action(power),
        }
    }

    fn action(&self, at: usize) -> T {
        let [action] = self.actions_from(at);
        action
    }
}
