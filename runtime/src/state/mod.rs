//! Solved states, and access to their contents.

use core::ops::{Deref, DerefMut};

use nalgebra::{Matrix3, SVector, Vector2, Vector3};

use crate::number::{DetSign, Real, Scalar};

mod coordinates;
mod extrapolation;
mod given;
mod lanes;
mod motion;
#[cfg(feature = "serde")]
mod serial;
mod step;

pub use coordinates::Coordinates;
pub(crate) use coordinates::Moment;
pub(crate) use extrapolation::Extrapolation;
pub use given::HasState;
pub use motion::{Motion, MotionWithJerk, PlanarBody, SpatialBody, ValueAndRate};
pub(crate) use step::Step;

/// Position, velocity and acceleration of a mechanism at one instant.
///
/// Its fields are those of [`Values`]: `state.q`, `state.t` and so on. They can be modified: the next step then starts from the modified
/// values (where motion is integrated, from those of its freedoms), and the state no longer counts as solved.
#[derive(Clone, Debug, PartialEq)]
pub struct State<T, const N: usize> {
    pub(crate) values: Values<T, N>,
    /// Hash of the parameters for which the state was solved; 0 if it was not solved.
    pub(crate) parameter_hash: u64,
    pub(crate) extrapolation: Extrapolation<T, N>,
}

/// The values of a [`State`].
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
    pub branch: [DetSign; N],
    /// Condition of Φ_q, over the blocks that were solved for this state (not those at rest): rounding errors are amplified in q by
    /// about this factor. 1 at best; its decimal logarithm is the number of digits that q has lost. Near a dead point q̇ loses
    /// twice as many digits, and q̈ three times as many; `error_bound` bounds the errors, and `polish` removes them.
    pub condition: T,
    /// Number of factorisations of Φ_q, from the predicted or guessed position.
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
    /// A modified state no longer counts as solved.
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut Values<T, N> {
        self.parameter_hash = 0;
        &mut self.values
    }
}

impl<T, const N: usize> State<T, N> {
    /// True if entries may have been changed since it was solved.
    pub(crate) fn was_changed(&self) -> bool {
        self.parameter_hash == 0
    }
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
        let branch = held.map(|i| self.branch.get(i).copied().unwrap_or(DetSign::Positive));
        let extrapolation = Extrapolation { span: self.extrapolation.span, rest: pick(&self.extrapolation.rest) };
        let Values { t, condition, iterations, .. } = self.values;
        let values = Values { t, q: pick(&self.q), qd: pick(&self.qd), qdd: pick(&self.qdd), branch, condition, iterations };
        State { values, parameter_hash: 0, extrapolation }
    }

    /// Copies the solved sub-state back; other coordinates keep their values.
    pub(crate) fn take<const P: usize>(&mut self, held: &[usize; P], part: &State<T, P>) {
        for (k, &i) in held.iter().enumerate() {
            if i < N {
                let there = &mut self.values;
                (there.q[i], there.qd[i], there.qdd[i]) = (part.q[k], part.qd[k], part.qdd[k]);
                self.extrapolation.rest[i] = part.extrapolation.rest[k];
            }
        }
        let there = &mut self.values;
        (there.t, there.condition, there.iterations) = (part.t, part.condition, part.iterations);
        self.extrapolation.span = part.extrapolation.span;
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

impl<T: Real, const N: usize> State<T, N> {
    /// The motion of the point whose x, y and z begin at index `first`; NaN where there is none.
    #[must_use]
    pub fn point_in_space(&self, first: usize) -> Motion<Vector3<T>> {
        let parts = [0, 1, 2].map(|offset| self.coordinate(first.saturating_add(offset)));
        let vector = |of: fn(&Motion<T>) -> T| Vector3::new(of(&parts[0]), of(&parts[1]), of(&parts[2]));
        Motion { value: vector(|part| part.value), rate: vector(|part| part.rate), acceleration: vector(|part| part.acceleration) }
    }

    /// The motion of the body whose x, y and z begin at index `first`, and whose rotation matrix, row by row, at `orientation`: there
    /// the first three rates are ω and the first three accelerations ω̇.
    #[must_use]
    pub fn spatial_body(&self, first: usize, orientation: usize) -> SpatialBody<T> {
        let (place, turn) = (self.point_in_space(first), self.point_in_space(orientation));
        let rotation = Matrix3::from_fn(|i, j| self.coordinate(orientation.saturating_add(3 * i + j)).value);
        SpatialBody {
            position: place.value,
            rotation,
            velocity: place.rate,
            angular_velocity: turn.rate,
            acceleration: place.acceleration,
            angular_acceleration: turn.acceleration,
        }
    }

    /// A state that was not solved for, from time (s), positions (m, rad), rates and accelerations.
    #[must_use]
    pub fn new(t: T, q: SVector<T, N>, qd: SVector<T, N>, qdd: SVector<T, N>) -> Self {
        let (branch, condition) = ([DetSign::Positive; N], T::of(1.0));
        Self::solved(Values { t, q, qd, qdd, branch, condition, iterations: 0 }, 0)
    }

    /// A state that was solved for, with the parameters of this hash.
    pub(crate) fn solved(values: Values<T, N>, parameter_hash: u64) -> Self {
        Self { values, parameter_hash, extrapolation: Extrapolation::none() }
    }

    /// Mutable access to the values of a state that still counts as solved, to test which values a step leaves unchanged.
    #[doc(hidden)]
    pub fn values_kept_as_solved(&mut self) -> &mut Values<T, N> {
        &mut self.values
    }
}

impl<T: Scalar, const N: usize> State<T, N> {
    /// The predicted q at `t` (s): q + h q̇ + h² q̈ / 2, h = `t` − `self.t`.
    pub(crate) fn predict(&self, t: T) -> SVector<T, N> {
        let h = t - self.t;
        SVector::from_fn(|i, _| self.q[i] + h * (self.qd[i] + h * T::of(0.5) * self.qdd[i]))
    }
}
