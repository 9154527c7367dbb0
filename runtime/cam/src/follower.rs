//! Followers over the angle of a cam that turns counter-clockwise about the origin.
//!
//! In: the lift or the swing at an angle θ of the cam, with its first and second derivative by θ: `rate` is s′ in m or rad per rad,
//! `acceleration` s″. Out: a [`Station`]. At θ = 0 the cam's coordinates are those of ground.
//!
//! A mechanism whose cam turns with ω has s′ = ṡ/ω, and at constant ω also s″ = s̈/ω².

use nalgebra::Vector2;
use reuleaux::{Motion, PlanarBody};

use crate::curve::{axes, in_frame_of, is_positive, perpendicular};
use crate::{CamError, CurvePoint};

/// What is known of a cam at one of its angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station {
    /// The pitch curve of a roller or a knife edge; for a flat face the surface itself.
    pub curve: CurvePoint,
    /// Angle (rad) from the path of the follower to the normal, counter-clockwise.
    pub pressure_angle: f64,
}

/// A roller or a knife edge that moves along the y axis of ground, on a line beside the cam's centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Translating {
    /// Radius of the pitch curve (m) where the lift is 0: base circle plus roller.
    pub prime_radius: f64,
    /// x coordinate of the line (m).
    pub offset: f64,
}

impl Translating {
    /// The smallest cam whose pressure angle stays within `rise` (rad) where the follower rises, and within `fall` where it falls; at rest
    /// within both. `lifts` are those of one turn. `None` if a cam of any size does, if a limit does not lie between 0 and 90°, or if a
    /// lift is not a number.
    ///
    /// ```text
    ///   √(R² − e²) = max |s′ − e| / tan α − s
    /// ```
    ///
    /// Reference: Norton, Cam Design and Manufacturing Handbook, chapter 7.
    #[must_use]
    pub fn smallest(offset: f64, [rise, fall]: [f64; 2], lifts: impl IntoIterator<Item = Motion<f64>>) -> Option<Translating> {
        let is_limit = |angle: f64| angle > 0.0 && angle < core::f64::consts::FRAC_PI_2;
        if !is_limit(rise) || !is_limit(fall) {
            return None;
        }
        let root = lifts.into_iter().try_fold(0.0_f64, |root, lift| {
            let limit = match lift.rate {
                rate if rate > 0.0 => rise,
                rate if rate < 0.0 => fall,
                _ => rise.min(fall),
            };
            let least = (lift.rate - offset).abs() / libm::tan(limit) - lift.value;
            least.is_finite().then(|| root.max(least))
        })?;
        is_positive(root).then(|| Translating { prime_radius: libm::hypot(root, offset), offset })
    }

    /// The pitch curve and the pressure angle for a lift.
    ///
    /// ```text
    ///   tan α = (s′ − e) / (s + √(R² − e²))
    /// ```
    ///
    /// # Errors
    /// [`CamError::OutOfReach`] if the offset is not smaller than the radius.
    pub fn station(&self, angle: f64, lift: &Motion<f64>) -> Result<Station, CamError> {
        let square = self.prime_radius * self.prime_radius - self.offset * self.offset;
        if !is_positive(square) {
            return Err(CamError::OutOfReach { at: angle });
        }
        let centre = Motion {
            value: Vector2::new(self.offset, libm::sqrt(square) + lift.value),
            rate: Vector2::new(0.0, lift.rate),
            acceleration: Vector2::new(0.0, lift.acceleration),
        };
        station(angle, &centre, Vector2::new(0.0, 1.0))
    }
}

/// A roller or a knife edge on an arm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Swinging {
    /// Pivot of the arm in ground (m).
    pub pivot: Vector2<f64>,
    /// Length of the arm, from the pivot to the centre of the roller (m).
    pub arm: f64,
}

impl Swinging {
    /// The pitch curve and the pressure angle for an angle of the arm against the x axis of ground.
    ///
    /// # Errors
    /// [`CamError::NoNormal`] if the pitch curve has none.
    pub fn station(&self, angle: f64, swing: &Motion<f64>) -> Result<Station, CamError> {
        let (along, across) = axes(swing.value);
        let centre = Motion {
            value: self.pivot + along * self.arm,
            rate: across * (self.arm * swing.rate),
            acceleration: across * (self.arm * swing.acceleration) - along * (self.arm * swing.rate * swing.rate),
        };
        station(angle, &centre, across)
    }
}

/// A flat face across the y axis of ground that moves along it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TranslatingFace {
    /// Distance of the face from the cam's centre (m) where the lift is 0: radius of the base circle.
    pub base_radius: f64,
}

impl TranslatingFace {
    /// The smallest cam whose radius of curvature is nowhere smaller than `radius` (m). `lifts` are those of one turn. `None` if a cam of any size
    /// is large enough, if there are no lifts, or if one is not a number.
    ///
    /// ```text
    ///   R = ρ − min (s + s″)
    /// ```
    ///
    /// Reference: Norton, Cam Design and Manufacturing Handbook, chapter 7.
    #[must_use]
    pub fn smallest(radius: f64, lifts: impl IntoIterator<Item = Motion<f64>>) -> Option<TranslatingFace> {
        let sums = lifts.into_iter().map(|lift| lift.value + lift.acceleration);
        let least = sums.fold(f64::INFINITY, |least, sum| if sum >= least || least.is_nan() { least } else { sum });
        let base_radius = radius - least;
        (is_positive(base_radius) && base_radius.is_finite()).then_some(TranslatingFace { base_radius })
    }

    /// The surface. The point of contact has the x coordinate s′ in ground, so that the face reaches as far as the largest and the smallest
    /// s′.
    ///
    /// # Errors
    /// [`CamError::NotConvex`] where R + s + s″ ≤ 0.
    pub fn station(&self, angle: f64, lift: &Motion<f64>) -> Result<Station, CamError> {
        let distance = Motion { value: self.base_radius + lift.value, ..*lift };
        let psi = Motion { value: core::f64::consts::FRAC_PI_2 - angle, rate: -1.0, acceleration: 0.0 };
        Ok(Station { curve: CurvePoint::envelope(angle, &psi, &distance)?, pressure_angle: 0.0 })
    }
}

/// A flat face that turns about a pivot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SwingingFace {
    /// Pivot in ground (m).
    pub pivot: Vector2<f64>,
    /// Distance of the face from the pivot (m), positive if the face lies beyond the pivot in the direction of its normal.
    pub offset: f64,
}

impl SwingingFace {
    /// The surface and the pressure angle for an angle of the face's normal, away from the cam, against the x axis of ground.
    ///
    /// # Errors
    /// [`CamError::NotConvex`] where the face would cut into the surface.
    pub fn station(&self, angle: f64, normal: &Motion<f64>) -> Result<Station, CamError> {
        let follower = PlanarBody {
            position: self.pivot,
            angle: normal.value,
            velocity: Vector2::zeros(),
            angular_velocity: normal.rate,
            acceleration: Vector2::zeros(),
            angular_acceleration: normal.acceleration,
        };
        let cam = turning(angle);
        let curve = CurvePoint::face(&cam, &follower, Vector2::new(self.offset, 0.0), 0.0)?;
        let pivot = CurvePoint::direction(&cam, self.pivot);
        Ok(of(curve, perpendicular(curve.point - pivot)))
    }
}

fn station(angle: f64, point: &Motion<Vector2<f64>>, path: Vector2<f64>) -> Result<Station, CamError> {
    let cam = turning(angle);
    // The cam turns under a follower that stays at its place.
    Ok(of(CurvePoint::going_round(angle, &in_frame_of(&cam, point), -cam.angular_velocity)?, CurvePoint::direction(&cam, path)))
}

/// The path is taken in the direction away from the cam.
fn of(curve: CurvePoint, path: Vector2<f64>) -> Station {
    let path = if path.dot(&curve.normal) < 0.0 { -path } else { path };
    Station { curve, pressure_angle: curve.pressure_angle(path) }
}

/// A cam at this angle that turns by 1 rad per unit of its parameter.
fn turning(angle: f64) -> PlanarBody<f64> {
    let rest = Vector2::zeros();
    PlanarBody { position: rest, angle, velocity: rest, angular_velocity: 1.0, acceleration: rest, angular_acceleration: 0.0 }
}
