//! Several mechanisms side by side, one in each lane of a SIMD register.
//!
//! `FourBar<F64x4>` is four parameter sets of one declaration, and [`Lockstep`] advances them together, each at its own time if
//! need be. A warm step is computed for all lanes at once. Where it fails in a lane (near a dead point, or because the step is
//! long), the scalar code redoes that lane, which ends as it would alone, in a state or in a [`Failure`](reuleaux::Failure) of its
//! own, while the others continue. States agree with those of scalar code to a few roundings.
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

    /// The signs of determinants with these lanes.
    fn from_signs(lanes: [DetSign; L]) -> Self::Signs;

    /// The signs by lane.
    fn to_signs(signs: Self::Signs) -> [DetSign; L];

    /// A mask as booleans.
    fn mask_to_lanes(mask: Self::Mask) -> [bool; L];

    /// A mask from booleans.
    fn mask_from_lanes(answers: [bool; L]) -> Self::Mask;
}
