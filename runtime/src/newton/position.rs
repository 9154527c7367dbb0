//! Solutions of Φ(q, t) = 0: the last correction, and whether there is exactly one solution here.

use nalgebra::{SMatrix, SVector};

use super::limits::WELL_CONDITIONED;
use super::newton_step::NewtonStep;
use super::{Iterate, Problem};
use crate::linear::Linear;
use crate::names::{CoordinateKind, Culprit};
use crate::number::Float;
use crate::number::order::{greater, smaller};

/// The largest rounding error of an angle, in rad.
const COARSEST_ANGLE: f64 = 1.0 / 64.0;

/// Φ_q may change by this share of itself within the rounding errors of q; it is also the relative error of q̇ at worst. From 1 on
/// another solution may be as near.
const LARGEST_CHANGE: f64 = 0.25;

/// Rounding errors are looked for at these places, as multiples of the way to where another solution may be.
const PLACES: [f64; 4] = [0.5, 1.0, 1.9, 2.9];

/// The furthest of them are at the cube root of ε.
const FAR_PLACES: f64 = 1.0 / 2.9;

/// How much larger rounding errors may be than they are there.
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

/// Why there is no solution here.
pub(crate) enum NewtonError<T, const N: usize> {
    /// The equations are not defined at an iterate.
    NotFinite(Culprit),
    /// The equations hold here, but Φ_q is singular.
    Singular(Iterate<T, N>),
    /// No step from here, however short, comes nearer.
    Stuck(Iterate<T, N>),
    /// Corrections go on at this length.
    NoConvergence { correction: T, iterations: usize },
}

/// Makes the last correction, with the factors that velocities will use as well.
pub(crate) fn accept<T: Float, P: Problem<T, N>, const N: usize>(
    problem: &P,
    step: NewtonStep<T, P::Factors, N>,
    iterations: usize,
) -> Result<Position<T, P::Factors, N>, NewtonError<T, N>> {
    let iterate = step.iterate.nudged(&step.correction, problem.needs_sin_cos());
    let condition = step.factors.condition(&problem.sizes(), &problem.scale().reciprocal);
    // Sine and cosine say nothing of an angle whose own rounding is no small one.
    let is_lost = |k: usize| problem.coordinate(k).kind == CoordinateKind::Angle && T::EPSILON * iterate.x[k].abs() > T::of(COARSEST_ANGLE);
    if let Some(k) = (0..N).find(|&k| is_lost(k)) {
        return Err(NewtonError::NoConvergence { correction: T::EPSILON * iterate.x[k].abs(), iterations });
    }
    let is_certain = condition * T::ROOT_EPSILON <= T::of(WELL_CONDITIONED);
    if is_certain || (step.factors.is_regular() && is_isolated(problem, &iterate, &step.factors, condition)) {
        Ok(Position { iterate, factors: step.factors, condition, iterations })
    } else {
        Err(NewtonError::Singular(iterate))
    }
}

/// Whether a solution with a large condition is one for itself: Φ_q changes by less than a quarter wherever rounding errors may have
/// taken it (Newton and Kantorovich). Next to a fold it does not; where lengths differ by many orders of magnitude it does.
///
/// ```text
/// v                                    what Φ_q nearly maps to zero, |v| = 1
/// ω = |Φ_q⁻¹ (Φ_q(q + λ v) − Φ_q) v| / λ      so that another solution may be at q ± 2 v / ω
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
    // Whatever is solved for with a nearly singular matrix lies along what it nearly maps to zero.
    let mut share = T::of(0.382);
    let along = factors.solve(&SVector::from_fn(|k, _| {
        let row = (0..N).fold(T::of(0.0), |sum, column| greater(sum, here[(k, column)].abs() * scale.column[column]));
        share = share + T::of(0.618);
        row * share
    }));
    let size = scale.norm(&along);
    let along = along.map(|entry| entry / size);
    let step = T::of(1.0) / condition;
    let curvature = [step, -step].into_iter().fold(T::of(0.0), |largest, step| {
        let (_, jacobian) = problem.linearize(&iterate.moved(step, &along, problem.needs_sin_cos()));
        let there = P::Factors::dense(&jacobian);
        let (there, here) = (product(&there, &along), product(&here, &along));
        let change = SVector::from_fn(|row, _| there[row] - here[row]);
        greater(largest, scale.norm(&factors.solve(&change)) / step.abs())
    });
    // Up to the cube root of ε what Φ has of third order is below rounding. Sums whose terms hardly change are rounded alike near to q,
    // and only further away it shows how.
    let furthest = T::of(FAR_PLACES) * cube_root_of_epsilon();
    let reaches = [smaller(T::of(1.0) / curvature, furthest), furthest];
    let mut error = T::EPSILON * scale.norm(&iterate.x);
    // Each is converted where it stands, before the machine runs: a loop over doubles would convert them then.
    let [a, b, c, d] = PLACES;
    for multiple in [T::of(a), T::of(-a), T::of(b), T::of(-b), T::of(c), T::of(-c), T::of(d), T::of(-d)] {
        for reach in reaches {
            let way = along.map(|entry| multiple * reach * entry);
            let there = iterate.moved(T::of(1.0), &way, problem.needs_sin_cos());
            let way = SVector::from_fn(|k, _| there.x[k] - iterate.x[k]);
            let (beside, jacobian) = problem.linearize(&there);
            let slope = P::Factors::dense(&jacobian);
            let (there, here) = (product(&slope, &way), product(&here, &way));
            let rest = SVector::from_fn(|row, _| (beside[row] - phi[row]) - T::of(0.5) * (there[row] + here[row]));
            error = greater(error, T::of(BEYOND_PLACES) * scale.norm(&factors.solve(&rest)));
        }
    }
    condition * T::EPSILON < T::of(1.0) && curvature * error <= T::of(LARGEST_CHANGE)
}

/// A v, without an index that could be out of bounds.
fn product<T: Float, const N: usize>(matrix: &SMatrix<T, N, N>, vector: &SVector<T, N>) -> SVector<T, N> {
    let mut product = SVector::<T, N>::from_element(T::of(0.0));
    for (column, &factor) in matrix.data.0.iter().zip(vector.iter()) {
        for (sum, &entry) in product.iter_mut().zip(column) {
            *sum = *sum + entry * factor;
        }
    }
    product
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
