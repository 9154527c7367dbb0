//! Points of curves on a cam, and their parallel curves.

use core::fmt;

use nalgebra::Vector2;
use reuleaux::{Motion, PlanarBody};

use crate::CamError;

/// A point of a curve on the cam, in the cam's coordinates, with the normal and the curvature there.
///
/// Displayed, it is a line of a CSV file with the columns [`CurvePoint::COLUMNS`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvePoint {
    /// Angle of the cam (rad), or another number under which errors name the point.
    pub at: f64,
    /// (x, y) in m.
    pub point: Vector2<f64>,
    /// Unit normal, away from the material of the cam.
    pub normal: Vector2<f64>,
    /// κ in 1/m: positive where the cam is convex, negative where it is hollow.
    pub curvature: f64,
}

impl CurvePoint {
    /// Heads of the columns of a CSV file.
    pub const COLUMNS: &'static str = "angle in deg,x in mm,y in mm,normal in deg,curvature in 1/mm";

    /// From a point with its first and second derivative by any parameter that grows steadily.
    ///
    /// ```text
    ///   κ = x′ × x″ / |x′|³                        positive where the curve turns about the origin as it goes round it
    /// ```
    ///
    /// # Errors
    /// [`CamError::NoNormal`] if the derivative is zero, or is directed to the origin, so that no side of the curve is the outside.
    pub fn new(at: f64, motion: &Motion<Vector2<f64>>) -> Result<CurvePoint, CamError> {
        CurvePoint::going_round(at, motion, cross(motion.value, motion.rate))
    }

    /// From a point with its derivatives, of a curve that goes round the origin in this sense: counter-clockwise if it is positive.
    pub(crate) fn going_round(at: f64, motion: &Motion<Vector2<f64>>, sense: f64) -> Result<CurvePoint, CamError> {
        let Motion { value: point, rate, acceleration } = *motion;
        let speed = length(rate);
        if !is_positive(speed) || !is_positive(sense.abs()) || !speed.is_finite() {
            return Err(CamError::NoNormal { at });
        }
        // To the right of a curve that goes round counter-clockwise.
        let side = sense.signum();
        let tangent = rate / speed;
        let normal = Vector2::new(tangent.y, -tangent.x) * side;
        Ok(CurvePoint { at, point, normal, curvature: side * cross(tangent, acceleration) / (speed * speed) })
    }

    /// From a polar curve R(ψ) with its derivatives by ψ: `radius.rate` is R′, `radius.acceleration` R″.
    ///
    /// ```text
    ///   κ = (R² + 2R′² − R R″) / (R² + R′²)^(3/2)
    /// ```
    ///
    /// # Errors
    /// [`CamError::NoNormal`] if R is zero.
    pub fn polar(psi: f64, radius: &Motion<f64>) -> Result<CurvePoint, CamError> {
        let Motion { value, rate, acceleration } = *radius;
        let (along, across) = axes(psi);
        let motion = Motion {
            value: along * value,
            rate: along * rate + across * value,
            acceleration: along * (acceleration - value) + across * (2.0 * rate),
        };
        CurvePoint::new(psi, &motion)
    }

    /// The polar radius of the curve here with its derivatives by ψ, the angle of the point: the inverse of [`polar`](CurvePoint::polar).
    ///
    /// ```text
    ///   R′ = −R (n · e_ψ) / (n · e_R)                    R″ = (R² + 2R′² − κ (R² + R′²)^(3/2)) / R
    /// ```
    ///
    /// # Errors
    /// [`CamError::NoNormal`] if the curve runs along the radius, or if the point is the origin.
    pub fn polar_radius(&self) -> Result<Motion<f64>, CamError> {
        let radius = length(self.point);
        let along = self.point / radius;
        let outward = self.normal.dot(&along);
        if !is_positive(radius) || !is_positive(outward.abs()) {
            return Err(CamError::NoNormal { at: self.at });
        }
        let rate = -radius * self.normal.dot(&perpendicular(along)) / outward;
        let square = radius * radius + rate * rate;
        // The normal of the outer wall of a groove is directed inwards.
        let bend = self.curvature * outward.signum() * square * libm::sqrt(square);
        Ok(Motion { value: radius, rate, acceleration: (square + rate * rate - bend) / radius })
    }

    /// The angle ψ (rad) of the point in the cam, from −π to π.
    #[must_use]
    pub fn direction_angle(&self) -> f64 {
        libm::atan2(self.point.y, self.point.x)
    }

    /// The curve that a moving point draws on the cam: for a roller its centre, which draws the pitch curve, for a knife its edge.
    ///
    /// The curve is taken to go round the cam as it does here. A follower beside the cam's centre whose path is so steep that offset × slope exceeds
    /// the square of the distance from the centre runs back for a while: there the normal is directed inwards, and the curvature has the other sign.
    /// [`Translating`](crate::follower::Translating) and [`Swinging`](crate::follower::Swinging), whose cam turns under them, know the sense.
    ///
    /// # Errors
    /// [`CamError::NoNormal`] if the point rests on the cam, as when the cam does not turn.
    pub fn relative(cam: &PlanarBody<f64>, point: &Motion<Vector2<f64>>) -> Result<CurvePoint, CamError> {
        CurvePoint::new(cam.angle, &in_frame_of(cam, point))
    }

    /// The curve that a straight line touches as it moves: n(ψ) is its normal, away from the cam, and h its distance from the origin, both
    /// with derivatives by the same parameter.
    ///
    /// ```text
    ///   point   h n + h_ψ n⊥                       radius of curvature  h + h_ψψ
    /// ```
    ///
    /// # Errors
    /// [`CamError::NotConvex`] where h + h_ψψ ≤ 0, [`CamError::NoNormal`] where the line does not turn.
    pub fn envelope(at: f64, psi: &Motion<f64>, distance: &Motion<f64>) -> Result<CurvePoint, CamError> {
        if !is_positive(psi.rate.abs()) {
            return Err(CamError::NoNormal { at });
        }
        let slope = distance.rate / psi.rate;
        let second = (distance.acceleration - slope * psi.acceleration) / (psi.rate * psi.rate);
        let radius = distance.value + second;
        if !is_positive(radius) {
            return Err(CamError::NotConvex { at, radius });
        }
        let (normal, across) = axes(psi.value);
        Ok(CurvePoint { at, point: normal * distance.value + across * slope, normal, curvature: 1.0 / radius })
    }

    /// The surface that a flat face of a follower touches. `point` is a point of the face and `normal` the angle of its normal away from the
    /// cam, both in the follower's coordinates.
    ///
    /// # Errors
    /// As [`envelope`](CurvePoint::envelope).
    pub fn face(cam: &PlanarBody<f64>, follower: &PlanarBody<f64>, point: Vector2<f64>, normal: f64) -> Result<CurvePoint, CamError> {
        let at = in_frame_of(cam, &follower.point(point));
        let psi = Motion {
            value: follower.angle + normal - cam.angle,
            rate: follower.angular_velocity - cam.angular_velocity,
            acceleration: follower.angular_acceleration - cam.angular_acceleration,
        };
        let (along, across) = axes(psi.value);
        let square = psi.rate * psi.rate;
        let distance = Motion {
            value: along.dot(&at.value),
            rate: along.dot(&at.rate) + across.dot(&at.value) * psi.rate,
            acceleration: along.dot(&at.acceleration) + 2.0 * psi.rate * across.dot(&at.rate) + psi.acceleration * across.dot(&at.value)
                - square * along.dot(&at.value),
        };
        CurvePoint::envelope(cam.angle, &psi, &distance)
    }

    /// From a measured point between its neighbours: the circle through all three.
    ///
    /// # Errors
    /// [`CamError::NoNormal`] if two of them are the same, or if they lie on a line through the origin.
    pub fn through(at: f64, points: [Vector2<f64>; 3]) -> Result<CurvePoint, CamError> {
        let [before, point, after] = points;
        let (back, forth, chord) = (point - before, after - point, after - before);
        // The tangent of the circle bends from the longer side to the shorter.
        let (a, b) = (length(back), length(forth));
        let rate = back * (b / a) + forth * (a / b);
        if !is_positive(a) || !is_positive(b) {
            return Err(CamError::NoNormal { at });
        }
        let found = CurvePoint::new(at, &Motion { value: point, rate, acceleration: Vector2::zeros() })?;
        let turn = 2.0 * cross(back, forth) / (a * b * length(chord));
        Ok(CurvePoint { curvature: turn * cross(point, rate).signum(), ..found })
    }

    /// Radius of curvature (m): positive where the cam is convex, negative where it is hollow, infinite where it is straight.
    #[must_use]
    pub fn radius_of_curvature(&self) -> f64 {
        1.0 / self.curvature
    }

    /// The surface of a disc cam, if this is a point of the pitch curve of a roller with this radius (m). With the radius 0 it is that of a
    /// knife edge.
    ///
    /// # Errors
    /// [`CamError::Undercut`] where the pitch curve is convex with a radius of curvature that is not larger than that of the roller.
    pub fn surface(&self, roller: f64) -> Result<CurvePoint, CamError> {
        self.parallel(-roller).ok_or(CamError::Undercut { at: self.at, radius: self.radius_of_curvature(), roller })
    }

    /// The outer wall of a groove in which the roller runs, if this is a point of its pitch curve. Its normal is directed inwards.
    ///
    /// # Errors
    /// [`CamError::Undercut`] where the pitch curve is hollow with a radius of curvature that is not larger than that of the roller.
    pub fn outer_surface(&self, roller: f64) -> Result<CurvePoint, CamError> {
        let wall = self.parallel(roller).ok_or(CamError::Undercut { at: self.at, radius: -self.radius_of_curvature(), roller })?;
        Ok(CurvePoint { normal: -wall.normal, curvature: -wall.curvature, ..wall })
    }

    /// The centre of a roller that touches the surface here: the pitch curve of a given or measured surface.
    ///
    /// # Errors
    /// [`CamError::TooHollow`] where the roller is not smaller than the hollow.
    pub fn pitch(&self, roller: f64) -> Result<CurvePoint, CamError> {
        self.parallel(roller).ok_or(CamError::TooHollow { at: self.at, radius: -self.radius_of_curvature(), tool: roller })
    }

    /// The centre of a milling cutter or a grinding wheel that touches the surface here.
    ///
    /// # Errors
    /// [`CamError::TooHollow`] where the cutter is not smaller than the hollow.
    pub fn cutter(&self, radius: f64) -> Result<CurvePoint, CamError> {
        self.pitch(radius)
    }

    /// The curve at a distance (m) along the normal; `None` where it has a cusp or runs backwards.
    fn parallel(&self, distance: f64) -> Option<CurvePoint> {
        let stretch = 1.0 + self.curvature * distance;
        let point = self.point + self.normal * distance;
        (stretch > 0.0).then(|| CurvePoint { point, curvature: self.curvature / stretch, ..*self })
    }

    /// Angle (rad) from the follower's direction of motion to the normal, counter-clockwise, from −π to π. The direction is that in which
    /// the follower rises, in the cam's coordinates.
    #[must_use]
    pub fn pressure_angle(&self, direction: Vector2<f64>) -> f64 {
        libm::atan2(cross(direction, self.normal), direction.dot(&self.normal))
    }

    /// A direction of ground in the cam's coordinates.
    #[must_use]
    pub fn direction(cam: &PlanarBody<f64>, direction: Vector2<f64>) -> Vector2<f64> {
        turned_back(cam.angle, direction)
    }
}

impl fmt::Display for CurvePoint {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let normal = libm::atan2(self.normal.y, self.normal.x).to_degrees();
        let (at, [x, y]) = (self.at.to_degrees(), [self.point.x * 1e3, self.point.y * 1e3]);
        write!(f, "{at:.4},{x:.6},{y:.6},{normal:.4},{:.8}", self.curvature * 1e-3)
    }
}

/// The motion of a point relative to the cam, in the cam's coordinates.
///
/// ```text
///   d = r_P − r_O = A p
///   p′ = Aᵀ ḋ − ω k × p
///   p″ = Aᵀ d̈ − 2ω k × p′ − ω̇ k × p + ω² p
/// ```
pub(crate) fn in_frame_of(cam: &PlanarBody<f64>, point: &Motion<Vector2<f64>>) -> Motion<Vector2<f64>> {
    let back = |vector: Vector2<f64>| turned_back(cam.angle, vector);
    let (speed, growth) = (cam.angular_velocity, cam.angular_acceleration);
    let value = back(point.value - cam.position);
    let rate = back(point.rate - cam.velocity) - perpendicular(value) * speed;
    let inertial = perpendicular(rate) * (2.0 * speed) + perpendicular(value) * growth - value * (speed * speed);
    Motion { value, rate, acceleration: back(point.acceleration - cam.acceleration) - inertial }
}

fn turned_back(angle: f64, vector: Vector2<f64>) -> Vector2<f64> {
    let (along, across) = axes(angle);
    Vector2::new(along.dot(&vector), across.dot(&vector))
}

/// The unit vector of this angle, and the one to its left.
pub(crate) fn axes(angle: f64) -> (Vector2<f64>, Vector2<f64>) {
    let (sine, cosine) = libm::sincos(angle);
    (Vector2::new(cosine, sine), Vector2::new(-sine, cosine))
}

/// k × a
pub(crate) fn perpendicular(a: Vector2<f64>) -> Vector2<f64> {
    Vector2::new(-a.y, a.x)
}

/// False for NaN.
pub(crate) fn is_positive(number: f64) -> bool {
    number > 0.0
}

fn cross(a: Vector2<f64>, b: Vector2<f64>) -> f64 {
    a.x * b.y - a.y * b.x
}

fn length(a: Vector2<f64>) -> f64 {
    libm::hypot(a.x, a.y)
}
