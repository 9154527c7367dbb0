//! What a mechanism gives: its equations as functions, and their names.

use nalgebra::{SMatrix, SVector};

use crate::{Coordinate, Real, Row};

/// What a mechanism says of itself: names, where to start, how large it is. Emitted code implements it.
pub trait Description<T: Real, const N: usize> {
    /// The mechanism as declared.
    const NAME: &'static str;

    /// The `N` coordinates, in the order of q.
    const COORDINATES: &'static [Coordinate];

    /// The rows, in the order of Φ.
    const ROWS: &'static [Row];

    /// A guess of q at t = 0, near the assembly that is meant.
    fn start(&self) -> SVector<T, N>;

    /// L, the length in metres that is worth a radian when lengths and angles are compared; above zero.
    fn characteristic_length(&self) -> T;

    /// Whether every parameter lies where the equations make sense.
    ///
    /// # Errors
    /// The first parameter that does not.
    fn validate(&self) -> Result<(), ParameterOutOfRange<T>>;
}

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

/// A parameter for which a mechanism has no meaning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParameterOutOfRange<T> {
    /// The parameter as declared.
    pub name: &'static str,
    /// The value it has, in SI.
    pub value: T,
    /// The SI unit of the value; empty for a pure number.
    pub unit: &'static str,
    /// Why not, or what it should be: `"it must not be zero"`.
    pub why: &'static str,
}
