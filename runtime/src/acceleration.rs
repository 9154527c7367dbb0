//! Φ_q q̈ = γ.

use nalgebra::SVector;

use crate::position::Position;
use crate::velocity::solve_rates;
use crate::{Culprit, Equations, Float};

/// q̈ in m/s² and rad/s² at a solved position with velocity q̇, with the factors found there and one step of refinement.
///
/// # Errors
/// The row in which γ, or else the coordinate in which q̈ is not finite.
pub(crate) fn acceleration<T: Float, E: Equations<T, N, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    position: &Position<T, N>,
    qd: &SVector<T, N>,
) -> Result<SVector<T, N>, Culprit> {
    let gamma = equations.gamma(&position.q, qd, t);
    solve_rates::<T, E, N>(position, &gamma)
}
