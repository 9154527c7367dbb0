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
//! Lengths are in m, angles in rad. No panic, no allocation, no standard library.

#![no_std]
#![deny(missing_docs)]
#![forbid(unsafe_code)]

mod curve;
mod error;
pub mod follower;

pub use curve::CurvePoint;
pub use error::CamError;
