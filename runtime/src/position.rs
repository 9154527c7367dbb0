//! Φ(q, t) = 0 for q. In: a guess. Out: q at the rounding limit and the factors of Φ_q there, or why not.
//! Not here: which guess to take (`continuation`), and how to tell the user (`verdict`).

use nalgebra::SVector;

use crate::damping::damped;
use crate::iterate::{History, Iterate};
use crate::lanes::Mask;
use crate::linear::Linear;
use crate::order::smaller;
use crate::place::Place;
use crate::problem::Problem;
use crate::straight::{LARGEST_CONTRACTION, LONGEST_FIRST_CORRECTION};
use crate::{Culprit, Float};

/// Longest scaled step towards a first assembly: half a radian, or half of L. Within it a revolute is still about linear.
pub(crate) const LONGEST_STEP: f64 = 0.5;

/// Corrections tried without damping. Over the reference mechanisms with guesses off by 0.6 rad and 0.6 L, 10 are usual.
const CLOSING_ITERATIONS: usize = 50;

/// Corrections of a predicted position; with that contraction, five reach rounding.
const FOLLOWING_ITERATIONS: usize = 12;

/// A Jacobian with a condition above 1 / √ε is singular: at a fold, where two assemblies meet, q is known to about √ε and the
/// condition there is about 1 / √ε.
const SINGULAR: f64 = 1.0;

/// Unless the last correction is no longer than this many roundings of q: lengths that differ by many orders of magnitude give
/// a large condition as well, without harm.
const HARMLESS: f64 = 64.0;

/// How far beside a solution it is tried whether Newton's method comes back to it, scaled: as far as rounding errors of Φ are felt where
/// two branches meet, some √ε, and a hundred times more.
const ASIDE: f64 = 1e-5;

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
        if iterate.has_settled(&history, problem.scale()) {
            return accept(problem, iterate, iterations, history.is_linear());
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
        if iterate.has_settled(&history, problem.scale()) {
            return accept(problem, iterate, iterations, false).map_err(|_| Refusal::Singular);
        }
        if iterations == 1 && side.is_some_and(|side| !T::same(iterate.factors.sides(), side).all()) {
            return Err(Refusal::Far);
        }
        let is_far = match history.contraction(iterate.length) {
            Some(theta) => theta > T::of(LARGEST_CONTRACTION),
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
    is_linear: bool,
) -> Result<Position<T, P::Factors, N>, Miss<T, N>> {
    let place = iterate.place.nudged(&iterate.correction, problem.turns());
    let condition = iterate.factors.condition(&problem.sizes(), &problem.scale().share);
    let resolved = condition * T::ROOT_EPSILON <= T::of(SINGULAR);
    let is_harmless =
        || iterate.factors.is_regular() && iterate.length <= T::of(HARMLESS) * T::EPSILON * (T::of(1.0) + problem.scale().norm(&place.x));
    if resolved || (!is_linear && is_harmless() && is_simple(problem, &place, &iterate.factors)) {
        Ok(Position { place, factors: iterate.factors, condition, iterations })
    } else {
        Err(Miss::Singular(place))
    }
}

/// Whether a solution with a large condition is one for itself: from a little beside it, Newton's method comes back to it. Where two
/// branches meet it only ever goes half the way (Griewank and Osborne 1983), until it is lost in rounding errors; where lengths
/// differ by many orders of magnitude it may do so as well at first, but ends at the same numbers.
#[cold]
fn is_simple<T: Float, P: Problem<T, N>, const N: usize>(problem: &P, place: &Place<T, N>, factors: &P::Factors) -> bool {
    // Whatever is solved for with a nearly singular matrix lies along what it nearly maps to zero.
    let along = factors.solve(&SVector::from_fn(|k, _| T::of(1.0 + 0.618 * k as f64)));
    let scale = problem.scale();
    let aside = T::of(ASIDE) / scale.norm(&along);
    let rounding = T::of(HARMLESS) * T::EPSILON * (T::of(1.0) + scale.norm(&place.x));
    [aside, -aside].into_iter().any(|aside| {
        let mut back = place.moved(aside, &along, problem.turns());
        (0..CLOSING_ITERATIONS).any(|corrections| {
            let Ok(iterate) = Iterate::at(problem, back) else { return false };
            back = iterate.moved(T::of(1.0), problem);
            let away = scale.norm(&SVector::from_fn(|k, _| back.x[k] - place.x[k]));
            away <= rounding || (corrections == 0 && away <= T::of(LARGEST_CONTRACTION * ASIDE))
        })
    })
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
