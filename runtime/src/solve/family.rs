//! A declaration over any number type.

use crate::number::Real;

/// The mechanisms of one declaration, over any number type; `mechanism!` implements it.
///
/// It applies one operation to every parameter, for example to take one lane out of several, or to put several side by side.
pub trait Family<T>: Sized {
    /// The same declaration over `U`.
    type Over<U: Real>: Family<U>;

    /// Whether equations read [inputs](macro@crate::mechanism#input) of the mechanism.
    const HAS_INPUTS: bool = false;

    /// The mechanism each of whose parameters `combine` computes from that parameter of several mechanisms.
    #[doc(hidden)]
    fn gather<U: Real, const L: usize>(each: [&Self; L], combine: impl Fn([T; L]) -> U) -> Self::Over<U>;

    /// The mechanism with its inputs a short time `h` (s) later, up to terms with h³: x + ẋ h + ẍ h² / 2. Inputs so get derivatives by time
    /// from h = 0 with the rate 1.
    #[doc(hidden)]
    #[must_use]
    fn later(self, h: T) -> Self {
        let _ = h;
        self
    }
}
