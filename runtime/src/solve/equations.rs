//! The equations of a mechanism as functions.

use nalgebra::{SMatrix, SVector};

use crate::names::Description;
use crate::number::Real;

/// The constraint equations of a mechanism: `M` rows on `N` coordinates. Emitted code implements it.
///
/// q, q̇ and t are in metres, radians and seconds. Implementations do not panic; where they are not defined they return NaN.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a mechanism with {M} equations on {N} coordinates over `{T}`",
    note = "`mechanism!` implements `Equations` for the types it declares"
)]
pub trait Equations<T: Real, const M: usize, const N: usize>: Description<T, N> {
    /// Φ(q, t), each row in its own unit.
    fn phi(&self, q: &SVector<T, N>, t: T) -> SVector<T, M>;

    /// Φ_q(q, t).
    fn jacobian(&self, q: &SVector<T, N>, t: T) -> SMatrix<T, M, N>;

    /// Φ and Φ_q together, which share most of their work.
    fn linearize(&self, q: &SVector<T, N>, t: T) -> (SVector<T, M>, SMatrix<T, M, N>);

    /// ν = −Φ_t, the right-hand side of Φ_q q̇ = ν.
    fn nu(&self, q: &SVector<T, N>, t: T) -> SVector<T, M>;

    /// γ, the right-hand side of Φ_q q̈ = γ: minus the second derivative of s ↦ Φ(q + s q̇, t + s) at s = 0.
    fn gamma(&self, q: &SVector<T, N>, qd: &SVector<T, N>, t: T) -> SVector<T, M>;
}
