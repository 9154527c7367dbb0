//! Loads of a driven mechanism: inverse dynamics.
//!
//! ```text
//! M u̇ + Φ_uᵀ λ = Q      solved for λ, the motion being known
//! ```

use core::ops::Range;

use nalgebra::{SMatrix, SVector, Vector2, Vector3};

use crate::number::Float;
use crate::state::State;

/// Multipliers of a mechanism with `M` equations and `U` speeds.
///
/// Joints and drives act on the bodies with −Φ_uᵀ λ, by speed: a force for the velocity of a body's origin, a torque about the origin for
/// its angular velocity.
#[derive(Clone, Debug, PartialEq)]
pub struct Loads<T, const M: usize, const U: usize> {
    /// λ, by equation; in N for an equation in m, in N m for one in rad.
    pub multipliers: SVector<T, M>,
    /// Whether a multiplier is determined: those that redundant equations share are not, and are the ones of least norm.
    pub is_unique: [bool; M],
    jacobian: SMatrix<T, M, U>,
    nu: SVector<T, M>,
}

/// What a joint in the plane does to a body, in ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarLoad<T> {
    /// Force at the joint's point, in N.
    pub force: Vector2<T>,
    /// Torque about the joint's point, in N m.
    pub torque: T,
    /// Whether both are determined; with redundant joints they may not be.
    pub is_unique: bool,
}

/// What a joint in space does to a body, in ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpatialLoad<T> {
    /// Force at the joint's point, in N.
    pub force: Vector3<T>,
    /// Torque about the joint's point, in N m.
    pub torque: Vector3<T>,
    /// Whether both are determined; with redundant joints they may not be.
    pub is_unique: bool,
}

/// What a drive has to do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DriveLoad<T> {
    /// −λ of its first equation: the force (N) or torque (N m) that does work on the driven quantity.
    pub effort: T,
    /// Power that it puts into the mechanism, in W.
    pub power: T,
    /// Whether both are determined.
    pub is_unique: bool,
}

/// A column counts as dependent on others if eliminating them leaves less than this fraction of the largest entry.
const DEPENDENT: f64 = 1e-11;

impl<T: Float, const M: usize, const U: usize> Loads<T, M, U> {
    /// The multipliers of Φ_uᵀ λ = −f.
    ///
    /// * `jacobian`, `nu`: given, Φ_u and ν.
    /// * `unbalanced`: given, f = M u̇ − Q.
    #[must_use]
    pub fn of(jacobian: SMatrix<T, M, U>, nu: SVector<T, M>, unbalanced: &SVector<T, U>) -> Self {
        let mut matrix = jacobian.transpose();
        let mut right = -*unbalanced;
        let (pivots, rank) = eliminate(&mut matrix, &mut right);
        let mut multipliers = SVector::<T, M>::from_element(T::of(0.0));
        for k in 0..rank {
            multipliers[pivots[k]] = right[k];
        }
        let mut is_unique = [true; M];
        least_norm(&matrix, &pivots, rank, &mut multipliers, &mut is_unique);
        Self { multipliers, is_unique, jacobian, nu }
    }

    /// −Φ_uᵀ λ of some equations, for the `K` speeds from `first` on.
    #[must_use]
    pub fn on<const K: usize>(&self, equations: Range<usize>, first: usize) -> [T; K] {
        core::array::from_fn(|k| {
            let term = |row: usize| match self.jacobian.get((row, first + k)) {
                Some(entry) => *entry * self.multipliers[row],
                None => T::of(0.0),
            };
            equations.clone().filter(|row| *row < M).fold(T::of(0.0), |sum, row| sum - term(row))
        })
    }

    /// What some equations do to the body in the plane whose speeds begin at `first`, about the point at the arm `arms[at..]`.
    #[doc(hidden)]
    #[must_use]
    pub fn planar<const A: usize>(&self, equations: Range<usize>, first: usize, arms: &SVector<T, A>, at: usize) -> PlanarLoad<T> {
        let [x, y, about_origin] = self.on(equations.clone(), first);
        let torque = about_origin - (arms[at] * y - arms[at + 1] * x);
        PlanarLoad { force: Vector2::new(x, y), torque, is_unique: self.are_unique(equations) }
    }

    /// The same in space.
    #[doc(hidden)]
    #[must_use]
    pub fn spatial<const A: usize>(&self, equations: Range<usize>, first: usize, arms: &SVector<T, A>, at: usize) -> SpatialLoad<T> {
        let [x, y, z, tx, ty, tz] = self.on(equations.clone(), first);
        let [a, b, c] = [0, 1, 2].map(|k| arms[at + k]);
        let torque = Vector3::new(tx - (b * z - c * y), ty - (c * x - a * z), tz - (a * y - b * x));
        SpatialLoad { force: Vector3::new(x, y, z), torque, is_unique: self.are_unique(equations) }
    }

    /// What a drive with these equations has to do.
    #[doc(hidden)]
    #[must_use]
    pub fn drive(&self, equations: Range<usize>) -> DriveLoad<T> {
        let first = self.multipliers.get(equations.start).copied().unwrap_or(T::of(0.0));
        let power = equations.clone().filter(|row| *row < M).fold(T::of(0.0), |sum, row| sum - self.multipliers[row] * self.nu[row]);
        DriveLoad { effort: -first, power, is_unique: self.are_unique(equations) }
    }

    fn are_unique(&self, equations: Range<usize>) -> bool {
        self.is_unique.get(equations).is_some_and(|unique| unique.iter().all(|unique| *unique))
    }
}

/// Gauss-Jordan elimination with complete pivoting: afterwards the columns `pivots[..rank]` are unit vectors in this order. Returns all
/// columns, the eliminated ones first, and their number.
fn eliminate<T: Float, const M: usize, const U: usize>(matrix: &mut SMatrix<T, U, M>, right: &mut SVector<T, U>) -> ([usize; M], usize) {
    let mut pivots: [usize; M] = core::array::from_fn(|k| k);
    let mut largest = T::of(0.0);
    for rank in 0..M.min(U) {
        let mut best = (T::of(0.0), rank, rank);
        for column in rank..M {
            for row in rank..U {
                let size = matrix[(row, pivots[column])].abs();
                if size > best.0 {
                    best = (size, row, column);
                }
            }
        }
        let (size, row, column) = best;
        largest = if size > largest { size } else { largest };
        if size <= T::of(DEPENDENT) * largest {
            return (pivots, rank);
        }
        pivots.swap(rank, column);
        matrix.swap_rows(rank, row);
        right.swap_rows(rank, row);
        let own = pivots[rank];
        let pivot = matrix[(rank, own)];
        for &other in &pivots[rank..] {
            matrix[(rank, other)] = matrix[(rank, other)] / pivot;
        }
        right[rank] = right[rank] / pivot;
        for row in (0..U).filter(|row| *row != rank) {
            let factor = matrix[(row, own)];
            if factor == T::of(0.0) {
                continue;
            }
            for &other in &pivots[rank..] {
                matrix[(row, other)] = matrix[(row, other)] - factor * matrix[(rank, other)];
            }
            right[row] = right[row] - factor * right[rank];
        }
    }
    (pivots, M.min(U))
}

/// Takes the part along the null space out of a solution, and marks the multipliers that it changes.
fn least_norm<T: Float, const M: usize, const U: usize>(
    matrix: &SMatrix<T, U, M>,
    pivots: &[usize; M],
    rank: usize,
    multipliers: &mut SVector<T, M>,
    is_unique: &mut [bool; M],
) {
    // Vectors of the null space, made orthogonal to each other.
    let mut basis = SMatrix::<T, M, M>::from_element(T::of(0.0));
    for (count, &free) in pivots[rank..].iter().enumerate() {
        let mut vector = SVector::<T, M>::from_element(T::of(0.0));
        vector[free] = T::of(1.0);
        for k in 0..rank {
            vector[pivots[k]] = -matrix[(k, free)];
        }
        for (k, unique) in is_unique.iter_mut().enumerate() {
            *unique &= vector[k].abs() <= T::of(DEPENDENT);
        }
        for _ in 0..2 {
            for other in 0..count {
                let along = sum((0..M).map(|k| basis[(k, other)] * vector[k]));
                for k in 0..M {
                    vector[k] = vector[k] - along * basis[(k, other)];
                }
            }
        }
        let length = sum((0..M).map(|k| vector[k] * vector[k])).sqrt();
        for k in 0..M {
            basis[(k, count)] = vector[k] / length;
        }
    }
    for count in 0..M - rank {
        let along = sum((0..M).map(|k| basis[(k, count)] * multipliers[k]));
        for k in 0..M {
            multipliers[k] = multipliers[k] - along * basis[(k, count)];
        }
    }
}

fn sum<T: Float>(terms: impl Iterator<Item = T>) -> T {
    terms.fold(T::of(0.0), |sum, term| sum + term)
}

/// Coordinates q, speeds u and their rates u̇ of the bodies of a state in space, as the declared equations read them.
///
/// * `bodies`: given, their number; their origins stand at the beginning of the state.
/// * `orientations`: given, where their rotation matrices begin.
#[doc(hidden)]
#[must_use]
#[allow(clippy::type_complexity)] // Three vectors.
pub fn declared_motion<T: Float, const N: usize, const Q: usize, const U: usize>(
    state: &State<T, N>,
    bodies: usize,
    orientations: usize,
) -> (SVector<T, Q>, SVector<T, U>, SVector<T, U>) {
    let mut q = SVector::from_element(T::of(0.0));
    let (mut u, mut rates) = (SVector::from_element(T::of(0.0)), SVector::from_element(T::of(0.0)));
    for body in 0..bodies {
        let found = state.spatial_body(3 * body, orientations + 9 * body);
        let turn = found.orientation();
        let [i, j, k, w] = [0, 1, 2, 3].map(|part| turn.coords[part]);
        let quaternion = [w, i, j, k];
        for k in 0..3 {
            q[7 * body + k] = found.position[k];
            u[6 * body + k] = found.velocity[k];
            u[6 * body + 3 + k] = found.angular_velocity[k];
            rates[6 * body + k] = found.acceleration[k];
            rates[6 * body + 3 + k] = found.angular_acceleration[k];
        }
        for (k, part) in quaternion.into_iter().enumerate() {
            q[7 * body + 3 + k] = part;
        }
    }
    (q, u, rates)
}
