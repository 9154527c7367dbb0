//! Linear systems of balls: enclosures of the solutions of all A x = b with A and b in given balls.
//!
//! ```text
//! x̂ = R b, refined;   |x − x̂| ≤ e   if   |R (b − A x̂)| + |I − R A| e < e
//! ```
//!
//! (Rump: Verification methods, Acta Numerica 2010, 10).

use nalgebra::{SMatrix, SVector};

use super::ball::{Ball, up};
use super::twofold::Twofold;
use crate::linear::{Factors, Linear};

/// Number of refinements; each adds the digits of R.
const REFINEMENTS: usize = 5;

/// Largest number of times that a box is widened until it contains its image.
const WIDENINGS: usize = 8;

/// An approximate inverse in doubles. Krawczyk's operator accounts for its error.
pub(super) fn inverse<const K: usize>(matrix: &SMatrix<Ball, K, K>) -> Option<SMatrix<f64, K, K>> {
    let factors = Factors::new(&matrix.map(|entry| entry.center.high)).ok().filter(|factors| factors.is_regular())?;
    let mut inverse = SMatrix::<f64, K, K>::from_element(0.0);
    for j in 0..K {
        inverse.set_column(j, &factors.solve(&SVector::from_fn(|i, _| if i == j { 1.0 } else { 0.0 })));
    }
    Some(inverse)
}

/// An upper bound of |R b|.
pub(super) fn product_of_magnitudes<const K: usize>(inverse: &SMatrix<f64, K, K>, b: &SVector<Ball, K>) -> SVector<f64, K> {
    SVector::from_fn(|i, _| (0..K).fold(0.0, |sum, k| up(sum + up(inverse[(i, k)].abs() * b[k].magnitude()))))
}

/// An upper bound of |I − R A|.
pub(super) fn excess<const K: usize>(inverse: &SMatrix<f64, K, K>, matrix: &SMatrix<Ball, K, K>) -> SMatrix<f64, K, K> {
    SMatrix::from_fn(|i, j| {
        let one = Ball::exact(if i == j { 1.0 } else { 0.0 });
        (0..K).fold(one, |rest, k| rest - Ball::exact(inverse[(i, k)]) * matrix[(k, j)]).magnitude()
    })
}

/// All solutions of A x = b.
///
/// * `inverse`, `spread`: given, R and an upper bound of |I − R A|.
pub(super) fn solve_all<const K: usize>(
    matrix: &SMatrix<Ball, K, K>,
    inverse: &SMatrix<f64, K, K>,
    spread: &SMatrix<f64, K, K>,
    b: &SVector<Ball, K>,
) -> SVector<Ball, K> {
    let residual = |x: &SVector<Twofold, K>| {
        SVector::<Ball, K>::from_fn(|i, _| (0..K).fold(b[i], |rest, j| rest - matrix[(i, j)] * Ball::around(x[j], 0.0)))
    };
    let mut x = SVector::from_element(Twofold::of(0.0));
    for _ in 0..REFINEMENTS {
        let rest = residual(&x);
        for i in 0..K {
            let correction = (0..K).fold(0.0, |sum, k| sum + inverse[(i, k)] * rest[k].center.high);
            x[i] = x[i] + Twofold::of(correction);
        }
    }
    let rest = residual(&x);
    let is_proven = rest.iter().all(|entry| entry.is_proven);
    let offset = product_of_magnitudes(inverse, &rest);
    let mut radius = offset.map(|offset| up(2.0 * offset));
    for _ in 0..WIDENINGS {
        let image = SVector::<f64, K>::from_fn(|i, _| (0..K).fold(offset[i], |sum, j| up(sum + up(spread[(i, j)] * radius[j]))));
        if (0..K).all(|k| image[k] < radius[k]) {
            return SVector::from_fn(|k, _| Ball { is_proven, ..Ball::around(x[k], image[k]) });
        }
        radius = image.map(|image| up(2.0 * image));
    }
    SVector::from_element(Ball::anything())
}
