//! A constraint compiler for mechanisms: bodies, joints and drives are declared in Rust source, and each mechanism becomes functions for its
//! positions, velocities and accelerations at the rounding limit, or an error that states the reason in the words of the declaration.
//!
//! ```
//! use reuleaux::mechanism;
//!
//! mechanism! {
//!     /// A Grashof crank-rocker turned at constant speed.
//!     pub mechanism CrankRocker {
//!         param speed: AngularVelocity = 60rpm;
//!         param crank_length: Length = 100mm;
//!
//!         ground { point O = (0mm, 0mm);  point C = (400mm, 0mm); }
//!         body crank   { point O = (0mm, 0mm);  point A = (crank_length, 0mm); }
//!         body coupler { point A = (0mm, 0mm);  point B = (350mm, 0mm);  point P = (175mm, 80mm); }
//!         body rocker  { point C = (0mm, 0mm);  point B = (300mm, 0mm);  start angle = 70deg; }
//!
//!         joint o = revolute(ground.O, crank.O);
//!         joint a = revolute(crank.A, coupler.A);
//!         joint b = revolute(coupler.B, rocker.B);
//!         joint c = revolute(rocker.C, ground.C);
//!         drive input = drive_angle(crank, speed * t);
//!
//!         output tip = coupler.P;
//!     }
//! }
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let mechanism = CrankRocker { crank_length: 0.12, ..Default::default() };
//! for state in mechanism.sweep((0..=6).map(|sixth| f64::from(sixth) / 6.0)) {
//!     let tip = mechanism.tip(&state?);
//!     println!("{} m   {} m/s   {} m/s²", tip.value, tip.rate, tip.acceleration);
//! }
//! # Ok(())
//! # }
//! ```
//!
#![cfg_attr(doc, doc = include_str!("guide/crank_rocker.svg"))]
//!
//! The language has its reference at [`mechanism!`], the joints, drives and forces their pages in [`library`], common tasks theirs in
//! [`guide`], and every compile error its own in [`errors`].
//!
//! A mechanism is compiled to the functions of [`Equations`]; this crate runs Newton's method
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
//! | T | `T` | number type, [`Real`] to evaluate, [`SolverReal`] to follow in time, [`Scalar`] for forces and [`Float`] for everything | | |
//! | L | `characteristic_length` | length that is worth a radian: scaled coordinates are x/L, y/L and φ | 1 | m |
//!
//! # Guarantees of every call
//!
//! - It does not panic, and except for `parallel` does not allocate, for any parameters, times, guesses and states: NaN, infinities,
//!   subnormal numbers, states of other parameters or states that were never solved for.
//! - It returns. A continuation of very many steps ends with [`Cause::TooManySteps`] after at most a million of them.
//! - `Ok` is a state: its equations hold to rounding errors of their terms, for positions, velocities and accelerations. `Err` is the
//!   reason why there is none; a state that cannot be taken to a time is unchanged.
//! - Fields of a [`State`] can be modified, those of a generated state by its first field: `state.0.q[0] = 1.0`. The next step starts from the
//!   modified values, and the state no longer counts as solved.
//!
//! `tests/abuse` calls every function with arbitrary arguments and checks the results with numbers of 32 digits.
//!
//! # Features
//!
//! - `std` (default): tables of motions in files ([`csv`]), and nalgebra with the standard library.
//! - `certify` (default): error bounds of states, proofs that they are solutions, and polished states
//!   ([`Mechanism::error_bound`], [`certify`](Mechanism::certify), [`polish`](Mechanism::polish)).
//! - `page-picture` (default): a drawing of each mechanism on the page of its type. It adds to compile time, not to run time.
//! - `picture`: the same drawing of any state at run time (`reuleaux::picture`), for mechanisms declared with `#[picture]`.
//! - `view`: animated pictures with plots, as pages and files (`reuleaux::view`). `view-figure`: figures for print, with
//!   diagrams. `view-png`: frames as PNG.
//! - `serde`: parameters, inputs and states of mechanisms declared with `#[serde]` can be read and written, and so can [`Motion`]; [`Plan`]
//!   and [`Failure`] can be written.
//! - `rayon`: studies of many mechanisms on all processors (`reuleaux::parallel`).
//!
//! The crate `reuleaux-wide` advances several mechanisms together in the lanes of SIMD registers, `reuleaux-cam` computes cams from the motion of
//! their followers.
//!
//! # Layers
//!
//! [`Equations`] is the interface that a mechanism implements, [`Mechanism`] the interface for its users; results are
//! [`State`] or [`Failure`]. The modules are layers; each uses those above it in this table and none below.
//!
//! | layer | contents |
//! | --- | --- |
//! | `number` | number types: [`Real`], [`SimdReal`], [`Float`]; sine and cosine; splines |
//! | `names` | names of unknowns and equations, [`Description`], [`Plan`], [`Cause`] |
//! | `linear` | linear systems on the stack: closed form, sparse, dense with pivoting |
//! | `state` | [`State`], its extrapolation, accepted steps |
//! | `dynamics` | [`Dynamics`]: accelerations from forces, initial states, [`Integrator`] |
//! | `newton` | Newton's method on one block: warm start, tracking, limited and damped steps |
//! | `solve` | all blocks at one time: [`Equations`], [`Stages`], [`Solver`], cold start |
//! | `path` | warm steps, continuation in time and in parameters, change points |
//! | `explain` | diagnosis and messages of failures |
//! | `enclosure` | error bounds and certificates, by interval arithmetic |
//! | `api` | [`Mechanism`], sweeps, derivatives by parameters |

#![no_std]
#![deny(missing_docs)]
#![forbid(unsafe_code)]
// A failure carries the last valid state by value: there is no allocator to put it elsewhere.
#![allow(clippy::result_large_err)]

#[cfg(feature = "std")]
extern crate std;

// Emitted code names its types by `::reuleaux`; this lets examples and macros inside the crate do so too.
extern crate self as reuleaux;

// Layers, as in the table above; `tests/layers.rs` checks the imports.
mod api;
mod dynamics;
#[cfg(feature = "certify")]
mod enclosure;
mod explain;
mod linear;
mod names;
mod newton;
mod number;
mod path;
mod solve;
mod state;

#[cfg(feature = "std")]
pub use api::csv;
#[cfg(feature = "rayon")]
pub use api::parallel;
pub use api::{
    Differentiable, DriveLoad, Gradient, HasOutput, Loads, Matrix, Mechanism, OutputName, OutputNames, Outputs, PlanarForce, PlanarLoad,
    Prepare, Prepared, Slice, SliceState, Sliced, SpatialForce, SpatialLoad, Sweep, Vector, sweep,
};
#[doc(hidden)]
pub use api::{
    Named, Opposed, Output, Relation, advance_once_with_inputs, advance_with_inputs, between, finite, listed, parameter_size, require,
    solve_with_inputs, sweep_with_inputs, varied, within,
};
#[doc(hidden)]
pub use dynamics::motion;
pub use dynamics::{Driven, Dynamics, Energy, Explicit, Integrator, Method, MotionSweep, Stiff, Stopped};
#[cfg(feature = "certify")]
pub use enclosure::{Certificate, Doubt, Enclosure, ErrorBound};
pub use explain::Failure;
#[doc(hidden)]
pub use linear::{AtIterate, Turning, third_derivatives, zeros};
pub use nalgebra;
pub use names::{
    BranchEnd, Cause, Coordinate, CoordinateEntries, CoordinateKind, Culprit, Description, Operations, ParameterOutOfRange, Plan,
    PlanStage, Row,
};
pub use number::{Float, Real, Scalar, SimdReal, Time, Times};
#[doc(hidden)]
pub use path::step_in_part;
#[doc(hidden)]
pub use solve::{Commanded, later, parameter_hash, parameter_hash_of};
pub use solve::{Equations, Family, SolverReal, Stages};
pub use state::{HasState, Motion, MotionWithJerk, PlanarBody, SpatialBody, State, ValueAndRate};

/// The parts of which generated code is made: linear systems of fixed size, Newton's method on one block, the stages of a solution, tables of laws.
///
/// A program that declares its mechanisms needs none of them. A mechanism that is written by hand implements [`Description`], [`Equations`] and
/// [`Stages`], the last by [`at_once`].
pub mod compiled {
    pub use crate::dynamics::{Balance, Constraints};
    pub use crate::linear::{Eliminated, Elimination, Entries, FactorReal, Factors, Linear, Order, Small, Sparse};
    pub use crate::newton::{Block, Iterate, Solved, SolvedInPlace, StepError};
    pub use crate::number::{DetSign, Ends, Mask, Single, Table};
    pub use crate::solve::{Solver, at_once, refined_guess_at_once, refined_guess_by_rows};
    pub use crate::state::{Coordinates, Values};
}
// Generated code names them by the crate alone.
#[doc(hidden)]
pub use compiled::*;

/// Interface for crates with SIMD number types, such as `reuleaux-wide`; not part of the public API.
#[doc(hidden)]
pub mod for_lanes {
    pub use crate::number::sin_cos::{LARGEST as SIN_COS_RANGE, within_range as sin_cos_in_range};
    pub use crate::path::step_lanes;
    pub use crate::solve::{ColdStart, NoColdStart};
}

#[cfg(feature = "serde")]
#[doc(hidden)]
pub use api::serial;
#[doc(hidden)]
pub use reuleaux_macros::__resume;
#[doc(inline)]
pub use reuleaux_macros::{constraint, mechanism};
#[cfg(feature = "serde")]
#[doc(hidden)]
pub use serde;

/// Textbook drawings of states, as SVG: single ones by [`Drawable`](picture::Drawable), frames of a motion by
/// [`frames`](picture::frames()) and [`animation`](picture::animation).
///
/// A mechanism is drawn at run time if `#[picture]` stands before its declaration. The drawing equals that on the page of its type, but
/// also shows profiles that are Rust functions, which the compiler cannot call.
#[cfg(feature = "picture")]
pub mod picture {
    pub use crate::api::Drawable;
    #[doc(hidden)]
    pub use crate::api::Sketch;
    pub use reuleaux_picture::{GROUND, Joint, Label, Picture, Pose, Scene, Undrawable, Vector, animation, frames};
}

/// Animated pictures: the states of a motion as one HTML page with plots, as an animated SVG, or as frames.
///
/// [`Drawable::view`](picture::Drawable::view) takes the states of any mechanism that is declared with `#[picture]`.
#[cfg(feature = "view")]
#[doc(inline)]
pub use reuleaux_view as view;

/// How to do common things: one page for each task, with complete programs.
///
/// | page | minutes | |
/// | --- | ---: | --- |
/// | [`tutorial`](guide::tutorial) | 20 | from a four-bar linkage to a press with its motor |
/// | [`sweeps`](guide::sweeps) | 10 | follow a motion and read numbers from it |
/// | [`dead_points`](guide::dead_points) | 10 | why a linkage locks, and how to choose its assembly |
/// | [`loads_and_motion`](guide::loads_and_motion) | 15 | bearing forces, motors, motion that follows from forces |
/// | [`small_motions`](guide::small_motions) | 10 | rest, natural frequencies, the linear model for a controller |
/// | [`optimising`](guide::optimising) | 15 | find dimensions, with exact derivatives |
/// | [`parameter_sets`](guide::parameter_sets) | 15 | many mechanisms of one declaration |
/// | [`files`](guide::files) | 10 | parameters from a file, motions as a table |
/// | [`pictures`](guide::pictures) | 10 | drawings, motions that can be played, shapes of bodies |
/// | [`control_loop`](guide::control_loop) | 10 | measurements and commands as inputs, a thousand times a second |
/// | [`cams`](guide::cams) | 15 | motion by segments, cams and motion laws |
/// | [`own_joint`](guide::own_joint) | 10 | a constraint of your own |
/// | [`coming_from`](guide::coming_from) | | words of Linkage, Simscape, Adams and others |
///
/// The modules are empty: the pages are all there is.
pub mod guide {
    #[doc = include_str!("guide/tutorial.md")]
    pub mod tutorial {}
    #[doc = include_str!("guide/sweeps.md")]
    pub mod sweeps {}
    #[doc = include_str!("guide/dead_points.md")]
    pub mod dead_points {}
    #[doc = include_str!("guide/loads_and_motion.md")]
    pub mod loads_and_motion {}
    #[doc = include_str!("guide/small_motions.md")]
    pub mod small_motions {}
    #[doc = include_str!("guide/optimising.md")]
    pub mod optimising {}
    #[doc = include_str!("guide/parameter_sets.md")]
    pub mod parameter_sets {}
    #[cfg_attr(all(feature = "serde", feature = "std"), doc = include_str!("guide/files.md"))]
    #[cfg_attr(not(all(feature = "serde", feature = "std")), doc = "Needs the features `serde` and `std`.")]
    pub mod files {}
    #[cfg_attr(feature = "view", doc = include_str!("guide/pictures.md"))]
    #[cfg_attr(not(feature = "view"), doc = "This page needs the feature `view`.")]
    pub mod pictures {}
    #[doc = include_str!("guide/control_loop.md")]
    pub mod control_loop {}
    #[doc = include_str!("guide/cams.md")]
    pub mod cams {}
    #[doc = include_str!("guide/own_joint.md")]
    pub mod own_joint {}
    #[doc = include_str!("guide/coming_from.md")]
    pub mod coming_from {}
}

/// The standard library of constraints and motion laws, each with its manual page.
///
/// The modules are empty: a constraint is used by its name inside [`mechanism!`].
pub mod library {
    reuleaux_macros::__library_pages!();
}

/// Accuracy of states.
///
#[cfg_attr(doc, doc = include_str!("accuracy/page.md"))]
#[cfg_attr(doc, doc = include_str!("accuracy/references.md"))]
#[cfg_attr(doc, doc = include_str!("accuracy/measured.md"))]
#[cfg_attr(doc, doc = include_str!("accuracy/time.md"))]
#[cfg_attr(doc, doc = include_str!("accuracy/diagram.svg"))]
#[cfg(feature = "certify")]
pub mod accuracy {}

/// Index of compile errors: one page for each code, with the mistake and its remedy.
///
/// A mistake in a declaration is a compile error at the word at fault. Its first line ends with a code; the page of that code explains
/// the mistake, with a model that is refused and a correct one:
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
/// | `E04…` | invalid values |
/// | `E05…` | loops, arrays and parts |
/// | `E06…` | equations, and the joints and drives made of them |
/// | `E07…` | mobility: underconstrained or overconstrained mechanisms |
/// | `E08…` | redundancy: equations that follow from others |
/// | `E09…` | closure: loops that do not close |
/// | `E10…` | parameters |
/// | `E11…` | masses and forces, freedoms, inputs |
///
/// The modules are empty; their documentation is the index.
#[allow(non_snake_case)] // Codes are written as the compiler says them.
pub mod errors {
    reuleaux_macros::__error_pages!();
}

/// The Rust blocks of the README and of the reference of the language are compiled and run with those of the guide.
#[cfg(all(doctest, feature = "picture", feature = "serde"))]
mod pages {
    #[doc = include_str!("../../README.md")]
    struct Readme;
    #[doc = include_str!("../../macros/src/reference/mechanism.md")]
    struct Mechanism;
    #[doc = include_str!("../../macros/src/reference/constraint.md")]
    struct Constraint;
}
