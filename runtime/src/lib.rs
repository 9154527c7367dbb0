//! The motion of a mechanism from its constraint equations: positions, velocities and accelerations at the rounding limit,
//! or one error that says in the words of the declaration why there are none.
//!
//! A mechanism declared with `mechanism!` is compiled to the functions of [`Equations`]; this crate runs Newton's method
//! over them. It needs neither `std` nor an allocator, contains no `unsafe`, and does not panic on any input.
//!
//! ```text
//! position       Φ(q, t) = 0         N equations, N coordinates
//! velocity       Φ_q q̇ = ν           ν = −Φ_t
//! acceleration   Φ_q q̈ = γ           γ = −(Φ_q q̇)_q q̇ − 2 Φ_qt q̇ − Φ_tt
//! ```
//!
//! # Symbols
//!
//! | symbol | in code | meaning | shape | unit |
//! | --- | --- | --- | --- | --- |
//! | t | `t` | time | 1 | s |
//! | q | `q` | coordinates; of a planar body x, y and φ, angles never wrapped | N | m, rad |
//! | q̇, q̈ | `qd`, `qdd` | first and second derivative of q by time | N | m/s, rad/s; m/s², rad/s² |
//! | Φ | `phi` | constraint equations, zero when the mechanism is assembled | M | of the row |
//! | Φ_q | `jacobian` | ∂Φ/∂q | M × N | of the row per m or rad |
//! | ν | `nu` | right-hand side of the velocity equation | M | of the row / s |
//! | γ | `gamma` | right-hand side of the acceleration equation | M | of the row / s² |
//! | M, N | `M`, `N` | number of equations, number of coordinates | | |
//! | T | `T` | number type, [`Real`] to evaluate, [`Lanes`] to follow in time and [`Float`] to solve in every way | | |
//! | L | `characteristic_length` | length that is worth a radian: scaled coordinates are x/L, y/L and φ | 1 | m |
//!
//! # What every call guarantees
//!
//! - It does not panic, and but for `parallel` does not allocate, whatever the parameters, times, guesses and states: NaN, infinities, subnormal numbers,
//!   states of other parameters or states that were never solved for.
//! - It returns. What takes very many steps ends with [`Cause::TooManySteps`] after a million of them, in lanes after a million each.
//! - `Ok` is a state: every equation, that of velocities and that of accelerations hold to rounding errors of their terms. `Err` says
//!   why there is none, and a state that could not be taken to its time stays as it was.
//! - Fields of a state can be written to. What was written is where the next step sets out from, and is not taken for solved.
//!
//! `tests/abuse` calls everything with anything and judges what comes back by numbers of 32 digits.
//!
//! # Features
//!
//! `std` (default) asks nalgebra for it and nothing else. `certify` (default) bounds the errors of states, proves that they are solutions,
//! and polishes them ([`Mechanism::error_bound`], [`certify`](Mechanism::certify), [`polish`](Mechanism::polish)). `wide` takes several mechanisms along in the lanes of a register
//! (`reuleaux::wide`), `rayon` many on all processors (`reuleaux::parallel`).
//!
//! # Rooms
//!
//! [`Equations`] is what a mechanism gives, [`Mechanism`] what one can ask of it, [`State`] and [`Failure`] the two answers.
//! Behind them: [`Stages`] (which unknowns are found together), [`Pass`] (what they are found from), `straight` (the usual step of a
//! sweep), `careful` and `position` (Newton's method wherever that is not enough), `continuation` (following a branch in time),
//! `linear` (small systems, and larger ones with and without known zeros), `enclosure` (how far a state is from the truth, with proof).

#![no_std]
#![deny(missing_docs)]
#![forbid(unsafe_code)]
// A failure carries the last valid state by value: there is no allocator to put it elsewhere.
#![allow(clippy::result_large_err)]

#[cfg(feature = "rayon")]
extern crate std;

// Emitted code names its types by `::reuleaux`; this lets examples and macros inside the crate do so too.
extern crate self as reuleaux;

mod assembly;
mod careful;
mod continuation;
mod crossing;
mod damping;
#[cfg(feature = "certify")]
mod enclosure;
mod equations;
mod failure;
mod family;
mod float;
mod generated;
mod gradient;
mod iterate;
mod lanes;
mod linear;
mod mechanism;
mod names;
mod order;
#[cfg(feature = "rayon")]
pub mod parallel;
mod pass;
mod place;
mod plan;
mod position;
mod prepared;
mod problem;
mod real;
mod scale;
mod single;
mod slice;
mod stages;
mod state;
mod straight;
mod sweep;
mod table;
mod turn;
mod verdict;
#[cfg(feature = "wide")]
pub mod wide;

#[doc(hidden)]
pub use continuation::step_in_part;
#[cfg(feature = "certify")]
pub use enclosure::{Certificate, Doubt, Enclosure, ErrorBound};
pub use equations::{Description, Equations, ParameterOutOfRange};
pub use failure::{BranchEnd, Cause, Culprit, Failure};
pub use family::Family;
pub use float::Float;
pub use generated::{Matrix, Vector};
#[doc(hidden)]
pub use generated::{Named, Relation, between, finite, require, within};
pub use gradient::Gradient;
pub use lanes::{Lanes, Mask};
pub use linear::{Eliminated, Elimination, Entries, Factors, Linear, Order, Small, Sparse};
pub use mechanism::Mechanism;
pub use nalgebra;
pub use names::{Coordinate, CoordinateKind, Row};
pub use pass::{Pass, Solved, Stop};
pub use place::Place;
pub use plan::{Operations, Plan, PlanStage};
pub use prepared::{Prepare, Prepared};
pub use problem::Block;
pub use real::Real;
pub use slice::{Slice, SliceState, Sliced};
#[doc(hidden)]
pub use stages::mark_of;
pub use stages::{Coordinates, Stages, at_once, improved_at_once, improved_by};
pub use state::{Motion, Orientation, PlanarBody, State, Values};
pub use sweep::{Sweep, sweep};
pub use table::{Ends, Single, Table};

#[doc(hidden)]
pub use reuleaux_macros::__resume;
#[doc(inline)]
pub use reuleaux_macros::{constraint, mechanism};

/// The standard library of constraints and motion laws, each with its manual page.
///
/// The modules are empty: a constraint is used by its name inside [`mechanism!`].
pub mod library {
    reuleaux_macros::__library_pages!();
}

/// How accurate is it?
///
#[cfg_attr(doc, doc = include_str!("accuracy/page.md"))]
#[cfg_attr(doc, doc = include_str!("accuracy/references.md"))]
#[cfg_attr(doc, doc = include_str!("accuracy/measured.md"))]
#[cfg_attr(doc, doc = include_str!("accuracy/time.md"))]
#[cfg_attr(doc, doc = include_str!("accuracy/diagram.svg"))]
#[cfg(feature = "certify")]
pub mod accuracy {}

/// What the compiler refuses, and what to do about it: one page for each code.
///
/// A mistake in a declaration is a compile error under the word that is to blame. Its first line ends with a code; the page of
/// that code tells what is behind it, with a model that is refused and one that is right:
///
/// ```text
/// error: `C` of `drive_angle` is an angle (rad), found an angular velocity (rad/s) [reuleaux::E0303]
///        help: multiply the rate by `t`
///   --> src/main.rs:21:42
///    |
/// 21 |         drive input = drive_angle(crank, speed);
///    |                                          ^^^^^
/// ```
///
/// | codes | families |
/// | --- | --- |
/// | `E00…` | grammar |
/// | `E01…` | names |
/// | `E02…` | arguments |
/// | `E03…` | kinds of quantities, and their dimensions |
/// | `E04…` | values that make no sense |
/// | `E05…` | loops, arrays and parts |
/// | `E06…` | equations, and the joints and drives made of them |
/// | `E07…` | mobility: too little is held, or too much |
/// | `E08…` | redundancy: what is demanded already |
/// | `E09…` | closure: loops that do not close |
/// | `E10…` | parameters |
///
/// The modules are empty: the pages are all there is.
#[allow(non_snake_case)] // Codes are written as the compiler says them.
pub mod errors {
    reuleaux_macros::__error_pages!();
}
