//! What a mechanism says of itself besides its equations.

use nalgebra::SVector;

use super::{Coordinate, Row};
use crate::number::Real;

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
