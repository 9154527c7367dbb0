//! Φ(q, t) = 0 for q. In: a guess. Out: q at the rounding limit and the factors of Φ_q there, or why not.
//! Not here: which guess to take (`continuation`), and how to tell the user (`verdict`).

use nalgebra::{SMatrix, SVector};

use crate::damping::damped;
use crate::iterate::{History, Iterate};
use crate::lanes::Mask;
use crate::linear::Linear;
use crate::order::{greater, smaller};
use crate::place::Place;
use crate::problem::Problem;
use crate::straight::{LARGEST_CONTRACTION, LONGEST_FIRST_CORRECTION};
use crate::{CoordinateKind, Culprit, Float};

/// Longest scaled step towards a first assembly: half a radian, or half of L. Within it a revolute is still about linear.
pub(crate) const LONGEST_STEP: f64 = 0.5;

/// Corrections tried without damping. Over the reference mechanisms with guesses off by 0.6 rad and 0.6 L, 10 are usual.
const CLOSING_ITERATIONS: usize = 50;

/// Corrections of a predicted position; with that contraction, five reach rounding.
const FOLLOWING_ITERATIONS: usize = 12;

/// Up to this share of 1 / √ε a condition says that two solutions are told apart: where they meet, at a fold, they are about
/// 1 / condition apart and each is known to about ε times the condition.
pub(crate) const CERTAIN: f64 = 0.125;

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
    pub(crate) place: Place<T, N>,
    /// Factors of Φ_q at q, of full rank.
    pub(crate) factors: L,
    /// Condition of Φ_q.
    pub(crate) condition: T,
    /// Number of factorisations.
    pub(crate) iterations: usize,
}

/// Why there is no solution here.
pub(crate) enum Miss<T, const N: usize> {
    /// The equations are not defined at an iterate.
    NotFinite(Culprit),
    /// The equations hold here, but Φ_q is singular.
    Singular(Place<T, N>),
    /// No step from here, however short, comes nearer.
    Stuck(Place<T, N>),
    /// Corrections go on at this length.
    NoConvergence { correction: T, iterations: usize },
}

/// Why a predicted position does not lead to one that is surely on the same branch.
pub(crate) enum Refusal {
    /// The equations are not defined at an iterate.
    NotFinite(Culprit),
    /// Φ_q is singular there.
    Singular,
    /// The solution is too far from the prediction.
    Far,
}

/// Assembles from a rough guess: Newton's method with limited steps and, if that does not settle, damped from the same guess.
///
/// Limited steps may cross singular positions, which from rough guesses they often must; damped ones never do, but end at
/// the best position that can be reached without.
pub(crate) fn close<T: Float, P: Problem<T, N>, const N: usize>(
    problem: &P,
    guess: &Place<T, N>,
) -> Result<Position<T, P::Factors, N>, Miss<T, N>> {
    limited(problem, guess).or_else(|_| damped(problem, guess))
}

/// Newton's method with scaled steps of at most [`LONGEST_STEP`].
fn limited<T: Float, P: Problem<T, N>, const N: usize>(problem: &P, guess: &Place<T, N>) -> Result<Position<T, P::Factors, N>, Miss<T, N>> {
    let mut place = *guess;
    let mut history = History::new();
    for iterations in 1..=CLOSING_ITERATIONS {
        let iterate = Iterate::at(problem, place)?;
        if iterate.has_settled(&history) {
            return accept(problem, iterate, iterations);
        }
        let in_full = iterate.length <= T::of(LONGEST_STEP);
        place = iterate.moved(smaller(T::of(1.0), T::of(LONGEST_STEP) / iterate.length), problem);
        history = history.after(iterate.length, in_full);
    }
    Err(Miss::NoConvergence { correction: history.last().unwrap_or(T::of(LONGEST_STEP)), iterations: CLOSING_ITERATIONS })
}

/// Newton's method from a prediction: full steps only, and none if the solution is far or convergence slow.
///
/// * `side`: given, the orientation before. Where two branches cross, the one that goes straight on changes it, and so does the
///   prediction: what is then found on the old side is another branch.
pub(crate) fn follow<T: Float, P: Problem<T, N>, const N: usize>(
    problem: &P,
    prediction: &Place<T, N>,
    side: Option<T::Sides>,
) -> Result<Position<T, P::Factors, N>, Refusal> {
    let mut history = History::new();
    let mut place = *prediction;
    for iterations in 1..=FOLLOWING_ITERATIONS {
        let iterate = Iterate::at(problem, place)?;
        if iterate.has_settled(&history) {
            return accept(problem, iterate, iterations).map_err(|_| Refusal::Singular);
        }
        if iterations == 1 && side.is_some_and(|side| !T::same(iterate.factors.sides(), side).all()) {
            return Err(Refusal::Far);
        }
        let is_far = match history.contraction(iterate.length) {
            Some(theta) => theta > T::of(LARGEST_CONTRACTION) && !iterate.is_rounding(),
            None => iterate.length > T::of(LONGEST_FIRST_CORRECTION),
        };
        if is_far {
            return Err(Refusal::Far);
        }
        place = iterate.moved(T::of(1.0), problem);
        history = history.after(iterate.length, true);
    }
    Err(Refusal::Far)
}

/// Makes the last correction, with the factors that velocities will use as well.
pub(crate) fn accept<T: Float, P: Problem<T, N>, const N: usize>(
    problem: &P,
    iterate: Iterate<T, P::Factors, N>,
    iterations: usize,
) -> Result<Position<T, P::Factors, N>, Miss<T, N>> {
    let place = iterate.place.nudged(&iterate.correction, problem.turns());
    let condition = iterate.factors.condition(&problem.sizes(), &problem.scale().share);
    // Sine and cosine say nothing of an angle whose own rounding is no small one.
    let is_lost = |k: usize| problem.coordinate(k).kind == CoordinateKind::Angle && T::EPSILON * place.x[k].abs() > T::of(COARSEST_ANGLE);
    if let Some(k) = (0..N).find(|&k| is_lost(k)) {
        return Err(Miss::NoConvergence { correction: T::EPSILON * place.x[k].abs(), iterations });
    }
    let is_certain = condition * T::ROOT_EPSILON <= T::of(CERTAIN);
    if is_certain || (iterate.factors.is_regular() && is_isolated(problem, &place, &iterate.factors, condition)) {
        Ok(Position { place, factors: iterate.factors, condition, iterations })
    } else {
        Err(Miss::Singular(place))
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
fn is_isolated<T: Float, P: Problem<T, N>, const N: usize>(problem: &P, place: &Place<T, N>, factors: &P::Factors, condition: T) -> bool {
    let scale = problem.scale();
    let (phi, jacobian) = problem.linearize(place);
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
        let (_, jacobian) = problem.linearize(&place.moved(step, &along, problem.turns()));
        let there = P::Factors::dense(&jacobian);
        let (there, here) = (product(&there, &along), product(&here, &along));
        let change = SVector::from_fn(|row, _| there[row] - here[row]);
        greater(largest, scale.norm(&factors.solve(&change)) / step.abs())
    });
    // Up to the cube root of ε what Φ has of third order is below rounding. Sums whose terms hardly change are rounded alike near to q,
    // and only further away it shows how.
    let furthest = T::of(FAR_PLACES) * cube_root_of_epsilon();
    let reaches = [smaller(T::of(1.0) / curvature, furthest), furthest];
    let mut error = T::EPSILON * scale.norm(&place.x);
    // Each is converted where it stands, before the machine runs: a loop over doubles would convert them then.
    let [a, b, c, d] = PLACES;
    for multiple in [T::of(a), T::of(-a), T::of(b), T::of(-b), T::of(c), T::of(-c), T::of(d), T::of(-d)] {
        for reach in reaches {
            let way = along.map(|entry| multiple * reach * entry);
            let there = place.moved(T::of(1.0), &way, problem.turns());
            let way = SVector::from_fn(|k, _| there.x[k] - place.x[k]);
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

impl<T, const N: usize> From<Culprit> for Miss<T, N> {
    fn from(culprit: Culprit) -> Self {
        Self::NotFinite(culprit)
    }
}

impl From<Culprit> for Refusal {
    fn from(culprit: Culprit) -> Self {
        Self::NotFinite(culprit)
    }
}
