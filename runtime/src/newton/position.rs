//! Solutions of Φ(q, t) = 0: the last correction, and the test whether the solution is isolated.

use nalgebra::{SMatrix, SVector};

use super::limits::WELL_CONDITIONED;
use super::newton_step::{NewtonStep, Settled};
use super::{Iterate, Problem};
use crate::linear::{Linear, difference, divided, moved, product};
use crate::names::{CoordinateKind, Culprit};
use crate::number::Float;
use crate::number::order::{greater, smaller};

/// Largest rounding error of an angle, in rad.
const COARSEST_ANGLE: f64 = 1.0 / 64.0;

/// Largest relative change of Φ_q within the rounding errors of q; it also bounds the relative error of q̇. From 1 on another
/// solution may be as close.
const LARGEST_CHANGE: f64 = 0.25;

/// Rounding errors are sampled at these distances, as multiples of the distance to a possible second solution.
const PLACES: [f64; 4] = [0.5, 1.0, 1.9, 2.9];

/// The largest sampling distance, times this factor, is at most ∛ε.
const FAR_PLACES: f64 = 1.0 / 2.9;

/// Factor by which rounding errors may exceed the sampled ones.
const BEYOND_PLACES: f64 = 6.0;

/// A solution of Φ(q, t) = 0.
pub(crate) struct Position<T, L, const N: usize> {
    /// q, at the rounding limit.
    pub(crate) iterate: Iterate<T, N>,
    /// Factors of Φ_q at q, of full rank.
    pub(crate) factors: L,
    /// Condition of Φ_q.
    pub(crate) condition: T,
    /// Number of factorisations.
    pub(crate) iterations: usize,
}

/// Why Newton's method from a rough guess failed.
pub(crate) enum NewtonError<T, const N: usize> {
    /// The equations are not defined at an iterate.
    NotFinite(Culprit),
    /// The equations hold here, but Φ_q is singular.
    Singular(Iterate<T, N>),
    /// No step from here, however short, reduces the error.
    Stuck(Iterate<T, N>),
    /// The iteration did not converge; the last correction has this length.
    NoConvergence { correction: T, iterations: usize },
}

/// Applies the last correction. The factors are those that velocities and accelerations use.
pub(crate) fn accept<T: Float, P: Problem<T, N>, const N: usize>(
    problem: &P,
    settled: Settled<T, P::Factors, N>,
) -> Result<Position<T, P::Factors, N>, NewtonError<T, N>> {
    let iterate = settled.nudged(problem);
    let Settled { step: NewtonStep { factors, .. }, iterations } = settled;
    let condition = factors.condition(&problem.sizes(), &problem.scale().reciprocal);
    // Sine and cosine are meaningless where the angle itself is rounded coarsely.
    let is_lost = |k: usize| problem.coordinate(k).kind == CoordinateKind::Angle && T::EPSILON * iterate.x[k].abs() > T::of(COARSEST_ANGLE);
    if let Some(k) = (0..N).find(|&k| is_lost(k)) {
        return Err(NewtonError::NoConvergence { correction: T::EPSILON * iterate.x[k].abs(), iterations });
    }
    let is_certain = condition * T::ROOT_EPSILON <= T::of(WELL_CONDITIONED);
    if is_certain || (factors.is_regular() && is_isolated(problem, &iterate, &factors, condition)) {
        Ok(Position { iterate, factors, condition, iterations })
    } else {
        Err(NewtonError::Singular(iterate))
    }
}

/// Whether an ill-conditioned solution is isolated: Φ_q changes by less than a quarter within the rounding errors of q (Newton and
/// Kantorovich). The test fails next to a fold, and passes where the condition is large only because lengths differ by many orders
/// of magnitude.
///
/// ```text
/// v approximate null vector of Φ_q, |v| = 1
/// ω = |Φ_q⁻¹ (Φ_q(q + w) − Φ_q) w| / λ²,  w = λ v      so that another solution may be at q ± 2 v / ω
/// r = Φ(q + w) − Φ − (Φ_q(q + w) + Φ_q) w / 2     rounding errors of Φ, at w of about v / ω
/// ω (|Φ_q⁻¹ r| + ε |q|) ≤ 1/4
/// ```
#[cold]
fn is_isolated<T: Float, P: Problem<T, N>, const N: usize>(
    problem: &P,
    iterate: &Iterate<T, N>,
    factors: &P::Factors,
    condition: T,
) -> bool {
    let scale = problem.scale();
    let (phi, jacobian) = problem.linearize(iterate);
    let here = P::Factors::dense(&jacobian);
    // A solution with a nearly singular matrix points along its approximate null vector.
    let along = factors.solve(&uneven(&here, &scale.column));
    let along = divided(&along, scale.norm(&along));
    let line = Line { problem, iterate, factors, phi, jacobian: here, along };
    let step = T::of(1.0) / condition;
    let curvature = greater(line.beside(step).bend, line.beside(-step).bend) / (step * step);
    // Up to ∛ε the third-order terms of Φ are below rounding. Close to q, sums of nearly constant terms all round the same way, so
    // that only samples further away reveal the rounding error.
    let furthest = T::of(FAR_PLACES) * cube_root_of_epsilon();
    let reaches = [smaller(T::of(1.0) / curvature, furthest), furthest];
    let mut error = T::EPSILON * scale.norm(&iterate.x);
    // Converted one by one at compile time; a loop over doubles would convert them at run time, which `f32` must not need.
    let [a, b, c, d] = PLACES;
    for multiple in [T::of(a), T::of(-a), T::of(b), T::of(-b), T::of(c), T::of(-c), T::of(d), T::of(-d)] {
        for reach in reaches {
            error = greater(error, T::of(BEYOND_PLACES) * line.beside(multiple * reach).rounding);
        }
    }
    condition * T::EPSILON < T::of(1.0) && curvature * error <= T::of(LARGEST_CHANGE)
}

/// A line through a solution.
struct Line<'a, T, P: Problem<T, N>, const N: usize>
where
    T: Float,
{
    problem: &'a P,
    iterate: &'a Iterate<T, N>,
    factors: &'a P::Factors,
    phi: SVector<T, N>,
    jacobian: SMatrix<T, N, N>,
    /// Its direction.
    along: SVector<T, N>,
}

/// Φ and Φ_q at q + w, beside a solution q.
struct Beside<T> {
    /// |Φ_q⁻¹ (Φ_q(q + w) − Φ_q) w|
    bend: T,
    /// |Φ_q⁻¹ r|
    rounding: T,
}

impl<T: Float, P: Problem<T, N>, const N: usize> Line<'_, T, P, N> {
    /// At this distance from the solution.
    #[inline(never)]
    fn beside(&self, distance: T) -> Beside<T> {
        let there = self.iterate.moved(distance, &self.along, self.problem.needs_sin_cos());
        let way = difference(&there.x, &self.iterate.x);
        let (phi, jacobian) = self.problem.linearize(&there);
        let (there, here) = (product(&P::Factors::dense(&jacobian), &way), product(&self.jacobian, &way));
        let rest = moved(&difference(&phi, &self.phi), T::of(-0.5), &moved(&there, T::of(1.0), &here));
        let [bend, rounding] = [difference(&there, &here), rest].map(|b| self.problem.scale().norm(&self.factors.solve(&b)));
        Beside { bend, rounding }
    }
}

/// The largest entry of each row in comparable units, times shares of which no two are alike.
fn uneven<T: Float, const N: usize>(matrix: &SMatrix<T, N, N>, column: &SVector<T, N>) -> SVector<T, N> {
    let mut largest = SVector::<T, N>::from_element(T::of(0.0));
    for (entries, &size) in matrix.data.0.iter().zip(column) {
        for (most, entry) in largest.iter_mut().zip(entries) {
            *most = greater(*most, entry.abs() * size);
        }
    }
    let mut share = T::of(0.382);
    for row in &mut largest {
        share = share + T::of(0.618);
        *row = *row * share;
    }
    largest
}

/// ∛ε
fn cube_root_of_epsilon<T: Float>() -> T {
    T::select_less(T::EPSILON, T::of(1e-12), T::of(6.1e-6), T::of(4.9e-3))
}

impl<T, const N: usize> From<Culprit> for NewtonError<T, N> {
    fn from(culprit: Culprit) -> Self {
        Self::NotFinite(culprit)
    }
}
