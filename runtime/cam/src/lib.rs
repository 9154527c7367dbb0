//! Cam profiles from the motion of a follower.
//!
//! In: the motion of a follower's point or face relative to the cam, from the states of a mechanism ([`CurvePoint::relative`],
//! [`CurvePoint::face`]), from the lift or the swing of a [`follower`] over the cam's angle, or from a polar curve with its
//! derivatives. Out: for each moment one [`CurvePoint`] of the curve, with its normal and curvature, and the pressure angle. A point of the
//! pitch curve gives one of the surface, a point of the surface one of the cutter's path; each is a line of a CSV file.
//!
//! ```text
//!   pitch curve    p                           centre of the roller, edge of the knife
//!   surface        p − ρ n                     ρ roller radius, n normal away from the cam
//!   cutter         p − ρ n + c n               c radius of the cutter
//!   curvature      κ / (1 − κ ρ)               of the surface, positive where it is convex
//! ```
//!
//! A surface is undercut where the pitch curve is convex and its radius of curvature is not larger than the roller's: the error names the
//! angle. This is a condition at each point; branches of a curve that cross elsewhere, as at a dwell that is too short, are not looked for.
//!
//! # From a mechanism
//!
//! ```
//! use reuleaux::mechanism;
//! use reuleaux_cam::CurvePoint;
//!
//! mechanism! {
//!     /// A drive raises the follower; the cam that does so is computed.
//!     pub mechanism Valve {
//!         body cam { }
//!         body follower { point C = (0mm, 0mm); }
//!         joint shaft = revolute(ground.position, cam.position);
//!         joint guide = translational((0, 1), (5mm, 0mm), follower.C);
//!         drive motor = drive_angle(cam, 60rpm * t);
//!         drive lift = drive_y(follower.C, segments(cam.angle, 40mm, [
//!             rise(12mm, 120deg, cycloidal), dwell(60deg), fall(12mm, 120deg, polynomial_345), dwell(60deg),
//!         ], periodic));
//!         output centre = follower.C;
//!     }
//! }
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let valve = Valve::default();
//! for degree in 0..360 {
//!     let state = valve.solve(f64::from(degree) / 360.0)?;
//!     let pitch = CurvePoint::relative(&state.cam(), &valve.centre(&state))?;
//!     // A roller of 8 mm, a cutter of 6 mm.
//!     let surface = pitch.surface(0.008)?;
//!     let cutter = surface.cutter(0.006)?;
//!     assert!((pitch.point - cutter.point).norm() - 0.002 < 1e-15);
//!     // Angle of the surface's normal against the guide.
//!     let guide = CurvePoint::direction(&state.cam(), [0.0, 1.0].into());
//!     assert!(pitch.pressure_angle(guide).abs() < 30_f64.to_radians());
//! }
//! # Ok(())
//! # }
//! ```
//!
//! # From a measured surface
//!
//! Readings of a radius at equal angles become a smooth surface by [`Harmonics`], this gives the pitch curve of a roller by
//! [`CurvePoint::pitch`], and [`Profile`] makes it the law of a joint. Points that are not at equal angles begin with [`CurvePoint::through`].
//!
//! ```
//! use std::sync::LazyLock;
//!
//! use reuleaux::{Motion, Real, mechanism};
//! use reuleaux_cam::{CamError, CurvePoint, Harmonics, Profile};
//!
//! const ROLLER: f64 = 0.01;
//!
//! /// Radius of the surface (m): here a disc of 30 mm, 8 mm beside the shaft.
//! fn read(degree: i32) -> f64 {
//!     let (sine, cosine) = f64::from(degree).to_radians().sin_cos();
//!     0.008 * cosine + (0.03 * 0.03 - 0.008 * 0.008 * sine * sine).sqrt()
//! }
//!
//! static PITCH: LazyLock<Result<Profile<'static>, CamError>> = LazyLock::new(|| {
//!     let readings: Vec<f64> = (0..360).map(read).collect();
//!     let surface = Harmonics::<16>::of(&readings).ok_or(CamError::NotRound { at: 0.0 })?;
//!     let angles = (0..360).map(|degree| f64::from(degree).to_radians());
//!     let pitch = angles.map(|psi| CurvePoint::polar(psi, &surface.at(psi))?.pitch(ROLLER)).collect::<Result<Vec<_>, _>>()?;
//!     Profile::new(pitch.leak())
//! });
//!
//! /// R(ψ) of `cam_roller` with its derivatives.
//! pub fn outline<T: Real>(psi: T) -> (T, T, T) {
//!     psi.map(|psi| match &*PITCH {
//!         Ok(pitch) => {
//!             let Motion { value, rate, acceleration } = pitch.radius(psi);
//!             (value - ROLLER, rate, acceleration)
//!         }
//!         Err(_) => (f64::NAN, f64::NAN, f64::NAN),
//!     })
//! }
//!
//! mechanism! {
//!     /// A slide on a cam that was measured.
//!     pub mechanism Measured {
//!         function outline(Angle) -> Length = crate::outline;
//!         body cam { }
//!         body slide { start y = 48mm; }
//!         joint shaft = revolute(ground.position, cam.position);
//!         joint guide = translational((0, 1), (0mm, 0mm), slide.position);
//!         joint contact = cam_roller(cam.position, slide.position, 10mm, outline);
//!         drive motor = drive_angle(cam, 60rpm * t);
//!         output lift = slide.y;
//!     }
//! }
//!
//! fn main() -> Result<(), Box<dyn std::error::Error>> {
//!     let measured = Measured::default();
//!     for state in measured.sweep((0..=100).map(|step| 0.01 * f64::from(step))) {
//!         let state = state?;
//!         // The centre of the roller is 40 mm from the middle of the disc.
//!         let (sine, cosine) = state.cam().angle.sin_cos();
//!         let exact = 0.008 * sine + (0.04 * 0.04 - 0.008 * 0.008 * cosine * cosine).sqrt();
//!         assert!((measured.lift(&state).value - exact).abs() < 1e-9);
//!     }
//!     Ok(())
//! }
//! ```
//!
//! Lengths are in m, angles in rad. No panic, no allocation, no standard library.

#![no_std]
#![deny(missing_docs)]
#![forbid(unsafe_code)]

mod curve;
mod error;
mod extremes;
pub mod follower;
mod profile;

pub use curve::CurvePoint;
pub use error::CamError;
pub use extremes::{Extreme, Extremes};
pub use profile::{Harmonics, Profile};
