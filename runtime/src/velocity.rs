//! Φ_q q̇ = ν.

use nalgebra::SVector;

use crate::iterate::first_not_finite;
use crate::position::Position;
use crate::{Culprit, Equations, Float, names};

/// q̇ in m/s and rad/s at a solved position, with the factors found there and one step of refinement.
///
/// # Errors
/// The row in which ν, or else the coordinate in which q̇ is not finite.
pub(crate) fn velocity<T: Float, E: Equations<T, N, N> + ?Sized, const N: usize>(
    equations: &E,
    t: T,
    position: &Position<T, N>,
) -> Result<SVector<T, N>, Culprit> {
    let nu = equations.nu(&position.q, t);
    solve_rates::<T, E, N>(position, &nu)
}

/// Φ_q x = b for the rates x of first or second order.
pub(crate) fn solve_rates<T: Float, E: Equations<T, N, N> + ?Sized, const N: usize>(
    position: &Position<T, N>,
    b: &SVector<T, N>,
) -> Result<SVector<T, N>, Culprit> {
    if let Some(row) = b.iter().position(|entry| !entry.is_finite()) {
        return Err(Culprit::Row(names::row(E::ROWS, row)));
    }
    let x = position.factors.solve_refined(b);
    first_not_finite::<T, E, N>(&x).map_or(Ok(x), Err)
}
