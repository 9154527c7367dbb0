//! A declaration over any number type.

use crate::number::Real;

/// The mechanisms of one declaration, over any number type; `mechanism!` implements it.
///
/// With it parameters are changed all in the same way: one lane is taken out of several, or several are put side by side.
pub trait Family<T>: Sized {
    /// The same declaration over `U`.
    type Over<U: Real>: Family<U>;

    /// A mechanism whose parameters are each combined from those of several.
    fn gather<U: Real, const L: usize>(each: [&Self; L], combine: impl Fn([T; L]) -> U) -> Self::Over<U>;
}
