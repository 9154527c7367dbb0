//! Mechanisms with inputs.

use crate::number::Real;

/// A mechanism with inputs, numbers that come from outside for each state; `mechanism!` implements it where there are any.
#[doc(hidden)]
pub trait Commanded<T: Real>: Sized {
    /// All inputs, each with its rate and its acceleration.
    type Inputs: Copy;

    /// The inputs that the equations read.
    fn inputs(&self) -> Self::Inputs;

    /// The mechanism with its inputs as declared for the start.
    #[must_use]
    fn at_start(&self) -> Self;

    /// The mechanism with other inputs.
    #[must_use]
    fn with(&self, inputs: Self::Inputs) -> Self;

    /// The inputs on a smooth way, see [`Motion::between`](crate::Motion::between).
    fn between(from: &Self::Inputs, to: &Self::Inputs, h: [T; 2], share: T) -> Self::Inputs;
}

/// [`Family::later`](crate::Family::later) of a mechanism with inputs.
#[doc(hidden)]
#[must_use]
pub fn later<T: Real, E: Commanded<T>>(mechanism: E, h: T) -> E {
    let inputs = mechanism.inputs();
    // The way to the same inputs begins with their rates and accelerations.
    mechanism.with(E::between(&inputs, &inputs, [T::of(1.0); 2], h))
}
