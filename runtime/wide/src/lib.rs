//! Several mechanisms side by side: one in each lane of a SIMD register.
//!
//! `FourBar<F64x4>` is four parameter sets of one declaration, and [`Lockstep`] takes them along together, each at its own time if
//! need be. The usual step is computed for all lanes at once; a lane that cannot go straight on (a dead point is near, the step is
//! long) is taken over by the scalar code, so that it ends as it would alone, in a state or in a [`Failure`](reuleaux::Failure) of its
//! own, while the others go on. States are those of scalar code to a few roundings.
//!
//! Registers of 256 bits need a processor with AVX and a compiler that may use it: `RUSTFLAGS="-C target-cpu=native"`.

#![no_std]
#![deny(missing_docs)]
#![forbid(unsafe_code)]

mod dense;
mod lockstep;
mod register;

pub use dense::LaneFactors;
pub use lockstep::Lockstep;
pub use register::{F32x8, F64x4, LaneMask};
use reuleaux::{DetSign, Float, SolverReal};

/// A number of `L` lanes.
pub trait Wide<const L: usize>: SolverReal {
    /// The number in one lane.
    type Lane: Float;

    /// The number with these lanes.
    fn from_lanes(lanes: [Self::Lane; L]) -> Self;

    /// The lanes of the number.
    fn to_lanes(self) -> [Self::Lane; L];

    /// Signs with these lanes.
    fn from_signs(lanes: [DetSign; L]) -> Self::Signs;

    /// The signs by lane.
    fn to_signs(signs: Self::Signs) -> [DetSign; L];

    /// The answer by lane.
    fn mask_to_lanes(mask: Self::Mask) -> [bool; L];

    /// An answer with these lanes.
    fn mask_from_lanes(answers: [bool; L]) -> Self::Mask;
}
