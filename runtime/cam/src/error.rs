//! Reasons why a cam cannot be made as asked.

use core::fmt;

/// Why a point of a curve does not exist. `at` is the angle of the cam, or the number that was given for it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum CamError {
    /// The pitch curve is convex, and its radius of curvature is not larger than that of the roller: the surface is undercut.
    Undercut {
        /// Angle (rad).
        at: f64,
        /// Radius of curvature of the pitch curve (m).
        radius: f64,
        /// Radius of the roller (m).
        roller: f64,
    },
    /// The curve is hollow, and its radius of curvature is not larger than that of the roller or cutter that shall touch it.
    TooHollow {
        /// Angle (rad).
        at: f64,
        /// Radius of curvature of the hollow (m), positive.
        radius: f64,
        /// Radius of the roller or cutter (m).
        tool: f64,
    },
    /// A flat face touches no point of a convex curve: h + h″ ≤ 0.
    NotConvex {
        /// Angle (rad).
        at: f64,
        /// h + h″ (m).
        radius: f64,
    },
    /// The curve has no normal away from the cam: the point rests on the cam, or moves straight towards the cam's centre.
    NoNormal {
        /// Angle (rad).
        at: f64,
    },
    /// The points do not go once round the cam's centre, in one sense: R would not be a function of the direction.
    NotRound {
        /// Angle (rad).
        at: f64,
    },
    /// The follower does not reach its line: the offset is not smaller than the radius.
    OutOfReach {
        /// Angle (rad).
        at: f64,
    },
}

impl CamError {
    /// Angle (rad) at which the cam cannot be made.
    #[must_use]
    pub fn at(&self) -> f64 {
        match *self {
            CamError::Undercut { at, .. }
            | CamError::TooHollow { at, .. }
            | CamError::NotConvex { at, .. }
            | CamError::NoNormal { at }
            | CamError::NotRound { at }
            | CamError::OutOfReach { at } => at,
        }
    }
}

impl fmt::Display for CamError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let at = self.at().to_degrees();
        match self {
            CamError::Undercut { radius, roller, .. } => {
                let [radius, roller] = [radius, roller].map(|length| length * 1e3);
                write!(f, "the surface is undercut at {at:.2}°: the pitch curve's radius of curvature is {radius:.3} mm, ")?;
                write!(f, "the roller's radius {roller:.3} mm")
            }
            CamError::TooHollow { radius, tool, .. } => {
                let [radius, tool] = [radius, tool].map(|length| length * 1e3);
                write!(f, "at {at:.2}° the curve is hollow with a radius of {radius:.3} mm, too narrow for a radius of {tool:.3} mm")
            }
            CamError::NotConvex { radius, .. } => {
                write!(f, "the flat face is undercut at {at:.2}°: h + h″ is {:.3} mm", radius * 1e3)
            }
            CamError::NoNormal { .. } => write!(f, "the curve has no normal away from the cam at {at:.2}°"),
            CamError::NotRound { .. } => write!(f, "the points do not go once round the cam's centre, in one sense, from {at:.2}° on"),
            CamError::OutOfReach { .. } => write!(f, "the follower does not reach the cam at {at:.2}°: its offset is too large"),
        }
    }
}

impl core::error::Error for CamError {}
