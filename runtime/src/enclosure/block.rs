//! Enclosure of one block: Newton's method with residuals of twice the digits, then Krawczyk's operator around the result.
//!
//! ```text
//! K(X) = c − R Φ(c) + (I − R Φ_q(X)) (X − c)        R ≈ Φ_q(c)⁻¹
//! ```
//!
//! If K(X) lies inside of X, there is exactly one solution in X, and it lies in K(X), for all values of the previous blocks within
//! their enclosures
//! (Krawczyk 1969; Neumaier: Interval Methods for Systems of Equations, 5.1). Its rates follow from the residuals' derivatives along the
//! motion, which [`Enclosure`]s carry with them, and not from the emitted ν and γ.

use nalgebra::{SMatrix, SVector};

use super::ball::{Ball, up};
use super::moving::Enclosure;
use super::system::{excess, inverse, product_of_magnitudes, solve_all};
use super::twofold::Twofold;
use super::{Doubt, EnclosureSolver};
use crate::linear::Linear;
use crate::names::{self, CoordinateKind, Culprit};
use crate::newton::{Block, Evaluate, Iterate, Solved, StepError};

/// Largest number of corrections; five are usual, most of them for the last digits.
const MOST_CORRECTIONS: usize = 40;

/// A scaled correction after which the next one is far below any rounding of a double.
const FINE: f64 = 1e-24;

/// Smallest half-width of a box, relative to the scale plus the unknown.
const NARROWEST: f64 = 1e-27;

/// Encloses the solution of a block next to the state.
///
/// # Errors
/// If that cannot be proven; the reason is stored in `solver.doubt`.
pub(super) fn solve<L: Linear<Enclosure, K>, const K: usize, const N: usize>(
    solver: &EnclosureSolver<N>,
    block: &Block<K>,
    evaluate: &Evaluate<'_, Enclosure, L, K>,
) -> Result<Solved<Enclosure, L, K>, StepError<Enclosure>> {
    let name = || names::coordinate(solver.coordinates, block.unknowns.first().copied().unwrap_or(0));
    let doubt = |doubt: Doubt| {
        solver.doubt.set(Some(doubt));
        StepError::NotFinite(Culprit::Coordinate(name()))
    };
    let length = solver.lengths.0.value.center.high;
    let length = if length > 0.0 && length.is_finite() { length } else { 1.0 };
    let columns = block.kinds.map(|kind| if kind == CoordinateKind::Length { length } else { 1.0 });

    let start = SVector::<f64, K>::from_fn(|k, _| solver.q[block.unknowns[k]]);
    // Residuals, with their rates for the given motion of the unknowns, and their Jacobian.
    let linearize = |x: &SVector<Enclosure, K>| {
        let (phi, matrix) = evaluate(&Iterate::at(*x, &block.needs_sin_cos));
        (phi, L::dense(&matrix).map(|entry| entry.value))
    };
    let within = |center: &SVector<Twofold, K>, radius: &SVector<f64, K>| {
        SVector::<Enclosure, K>::from_fn(|k, _| Enclosure::at_rest(Ball::around(center[k], radius[k])))
    };
    let none = SVector::<f64, K>::from_element(0.0);
    let (center, inverse) = newton(&start, &columns, |x| {
        let (phi, jacobian) = linearize(&within(x, &none));
        (phi.map(|residual| residual.value), jacobian)
    })
    .ok_or_else(|| doubt(Doubt::NoSolution(name())))?;

    // |R Φ(c)|, for all values of the previous blocks.
    let phi = linearize(&within(&center, &none)).0.map(|residual| residual.value);
    let offset = product_of_magnitudes(&inverse, &phi);
    let are_proven = |mut entries: core::slice::Iter<'_, Ball>| entries.all(|entry| entry.is_proven);
    let image = |radius: &SVector<f64, K>| {
        let (residuals, jacobian) = linearize(&within(&center, radius));
        let is_proven = are_proven(jacobian.as_slice().iter()) && residuals.iter().all(|residual| residual.value.is_proven);
        let spread = excess(&inverse, &jacobian);
        let sum = |i: usize| (0..K).fold(offset[i], |sum, j| up(sum + up(spread[(i, j)] * radius[j])));
        (SVector::<f64, K>::from_fn(|i, _| sum(i)), is_proven)
    };
    let is_inside = |image: &SVector<f64, K>, radius: &SVector<f64, K>| (0..K).all(|k| image[k] < radius[k]);
    let narrow = SVector::<f64, K>::from_fn(|k, _| up(4.0 * offset[k] + NARROWEST * (columns[k] + center[k].high.abs())));
    // All points as close to the state as the solution.
    let wide = SVector::<f64, K>::from_fn(|k, _| {
        let away = (Ball::exact(start[k]) - Ball::around(center[k], 0.0)).magnitude();
        up(2.0 * away + narrow[k])
    });
    let (in_wide, is_wide_proven) = image(&wide);
    let is_alone = is_inside(&in_wide, &wide);
    let (in_narrow, is_narrow_proven) = image(&narrow);
    let radius = match (is_inside(&in_narrow, &narrow), is_alone) {
        (true, _) => in_narrow,
        (false, true) => in_wide,
        (false, false) => return Err(doubt(Doubt::NoSolution(name()))),
    };
    if solver.alone && !is_alone {
        return Err(doubt(Doubt::Another(name())));
    }

    // Rates follow from the condition that residuals stay zero: velocities with the unknowns at rest, accelerations with constant
    // velocities.
    let mut x = within(&center, &radius);
    let (at_rest, jacobian) = linearize(&x);
    let is_proven = is_narrow_proven && (is_wide_proven || !solver.alone) && are_proven(phi.as_slice().iter());
    let spread = excess(&inverse, &jacobian);
    let solve = |b: SVector<Ball, K>| solve_all(&jacobian, &inverse, &spread, &b);
    let rates = solve(at_rest.map(|residual| -residual.rate));
    for k in 0..K {
        x[k].value.is_proven = is_proven;
        x[k].rate = rates[k].with_doubts_of(x[k].value);
    }
    let accelerations = solve(linearize(&x).0.map(|residual| -residual.acceleration));
    for k in 0..K {
        x[k].acceleration = accelerations[k].with_doubts_of(x[k].value);
    }
    let there = Iterate::at(x, &block.needs_sin_cos);
    let factors = L::factor(&evaluate(&there).1).map_err(|_| doubt(Doubt::NoSolution(name())))?;
    Ok(Solved { x: x.data.0[0], sin_cos: there.sin_cos, factors })
}

/// The result of Newton's method from doubles, and an approximate inverse of the Jacobian there.
fn newton<const K: usize>(
    start: &SVector<f64, K>,
    columns: &[f64; K],
    linearize: impl Fn(&SVector<Twofold, K>) -> (SVector<Ball, K>, SMatrix<Ball, K, K>),
) -> Option<(SVector<Twofold, K>, SMatrix<f64, K, K>)> {
    let mut x = start.map(Twofold::of);
    let mut last = f64::INFINITY;
    for _ in 0..MOST_CORRECTIONS {
        let (phi, jacobian) = linearize(&x);
        let inverse = inverse(&jacobian)?;
        let mut length = 0.0;
        for i in 0..K {
            let correction = (0..K).fold(0.0, |sum, k| sum + inverse[(i, k)] * phi[k].center.high);
            x[i] = x[i] - Twofold::of(correction);
            length += correction.abs() / (columns[i] + x[i].high.abs());
        }
        if !length.is_finite() {
            return None;
        }
        let has_stalled = length < f64::EPSILON && length > 0.25 * last;
        if length <= FINE || has_stalled {
            return Some((x, inverse));
        }
        last = length;
    }
    None
}
