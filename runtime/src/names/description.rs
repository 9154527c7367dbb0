//! The description of a mechanism besides its equations.

use nalgebra::SVector;

use super::{Coordinate, Row};
use crate::number::Real;

/// Names, start and size of a mechanism. Emitted code implements it.
pub trait Description<T: Real, const N: usize> {
    /// The mechanism as declared.
    const NAME: &'static str;

    /// The `N` coordinates, in the order of q.
    const COORDINATES: &'static [Coordinate];

    /// The rows, in the order of Φ.
    const ROWS: &'static [Row];

    /// A guess of q at t = 0, near the intended assembly.
    fn start(&self) -> SVector<T, N>;

    /// L in metres, above zero: the length that equals one radian when lengths and angles are compared.
    fn characteristic_length(&self) -> T;

    /// Whether every parameter has a value for which the equations are defined.
    ///
    /// # Errors
    /// The first parameter that does not.
    fn validate(&self) -> Result<(), ParameterOutOfRange<T>>;
}

/// A parameter for which a mechanism is not defined.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ParameterOutOfRange<T> {
    /// The parameter as declared.
    pub name: &'static str,
    /// The value it has, in SI.
    pub value: T,
    /// The SI unit of the value; empty for a pure number.
    pub unit: &'static str,
    /// The violated condition: `"it must not be zero"`.
    pub why: &'static str,
}
