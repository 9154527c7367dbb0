//! Loads of a driven mechanism: inverse dynamics.
//!
//! ```text
//! M u̇ + Φ_uᵀ λ = Q      solved for λ, the motion being known
//! ```

use core::ops::Range;

use nalgebra::{SMatrix, SVector, Vector2, Vector3};

use crate::linear::{unpermuted, zeros};
use crate::number::Scalar;
use crate::state::{PlanarBody, SpatialBody};

/// Multipliers of a mechanism with `M` equations, and `A` numbers with the loads of its joints and drives.
///
/// The joints and drives load the bodies with −Φ_uᵀ λ: the entry for the velocity of a body's origin is a force, the entry for its
/// angular velocity a torque about the origin.
#[derive(Clone, Debug, PartialEq)]
pub struct Loads<T, const M: usize, const A: usize> {
    /// λ, by equation; in N for an equation in m, in N m for one in rad. NaN if it depends on a NaN, and where joints lose rank and no forces
    /// balance.
    pub multipliers: SVector<T, M>,
    /// True for multipliers that are unique. Redundant equations share their load: of all solutions, these multipliers have least norm.
    pub is_unique: [bool; M],
    /// Force and torque of each joint, power of each drive.
    actions: SVector<T, A>,
}

/// Load of a joint on a planar body, in ground coordinates.
///
/// * `HAS_OPPOSITE`: false for a joint whose other body does not get the opposite load, such as a gear pair: it has a load for each body.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct PlanarLoad<T, const HAS_OPPOSITE: bool = true> {
    /// Force at the joint's point, of `loads.joint_on_body()` at the origin of the body, in N.
    pub force: Vector2<T>,
    /// Torque about the same point, in N m.
    pub torque: T,
    /// True if both are unique; with redundant joints they may not be.
    pub is_unique: bool,
}

/// Load of a joint on a body in space, in ground coordinates.
///
/// * `HAS_OPPOSITE`: false for a joint whose other body does not get the opposite load, such as a gear pair: it has a load for each body.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct SpatialLoad<T, const HAS_OPPOSITE: bool = true> {
    /// Force at the joint's point, of `loads.joint_on_body()` at the origin of the body, in N.
    pub force: Vector3<T>,
    /// Torque about the same point, in N m.
    pub torque: Vector3<T>,
    /// True if both are unique; with redundant joints they may not be.
    pub is_unique: bool,
}

impl<T: Scalar, const HAS_OPPOSITE: bool> PlanarLoad<T, HAS_OPPOSITE> {
    /// The opposite load, which acts on the other body about the same point.
    #[must_use]
    pub fn on_other(self) -> Self
    where
        Self: Opposed,
    {
        Self { force: self.force.map(|part| -part), torque: -self.torque, ..self }
    }

    /// The same load with the components of its force in the frame of a body.
    #[must_use]
    pub fn in_axes_of(self, body: &PlanarBody<T>) -> Self {
        let (sine, cosine) = body.angle.sin_cos();
        let (x, y) = (self.force[0], self.force[1]);
        Self { force: Vector2::new(cosine * x + sine * y, cosine * y - sine * x), ..self }
    }
}

impl<T: Scalar, const HAS_OPPOSITE: bool> SpatialLoad<T, HAS_OPPOSITE> {
    /// The opposite load, which acts on the other body about the same point.
    #[must_use]
    pub fn on_other(self) -> Self
    where
        Self: Opposed,
    {
        Self { force: self.force.map(|part| -part), torque: self.torque.map(|part| -part), ..self }
    }

    /// The same load with its components in the frame of a body.
    #[must_use]
    pub fn in_axes_of(self, body: &SpatialBody<T>) -> Self {
        let along =
            |vector: Vector3<T>| Vector3::from_fn(|axis, _| (0..3).fold(T::of(0.0), |sum, k| sum + body.rotation[(k, axis)] * vector[k]));
        Self { force: along(self.force), torque: along(self.torque), ..self }
    }
}

/// A load whose opposite acts on the other body of the joint.
///
/// ```compile_fail,E0277
/// reuleaux::mechanism! {
///     mechanism Pair {
///         ground { point A = (1m, 0m); }
///         body large { mass = 1kg;  inertia = 0.1kgm2; }
///         body small { mass = 1kg;  inertia = 0.02kgm2; }
///         joint of_large = revolute(ground.position, large.position);
///         joint of_small = revolute(ground.A, small.position);
///         joint mesh = gear_pair(large, small, 1, 3);
///         drive motor = drive_angle(small, 2rad_s * t);
///     }
/// }
///
/// let pair = Pair::default();
/// let _ = pair.loads(&pair.solve(0.1).unwrap()).mesh().on_other();
/// ```
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "the bodies of this joint do not get opposite loads",
    note = "the load on each of its bodies has a method: `loads.mesh_on_wheel()` of a joint `mesh` and a body `wheel`"
)]
pub trait Opposed {}

impl<T> Opposed for PlanarLoad<T> {}

impl<T> Opposed for SpatialLoad<T> {}

/// Load that a drive must supply.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct DriveLoad<T> {
    /// Force (N) or torque (N m) along the driven quantity, positive where it drives this forward: times the rate of the quantity, it is the
    /// power. Of an equation Φ(q) = C(t) it is −λ, of `drive_distance` and every other equation s² = C² it is −2 C λ, along s. Of a drive of
    /// several equations it is that of the first.
    pub effort: T,
    /// Power supplied to the mechanism, in W.
    pub power: T,
    /// True if both are unique.
    pub is_unique: bool,
}

/// A column counts as dependent on others if eliminating them leaves less than this fraction of the largest entry: at a change point positions are
/// known to √ε.
const DEPENDENT: f64 = 4e-8;

/// The least such fraction, in ε.
const ROUNDED: f64 = 16.0;

/// An entry of a vector of the null space counts as zero up to this size.
const NOTHING: f64 = 1e-11;

/// Forces count as balanced if what is left of them is at most this multiple of √ε of the largest one that is coupled with them.
const BALANCED: f64 = 64.0;

impl<T: Scalar, const M: usize, const A: usize> Loads<T, M, A> {
    /// The multipliers of Φ_uᵀ λ = −f, and the loads that follow from them. Where none satisfy it, those that are coupled are NaN.
    ///
    /// * `jacobian`: given, Φ_u; overwritten.
    /// * `unbalanced`: given, f = M u̇ − Q.
    /// * `is_driven`: given, true if drives determine the motion; otherwise f vanishes along the freedoms, but for rounding.
    /// * `actions`: given, computes the loads of joints and drives from λ.
    #[doc(hidden)]
    #[must_use]
    pub fn of<const U: usize>(
        jacobian: &mut SMatrix<T, M, U>,
        unbalanced: &SVector<T, U>,
        is_driven: bool,
        actions: impl Fn(&SVector<T, M>) -> SVector<T, A>,
    ) -> Self {
        if !jacobian.iter().chain(unbalanced.iter()).all(|value| value.is_finite()) {
            return Self::unknown();
        }
        // The columns of Φ_u are the rows of its transpose.
        let rows = &mut jacobian.data.0;
        let (mut right, mut coupled) = (unbalanced.data.0[0], [(0, T::of(0.0)); U]);
        for (row, (force, coupled)) in right.iter_mut().zip(&mut coupled).enumerate() {
            (*force, *coupled) = (-*force, (row, force.abs()));
        }
        let (pivots, rank) = eliminate(rows, &mut right, &mut coupled);
        let mut multipliers = SVector::<T, M>::from_element(T::of(0.0));
        for (multiplier, value) in pivots.iter().zip(&right).take(rank) {
            multipliers[*multiplier] = *value;
        }
        let mut is_unique = [true; M];
        if rank < M {
            least_norm(rows, &pivots, rank, &mut multipliers, &mut is_unique);
        }
        // Where joints lose rank, no forces may balance: close to such a place they grow beyond all bounds.
        for row in (rank..U).filter(|_| is_driven) {
            let is_coupled = |k: usize| coupled[k].0 == coupled[row].0;
            let heaviest =
                coupled.iter().filter(|(group, _)| *group == coupled[row].0).fold(T::of(0.0), |most, (_, force)| most.max(*force));
            if right[row].abs() <= T::of(BALANCED) * T::ROOT_EPSILON * heaviest {
                continue;
            }
            for (place, &multiplier) in pivots.iter().enumerate() {
                let takes_part = |k: usize| is_coupled(k) && rows[k][multiplier] != T::of(0.0);
                let is_lost = if place < rank { is_coupled(place) } else { (0..rank).any(takes_part) };
                if is_lost {
                    (multipliers[multiplier], is_unique[multiplier]) = (T::of(f64::NAN), false);
                }
            }
        }
        Self { multipliers, is_unique, actions: actions(&multipliers) }
    }

    /// Loads with unique multipliers.
    #[doc(hidden)]
    #[must_use]
    pub fn unique(multipliers: SVector<T, M>, actions: SVector<T, A>) -> Self {
        Self { multipliers, is_unique: [true; M], actions }
    }

    /// Loads that are unknown: all numbers are NaN.
    #[doc(hidden)]
    #[must_use]
    pub fn unknown() -> Self {
        let nothing = T::of(f64::NAN);
        Self { multipliers: SVector::from_element(nothing), is_unique: [false; M], actions: SVector::from_element(nothing) }
    }

    /// Load on a planar body of a joint with these equations.
    #[doc(hidden)]
    #[must_use]
    pub fn planar<const HAS_OPPOSITE: bool>(&self, equations: Range<usize>, at: usize) -> PlanarLoad<T, HAS_OPPOSITE> {
        let [x, y, torque] = self.actions_from(at);
        PlanarLoad { force: Vector2::new(x, y), torque, is_unique: self.are_unique(equations) }
    }

    /// The same in space.
    #[doc(hidden)]
    #[must_use]
    pub fn spatial<const HAS_OPPOSITE: bool>(&self, equations: Range<usize>, at: usize) -> SpatialLoad<T, HAS_OPPOSITE> {
        let [x, y, z, about_x, about_y, about_z] = self.actions_from(at);
        let (force, torque) = (Vector3::new(x, y, z), Vector3::new(about_x, about_y, about_z));
        SpatialLoad { force, torque, is_unique: self.are_unique(equations) }
    }

    /// Effort and power of a drive with these equations.
    #[doc(hidden)]
    #[must_use]
    pub fn drive(&self, equations: Range<usize>, at: usize) -> DriveLoad<T> {
        let [effort, power] = self.actions_from(at);
        DriveLoad { effort, power, is_unique: self.are_unique(equations) }
    }

    /// Multipliers of the equations from `first` on.
    #[doc(hidden)]
    #[must_use]
    pub fn multipliers_from<const K: usize>(&self, first: usize) -> [T; K] {
        from_place(self.multipliers.as_slice(), first)
    }

    pub(super) fn actions_from<const K: usize>(&self, at: usize) -> [T; K] {
        from_place(self.actions.as_slice(), at)
    }

    fn are_unique(&self, equations: Range<usize>) -> bool {
        self.is_unique.get(equations).is_some_and(|unique| unique.iter().all(|unique| *unique))
    }
}

/// Numbers from a place on; NaN beyond the last one.
fn from_place<T: Scalar, const K: usize>(values: &[T], first: usize) -> [T; K] {
    let mut found = [T::of(f64::NAN); K];
    for (found, value) in found.iter_mut().zip(values.iter().skip(first)) {
        *found = *value;
    }
    found
}

/// Gauss-Jordan elimination of rows with complete pivoting: afterwards the columns `pivots[..rank]` are unit vectors in this order. Returns all
/// columns, the eliminated ones first, and their number.
///
/// * `coupled`: given, a different number for each row, with anything of it; afterwards the numbers of rows that were added to each other are equal.
#[inline(never)]
fn eliminate<T: Scalar, const M: usize, const U: usize>(
    rows: &mut [[T; M]; U],
    right: &mut [T; U],
    coupled: &mut [(usize, T); U],
) -> ([usize; M], usize) {
    let (mut pivots, mut largest, mut sizes) = (unpermuted::<M>(), T::of(0.0), [(T::of(0.0), 0); U]);
    for (size, row) in sizes.iter_mut().zip(rows.iter()) {
        *size = largest_of(row, &pivots);
    }
    for rank in 0..M.min(U) {
        let mut best = (T::of(0.0), rank, rank);
        for (row, (size, column)) in sizes.iter().enumerate().skip(rank) {
            best = if *size > best.0 { (*size, row, *column) } else { best };
        }
        let (size, row, column) = best;
        largest = if size > largest { size } else { largest };
        if size <= T::of(DEPENDENT).max(T::of(ROUNDED) * T::EPSILON) * largest {
            return (pivots, rank);
        }
        let place = pivots.iter().position(|pivot| *pivot == column).unwrap_or(rank);
        pivots.swap(rank, place);
        rows.swap(rank, row);
        right.swap(rank, row);
        sizes.swap(rank, row);
        coupled.swap(rank, row);
        let pivot = rows[rank][column];
        rows[rank].iter_mut().for_each(|entry| *entry = *entry / pivot);
        right[rank] = right[rank] / pivot;
        let (own, side) = (rows[rank], right[rank]);
        for row in 0..U {
            let factor = rows[row][column];
            if row != rank && factor != T::of(0.0) {
                for (entry, own) in rows[row].iter_mut().zip(&own) {
                    *entry = *entry - factor * *own;
                }
                right[row] = right[row] - factor * side;
                let (one, other) = (coupled[rank].0, coupled[row].0);
                coupled.iter_mut().filter(|(number, _)| *number == other).for_each(|(number, _)| *number = one);
                sizes[row] = largest_of(&rows[row], &pivots[rank + 1..]);
            }
        }
    }
    (pivots, M.min(U))
}

/// The largest of these entries of a row, and its column.
fn largest_of<T: Scalar, const M: usize>(row: &[T; M], columns: &[usize]) -> (T, usize) {
    columns
        .iter()
        .fold((T::of(0.0), 0), |largest, column| if row[*column].abs() > largest.0 { (row[*column].abs(), *column) } else { largest })
}

/// Removes the component along the null space from a solution, and marks multipliers with an entry in the null space as not unique.
#[cold]
#[inline(never)]
fn least_norm<T: Scalar, const M: usize, const U: usize>(
    rows: &[[T; M]; U],
    pivots: &[usize; M],
    rank: usize,
    multipliers: &mut SVector<T, M>,
    is_unique: &mut [bool; M],
) {
    // Vectors of the null space, orthogonalised.
    let mut basis: SMatrix<T, M, M> = zeros();
    for (count, &free) in pivots[rank..].iter().enumerate() {
        let mut vector = SVector::<T, M>::from_element(T::of(0.0));
        vector[free] = T::of(1.0);
        for k in 0..rank {
            vector[pivots[k]] = -rows[k][free];
        }
        for (k, unique) in is_unique.iter_mut().enumerate() {
            *unique &= vector[k].abs() <= T::of(NOTHING);
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

fn sum<T: Scalar>(terms: impl Iterator<Item = T>) -> T {
    terms.fold(T::of(0.0), |sum, term| sum + term)
}
